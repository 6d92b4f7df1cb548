"""What a recording with known truth teaches: candidates with their evidence, and the events."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.evidence.contact_terms import contact_candidates
from keyphase.segmentation.evidence.grid import grid_of
from keyphase.segmentation.evidence.motion_terms import motion_candidates
from keyphase.segmentation.evidence.speed import speed_of
from keyphase.segmentation.evidence.tool import without_tool
from keyphase.segmentation.motion import motion_of

SERVED_S = 0.4
"""Motion nearer than this to a contact change is part of it, and neither right nor wrong."""

SLOW_S = 0.3
"""An event with a wider window is a ramp, which the line of steps need not find."""

_NEARER = 0.5

Labels = NDArray[np.int8]
"""1 an event, 0 none, -1 unknown, 2 a slow event."""


@dataclass(frozen=True, eq=False)
class Truth:
    """What is true of a recording: events (E,) ascending with windows (E, 2), before and after.

    contact (E,)  which of them are contact changes
    ignore, ignore_motion (I, 2)  where candidates, and those of motion, are neither right nor wrong
    """

    time_s: Array
    window_s: Array
    contact: NDArray[np.bool_]
    ignore: Array
    ignore_motion: Array


@dataclass(frozen=True, eq=False)
class Side:
    """One kind of candidates of one recording: times (C,), where they were seen (C,), terms
    (C, T), and its events."""

    time_s: Array
    seen_s: Array
    terms: Array
    event_s: Array
    window_s: Array
    unknown: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Taught:
    """A recording of a family, as both lines see it."""

    family: str
    contact: Side
    motion: Side


def taught(family: str, demonstration: Demonstration, truth: Truth) -> Taught:
    """Look at every candidate of a recording."""
    motion = motion_of(demonstration)
    grid = grid_of(demonstration, motion)
    speed = speed_of(grid)
    grid = without_tool(grid, speed)
    touches, moves = contact_candidates(grid, speed), motion_candidates(grid, speed)
    cells = np.arange(len(grid))
    touch_s = grid.time_s[touches.cell]
    move_s = np.interp(moves.cell, cells, grid.time_s)
    beside = truth.time_s[truth.contact]
    served = np.column_stack([beside - SERVED_S, beside + SERVED_S])
    both = np.vstack([truth.ignore, truth.ignore_motion, served])
    return Taught(
        family,
        _side(
            touch_s, grid.time_s[touches.seen], touches.terms, truth, truth.contact, truth.ignore
        ),
        _side(move_s, move_s, moves.terms, truth, ~truth.contact, both),
    )


def _side(
    time_s: Array,
    seen_s: Array,
    terms: Array,
    truth: Truth,
    chosen: NDArray[np.bool_],
    ignore: Array,
) -> Side:
    unknown = np.zeros(len(time_s), dtype=bool)
    for low, high in ignore:
        unknown |= (time_s >= low) & (time_s <= high)
    return Side(time_s, seen_s, terms, truth.time_s[chosen], truth.window_s[chosen], unknown)


def labels(side: Side, odds: Array) -> Labels:
    """Which candidates are events: in each window the likeliest and nearest one.

    Others in a window are unknown: they are duplicates, which the choice sorts out.
    """
    found = np.where(side.unknown, -1, 0).astype(np.int8)
    used = np.zeros(len(odds), dtype=bool)
    for event, (before, after) in zip(side.event_s, side.window_s, strict=True):
        inside = np.flatnonzero(
            (side.time_s >= event - before) & (side.time_s <= event + after) & ~used
        )
        if not len(inside):
            continue
        off = np.abs(side.time_s[inside] - event) / max(before, after)
        best = inside[np.argmax(odds[inside] - _NEARER * off)]
        found[inside[found[inside] == 0]] = -1
        found[best] = 2 if max(before, after) > SLOW_S else 1
        used[best] = True
    return found


def right(side: Side, scores: Array) -> Labels:
    """Which chosen candidates are right (1) or wrong (0), from the likeliest down, one per event.

    -1 where nobody knows, and for candidates that were not chosen.
    """
    found = np.full(len(scores), -1, dtype=np.int8)
    taken = np.zeros(len(side.event_s), dtype=bool)
    for index in np.argsort(-scores, kind="stable"):
        if not np.isfinite(scores[index]):
            break
        off = side.time_s[index] - side.event_s
        fits = (off >= -side.window_s[:, 0]) & (off <= side.window_s[:, 1]) & ~taken
        if fits.any():
            taken[int(np.argmin(np.where(fits, np.abs(off), np.inf)))] = True
            found[index] = 1
        elif not side.unknown[index]:
            found[index] = 0
    return found
