# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""How the held part lies to its housing, and whether it sits on it."""

from dataclasses import dataclass
from math import pi, sqrt

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.simulation.simulation import Simulation
from keyphase.simulation.workcells.parts import HOUSING_M

GAP_M = 0.0003
"""A part whose mating face is further above the housing's top than this does not sit on it."""

SUNK_M = 0.0015
"""Contacts of the simulator give way; what lies deeper than this has gone through the housing."""

SLACK_M = 0.0003
"""What is added to a clearance, for contacts that give way."""

ANGLE_RAD = np.radians(3.0)


@dataclass(frozen=True, eq=False)
class Lie:
    """The held part seen from its housing.

    gap_m      of its mating face above the housing's top, along the housing's axis
    aside_m    (2,) of its middle, in the housing's x and y
    angle_rad  by which it is turned and tilted against the nearest pose in which it fits
    """

    gap_m: float
    aside_m: Array
    angle_rad: float


def lie_of(simulation: Simulation, fits: int) -> Lie:
    """How the held part lies to the part "housing"; it fits in `fits` turns about its axis."""
    poses = simulation.part_poses()
    (housing_m, housing_wxyz), (held_m, held_wxyz) = poses["housing"], poses["held"]
    back, way, turn = np.empty(4), np.empty(3), np.empty(4)
    mujoco.mju_negQuat(back, housing_wxyz)
    mujoco.mju_rotVecQuat(way, held_m - housing_m, back)
    mujoco.mju_mulQuat(turn, back, held_wxyz)
    return Lie(float(way[2]) - HOUSING_M[2], way[:2], _nearest_angle(turn, fits))


def seat_gap_m(simulation: Simulation) -> float:
    """How far the held part's mating face is above the housing's top, along its axis [m]."""
    return lie_of(simulation, 1).gap_m


def is_seated(lie: Lie) -> bool:
    """Whether gap and angle are those of a part that sits on its housing, wherever sideways."""
    return -SUNK_M < lie.gap_m < GAP_M and lie.angle_rad < ANGLE_RAD


def within_clearance(lie: Lie, clearance_m: float) -> bool:
    """Whether a part lies inside a rim all around with this clearance, its corners included."""
    return float(np.linalg.norm(lie.aside_m)) < clearance_m * sqrt(2.0) + SLACK_M


def _nearest_angle(turn: Array, fits: int) -> float:
    """Angle of the rotation `turn` (4,) once its nearest fitting turn about z is taken out."""
    about_z = 2.0 * np.arctan2(turn[3], turn[0])
    step = 2.0 * pi / fits
    fitting = step * round(about_z / step)
    out, left = np.empty(4), np.empty(3)
    mujoco.mju_axisAngle2Quat(out, np.array([0.0, 0.0, 1.0]), fitting)
    mujoco.mju_subQuat(left, turn, out)
    return float(np.linalg.norm(left))
