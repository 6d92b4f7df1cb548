"""Step a primitive in real time with temporal coupling: it waits while the robot is held.

The law with two degrees of freedom of Karlsson et al. (2017), for position and orientation with
one error and one phase. With y_a measured, y_c the primitive's own state and v = z / tau_a:

    e' = alpha_e (W (y_a - y_c) - e)            W: 1 for metres, 0.2 m/rad for rotations
    tau_a = tau (1 + k_c e'e)                   replaces tau everywhere, the phase included
    y_c'' = (z' - tau_a' v) / tau_a             tau_a' = 2 tau k_c e'(de/dt)
    y_r'' = k_p (y_c - y_a) + k_v (v - y_a') + y_c''

y_r'' is integrated to the reference y_r for an impedance controller and kept within 10 mm and
0.05 rad of the measured pose, so that it neither runs away from a robot that is held nor pulls
harder than that.

Everything is a pure function over arrays; a leading batch axis steps many at once.
"""

from dataclasses import dataclass
from functools import cached_property
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from keyphase.demonstration import Array
from keyphase.errors import SkillError
from keyphase.rotations import quaternions, turns
from keyphase.rotations.components import (
    Components,
    chosen,
    components,
    dot,
    functions,
    joined,
    larger,
    number,
)
from keyphase.skills.changed import changed
from keyphase.skills.primitive import (
    Primitive,
    forces,
    remaining,
    scale_and_hold,
    tau_of,
    transformation,
)

MAX_STEP = 0.5
"""Largest alpha_z h / tau of one integration step; it is unstable above 1.66."""

REFERENCE_REACH = (0.01, 0.05)
"""How far the reference may be from the measured pose [m, rad]."""


@dataclass(frozen=True, eq=False)
class State:
    """Where a primitive is while it runs; `...` is the batch, empty for one.

    phase, tau                 (...)    from 1 towards 0; time constant [s]
    position_m                 (..., 3) y_c
    orientation_wxyz           (..., 4)
    z                          (..., 6) tau_a times its velocity
    error_m                    (..., 6) e, the coupling error
    goal_position_m            (..., 3) goal_orientation_wxyz (..., 4) alike
    scale, hold                (..., 6) s and b of the forcing term
    reference_position_m       (..., 3) y_r
    reference_orientation_wxyz (..., 4)
    reference_velocity         (..., 6) metres and radians per second
    """

    phase: Array
    tau: Array
    position_m: Array
    orientation_wxyz: Array
    z: Array
    error_m: Array
    goal_position_m: Array
    goal_orientation_wxyz: Array
    scale: Array
    hold: Array
    reference_position_m: Array
    reference_orientation_wxyz: Array
    reference_velocity: Array

    # What stays as it is while a primitive runs is taken apart once; `changed` hands it on.

    @cached_property
    def goal(self) -> Components:
        """`goal_position_m`, then `goal_orientation_wxyz`."""
        return [*components(self.goal_position_m), *components(self.goal_orientation_wxyz)]

    @cached_property
    def shaping(self) -> tuple[Components, Components]:
        """`scale` and `hold`."""
        return components(self.scale), components(self.hold)


@dataclass(frozen=True, eq=False)
class Measured:
    """Measured pose (..., 3), (..., 4) and velocity (..., 6) in m/s and rad/s, base frame."""

    position_m: Array
    orientation_wxyz: Array
    velocity: Array


@dataclass(frozen=True, eq=False)
class Reference:
    """What the impedance controller is to follow over the coming step, base frame.

    position_m (..., 3), orientation_wxyz (..., 4), velocity (..., 6) and acceleration (..., 6)
    in m and rad; the acceleration is the reference acceleration y_r'' before it is clamped.
    """

    position_m: Array
    orientation_wxyz: Array
    velocity: Array
    acceleration: Array


