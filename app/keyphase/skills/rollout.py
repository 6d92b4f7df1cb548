"""Roll a primitive out without coupling: the motion it would make if nothing disturbed it.

Without coupling the phase is a known function of time, so for the position the semi-implicit
steps of `keyphase.skills.coupling.step` are a linear recursion of second order,

    u[k+1] = (2 - a alpha - a^2 alpha beta) u[k] - (1 - a alpha) u[k-1] + a^2 f[k],   a = h / tau,

in u = y - g. It is filtered once for the start and once per axis for the forcing term; every
rollout of a batch is a weighted sum of these responses. The orientation is stepped, all rollouts
of the batch at once.
"""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.signal import lfilter

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.skills.coupling import goal_pose, refuse_not_positive, start_pose, substeps
from keyphase.skills.primitive import (
    Constants,
    Primitive,
    activations,
    remaining,
    scale_and_hold,
    tau_of,
)


@dataclass(frozen=True, eq=False)
class Rollout:
    """Poses over time; `...` is the batch, empty for one.

    time_s            (M,)        from zero
    position_m        (..., M, 3)
    orientation_wxyz  (..., M, 4)
    """

    time_s: Array
    position_m: Array
    orientation_wxyz: Array


@dataclass(frozen=True, eq=False)
class _Responses:
    """What one motion is made of, at K integration steps of length `a` in units of tau.

    phase (K,), shape (K, 6) is the forcing term where s = 1 and b = 0; the others are the
    position over K + 1 steps that answers a unit start, the shape (three axes) and the phase.
    """

    a: float
    phase: Array
    shape: Array
    of_start: Array
    of_shape: Array
    of_phase: Array


def rollout(
    primitive: Primitive,
    h: float = 0.004,
    run_s: float | None = None,
    *,
    start_position_m: ArrayLike | None = None,
    start_orientation_wxyz: ArrayLike | None = None,
    goal_position_m: ArrayLike | None = None,
    goal_orientation_wxyz: ArrayLike | None = None,
    duration_s: float | None = None,
) -> Rollout:
    """The undisturbed motion sampled every `h` seconds for `run_s` (its duration, if None).

    Start and goal are as demonstrated where not given; each may carry a leading batch axis and
    they are broadcast against each other. `duration_s` scales time. The numbers are those of
    `step` fed with its own pose.

    Raises SkillError for a duration that is not positive.
    """
    duration = primitive.duration_s if duration_s is None else duration_s
    refuse_not_positive(np.array([duration, h]))
    tau = float(tau_of(duration))
    start, start_wxyz = start_pose(primitive, start_position_m, start_orientation_wxyz)
    goal, goal_wxyz = goal_pose(primitive, goal_position_m, goal_orientation_wxyz, start_wxyz)
    displacement = remaining(goal, goal_wxyz, start, start_wxyz)
    scale, hold = scale_and_hold(primitive, displacement)
    count = round((duration if run_s is None else run_s) / h)
    parts = substeps(primitive, np.array(tau), h)
    responses = _responses(primitive, h / parts / tau, count * parts)
    position = _positions(responses, goal, displacement, scale, hold, parts)
    wxyz = _orientations(primitive, responses, start_wxyz, goal_wxyz)[..., ::parts, :]
    batch = np.broadcast_shapes(position.shape[:-2], wxyz.shape[:-2])
    return Rollout(
        time_s=h * np.arange(count + 1, dtype=np.float64),
        position_m=np.broadcast_to(position, (*batch, count + 1, 3)),
        orientation_wxyz=np.broadcast_to(wxyz, (*batch, count + 1, 4)),
    )


