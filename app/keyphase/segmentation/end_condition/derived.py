"""An end condition derived from what the demonstrated force did, and tried on its demonstration.

The end condition belongs to the contact, the boundary says where to cut. So the step of the force
is taken where it changed, near the boundary, and made square to what was pressed already: a hand
that presses harder or less while it meets a wall would tilt it. Where the demonstration does not
end at what comes of it, the boundary's own step is tried, then others near by.
"""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition.agreement import DRAGGED_S, WITHIN_S, OwnDemonstration
from keyphase.segmentation.end_condition.force_step import (
    ForceStep,
    contact_event_s,
    force_step,
)
from keyphase.segmentation.end_condition.values import ConfigurationEnd, ContactEnd, EndCondition
from keyphase.segmentation.free_force import free_force

STEP_FRACTION = 0.5
"""Part of the demonstrated force step that has to be passed again."""

NOISE_FACTOR = 5.0
"""A threshold is never below this many standard deviations of the force before the change."""

MIN_STEP_N = 0.3
"""A force that changes by less than this is one no robot ends a motion at: a hand that waits sways
by as much, and a threshold of half of it lies in what other sensors call noise."""

MAX_THRESHOLD_N = 1e9
"""Beyond this it is no force of this world."""

LAST_STEP_N = 1.0
LAST_NOISE_FACTOR = 8.0
"""A recording ends in a contact if its force ends changed by this much, and by this many standard
deviations of the force before; whether it would stay changed cannot be seen."""

KEPT_N = 0.5
"""A force before the change that is less than this, its friction aside, presses nothing."""

MIN_SQUARE = 0.5
"""A change of which less than this part is square to what was pressed is a change of the press."""

ALONG_THE_WAY = 0.3
"""A force that changes towards where the tool goes does not stand in its way."""

RELEASED = 0.5
"""A force of which less than this part is left has ended."""

AT_CONTACT_S = 0.1
"""The condition of such a boundary is found so near to its contact."""

_SEARCH_S = 0.05
_FACTORS = (1.0, 0.7, 1.4)
_GOOD_ENOUGH_S = 0.06


def end_condition_at(
    demonstration: Demonstration,
    start_s: float,
    end_s: float,
    contact_change: bool,
    free_N: Array | None = None,
) -> EndCondition:
    """End condition of the segment from `start_s` to `end_s`, from the force around its end.

    A contact change gives a ContactEnd along the demonstrated change of the mean force, its
    threshold half that change but at least five standard deviations of the force before; it
    `agrees` if the demonstration ends at it. Without a contact change, without recorded force, or
    where the force did not change at all (a change of torque alone) or beyond any sense, it is
    the default ConfigurationEnd. `free_N` (3,): the force in free space, where it is known.
    """
    if not contact_change or demonstration.force_N is None:
        return ConfigurationEnd()
    free = free_force(demonstration) if free_N is None else free_N
    own = OwnDemonstration.of(demonstration, start_s, end_s)
    event_s = contact_event_s(demonstration, start_s, end_s)

    def at(moment_s: float, square: bool = True) -> ContactEnd | None:
        step = force_step(demonstration, start_s, moment_s)
        return _contact_end(step, own.way, free, square)

    found = at(event_s) or at(end_s)
    if found is None:
        return ConfigurationEnd()
    if own.misses_by(found) < WITHIN_S:
        return replace(found, agrees=True)
    moments = _moments(end_s, start_s)
    best = _best(own, (at(moment, square) for moment in moments for square in (True, False)))
    if best is not None:
        return replace(best, agrees=True)
    # A boundary that a person dragged a little still has its contact.
    dragged = abs(event_s - end_s) <= DRAGGED_S
    return replace(found, agrees=dragged and own.misses_by(found, event_s) < AT_CONTACT_S)


def ends_in_contact(demonstration: Demonstration, start_s: float) -> bool:
    """Whether the recording breaks off in a contact change within its last moments.

    No boundary can say so, as none lies that close to an end. The last segment starts at
    `start_s`; the force before it does not count.
    """
    if demonstration.force_N is None:
        return False
    step = force_step(demonstration, start_s, demonstration.end_s)
    size = float(np.linalg.norm(step.change))
    noise = step.noise_along(step.change / max(size, 1e-300))
    return size > max(LAST_STEP_N, LAST_NOISE_FACTOR * noise)


def _contact_end(
    step: ForceStep, way: Array | None, free_N: Array, square: bool
) -> ContactEnd | None:
    """The end condition of a force step; None where there is none."""
    change = _square_to_pressed(step, way, free_N) if square else step.change
    size = float(np.sqrt(change @ change))
    if not size > MIN_STEP_N:
        return None
    direction = change / size
    threshold = max(STEP_FRACTION * size, NOISE_FACTOR * step.noise_along(direction))
    if not threshold < MAX_THRESHOLD_N:
        return None
    x, y, z = direction.tolist()
    return ContactEnd((x, y, z), threshold, release=_is_release(step, way, free_N))


def _square_to_pressed(step: ForceStep, way: Array | None, free_N: Array) -> Array:
    """The change (3,) without what lies along a force that was pressed before.

    What was pressed is the force before, but for friction, which lies along the way.
    """
    change, pressed = step.change, step.before_N - free_N
    if way is not None:
        pressed = pressed - float(pressed @ way) * way
    size = float(np.linalg.norm(pressed))
    noise = float(np.sqrt(np.trace(step.noise_N)))
    if size < max(KEPT_N, noise):
        return change
    square = change - float(change @ pressed) * pressed / size**2
    lasting = float(np.linalg.norm(square)) > MIN_SQUARE * float(np.linalg.norm(change))
    return square if lasting else change


def _is_release(step: ForceStep, way: Array | None, free_N: Array) -> bool:
    """Whether the force falls: along the way, or to less than half of what it was."""
    before, after = step.before_N - free_N, step.after_N - free_N
    was, is_left = float(np.linalg.norm(before)), float(np.linalg.norm(after))
    size = float(np.linalg.norm(step.change))
    if is_left >= was or was < KEPT_N:
        return False
    along = way is not None and float(step.change @ way) > ALONG_THE_WAY * size
    return along or is_left < RELEASED * was


def _best(own: OwnDemonstration, ends: Iterator[ContactEnd | None]) -> ContactEnd | None:
    """Of the conditions, at lower and higher thresholds too, what ends the demonstration best."""
    best, least = None, WITHIN_S
    for end in ends:
        if end is None:
            continue
        for factor in _FACTORS:
            scaled = replace(end, threshold_N=factor * end.threshold_N)
            misses = own.misses_by(scaled)
            if misses < least:
                best, least = scaled, misses
        if least < _GOOD_ENOUGH_S:
            break
    return best


def _moments(end_s: float, start_s: float) -> list[float]:
    """Moments up to 0.25 s from the boundary, the nearest first."""
    count = round(WITHIN_S / _SEARCH_S)
    offsets = sorted(range(-count, count + 1), key=abs)
    moments = [end_s + _SEARCH_S * offset for offset in offsets]
    return [moment for moment in moments if moment == end_s or moment > start_s + WITHIN_S]
