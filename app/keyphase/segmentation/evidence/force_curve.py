"""The paper's force filter run forward and backward: how much their predictions differ.

At time scale w the gain is K = 1 - exp(-2 / (w rate)). The forward filter knows only the past,
the backward one only the future, so the difference of their predictions is a step of the force
averaged over w on both sides: the paper's innovation with the future as a second opinion.
"""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices, whole_in
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.order_statistics import quantile

SCALES_S = (0.06, 0.12, 0.24, 0.64, 1.4)
"""What the filters average over."""

FINE = 3
"""The first so many scales see steps, the others ramps."""

_FLOOR = 0.003
_MIN_WINDOW_S = 0.8
_MIN_PEAK = 0.03
_MAX_TOP_S = 0.8


@dataclass(frozen=True, eq=False)
class ForceCurves:
    """One row per scale over n cells.

    step (5, n)   difference of the two predictions, in sizes of the wrench
    quiet (5, n)  its running median on the quieter side, busy (5, n) on the busier one
    """

    step: Array
    quiet: Array
    busy: Array

    def tops(self, at: Indices, rate_hz: float) -> Array:
        """Largest step (5, C) near candidates, within half a scale."""
        from scipy.ndimage import maximum_filter1d

        reach = [max(1, round(min(w, _MAX_TOP_S) * rate_hz / 2)) for w in SCALES_S]
        rows = zip(self.step, reach, strict=True)
        return np.array([maximum_filter1d(row, 2 * r + 1)[at] for row, r in rows]) + 1e-3


def force_curves(grid: Grid) -> ForceCurves:
    """The curves of a grid's wrench at every scale."""
    assert grid.wrench is not None
    channels = np.ascontiguousarray(grid.wrench.T)
    apart = [_two_filters(channels, grid.rate_hz, scale) for scale in SCALES_S]
    # What happens beside a step is told by the curve as it is: tapered, an end would look quiet.
    sides = [_background(row, grid, w) for row, w in zip(apart, SCALES_S, strict=True)]
    quiet, busy = (np.array(side) + _FLOOR for side in zip(*sides, strict=True))
    step = [
        row * _taper(len(row), w * grid.rate_hz) for row, w in zip(apart, SCALES_S, strict=True)
    ]
    return ForceCurves(np.array(step), quiet, busy)


def _two_filters(channels: Array, rate_hz: float, scale_s: float) -> Array:
    """|backward - forward prediction| (n,) of channels (D, n)."""
    gain = 1.0 - np.exp(-2.0 / max(scale_s * rate_hz, 1.0))
    forward, backward = _settled(channels, gain), _settled(channels[:, ::-1], gain)[:, ::-1]
    step = np.zeros(channels.shape[1])
    step[1:] = np.linalg.norm(backward[:, 1:] - forward[:, :-1], axis=0)
    step[0] = step[1]
    return step


def _taper(count: int, cells: float) -> Array:
    """What the curve counts (n,): less at the ends, where one of the filters has hardly begun."""
    from_end = np.minimum(np.arange(count), count - np.arange(count))
    return np.sqrt(np.clip(from_end / cells, 0.0, 1.0))


def _settled(channels: Array, gain: float) -> Array:
    """The steady-state random-walk filter, started at the first sample."""
    from scipy.signal import lfilter

    start = (1.0 - gain) * channels[:, :1]
    return lfilter([gain], [1.0, -(1.0 - gain)], channels, axis=1, zi=start)[0]


def _background(row: Array, grid: Grid, scale_s: float) -> tuple[Array, Array]:
    """Running medians beside each cell, far enough off not to see its own step."""
    from scipy.ndimage import median_filter

    length = max(_MIN_WINDOW_S, 2.0 * scale_s)
    median = median_filter(row, grid.cells(length) | 1, mode="nearest")
    away = grid.cells(length / 2.0 + scale_s)
    last = len(row) - 1
    cell = np.arange(len(row))
    before, after = median[np.maximum(cell - away, 0)], median[np.minimum(cell + away, last)]
    return np.minimum(before, after), np.maximum(before, after)


def peaks(curves: ForceCurves, rate_hz: float) -> Indices:
    """Cells (C,) at which the curve of any scale peaks, ascending."""
    from scipy.signal import find_peaks

    found = []
    for row, scale in zip(curves.step, SCALES_S, strict=True):
        height = max(_MIN_PEAK, 3.0 * quantile(row, 0.1))
        distance = whole_in(scale, rate_hz)
        padded = np.concatenate([[0.0], row, [0.0]])
        found.append(find_peaks(padded, height=height, distance=distance)[0] - 1)
    return np.unique(np.concatenate(found))
