"""When a contact change happened: at the step itself, or where a ramp leaves or reaches a level."""

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.force_curve import ForceCurves
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.state_view import StateView

_STEP_REACH_S = 0.16
_RAMP_REACH_S = 1.0
_LEVEL_S = 0.3
_STATE_REACH_S = 1.5
_STATE_NEAR_S = 0.5
_FREE_S = (0.3, 0.8)
_SHARP = 0.6
_SOFT = 0.75
_SHARE_OF_RAMP = 0.3


def placed(
    grid: Grid, curves: ForceCurves, view: StateView, at: Indices, tops: Array
) -> tuple[Indices, Indices]:
    """The cell (C,) of each change, and the first and last (C, 2) it may have been.

    tops (5, C) are the largest steps near each at every scale: one that is much smaller at the
    fine scales is a ramp, unless it is sharp itself: then it is a step on the way of a ramp.
    """
    slowest = np.maximum(tops[3], tops[4])
    cell = _steepest(curves.step[0], at, int(_STEP_REACH_S * grid.rate_hz))
    steepest = curves.step[0, cell]
    sharp = (steepest >= _SHARP * tops[2]) & (tops[1] >= _SHARE_OF_RAMP * slowest)
    ramp = (tops[1] < 0.5 * slowest) & ~sharp
    slow = ramp & (tops[1] < 0.5 * tops[4]) & (tops[3] < 0.85 * tops[4])
    cell[ramp] = _ramps(grid, at[ramp])
    soft = ramp | (steepest < _SOFT * tops[2])
    cell[soft] = _beside_free(grid, view, at[soft], cell[soft])
    cell[slow] = _leaving_core(grid, view, at[slow], cell[slow])
    reach = np.where(slow, 0.5, np.where(ramp, 0.25, 0.04)) * grid.rate_hz
    reach = np.maximum(reach, np.abs(cell - at)).astype(np.intp)
    last = len(grid) - 1
    interval = np.column_stack([np.maximum(cell - reach, 0), np.minimum(cell + reach, last)])
    return cell, interval


def _steepest(row: Array, at: Indices, reach: int) -> Indices:
    around = np.arange(-max(1, reach), max(1, reach) + 1)
    cells = np.clip(at[:, None] + around, 0, len(row) - 1)
    return cells[np.arange(len(at)), row[cells].argmax(axis=1)]


def _ramps(grid: Grid, at: Indices) -> Indices:
    """Where the force leaves a quiet level, or has come to rest on one (C,); else the candidate.

    Levels are the medians of 0.3 s on both ends of the two seconds around it; where the recording
    is not that long around a candidate, it stays.
    """
    assert grid.wrench is not None
    wrench, cell = grid.wrench, at.copy()
    reach, level = int(_RAMP_REACH_S * grid.rate_hz), max(3, int(_LEVEL_S * grid.rate_hz))
    whole = np.flatnonzero((at >= reach + level) & (at <= len(grid) - reach - level))
    low, low_scatter = _levels(wrench, at[whole] - reach - level, level)
    high, high_scatter = _levels(wrench, at[whole] + reach, level)
    jump = np.linalg.norm(high - low, axis=1)
    quieter, busier = np.minimum(low_scatter, high_scatter), np.maximum(low_scatter, high_scatter)
    tells = (quieter <= 0.15 * jump) & (busier >= 2.0 * quieter)
    rises = tells & (low_scatter < high_scatter)
    falls = tells & ~rises & (high_scatter <= 0.03)
    beside = np.arange(reach + 1)
    edge = np.maximum(0.03 * jump, 3.0 * quieter)[:, None]
    if rises.any():
        cells = at[whole[rises], None] - beside
        near = np.linalg.norm(wrench[cells] - low[rises, None], axis=2) <= edge[rises]
        # Backwards from the candidate: the first cell that is still on the level.
        cell[whole[rises]] -= np.where(near.any(axis=1), np.maximum(near.argmax(axis=1) - 1, 0), 0)
    if falls.any():
        cells = np.minimum(at[whole[falls], None] + beside[:-1], len(grid) - 1)
        near = np.linalg.norm(wrench[cells] - high[falls, None], axis=2) <= edge[falls]
        cell[whole[falls]] += np.where(near.any(axis=1), near.argmax(axis=1), 0)
    return cell


def _levels(wrench: Array, first: Indices, length: int) -> tuple[Array, Array]:
    """Medians (C, D) of the windows that begin at `first` (C,), and their scatter (C,)."""
    windows = wrench[first[:, None] + np.arange(length)]
    level = np.median(windows, axis=1)
    distance = np.linalg.norm(windows - level[:, None], axis=2)
    return level, np.quantile(distance, 0.9, axis=1)


def _beside_free(grid: Grid, view: StateView, at: Indices, else_: Indices) -> Indices:
    """Where a change of some tenths of a second leaves free space, or is back in it (C,).

    Contact is made when the force begins to rise and lost when it is gone, not where it changes
    fastest. For changes with no free side, or two, `else_`.
    """
    near, far = (round(seconds * grid.rate_hz) for seconds in _FREE_S)
    if not len(view.crossings) or not len(at):
        return else_
    last = len(grid) - 1
    away, beside = np.arange(near, far), np.arange(far)
    before = np.median(view.distance[np.maximum(at[:, None] - away, 0)], axis=1)
    after = np.median(view.distance[np.minimum(at[:, None] + away, last)], axis=1)
    lower, higher = np.minimum(before, after), np.maximum(before, after)
    edge = np.maximum(2.5 * view.core_spread, 0.1 * higher)
    sense = np.where(before > after, 1, -1)
    cells = np.clip(at[:, None] + sense[:, None] * beside, 0, last)
    inside = view.distance[cells] <= edge[:, None]
    one_side = (lower < edge) & (edge < 0.7 * higher) & inside.any(axis=1)
    return np.where(one_side, cells[np.arange(len(at)), inside.argmax(axis=1)], else_)


def _leaving_core(grid: Grid, view: StateView, at: Indices, else_: Indices) -> Indices:
    """Where slow ramps leave free space, or are back in it (C,); `else_` where no side is free."""
    far, near = int(_STATE_REACH_S * grid.rate_hz), int(_STATE_NEAR_S * grid.rate_hz)
    cell, last = else_.copy(), len(grid) - 1
    away = np.arange(near, max(far, near + 1))
    distance = view.distance[np.clip(at[:, None] + np.arange(-far, far + 1), 0, last)]
    low = np.median(view.distance[np.maximum(at[:, None] - away, 0)], axis=1)
    high = np.median(view.distance[np.minimum(at[:, None] + away, last)], axis=1)
    edge = np.maximum(2.5 * view.core_spread, 0.1 * np.maximum(low, high))
    free_side = (np.minimum(low, high) < edge) & (edge < 0.7 * np.maximum(low, high))
    inside = distance <= edge[:, None]
    # A rise begins after the last free cell up to `near` after it, a fall ends at the first one.
    before, after = inside[:, : far + near + 1], inside[:, far - near :]
    rises = free_side & (low < high) & before.any(axis=1)
    falls = free_side & (low >= high) & after.any(axis=1)
    begun = at + near - before[:, ::-1].argmax(axis=1) + 1
    cell[rises] = np.clip(begun, 0, last)[rises]
    cell[falls] = np.clip(at - near + after.argmax(axis=1), 0, last)[falls]
    return cell