def start(
    primitive: Primitive,
    position_m: ArrayLike | None = None,
    orientation_wxyz: ArrayLike | None = None,
    *,
    goal_position_m: ArrayLike | None = None,
    goal_orientation_wxyz: ArrayLike | None = None,
    velocity: ArrayLike = 0.0,
    duration_s: ArrayLike | None = None,
) -> State:
    """State at the start; what is not given is as demonstrated, at rest.

    Any argument may carry a leading batch axis; they are broadcast against each other.
    `duration_s` scales time. Quaternion signs are chosen nearest to the demonstrated ones.

    Raises SkillError for a duration that is not positive.
    """
    position, wxyz = start_pose(primitive, position_m, orientation_wxyz)
    goal, goal_wxyz = goal_pose(primitive, goal_position_m, goal_orientation_wxyz, wxyz)
    duration = np.asarray(primitive.duration_s if duration_s is None else duration_s, float)
    refuse_not_positive(duration)
    vectors = (position, wxyz, goal, goal_wxyz, np.asarray(velocity))
    batch = np.broadcast_shapes(*(vector.shape[:-1] for vector in vectors), duration.shape)
    displacement = np.broadcast_to(remaining(goal, goal_wxyz, position, wxyz), (*batch, 6))
    scale, hold = scale_and_hold(primitive, displacement)
    tau = np.broadcast_to(tau_of(duration), batch)
    speed = np.broadcast_to(np.asarray(velocity, float), (*batch, 6))
    position = np.broadcast_to(position, (*batch, 3))
    wxyz = np.broadcast_to(wxyz, (*batch, 4))
    return State(
        phase=np.ones(batch),
        tau=tau,
        position_m=position,
        orientation_wxyz=wxyz,
        z=speed * tau[..., None],
        error_m=np.zeros((*batch, 6)),
        goal_position_m=np.broadcast_to(goal, (*batch, 3)),
        goal_orientation_wxyz=np.broadcast_to(goal_wxyz, (*batch, 4)),
        scale=scale,
        hold=hold,
        reference_position_m=position,
        reference_orientation_wxyz=wxyz,
        reference_velocity=speed,
    )


def start_pose(
    primitive: Primitive, position_m: ArrayLike | None, wxyz: ArrayLike | None
) -> tuple[Array, Array]:
    """The given pose, the demonstrated one where none is given, its sign as demonstrated."""
    position = primitive.start_position_m if position_m is None else np.asarray(position_m, float)
    if wxyz is None:
        return position, primitive.start_orientation_wxyz
    unit = np.asarray(wxyz, float)
    return position, quaternions.nearest_sign(unit, primitive.start_orientation_wxyz)


def goal_pose(
    primitive: Primitive, position_m: ArrayLike | None, wxyz: ArrayLike | None, start_wxyz: Array
) -> tuple[Array, Array]:
    """Like `start_pose` for the goal; without recorded orientation it is the start's own."""
    position = primitive.goal_position_m if position_m is None else np.asarray(position_m, float)
    if wxyz is not None:
        unit = np.asarray(wxyz, float)
        near = primitive.goal_orientation_wxyz if primitive.oriented else start_wxyz
        return position, quaternions.nearest_sign(unit, near)
    return position, primitive.goal_orientation_wxyz if primitive.oriented else start_wxyz


def step(
    primitive: Primitive, state: State, measured: Measured, h: float
) -> tuple[State, Reference]:
    """Advance by `h` seconds against the measured pose; the reference for that time.

    Splits the step where alpha_z h / tau would pass 0.5; the reference then has the mean of its
    accelerations, as a brief primitive takes up its speed within one. Semi-implicit: velocity, then
    pose.
    """
    parts, accelerations = substeps(primitive, state.tau, h), list[Components]()
    for _ in range(parts):
        state, now = _advance(primitive, state, measured, h / parts)
        accelerations.append(now)
    acceleration = [sum(each) / parts for each in zip(*accelerations, strict=True)]
    reference = _reference(state, measured, acceleration, h)
    followed = changed(
        state,
        reference_position_m=reference.position_m,
        reference_orientation_wxyz=reference.orientation_wxyz,
        reference_velocity=reference.velocity,
    )
    return followed, reference


def substeps(primitive: Primitive, tau: Array, h: float) -> int:
    """Integration steps that one control step needs to stay accurate."""
    ratio = primitive.constants.alpha_z * h / (tau.item() if tau.ndim == 0 else float(np.min(tau)))
    return max(1, ceil(ratio / MAX_STEP - 1e-9))


