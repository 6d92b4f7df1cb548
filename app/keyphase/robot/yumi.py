"""The YuMi that comes with keyphase."""

from collections.abc import Mapping, Sequence
from functools import cache
from typing import Literal

import numpy as np

from keyphase.demonstration import Array
from keyphase.files.shipped import shipped
from keyphase.robot.description import RobotDescription, load_descriptions

Side = Literal["r", "l"]

AXES = ("1", "2", "7", "3", "4", "5", "6")
"""ABB's numbers of the axes in the order of the chain."""

RIGHT_START_DEG = (77.0, -86.0, -76.0, 30.0, -138.0, 78.0, -131.0)
"""Tool pointing down over the table, elbow out, far from limits and singularities."""

RIGHT_REST_DEG = (0.0, -130.0, -135.0, 30.0, 0.0, 40.0, 0.0)
"""ABB's calibration posture: the hand hangs beside the body."""

GRIPPER_OPEN_M = 0.018
"""How far each finger of a gripper is from the middle plane, for display."""

_MIRRORED = (-1, 1, -1, 1, -1, 1, -1)


def yumi(side: Side = "r") -> RobotDescription:
    """The YuMi, its right or left tool point to be moved; the other arm rests."""
    return _both_sides()[side]


@cache
def _both_sides() -> Mapping[Side, RobotDescription]:
    """Read once: the files come with keyphase, and nobody changes a description."""
    path = shipped("static_robots") / "yumi" / "yumi.urdf"
    right, left = load_descriptions(path, ("tcp_r", "tcp_l"))
    return {"r": _posed(right, "r", "l"), "l": _posed(left, "l", "r")}


def _posed(robot: RobotDescription, side: Side, other: Side) -> RobotDescription:
    resting = dict(zip(joint_names(other), _rad(RIGHT_REST_DEG, other).tolist(), strict=True))
    open_grippers = {f"gripper_{each}_joint": GRIPPER_OPEN_M for each in "rl"}
    return robot.starting_at(_rad(RIGHT_START_DEG, side), {**resting, **open_grippers})


def joint_names(side: Side) -> tuple[str, ...]:
    """The seven joints of one arm from shoulder to wrist."""
    return tuple(f"yumi_joint_{axis}_{side}" for axis in AXES)


def _rad(right_deg: Sequence[float], side: Side) -> Array:
    return np.radians(right_deg) * (1 if side == "r" else np.array(_MIRRORED))
