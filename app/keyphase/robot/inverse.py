"""Inverse kinematics: Levenberg–Marquardt within joint bounds.

Every step minimises |W (e - J dq)|^2 + damping |dq|^2 over the joints that are not at a bound.
The damping shrinks with the squared error that is left (T. Sugihara, "Solvability-unconcerned
inverse kinematics by the Levenberg-Marquardt method", IEEE Transactions on Robotics, 2011), so
steps are cautious far from the target and near singularities, and exact close to it; a target out
of reach gives the nearest pose instead of a wild one.
"""

from dataclasses import dataclass

import numpy as np
import pinocchio  # pyright: ignore[reportMissingImports]
from numpy.typing import ArrayLike

from keyphase.demonstration import Array
from keyphase.robot.arm import Arm

POSITION_TOLERANCE_M = 2e-6
ANGLE_TOLERANCE_RAD = 1e-5

ARM_LENGTH_M = 0.3
"""Turning by one radian weighs as much as moving by this."""

RESTARTS = 60
_MIN_DAMPING = 1e-10
_MAX_STEPS = 200
_STALLED = 1e-3
_PATIENCE = 8
"""Steps that gain less than the share `_STALLED` of the error before the target is given up."""


@dataclass(frozen=True, eq=False)
class Solution:
    """Joint values (J,) and how far from the target the tool frame then is."""

    joints_rad: Array
    distance_m: float
    angle_rad: float

    @property
    def reached(self) -> bool:
        """Whether position and orientation are within the tolerances."""
        return self.distance_m <= POSITION_TOLERANCE_M and self.angle_rad <= ANGLE_TOLERANCE_RAD

    @property
    def error(self) -> float:
        """Distance and angle in one number, metres."""
        return float(np.hypot(self.distance_m, ARM_LENGTH_M * self.angle_rad))


def inverse(
    arm: Arm, target: ArrayLike, start_rad: ArrayLike | None = None, seed: int = 0
) -> Solution:
    """Joint values that bring the tool frame to `target` (4, 4), or as near as they can.

    Tried from `start_rad`, the arm's start posture, and then from random postures.
    """
    goal = pinocchio.SE3(np.asarray(target, dtype=np.float64))
    data = arm.model.createData()
    lower, upper = arm.robot.lower_rad, arm.robot.upper_rad
    best: Solution | None = None
    for start in starts(arm, start_rad, seed):
        solution = nearest(arm, goal, start, lower, upper, data)
        if solution.reached:
            return solution
        if best is None or solution.error < best.error:
            best = solution
    assert best is not None
    return best


def starts(arm: Arm, start_rad: ArrayLike | None, seed: int) -> list[Array]:
    """Postures to start from: the given one, the arm's own, and random ones within limits."""
    random = np.random.default_rng(seed)
    lower = np.maximum(arm.robot.lower_rad, -np.pi)
    upper = np.minimum(arm.robot.upper_rad, np.pi)
    given = [] if start_rad is None else [np.asarray(start_rad, dtype=np.float64)]
    return [*given, arm.robot.start_rad, *random.uniform(lower, upper, (RESTARTS, len(lower)))]


def nearest(
    arm: Arm,
    goal: pinocchio.SE3,
    start_rad: Array,
    lower_rad: Array,
    upper_rad: Array,
    data: pinocchio.Data,
) -> Solution:
    """From `start_rad`, the nearest the tool frame gets to `goal` within the joint bounds."""
    joints = np.clip(start_rad, lower_rad, upper_rad)
    error, jacobian = _error(arm, goal, joints, data)
    left, caution, stalled = float(error @ error), 1.0, 0
    for _ in range(_MAX_STEPS):
        if _within_tolerance(error) or stalled >= _PATIENCE:
            break
        damping = caution * left + _MIN_DAMPING
        trial = joints + _bounded_step(
            jacobian, error, lower_rad - joints, upper_rad - joints, damping
        )
        trial = np.clip(trial, lower_rad, upper_rad)
        trial_error, trial_jacobian = _error(arm, goal, trial, data)
        trial_left = float(trial_error @ trial_error)
        stalled = stalled + 1 if trial_left > left * (1 - _STALLED) else 0
        if trial_left < left:
            joints, error, jacobian, left = trial, trial_error, trial_jacobian, trial_left
            caution = max(caution / 4, 1e-3)
        else:
            caution *= 8
    distance, angle = np.linalg.norm(error[:3]), np.linalg.norm(error[3:]) / ARM_LENGTH_M
    return Solution(joints, float(distance), float(angle))


def _within_tolerance(error: Array) -> bool:
    moved, turned = error[:3], error[3:]
    return bool(
        moved @ moved <= POSITION_TOLERANCE_M**2
        and turned @ turned <= (ANGLE_TOLERANCE_RAD * ARM_LENGTH_M) ** 2
    )


def _error(
    arm: Arm, goal: pinocchio.SE3, joints: Array, data: pinocchio.Data
) -> tuple[Array, Array]:
    """What is missing (6,) and how joints change it (6, J), in metres, root's axes."""
    pose, jacobian = arm.pose_and_jacobian(joints, data)
    error = np.empty(6)
    error[:3] = goal.translation - pose.translation
    error[3:] = ARM_LENGTH_M * pinocchio.log3(goal.rotation @ pose.rotation.T)
    jacobian[3:] *= ARM_LENGTH_M
    return error, jacobian


def _bounded_step(
    jacobian: Array, error: Array, lowest: Array, highest: Array, damping: float
) -> Array:
    """Damped least-squares step; joints that would pass a bound stop there, the rest make up."""
    step = np.zeros(jacobian.shape[1])
    free = np.ones(len(step), dtype=bool)
    for _ in step:
        moving = jacobian[:, free]
        normal = moving.T @ moving
        normal.flat[:: len(normal) + 1] += damping
        wanted = np.linalg.solve(normal, moving.T @ (error - jacobian[:, ~free] @ step[~free]))
        step[free] = np.clip(wanted, lowest[free], highest[free])
        stopped = step[free] != wanted
        if not stopped.any():
            break
        free[np.flatnonzero(free)[stopped]] = False
        if not free.any():
            break
    return step
