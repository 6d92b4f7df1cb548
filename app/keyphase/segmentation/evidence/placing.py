"""When a contact change happened: at the step itself, or as the force leaves free space.

A step lies halfway between where its rise begins and where the force changes fastest, and half of
a step back into free space between there and where its fall has ended. A rise of some tenths of a
second has no fastest place: contact is made when it begins, and lost when a fall has ended. Where
there is contact before and after, the change lies in the middle. Where no view of contact as a
state tells which side is free, every change lies where the force changes fastest.
"""

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices, whole_in
from keyphase.segmentation.evidence.force_curve import FINE, ForceCurves
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.rises import rises
from keyphase.segmentation.evidence.state_view import StateView

_STEP_REACH_S = 0.14
_HALFWAY, _AT_MOST_S = 0.5, 0.1
"""A step lies this far from its fastest place towards its begin or end, and no further than that: a
step on the way of a slow rise stays on it."""
_STEP, _PART = 0.75, 0.3
"""A step is seen at the finest scale almost as large as over a quarter of a second, and is no small
part of a slow change on whose way it lies."""

_RISE_S, _LARGER = 0.2, 1.5
"""Within a rise no longer than this a step so many times as large, further off than a step is
sought, is the change itself: a touch and the snap that follows it at once are one."""

_LEVEL_S = 0.2
_LEAST_S = 0.04

_MADE, _LOST = 0.4, 0.15
"""Shares of the distance from free space before and after a change that the distance before, or
after it, may have: a hand that lets go is gone at once, one that touches may have begun to lean."""


def placed(
    grid: Grid, curves: ForceCurves, view: StateView, at: Indices, tops: Array
) -> tuple[Indices, Indices]:
    """The cell (C,) of each change, and the first and last (C, 2) it may have been.

    tops (5, C) are the largest steps near each at every scale.
    """
    begin, end = rises(grid, at)
    cell = _fastest(curves.step[0], at, begin, end, grid.rate_hz)
    if len(view.crossings):
        # Here, over 0.12 and 0.24 s, and over the longer of both times in which ramps are seen.
        here, (short, long), slow = curves.step[0, cell], tops[1:FINE], tops[FINE:].max(axis=0)
        step = (here >= _STEP * long) & (short >= _PART * slow)
        made, lost = _free_sides(grid, view, begin, end)
        halfway = _halfway(cell, np.where(lost, end, begin), _AT_MOST_S * grid.rate_hz)
        rise = np.where(made, begin, np.where(lost, end, (begin + end) // 2))
        cell = np.where(step, halfway, rise)
    more = round(_LEAST_S * grid.rate_hz)
    first = np.minimum(np.minimum(begin, at), cell) - more
    last = np.maximum(np.maximum(end, at), cell) + more
    return cell, np.clip(np.column_stack([first, last]), 0, len(grid) - 1)


def _halfway(steepest: Indices, edge: Indices, at_most: float) -> Indices:
    """Between the fastest places (C,) of steps and their edges (C,), at most so many cells off."""
    off = np.clip(_HALFWAY * (edge - steepest), -at_most, at_most)
    return steepest + np.round(off).astype(np.intp)


def _fastest(row: Array, at: Indices, begin: Indices, end: Indices, rate_hz: float) -> Indices:
    """Where the force changes fastest near places (C,), or in the short rise they belong to."""
    near = _steepest(row, at, whole_in(_STEP_REACH_S, rate_hz))
    cells = np.arange(whole_in(_RISE_S, rate_hz) + 1)
    inside = np.minimum(begin[:, None] + cells, np.maximum(end, begin)[:, None])
    within = inside[np.arange(len(at)), row[inside].argmax(axis=1)]
    short = end - begin <= _RISE_S * rate_hz
    return np.where(short & (row[within] >= _LARGER * row[near]), within, near)


def _steepest(row: Array, at: Indices, reach: int) -> Indices:
    """Where a curve is highest near places (C,)."""
    cells = np.clip(at[:, None] + np.arange(-reach, reach + 1), 0, len(row) - 1)
    return cells[np.arange(len(at)), row[cells].argmax(axis=1)]


def _free_sides(
    grid: Grid, view: StateView, begin: Indices, end: Indices
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which rises (C,) come out of free space, and which fall back into it."""
    away = np.arange(grid.cells(_LEVEL_S))
    last = len(grid) - 1
    before = np.median(view.distance[np.maximum(begin[:, None] - away, 0)], axis=1)
    after = np.median(view.distance[np.minimum(end[:, None] + away, last)], axis=1)
    made = before < _MADE * (before + after)
    return made, (after < _LOST * (before + after)) & ~made
