"""What skills press: read off the demonstration when a plan is made, so that nothing else needs it.

Where a contact was met and the demonstration stayed in it, the skill presses as hard, and the
skills that follow keep that force up as long as they were demonstrated doing so. Where the
demonstration came into a contact otherwise, within a skill or in a pause that was dropped, the
recorded state of contact tells where its force is to be followed.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.recorded_force import evenly, offset_while_moving
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.windows import AFTER_S, LAST_S
from keyphase.skills.followed import (
    MIN_FORCE_N,
    MIN_SLIDE_M,
    SLIDES_BELOW,
    before_contact,
    carried,
    followed_force,
    smoothed,
)
from keyphase.skills.precondition import precondition_of
from keyphase.skills.pressed import KeptForce, Press
from keyphase.skills.search import Search, search_for
from keyphase.skills.skill import Skill
from keyphase.skills.squaring import squaring_at

MAX_DEPTH_M, MAX_SLOPE = 0.005, 0.1
"""A contact is kept by a skill that moves less than this, or this part of its way, along it."""

STEEPEST = 0.4
"""Largest part of a way that may lie along a contact for the way to have slid on the surface."""

STAYED_WITHIN_M = 0.002
"""A demonstration that moved less than this after a contact stayed in it."""

SOFT_N_M = 2000.0
"""A contact whose force rises less steeply than this says little about where it is."""

SOFT_BEYOND_M = 0.003, 0.01
"""Out of a soft contact only what is more than its force took to rise, and more than this, counts
as a part that lies elsewhere; more than the second counts in any case."""

GRID = 51
"""Forces are kept at so many moments of a skill."""

_AGAINST_FORCE = 0.5
_ALIKE = 0.9
_HALF_STEP_S = 0.1


def with_contacts(demonstration: Demonstration, skills: Sequence[Skill]) -> tuple[Skill, ...]:
    """The plan's skills, each with what it presses at its end and keeps up on its way.

    A plan goes on only where its contacts were met, so what is kept follows from its order.
    """
    if demonstration.force_N is None:
        return tuple(replace(s, precondition=precondition_of(s.primitive, ())) for s in skills)
    free = offset_while_moving(evenly(demonstration))
    directions, done = list[Array](), list[Skill]()
    for skill in skills:
        kept = [kept_force(demonstration, skill, d) for d in directions]
        keeps = _dragged([force for force in kept if force is not None])
        directions = [force.direction[0] for force in keeps]
        if not keeps and (followed := followed_force(demonstration, skill, free)) is not None:
            keeps = (followed,)
        press = press_after(demonstration, skill, directions)
        if press is not None:
            directions.append(press.direction)
        beyond = shift_beyond(demonstration, skill, free)
        done.append(
            replace(
                skill,
                kept=keeps,
                press=press,
                shift_beyond_m=beyond,
                precondition=precondition_of(skill.primitive, keeps),
                search=_search(demonstration, skill, press),
            )
        )
    return tuple(
        _squared(demonstration, skill, done[place + 1 :]) for place, skill in enumerate(done)
    )


def _dragged(kept: Sequence[KeptForce]) -> tuple[KeptForce, ...]:
    """The forces kept; of several, what drags may be the friction of another, and none carries."""
    return tuple(kept) if len(kept) < 2 else tuple(replace(one, carries=None) for one in kept)


def _squared(demonstration: Demonstration, skill: Skill, following: Sequence[Skill]) -> Skill:
    """The skill with a squaring, if it puts a part on what a later one carries along.

    A seat that is told by its depth has no play. What is put down at a slant is then pressed
    square to the place: shaken, it would creep along with whatever it lies on. What was held
    aside as it was put down leant against something: it has no play either, and pressed square to
    the place it would slip off.
    """
    if skill.press is None or skill.search is not None or skill.kept:
        return skill
    for later in following:
        alike = [k for k in later.kept if k.direction[0] @ skill.press.direction > _ALIKE]
        carrying = [kept.direction[0] for kept in alike if kept.carries is not None]
        if carrying:
            if _leans(demonstration, skill, carrying[0]):
                return skill
            way = later.end_position_m - later.primitive.start_position_m
            at = squaring_at(carrying[0], skill.end_orientation_wxyz, way)
            return replace(skill, squaring=at, press=replace(skill.press, direction=carrying[0]))
        if not alike:
            break
    return skill


def _leans(demonstration: Demonstration, skill: Skill, normal: Array) -> bool:
    """Whether a part that was put down was pushed aside by more than slides on the place."""
    assert skill.demonstrated_s is not None
    assert demonstration.force_N is not None
    end_s = skill.demonstrated_s[1]
    after = demonstration.force_N[_inside(demonstration, (end_s + AFTER_S[0], end_s + AFTER_S[1]))]
    force = after.mean(axis=0) if len(after) else np.zeros(3)
    pressed = -float(force @ normal)
    return float(np.linalg.norm(force + pressed * normal)) > SLIDES_BELOW * pressed


def _search(demonstration: Demonstration, skill: Skill, press: Press | None) -> Search | None:
    if skill.demonstrated_s is None:
        return None
    return search_for(demonstration, skill.demonstrated_s[1], press)


def pressing_direction(skill: Skill) -> Array:
    """Unit vector (3,) in which a contact-terminated skill presses.

    That of its travel, as friction tilts the force; but where the travel does not go against the
    force at all, against the force.
    """
    assert isinstance(skill.end_condition, ContactEnd)
    against = -np.asarray(skill.end_condition.direction)
    travel = against if skill.travel_direction is None else np.asarray(skill.travel_direction)
    return travel if float(travel @ against) > _AGAINST_FORCE else against


def press_after(
    demonstration: Demonstration, skill: Skill, kept: Sequence[Array] = ()
) -> Press | None:
    """How the demonstration pressed right after the contact that ends a skill.

    None where it moved on in that direction, or the contact lies in those that are `kept` already.
    Judged over the time that its end condition's force step was, too.
    """
    if skill.demonstrated_s is None or not isinstance(skill.end_condition, ContactEnd):
        return None
    direction, end_s = pressing_direction(skill), skill.demonstrated_s[1]
    inside = _inside(demonstration, (end_s + AFTER_S[0], end_s + AFTER_S[1]))
    if inside.stop <= inside.start:
        inside = _inside(demonstration, (end_s + LAST_S[0], end_s))
    path, force = demonstration.position_m[inside], demonstration.force_N
    if force is None or not len(path):
        return None
    own = square(direction, kept)
    if own is None or float(np.ptp(path @ direction)) > STAYED_WITHIN_M:
        return None
    # What is kept up presses, too: only what lies in this direction is its own.
    pressed = -float((force[inside] @ own).mean())
    return Press(own, pressed, path.mean(axis=0)) if pressed >= MIN_FORCE_N else None


def kept_force(demonstration: Demonstration, skill: Skill, direction: Array) -> KeptForce | None:
    """The force that a skill was demonstrated keeping up in a contact that was met before.

    None where it did not press (0.5 N in the median), or moved along the contact's direction (3,).
    """
    if skill.demonstrated_s is None or demonstration.force_N is None:
        return None
    inside = _inside(demonstration, skill.demonstrated_s)
    own = _off_the_way(direction, demonstration.position_m[inside])
    if own is None:
        return None
    force = -(demonstration.force_N[inside] @ own)
    if float(np.median(force)) < MIN_FORCE_N:
        return None
    smooth = smoothed(force, demonstration.rate_hz)
    grid = np.linspace(0, len(smooth) - 1, GRID)
    profile = np.interp(grid, np.arange(len(smooth)), smooth)
    rows = _inside(demonstration, before_contact(skill))
    carries = carried(
        demonstration.force_N[rows], demonstration.position_m[rows], own, demonstration.rate_hz
    )
    return KeptForce(np.tile(own, (GRID, 1)), np.maximum(profile, MIN_FORCE_N), carries=carries)


def square(direction: Array, others: Sequence[Array]) -> Array | None:
    """The direction (3,) at right angles to `others`; None if it lies in them.

    Forces along directions at right angles do not disturb each other.
    """
    for other in others:
        direction = direction - float(direction @ other) * other
    length = float(np.linalg.norm(direction))
    return direction / length if length > _AGAINST_FORCE else None


def shift_beyond(demonstration: Demonstration, skill: Skill, free_N: Array) -> float | None:
    """How much must be missing for a contact that is met elsewhere to shift what follows [m].

    Nothing for a stiff contact; for a soft one that the tool came to through free space 3 mm, or
    the way over which its force rose, as a slower tool sinks in further; None for a soft one out of
    another contact, and for a release: the tool sinks in, or slips, however it was pressed.
    """
    end = skill.end_condition
    if skill.demonstrated_s is None or not isinstance(end, ContactEnd):
        return 0.0
    if end.release:
        return None
    stiffness, rose_N = _stiffness(demonstration, skill)
    if stiffness > SOFT_N_M:
        return 0.0
    assert demonstration.force_N is not None
    inside = demonstration.force_N[_inside(demonstration, skill.demonstrated_s)]
    before = np.linalg.norm(inside - free_N, axis=1)
    free = len(before) and float(np.median(before)) < max(MIN_FORCE_N, end.threshold_N)
    least_m, most_m = SOFT_BEYOND_M
    return min(max(least_m, rose_N / max(stiffness, 1.0)), most_m) if free else None


def _stiffness(demonstration: Demonstration, skill: Skill) -> tuple[float, float]:
    """How steeply the force rose with the way into the contact [N/m], and by how much [N]."""
    assert skill.demonstrated_s is not None
    assert demonstration.force_N is not None
    direction, end_s = pressing_direction(skill), skill.demonstrated_s[1]
    inside = _inside(demonstration, (end_s - 3.0 * _HALF_STEP_S, end_s + AFTER_S[1]))
    force = -(demonstration.force_N[inside] @ direction)
    depth = demonstration.position_m[inside] @ direction
    if len(force) < 3:
        return 0.0, 0.0
    low, high = np.quantile(force, [0.05, 0.95])
    rising = (force > low + 0.2 * (high - low)) & (force < low + 0.8 * (high - low))
    way = float(np.ptp(depth[rising])) if rising.any() else 0.0
    return 0.6 * float(high - low) / max(way, 1e-6), float(high - low)


def _off_the_way(direction: Array, path: Array) -> Array | None:
    """The direction of a contact, made square to a way along its surface; None if it left it.

    The way that was slid tells the surface better than the way into the contact does.
    """
    if len(path) < 2:
        return None
    slid = path[-1] - path[0]
    length = float(np.linalg.norm(slid))
    if length > MIN_SLIDE_M:
        slope = float(direction @ slid) / length
        if abs(slope) > STEEPEST:
            return None
        direction = direction - slope * slid / length
        direction = direction / np.linalg.norm(direction)
    way = float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())
    deep = float(np.ptp(path @ direction)) > max(MAX_DEPTH_M, MAX_SLOPE * way)
    return None if deep else direction


def _inside(demonstration: Demonstration, span_s: tuple[float, float]) -> slice:
    first, last = np.searchsorted(demonstration.time_s, span_s).tolist()
    return slice(first, last)
