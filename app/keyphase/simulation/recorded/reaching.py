# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Whether an arm reaches poses: damped least squares on a MuJoCo model."""

from collections.abc import Sequence

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.simulation.impedance import rotation_towards

Pose = tuple[Array, Array]
"""Position (3,) and orientation (4,), w x y z."""

NEAR_M, NEAR_RAD = 1e-3, 0.01
STARTS, STEPS = 12, 80
MARGIN_RAD = 0.12
"""A posture keeps this far from the joints' ends, where the controller holds them back."""

_DAMPING = 1e-3
_LARGEST_STEP_RAD = 0.3


def reached_from(model: mujoco.MjModel, site: int, poses: Sequence[Pose]) -> tuple[int, Array]:
    """How many of the poses are reached one after the other, and the posture (J,) at the first.

    The best of several postures at the first one, seeded: an arm has several, and not all of them
    lead on.
    """
    ends = np.clip(model.jnt_range, -2.0 * np.pi, 2.0 * np.pi)
    margin = np.minimum(MARGIN_RAD, 0.25 * np.ptp(ends, axis=1))
    low, high = ends[:, 0] + margin, ends[:, 1] - margin
    draws = np.random.default_rng(0).uniform(*_nearest_turn(low, high), (STARTS, model.nq))
    best, start = 0, 0.5 * (low + high)
    for first in (np.clip(np.zeros(model.nq), low, high), 0.5 * (low + high), *draws):
        posture, reached, begun = first, 0, first
        for pose in poses:
            posture, is_there = _towards(model, site, pose, posture, low, high)
            if not is_there:
                break
            begun = posture if not reached else begun
            reached += 1
        if reached > best:
            best, start = reached, begun
        if best == len(poses):
            break
    return best, start


def _nearest_turn(low: Array, high: Array) -> tuple[Array, Array]:
    """Of each range the part within half a turn either way; all of it, where none is."""
    near_low, near_high = np.maximum(low, -np.pi), np.minimum(high, np.pi)
    outside = near_low > near_high
    return np.where(outside, low, near_low), np.where(outside, high, near_high)


def _towards(
    model: mujoco.MjModel, site: int, pose: Pose, start_rad: Array, low: Array, high: Array
) -> tuple[Array, bool]:
    """The posture (J,) nearest to a pose from a start, and whether it is there."""
    data, q = mujoco.MjData(model), start_rad
    jacobian = np.zeros((6, model.nv))
    for _ in range(STEPS):
        data.qpos[:] = q
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        away = np.r_[
            pose[0] - data.site_xpos[site], rotation_towards(data.site_xmat[site], pose[1])
        ]
        if np.linalg.norm(away[:3]) < NEAR_M and np.linalg.norm(away[3:]) < NEAR_RAD:
            return q, True
        mujoco.mj_jacSite(model, data, jacobian[:3], jacobian[3:], site)
        square = jacobian @ jacobian.T + _DAMPING * np.eye(6)
        step = jacobian.T @ np.linalg.solve(square, away)
        largest = float(np.abs(step).max())
        q = np.clip(q + step * min(1.0, _LARGEST_STEP_RAD / max(largest, 1e-9)), low, high)
    return q, False
