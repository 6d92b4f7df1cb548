"""The YuMi in numbers: what is published, and what is estimated because nothing is published.

Published: joint origins, axes and ranges (yumi_description, BSD-2-Clause, the ABB product
specification of the IRB 14000), joint speeds, the weight of the robot (38 kg) and of an arm
(9.5 kg), the origins and the stroke of the fingers. Estimated: how the weight is shared among the
links, the weight of gripper and sensor, inertias, joint torques, the shapes, and where the tool
point lies.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

Triple = tuple[float, float, float]
QUARTER = float(np.pi / 2)

BODY_HEIGHT_M = 0.1
ROBOT_MASS_KG, ARM_MASS_KG = 38.0, 9.5
FLANGE_M = 0.007
"""From the frame of link 7 to the face of the tool flange."""
SENSOR_HEIGHT_M, SENSOR_MASS_KG = 0.0122, 0.050
"""A sensor 40 mm wide, of the size used on such wrists."""
FINGER_ORIGIN_M = (0.0, 0.0065, 0.0837)
FINGER_STROKE_M = 0.025
TOOL_POINT_M = 0.126
"""From the gripper's base to the tool point, 12 mm above the tips."""


@dataclass(frozen=True)
class Joint:
    """One revolute joint: its origin in the link before it, range in degrees, speed in degrees
    per second (published), and largest torque in N m (estimated).
    """

    name: str
    xyz_m: Triple
    rpy_rad: Triple
    range_deg: tuple[float, float]
    speed_deg_s: float
    torque_Nm: float


SHOULDERS: Mapping[str, tuple[Triple, Triple]] = {
    "r": ((0.05355, -0.0725, 0.41492), (-0.9788, -0.5699, -2.3168)),
    "l": ((0.05355, 0.0725, 0.41492), (0.9788, -0.5699, 2.3168)),
}
"""Origin of joint 1 in the body. The two published turns differ by 0.23 degrees; this is their
mean, mirrored.
"""

SHOULDER = Joint("1", (0, 0, 0), (0, 0, 0), (-168.5, 168.5), 180, 30)
"""Its origin differs between the arms."""
CHAIN = (
    Joint("2", (0.03, 0.0, 0.1), (QUARTER, 0, 0), (-143.5, 43.5), 180, 30),
    Joint("7", (-0.03, 0.17283, 0.0), (-QUARTER, 0, 0), (-168.5, 168.5), 180, 20),
    Joint("3", (-0.04188, 0.0, 0.07873), (QUARTER, -QUARTER, 0), (-123.5, 80.0), 180, 20),
    Joint("4", (0.0405, 0.16461, 0.0), (-QUARTER, 0, 0), (-290.0, 290.0), 400, 10),
    Joint("5", (-0.027, 0.0, 0.10039), (QUARTER, 0, 0), (-88.0, 138.0), 400, 10),
    Joint("6", (0.027, 0.029, 0.0), (-QUARTER, 0, 0), (-229.0, 229.0), 400, 5),
)
"""Joints 2 to 6 in the order of the chain; ABB counts the third one as 7."""

MASS_KG: Mapping[str, float] = {
    "body": 19.0,
    "link_1": 1.78,
    "link_2": 2.61,
    "link_3": 1.33,
    "link_4": 2.19,
    "link_5": 0.64,
    "link_6": 0.87,
    "link_7": 0.08,
    "gripper": 0.21,
    "finger": 0.01,
}
"""Shared by the volume of the links so that an arm weighs 9.5 kg and the robot 38 kg; a gripper
weighs 0.23 kg with its fingers.
"""


@dataclass(frozen=True)
class Solid:
    """A collision shape: a box by its three sizes, or a cylinder by radius and length along
    `axis`.
    """

    size_m: tuple[float, ...]
    centre_m: Triple
    axis: str = "z"


COLLISION: Mapping[str, tuple[Solid, ...]] = {
    "body": (
        Solid((0.48, 0.39, 0.085), (-0.115, 0, -0.055)),
        Solid((0.20, 0.26, 0.45), (-0.26, 0, 0.22)),
        Solid((0.36, 0.22, 0.12), (-0.16, 0, 0.405)),
    ),
    "link_1": (
        Solid((0.050, 0.150), (0.03, 0, 0.1), "y"),
        Solid((0.055, 0.06), (0, 0, 0.04)),
    ),
    "link_2": (
        Solid((0.048, 0.08), (0, 0, -0.04)),
        Solid((0.048, 0.12), (-0.03, 0.11, 0), "y"),
    ),
    "link_3": (
        Solid((0.047, 0.08), (-0.042, -0.04, 0.079), "y"),
        Solid((0.043, 0.06), (0, 0, 0.04)),
    ),
    "link_4": (
        Solid((0.047, 0.08), (0, 0, -0.04)),
        Solid((0.044, 0.11), (0.04, 0.105, 0), "y"),
    ),
    "link_5": (
        Solid((0.032, 0.07), (-0.027, -0.035, 0.1), "y"),
        Solid((0.036, 0.05), (0, 0, 0.035)),
    ),
    "link_6": (Solid((0.088, 0.085, 0.065), (0.017, -0.018, -0.025)),),
    "gripper": (Solid((0.080, 0.066, 0.088), (0, 0, 0.044)),),
    "finger": (Solid((0.009, 0.016, 0.050), (-0.006, 0.0065, 0.029)),),
}