def _responses(primitive: Primitive, a: float, count: int) -> _Responses:
    c = primitive.constants
    phase = np.exp(-c.alpha_x * a * np.arange(count))
    bumps = activations(phase, primitive.centres, primitive.widths)
    shape = phase[:, None] * (bumps @ primitive.weights)
    damping = 1.0 - a * c.alpha_z
    # A start at rest is a unit pulse, then one that stands for the same value before it.
    pulses = np.zeros((count + 1, 5))
    pulses[:2, 0] = (1.0, -damping)[: count + 1]
    pulses[1:, 1:4] = a * a * shape[:, :3]
    pulses[1:, 4] = a * a * phase
    recursion = [1.0, a * a * c.alpha_z * c.beta_z - 1.0 - damping, damping]
    out = np.asarray(lfilter([1.0], recursion, pulses, axis=0))
    return _Responses(a, phase, shape, out[:, :1], out[:, 1:4], out[:, 4:])


def _positions(
    responses: _Responses,
    goal: Array,
    displacement: Array,
    scale: Array,
    hold: Array,
    parts: int,
) -> Array:
    """Positions (..., M, 3): the goal, less what is left of the start, and the shape on top."""
    position = scale[..., None, :3] * responses.of_shape[::parts]
    position -= displacement[..., None, :3] * responses.of_start[::parts]
    if hold[..., :3].any():
        position -= hold[..., None, :3] * responses.of_phase[::parts]
    position += goal[..., None, :]
    return position


def _orientations(
    primitive: Primitive, responses: _Responses, start_wxyz: Array, goal_wxyz: Array
) -> Array:
    """Orientations (..., K + 1, 4), from what is left of the rotation at every step."""
    count = len(responses.phase)
    left = quaternions.product(goal_wxyz, quaternions.conjugate(start_wxyz))
    if not primitive.oriented:
        return np.broadcast_to(start_wxyz[..., None, :], (*left.shape[:-1], count + 1, 4))
    vector = quaternions.rotation_vector(left)
    displacement = np.concatenate((np.zeros_like(vector), vector), axis=-1)
    scale, hold = scale_and_hold(primitive, displacement)
    shape = np.expand_dims(responses.shape[:, 3:], tuple(range(1, left.ndim)))
    phase = np.expand_dims(responses.phase, tuple(range(1, left.ndim + 1)))
    force = np.moveaxis(shape * scale[..., 3:] - phase * hold[..., 3:], -1, 1)
    first = np.moveaxis(left, -1, 0)
    turns = np.empty((count + 1, *first.shape))
    turns[0] = first
    if left.ndim == 1:
        # One rollout goes through plain numbers: numpy takes many times as long for them.
        _turn(turns, first.tolist(), force.tolist(), responses.a, primitive.constants, math)
    else:
        _turn(turns, first, force, responses.a, primitive.constants, np)
    turned = np.moveaxis(turns, (0, 1), (-2, -1))
    return quaternions.product(quaternions.conjugate(turned), goal_wxyz[..., None, :])


def _turn(turns: Array, first: Any, steps: Any, a: float, c: Constants, m: Any) -> None:
    """Fill `turns` (K + 1, 4, ...) with goal * conj(orientation), step by step.

    Written by component, so that the same lines serve one rollout in plain numbers (`m` is math)
    and a batch in arrays (`m` is numpy). The tiny addends keep zero rotations from dividing by 0.
    """
    w, x, y, z = first
    p = q = r = 0.0
    damping, spring = 1.0 - a * c.alpha_z, a * c.alpha_z * c.beta_z
    for k, (force_x, force_y, force_z) in enumerate(steps, start=1):
        sine = m.sqrt(x * x + y * y + z * z)
        pull = spring * 2.0 * m.atan2(sine, w) / (sine + 1e-300)
        p = damping * p + pull * x + a * force_x
        q = damping * q + pull * y + a * force_y
        r = damping * r + pull * z + a * force_z
        half = 0.5 * a * m.sqrt(p * p + q * q + r * r)
        turn = 0.5 * a * m.sin(half) / (half + 1e-300)
        cosine, i, j, n = m.cos(half), turn * p, turn * q, turn * r
        w, x, y, z = (
            cosine * w + i * x + j * y + n * z,
            cosine * x - i * w - n * y + j * z,
            cosine * y - j * w + n * x - i * z,
            cosine * z - n * w - j * x + i * y,
        )
        turns[k] = w, x, y, z
