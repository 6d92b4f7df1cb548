# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""A reference that follows a target set from outside, smoothly and not too far ahead."""

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.simulation.impedance import RATE_HZ, Reference, rotation_towards

FASTEST_M_S = 0.25
FASTEST_RAD_S = 1.5
FURTHEST_AHEAD_M = 0.010
FURTHEST_AHEAD_RAD = 0.15

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
        self._velocity = _accelerated(self._velocity, away, FASTEST_M_S)
        self._turning = _accelerated(self._turning, turn, FASTEST_RAD_S)
        self._position = self._position + self._velocity * _STEP_S
        self._orientation = _turned(self._orientation, self._turning * _STEP_S)
        self._stay_near(tool)
        return Reference(
            self._position.copy(), self._orientation.copy(), self._velocity, self._turning
        )

    def _stay_near(self, tool: Reference) -> None:
        ahead = self._position - tool.position_m
        if (far := float(np.linalg.norm(ahead))) > FURTHEST_AHEAD_M:
            self._position = tool.position_m + ahead * (FURTHEST_AHEAD_M / far)
            self._velocity = self._velocity * 0.9
        turned = _turn(tool.orientation_wxyz, self._orientation)
        if (far := float(np.linalg.norm(turned))) > FURTHEST_AHEAD_RAD:
            near = turned * (FURTHEST_AHEAD_RAD / far)
            self._orientation = _turned(tool.orientation_wxyz, near)
            self._turning = self._turning * 0.9


def _accelerated(velocity: Array, away: Array, fastest: float) -> Array:
    acceleration = _NATURAL_RAD_S**2 * away - 2.0 * _NATURAL_RAD_S * velocity
    faster = velocity + acceleration * _STEP_S
    speed = float(np.linalg.norm(faster))
    return faster * (fastest / speed) if speed > fastest else faster


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
