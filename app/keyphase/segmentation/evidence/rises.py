"""From when to when the force changed: the straight rise that fits best around each place.

Every rise that begins and ends on a grid of RISE_STEP_S, level before and after, is compared with
the wrench within WINDOW_S, near moments counting more (a bell of BELL_S). What is left after the
best level and the best height is smallest where the rise's share of the wrench is largest, so one
product of matrices tells all of them. A click is a rise of one step.
"""

from functools import lru_cache

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.grid import Grid

WINDOW_S = 0.6
BELL_S = 0.2
RISE_STEP_S = 0.04

BESIDE_S = 0.12
"""A rise that was seen at a place begins no later than this after it, and ends no earlier."""

_AT_ONCE = 2000
_NO_RISE = 1e-300


def rises(grid: Grid, at: Indices) -> tuple[Indices, Indices]:
    """First and last cell (C,) of the rise or fall seen at each place (C,)."""
    assert grid.wrench is not None
    reach, edges, shapes = _shapes(grid.rate_hz)
    around, last = np.arange(-reach, reach + 1), len(grid) - 1
    found = np.zeros((len(at), 2), dtype=np.intp)
    for first in range(0, len(at), _AT_ONCE):
        some = at[first : first + _AT_ONCE]
        cells = np.clip(some[:, None] + around, 0, last)
        share = sum(np.square(channel[cells] @ shapes) for channel in grid.wrench.T)
        found[first : first + _AT_ONCE] = some[:, None] + edges[np.argmax(share, axis=1)]
    found = np.clip(found, 0, last)
    return found[:, 0], found[:, 1]


@lru_cache(maxsize=8)
def _shapes(rate_hz: float) -> tuple[int, Indices, Array]:
    """Cells on each side, where each rise begins and ends (R, 2) in cells from the middle, and each
    as a column (2 reach + 1, R): weighed, without its mean, of length one."""
    reach = max(2, round(WINDOW_S * rate_hz))
    time_s = np.arange(-reach, reach + 1) / rate_hz
    bell = np.exp(-0.5 * np.square(time_s / BELL_S))
    step_s = max(RISE_STEP_S, 1.0 / rate_hz)
    count = max(1, int(WINDOW_S / step_s + 1e-9))
    places = step_s * np.arange(-count, count + 1)
    begin, end = (each.ravel() for each in np.meshgrid(places, places, indexing="ij"))
    use = (end > begin) & (begin <= BESIDE_S) & (end >= -BESIDE_S)
    begin, end = begin[use], end[use]
    rise = np.clip((time_s[:, None] - begin) / (end - begin), 0.0, 1.0)
    rise -= bell @ rise / bell.sum()
    rise *= bell[:, None] / np.sqrt(np.maximum(bell @ np.square(rise), _NO_RISE))
    edges = np.round(np.column_stack([begin, end]) * rate_hz).astype(np.intp)
    return reach, edges, rise
