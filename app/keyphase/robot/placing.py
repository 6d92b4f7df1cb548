"""Where to put a recording that was made elsewhere, so that an arm reaches it."""

import numpy as np
import pinocchio  # pyright: ignore[reportMissingImports]
from numpy.typing import ArrayLike

from keyphase.demonstration import Array, Demonstration
from keyphase.robot.arm import Arm
from keyphase.robot.follow import tool_poses
from keyphase.robot.inverse import nearest, starts
from keyphase.robot.pose import Placement

TRIED = 8
"""So many poses, spread over the recording, decide whether it is within reach."""

_STARTS = 3
_TURNS_RAD = tuple(np.radians([0, 180, 90, -90, 45, -45, 135, -135]).tolist())
_SHIFTS_M = ((0.0, 0.0), (0.0, 0.1), (-0.08, 0.05), (0.08, 0.0))
"""Moves of the middle of the path from the arm's start: forward and up."""


def within_reach(arm: Arm, demonstration: Demonstration, placement: Placement) -> bool:
    """Whether the arm reaches poses spread over the placed recording."""
    poses = placement.apply(_some_poses(demonstration))
    return _reached(arm, poses, len(poses) - 1) == len(poses)


def suggested_placement(arm: Arm, demonstration: Demonstration) -> Placement:
    """A placement that brings the recording within reach, or most of it where nothing does more.

    The recording stays where it is if it is within reach there. Else the middle of its path is
    put to where the arm starts and the whole turned about the vertical; the best of these turns
    is then tried at places nearby. It takes a second at most.
    """
    if within_reach(arm, demonstration, Placement()):
        return Placement()
    poses, best, most, best_turn = _some_poses(demonstration), Placement(), -1, 0.0
    for first, (forward, up) in enumerate(_SHIFTS_M):
        middle = arm.forward(arm.robot.start_rad)[:3, 3] + [forward, 0.0, up]
        for turn in _TURNS_RAD if first == 0 else (best_turn,):
            placement = _turned_about(demonstration.position_m, turn, middle)
            reached = _reached(arm, placement.apply(poses), most)
            if reached > most:
                best, most, best_turn = placement, reached, turn
            if most == len(poses):
                return best
    return best


def _some_poses(demonstration: Demonstration) -> Array:
    rows = np.unique(np.linspace(0, len(demonstration) - 1, TRIED).astype(int))
    return tool_poses(demonstration, rows)


def _reached(arm: Arm, poses: Array, enough: int) -> int:
    """How many are reached; counting ends where it can be no more than `enough`."""
    reached = 0
    for left, pose in zip(range(len(poses), 0, -1), poses, strict=True):
        if reached + left <= enough:
            break
        reached += _is_reached(arm, pose)
    return reached


def _is_reached(arm: Arm, pose: Array) -> bool:
    goal, data = pinocchio.SE3(pose), arm.model.createData()
    lower, upper = arm.robot.lower_rad, arm.robot.upper_rad
    some = starts(arm, None, seed=0)[:_STARTS]
    return any(nearest(arm, goal, start, lower, upper, data).reached for start in some)


def _turned_about(position_m: Array, turn_rad: float, middle_m: ArrayLike) -> Placement:
    """The path turned about the vertical, and the middle of its box put to `middle_m`."""
    cosine, sine = np.cos(turn_rad), np.sin(turn_rad)
    turn = np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    middle = 0.5 * (position_m.min(axis=0) + position_m.max(axis=0))
    x, y, z = (np.asarray(middle_m) - turn @ middle).tolist()
    half = 0.5 * turn_rad
    return Placement((x, y, z), (float(np.cos(half)), 0.0, 0.0, float(np.sin(half))))
