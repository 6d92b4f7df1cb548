"""The YuMi that comes with keyphase."""

from typing import Literal

import numpy as np

from keyphase.robot.description import RobotDescription, load_description
from keyphase.shipped import shipped

Side = Literal["r", "l"]

AXES = ("1", "2", "7", "3", "4", "5", "6")
"""ABB's numbers of the axes in the order of the chain."""

MIRRORED = np.array([-1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0])
"""Joint values of one arm times this mirror the other arm."""

RIGHT_START_RAD = np.radians([77.0, -86.0, -76.0, 30.0, -138.0, 78.0, -131.0])
"""Tool pointing down over the table, elbow out, far from limits and singularities."""

LEFT_REST_RAD = np.radians([0.0, -130.0, 135.0, 30.0, 0.0, 40.0, 0.0])
"""ABB's calibration posture of the left arm: both hands hang beside the body."""

GRIPPER_OPEN_M = 0.018
"""How far each finger of a gripper is from the middle plane, for display."""


def yumi(side: Side = "r") -> RobotDescription:
    """The YuMi, its right or left tool point to be moved; the other arm rests."""
    path = shipped("static_robots") / "yumi" / "yumi.urdf"
    return load_description(path, f"tcp_{side}").starting_at(
        RIGHT_START_RAD if side == "r" else RIGHT_START_RAD * MIRRORED,
        _rest("l" if side == "r" else "r"),
    )


def joint_names(side: Side) -> tuple[str, ...]:
    """The seven joints of one arm from shoulder to wrist."""
    return tuple(f"yumi_joint_{axis}_{side}" for axis in AXES)


def _rest(side: Side) -> dict[str, float]:
    angles = LEFT_REST_RAD if side == "l" else LEFT_REST_RAD * MIRRORED
    arm = dict(zip(joint_names(side), angles.tolist(), strict=True))
    return {**arm, "gripper_r_joint": GRIPPER_OPEN_M, "gripper_l_joint": GRIPPER_OPEN_M}
