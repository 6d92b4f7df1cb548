"""When a contact change happened: at the step itself, or as the force leaves free space.

A step lies where the force changes fastest. A rise of some tenths of a second has no such place:
contact is made when it begins, and lost when a fall has ended. Where there is contact before and
after, the change lies in the middle. Where no view of contact as a state tells which side is free,
it lies where the force changes fastest, too.
"""

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices, whole_in
from keyphase.segmentation.evidence.force_curve import FINE, ForceCurves
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.rises import rises
from keyphase.segmentation.evidence.state_view import StateView

_STEP_REACH_S = 0.14
_STEP, _PART = 0.75, 0.3
"""A step is seen at the finest scale almost as large as over a quarter of a second, and is no small
part of a slow change on whose way it lies."""

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
    cell = _steepest(curves.step[0], at, whole_in(_STEP_REACH_S, grid.rate_hz))
    if len(view.crossings):
        # Here, over 0.12 and 0.24 s, and over the longer of both times in which ramps are seen.
        here, (short, long), slow = curves.step[0, cell], tops[1:FINE], tops[FINE:].max(axis=0)
        step = (here >= _STEP * long) & (short >= _PART * slow)
        cell = np.where(step, cell, _on_the_way(grid, view, begin, end))
    more = round(_LEAST_S * grid.rate_hz)
    first = np.minimum(np.minimum(begin, at), cell) - more
    last = np.maximum(np.maximum(end, at), cell) + more
    return cell, np.clip(np.column_stack([first, last]), 0, len(grid) - 1)


def _steepest(row: Array, at: Indices, reach: int) -> Indices:
    """Where a curve is highest near places (C,)."""
    cells = np.clip(at[:, None] + np.arange(-reach, reach + 1), 0, len(row) - 1)
    return cells[np.arange(len(at)), row[cells].argmax(axis=1)]


def _on_the_way(grid: Grid, view: StateView, begin: Indices, end: Indices) -> Indices:
    """The begin of a rise (C,) out of free space, the end of a fall back into it, else between."""
    away = np.arange(grid.cells(_LEVEL_S))
    last = len(grid) - 1
    before = np.median(view.distance[np.maximum(begin[:, None] - away, 0)], axis=1)
    after = np.median(view.distance[np.minimum(end[:, None] + away, last)], axis=1)
    made = before < _MADE * (before + after)
    lost = after < _LOST * (before + after)
    return np.where(made, begin, np.where(lost, end, (begin + end) // 2))
