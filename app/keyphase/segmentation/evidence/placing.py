"""When a contact change happened: at the step itself, or where a ramp leaves or reaches a level."""

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.force_curve import ForceCurves
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.state_view import StateView

_STEP_REACH_S = 0.1
_RAMP_REACH_S = 1.0
_LEVEL_S = 0.3
_STATE_REACH_S = 1.5
_STATE_NEAR_S = 0.5


def placed(
    grid: Grid, curves: ForceCurves, view: StateView, at: Indices, tops: Array
) -> tuple[Indices, Indices]:
    """The cell (C,) of each change, and the first and last (C, 2) it may have been.

    tops (5, C) are the largest steps near each at every scale: one that is much smaller at the
    fine scales is a ramp.
    """
    ramp = tops[1] < 0.5 * np.maximum(tops[3], tops[4])
    slow = ramp & (tops[1] < 0.5 * tops[4]) & (tops[3] < 0.85 * tops[4])
    cell = _steepest(curves.step[0], at, int(_STEP_REACH_S * grid.rate_hz))
    for index in np.flatnonzero(ramp):
        place = _leaving_core(grid, view, int(at[index])) if slow[index] else None
        cell[index] = _ramp(grid, int(at[index])) if place is None else place
    reach = np.where(slow, 0.5, np.where(ramp, 0.25, 0.04)) * grid.rate_hz
    reach = np.maximum(reach, np.abs(cell - at)).astype(np.intp)
    last = len(grid) - 1
    interval = np.column_stack([np.maximum(cell - reach, 0), np.minimum(cell + reach, last)])
    return cell, interval


def _steepest(row: Array, at: Indices, reach: int) -> Indices:
    around = np.arange(-max(1, reach), max(1, reach) + 1)
    cells = np.clip(at[:, None] + around, 0, len(row) - 1)
    return cells[np.arange(len(at)), row[cells].argmax(axis=1)]


def _ramp(grid: Grid, at: int) -> int:
    """Where the force leaves a quiet level, or has come to rest on one; else the candidate.

    Levels are the medians of 0.3 s on both ends of the two seconds around it.
    """
    assert grid.wrench is not None
    reach, level = int(_RAMP_REACH_S * grid.rate_hz), max(3, int(_LEVEL_S * grid.rate_hz))
    first, last = max(0, at - reach), min(len(grid), at + reach)
    before = grid.wrench[max(0, first - level) : first]
    after = grid.wrench[last : last + level]
    if min(len(before), len(after)) < max(3, level // 2):
        return at
    (low, low_scatter), (high, high_scatter) = _level(before), _level(after)
    jump = float(np.linalg.norm(high - low))
    quieter, busier = sorted((low_scatter, high_scatter))
    if quieter > 0.15 * jump or busier < 2.0 * quieter:
        return at
    if low_scatter < high_scatter:
        distance = np.linalg.norm(grid.wrench[first : at + 1] - low, axis=1)
        level_cells = np.flatnonzero(distance <= max(0.03 * jump, 3.0 * low_scatter))
        return min(at, first + int(level_cells[-1]) + 1) if len(level_cells) else at
    if high_scatter > 0.03:
        return at
    distance = np.linalg.norm(grid.wrench[at:last] - high, axis=1)
    level_cells = np.flatnonzero(distance <= max(0.03 * jump, 3.0 * high_scatter))
    return min(len(grid) - 1, at + int(level_cells[0])) if len(level_cells) else at


def _level(wrench: Array) -> tuple[Array, float]:
    level = np.median(wrench, axis=0)
    return level, float(np.quantile(np.linalg.norm(wrench - level, axis=1), 0.9))


def _leaving_core(grid: Grid, view: StateView, at: int) -> int | None:
    """Where a slow ramp leaves free space, or is back in it; None where neither side is free."""
    far, near = int(_STATE_REACH_S * grid.rate_hz), int(_STATE_NEAR_S * grid.rate_hz)
    distance = view.distance
    first, last = max(0, at - far), min(len(grid), at + far)
    before, after = distance[first : max(first + 1, at - near)], distance[at + near : last]
    if not len(after):
        after = distance[-1:]
    low, high = float(np.median(before)), float(np.median(after))
    edge = max(2.5 * view.core_spread, 0.1 * max(low, high))
    if not min(low, high) < edge < 0.7 * max(low, high):
        return None
    if low < high:
        inside = np.flatnonzero(distance[first : min(at + near + 1, last)] <= edge)
        return min(first + int(inside[-1]) + 1, len(grid) - 1) if len(inside) else None
    start = max(first, at - near)
    inside = np.flatnonzero(distance[start:last] <= edge)
    return start + int(inside[0]) if len(inside) else None