def _advance(
    primitive: Primitive, state: State, measured: Measured, h: float
) -> tuple[State, Components]:
    """One integration step; also the reference acceleration y_r'' at its beginning."""
    c = primitive.constants
    here, wxyz = components(state.position_m), components(state.orientation_wxyz)
    ahead = turns.difference(state.goal[3:], wxyz)
    left = [*_between(state.goal[:3], here), *ahead]
    force = forces(primitive, state.phase, *state.shaping)
    turn = turns.shortest_difference(components(measured.orientation_wxyz), wxyz)
    away = [*_between(components(measured.position_m), here), *turn]
    error, z, tau = components(state.error_m), components(state.z), number(state.tau)
    error_rate = [
        c.alpha_e * (weight * d - e)
        for weight, d, e in zip(c.error_weights, away, error, strict=True)
    ]
    tau_rate = 2.0 * c.k_c * tau * dot(error, error_rate)
    tau = tau * (1.0 + c.k_c * dot(error, error))
    z_rate = [transformation(c, u, v, f) / tau for u, v, f in zip(left, z, force, strict=True)]
    slowing = tau_rate / tau
    acceleration = [
        (rate - slowing * v) / tau + c.k_v * (v / tau - own) - c.k_p * d
        for rate, v, own, d in zip(z_rate, z, components(measured.velocity), away, strict=True)
    ]
    z = [v + h * rate for v, rate in zip(z, z_rate, strict=True)]
    share = h / tau
    moved = [share * v for v in z]
    decay = functions(tau).exp(-c.alpha_x * h / tau)
    advanced = changed(
        state,
        phase=np.asarray(number(state.phase) * decay),
        position_m=joined([y + d for y, d in zip(here, moved[:3], strict=True)]),
        orientation_wxyz=joined(turns.turned(wxyz, moved[3:])),
        z=joined(z),
        error_m=joined([e + h * rate for e, rate in zip(error, error_rate, strict=True)]),
    )
    return advanced, acceleration


def _between(to_m: Components, here: Components) -> Components:
    return [there - y for there, y in zip(to_m, here, strict=True)]


def _reference(state: State, measured: Measured, acceleration: Components, h: float) -> Reference:
    """Integrate y_r'' and keep the reference within reach of the measured pose."""
    rate = zip(components(state.reference_velocity), acceleration, strict=True)
    velocity = [v + h * a for v, a in rate]
    here, own = components(measured.position_m), components(measured.velocity)
    measured_wxyz = components(measured.orientation_wxyz)
    at = zip(components(state.reference_position_m), velocity[:3], here, strict=True)
    away, far = _within([y + h * v - m for y, v, m in at], REFERENCE_REACH[0])
    moved = [h * v for v in velocity[3:]]
    wxyz = turns.turned(components(state.reference_orientation_wxyz), moved)
    turn = turns.shortest_difference(wxyz, measured_wxyz)
    turn, far_turned = _within(turn, REFERENCE_REACH[1])
    clamped = zip((far,) * 3 + (far_turned,) * 3, own, velocity, strict=True)
    return Reference(
        position_m=joined([m + a for m, a in zip(here, away, strict=True)]),
        orientation_wxyz=joined(turns.turned(measured_wxyz, turn)),
        velocity=joined([chosen(*each) for each in clamped]),
        acceleration=joined(acceleration),
    )


def _within(vector: Components, reach: float) -> tuple[Components, Any]:
    """The vector shortened to `reach`, and whether it had to be."""
    squared = dot(vector, vector)
    norm = functions(squared).sqrt(squared)
    shorter = reach / larger(norm, reach)
    return [shorter * part for part in vector], norm > reach


def refuse_not_positive(duration_s: Array) -> None:
    """Raise SkillError unless every duration is a positive number."""
    if not (np.isfinite(duration_s).all() and (duration_s > 0.0).all()):
        raise SkillError(
            f"The duration of a skill must be above zero, but is {duration_s}; give seconds."
        )
