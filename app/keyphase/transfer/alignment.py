"""Dynamic time warping of two recordings (Sakoe and Chiba 1978), one anti-diagonal at a time.

The band keeps to a quarter of the longer recording around the diagonal, so that long recordings
cost in proportion to their length and no phase is warped onto one at the other end.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.transfer.signals import Signals, in_common

BAND = 0.25
_MIN_BAND = 50

MAX_TURNED_RAD = np.deg2rad(100.0)
"""A recording that had to be turned by more to fit does something else."""

_MAX_TURNS = 2
_FITS_WELL = 0.3
_SAME_TURN_RAD = np.deg2rad(5.0)


@dataclass(frozen=True, eq=False)
class Alignment:
    """Which moments of two recordings belong together.

    from_s, to_s  (K,) pairs of moments, neither ever falling
    residual      (K,) how far apart the signals are there
    cost          their mean: how badly the recordings fit together
    turned_rad    by how much the second was turned about the vertical to fit
    """

    from_s: Array
    to_s: Array
    residual: Array
    cost: float
    turned_rad: float = 0.0

    @property
    def tempo(self) -> float:
        """How much longer the second takes."""
        ours, others = self.from_s[-1] - self.from_s[0], self.to_s[-1] - self.to_s[0]
        return float(others / max(ours, 1e-9))

    def at(self, time_s: float) -> float:
        """The moment of the second recording that belongs to one of the first."""
        near = np.abs(self.from_s - time_s)
        return float(np.median(self.to_s[near <= near.min() + 1e-9]))

    def residual_near(self, time_s: float, within_s: float = 0.5) -> float:
        """How far apart the signals are around a moment of the first recording."""
        near = np.abs(self.from_s - time_s) <= within_s
        return float(self.residual[near].mean()) if near.any() else self.cost


def align(first: Signals, second: Signals) -> Alignment:
    """The cheapest warping of two recordings by the signals both have.

    A second that fits badly may stand turned about the vertical to the robot: it is turned as the
    places aligned so far say, and aligned again, where that fits better.
    """
    best = _aligned(first, second, 0.0)
    for _ in range(_MAX_TURNS):
        if best.cost < _FITS_WELL:
            break
        turned_rad = _turned_between(first, second, best)
        if abs(turned_rad) > MAX_TURNED_RAD or abs(turned_rad - best.turned_rad) < _SAME_TURN_RAD:
            break
        again = _aligned(first, second, turned_rad)
        if again.cost >= best.cost:
            break
        best = again
    return best


def _aligned(first: Signals, second: Signals, turned_rad: float) -> Alignment:
    ours, others = in_common(first, second, turned_rad)
    distance = _distances(ours.values, others.values)
    total = _accumulated(distance)
    rows, columns = _path(total)
    residual = distance[rows, columns]
    cost = float(residual.mean())
    return Alignment(first.time_s[rows], second.time_s[columns], residual, cost, turned_rad)


def _turned_between(first: Signals, second: Signals, alignment: Alignment) -> float:
    """The angle about the vertical that brings the second's ways onto the first's [rad]."""
    dot = cross = 0.0
    for kind in ("velocity", "place"):
        a = first.only([kind]).between(alignment.from_s)
        b = second.only([kind]).between(alignment.to_s)
        dot += float((a[:, :2] * b[:, :2]).sum())
        cross += float((b[:, 0] * a[:, 1] - b[:, 1] * a[:, 0]).sum())
    return float(np.arctan2(cross, dot))


def _distances(a: Array, b: Array) -> Array:
    """Euclidean distances (N, M); infinite outside the band."""
    squares = (a**2).sum(1)[:, None] + (b**2).sum(1)[None] - 2.0 * a @ b.T
    distance = np.sqrt(np.maximum(squares, 0.0))
    rows, columns = np.arange(len(a))[:, None], np.arange(len(b))[None]
    diagonal = rows * (len(b) - 1) / max(len(a) - 1, 1)
    near = np.abs(columns - diagonal) <= _band_width(len(a), len(b))
    return np.where(near, distance, np.inf)


def _band_width(rows: int, columns: int) -> float:
    return max(BAND * max(rows, columns), _MIN_BAND)


def _accumulated(distance: Array) -> Array:
    """Cost (N + 1, M + 1) of the cheapest way to each pair; row and column 0 are the border."""
    n, m = distance.shape
    total = np.full((n + 1, m + 1), np.inf)
    total[0, 0] = 0.0
    slope = (m - 1) / max(n - 1, 1)
    width = _band_width(n, m) + 2.0
    for diagonal in range(2, n + m + 1):
        low = max(1, diagonal - m, int((diagonal - width) / (1.0 + slope)))
        high = min(n, diagonal - 1, int((diagonal + width) / (1.0 + slope)) + 1)
        i = np.arange(low, high + 1)
        j = diagonal - i
        before = np.minimum(np.minimum(total[i - 1, j], total[i, j - 1]), total[i - 1, j - 1])
        total[i, j] = distance[i - 1, j - 1] + before
    return total


def _path(total: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    before = np.stack([total[:-1, :-1], total[:-1, 1:], total[1:, :-1]])
    steps = before.argmin(axis=0).tolist()
    i, j = total.shape[0] - 1, total.shape[1] - 1
    pairs = []
    while i > 0 and j > 0:
        pairs.append((i - 1, j - 1))
        step = steps[i - 1][j - 1]
        i -= step != 2
        j -= step != 1
    path = np.array(pairs[::-1], dtype=np.intp)
    return path[:, 0], path[:, 1]
