# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""A reference that follows a target set from outside, smoothly and not too far ahead."""

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.simulation.impedance import RATE_HZ, Reference, rotation_towards

MAX_SPEED_M_S = 0.25
MAX_SPEED_RAD_S = 1.5
MAX_AHEAD_M = 0.010
MAX_AHEAD_RAD = 0.15

_STEP_S = 1.0 / RATE_HZ
_NATURAL_RAD_S = 25.0


class Follower:
    """A critically damped reference: the hand between a dragged gizmo and the impedance.

    A gizmo jumps from place to place some twenty times a second; its reference moves with bounded
    speed, and never runs further ahead of the tool than the hand would push.
    """

    def __init__(self, start: Reference) -> None:
        self.restart(start)

    def restart(self, at: Reference) -> None:
        """Rest at a pose."""
        self._position = at.position_m.copy()
        self._orientation = at.orientation_wxyz.copy()
        self._velocity, self._turning = np.zeros(3), np.zeros(3)

    def towards(self, target: Reference, tool: Reference) -> Reference:
        """The reference of the next tick, on its way to `target`, for a tool that is at `tool`."""
        away = target.position_m - self._position
        turn = _turn(self._orientation, target.orientation_wxyz)
        velocity = _accelerated(self._velocity, away, MAX_SPEED_M_S)
        turning = _accelerated(self._turning, turn, MAX_SPEED_RAD_S)
        position = _near(tool.position_m, self._position + velocity * _STEP_S)
        wanted = _turned(self._orientation, turning * _STEP_S)
        ahead = _bounded(_turn(tool.orientation_wxyz, wanted), MAX_AHEAD_RAD)
        orientation = _turned(tool.orientation_wxyz, ahead)
        # What was held back was not moved: the damping must not push on.
        self._velocity = (position - self._position) / _STEP_S
        self._turning = _turn(self._orientation, orientation) / _STEP_S
        self._position, self._orientation = position, orientation
        return Reference(position, orientation, self._velocity, self._turning)


def _near(tool_m: Array, wanted_m: Array) -> Array:
    return tool_m + _bounded(wanted_m - tool_m, MAX_AHEAD_M)


def _bounded(vector: Array, greatest: float) -> Array:
    norm = float(np.linalg.norm(vector))
    return vector * (greatest / norm) if norm > greatest else vector


def _accelerated(velocity: Array, away: Array, fastest: float) -> Array:
    acceleration = _NATURAL_RAD_S**2 * away - 2.0 * _NATURAL_RAD_S * velocity
    return _bounded(velocity + acceleration * _STEP_S, fastest)


def _turn(wxyz: Array, goal_wxyz: Array) -> Array:
    """Rotation vector, base frame, from one orientation to another."""
    matrix = np.empty(9)
    mujoco.mju_quat2Mat(matrix, wxyz)
    return rotation_towards(matrix, goal_wxyz)


def _turned(wxyz: Array, rotation: Array) -> Array:
    angle = float(np.linalg.norm(rotation))
    if angle < 1e-12:
        return wxyz.copy()
    turn, result = np.empty(4), np.empty(4)
    mujoco.mju_axisAngle2Quat(turn, rotation / angle, angle)
    mujoco.mju_mulQuat(result, turn, wxyz)
    return result / np.linalg.norm(result)
