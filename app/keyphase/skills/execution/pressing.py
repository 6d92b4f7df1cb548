"""Following a force where one is kept up, and the primitive's pose everywhere else.

A recorded pose lies on the surface that was touched; the force with which the hand pressed is in
the recorded force alone. Along the direction of a contact the demonstrated force is therefore
followed, and everywhere else the demonstrated pose.
"""

from collections.abc import Sequence
from math import sqrt

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.changed import changed
from keyphase.skills.coupling import Measured, Reference, State
from keyphase.skills.pressed import KeptForce
from keyphase.skills.skill import Skill

MAX_DISTANCE_M = 0.01
"""How far beyond the skill's own path a contact is followed."""

TOUCHING_N = 0.5
"""A force above this is a touch."""

FIRMER = 3.0
"""What is carried along is gripped at most so many times as hard as demonstrated."""

PUSHED_S = 0.1
"""What is exerted besides comes and goes within this time, so that a touch does not jerk."""

DRAGGED_S = 0.1
"""A force that drags is averaged over this time, so that a blow is not gripped against."""

GRIPPED_BELOW = 0.9
"""Part of a skill's force limit up to which gripping harder may bring the whole force."""

HEAVY, HEAVY_M_S = 2.0, 0.010
"""What is carried along is heavy once it drags so many times as much as demonstrated; from then on
it is pushed no faster than this, so that little is needed besides what overcomes its friction."""

Pressed = tuple[Array, float]
"""Direction (3,) and force [N]."""


def pressed_now(
    skill: Skill, fraction: float, force_N: Array, dragged_N: Array | None = None
) -> list[Pressed]:
    """What is to be pressed at a fraction of the demonstrated time, under a measured force (3,).

    `dragged_N` (3,) is the force that tells how much what is carried drags, the measured one if
    None.
    """
    averaged = force_N if dragged_N is None else dragged_N
    touching = float(force_N.dot(force_N)) > TOUCHING_N**2
    now = ((each, each.at(fraction)) for each in skill.kept if each.met or touching)
    most_N = GRIPPED_BELOW * skill.force_limit_N
    return [
        _gripped(each, one, (averaged, force_N), most_N) for each, one in now if one is not None
    ]


def pushed_now(skill: Skill, fraction: float, force_N: Array) -> Array:
    """What is exerted besides (3,) at a fraction of the demonstrated time, in a touch [N]."""
    pushed = np.zeros(3)
    if float(force_N.dot(force_N)) > TOUCHING_N**2:
        for each in skill.kept:
            if (one := each.pushed_at(fraction)) is not None:
                pushed = pushed + one
    return pushed


def _gripped(
    kept: KeptForce, now: Pressed, forces_N: tuple[Array, Array], most_N: float
) -> Pressed:
    """What is pressed, as much harder as what is carried drags more than demonstrated.

    Not so hard that the whole force would come to more than `most_N`. The forces (3,) are averaged
    and as measured: the press grows with the first, and stays below what either leaves.
    """
    if kept.carries is None:
        return now
    direction, pressed = now
    drags, at_once = (_aside(force, direction) for force in forces_N)
    left = sqrt(max(most_N**2 - max(drags, at_once) ** 2, 0.0))
    return direction, max(pressed, min(drags / kept.carries, FIRMER * pressed, left))


def _aside(force_N: Array, direction: Array) -> float:
    """Size of the part of a force (3,) at right angles to a direction (3,)."""
    aside = force_N - float(force_N.dot(direction)) * direction
    return sqrt(float(aside.dot(aside)))


def is_heavy(skill: Skill, fraction: float, force_N: Array) -> bool:
    """Whether what a skill carries along drags far more than demonstrated, under a force (3,)."""
    for kept in skill.kept:
        if kept.carries is not None and (one := kept.at(fraction)) is not None:
            direction, pressed = one
            if _aside(force_N, direction) > HEAVY * kept.carries * pressed:
                return True
    return False


def given_way(measured: Measured, state: State, pressed: Sequence[Pressed]) -> Measured:
    """What was measured, with the primitive's own motion along what is pressed.

    Where a force is followed, the pose is whatever it is, and no error of the coupling.
    """
    if not pressed:
        return measured
    position, velocity = measured.position_m, measured.velocity.copy()
    for d, _ in pressed:
        position = position + float((state.position_m - position).dot(d)) * d
        velocity[:3] += float((state.reference_velocity[:3] - velocity[:3]).dot(d)) * d
    return Measured(position, measured.orientation_wxyz, velocity)


def pressing(
    reference: Reference, position_m: Array, pressed: Sequence[Pressed], stiffness_N_m: float
) -> Reference:
    """The reference with the spring pressed as wanted for a tool at `position_m` (3,).

    Along what is pressed it moves as the skill does; a surface that falls away is not followed
    further than 10 mm beyond the skill's own path.
    """
    if not pressed:
        return reference
    at = reference.position_m
    for d, force in pressed:
        here = float(position_m.dot(d)) + force / stiffness_N_m
        wanted = min(here, float(reference.position_m.dot(d)) + MAX_DISTANCE_M)
        at = at + (wanted - float(at.dot(d))) * d
    return changed(reference, position_m=at)


def still(position_m: Array, orientation_wxyz: Array) -> Reference:
    """The reference that keeps a tool at a pose."""
    return Reference(position_m, orientation_wxyz, np.zeros(6), np.zeros(6))
