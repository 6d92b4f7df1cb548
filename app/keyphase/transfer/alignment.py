"""Dynamic time warping of two recordings (Sakoe and Chiba 1978), one anti-diagonal at a time.

The band keeps to a quarter of the longer recording around the diagonal, so that long recordings
cost in proportion to their length and no phase is warped onto one at the other end.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.transfer.signals import Signals

BAND = 0.25
_MIN_BAND = 50


@dataclass(frozen=True, eq=False)
class Alignment:
    """Which moments of two recordings belong together.

    from_s, to_s  (K,) pairs of moments, neither ever falling
    residual      (K,) how far apart the signals are there
    cost          their mean: how badly the recordings fit together
    """

    from_s: Array
    to_s: Array
    residual: Array
    cost: float

    def at(self, time_s: float) -> float:
        """The moment of the second recording that belongs to one of the first."""
        near = np.abs(self.from_s - time_s)
        return float(np.median(self.to_s[near <= near.min() + 1e-9]))

    def residual_near(self, time_s: float, within_s: float = 0.5) -> float:
        """How far apart the signals are around a moment of the first recording."""
        near = np.abs(self.from_s - time_s) <= within_s
        return float(self.residual[near].mean()) if near.any() else self.cost


def align(first: Signals, second: Signals) -> Alignment:
    """The cheapest warping of two recordings by the signals both have."""
    a, b = _common(first, second)
    distance = _distances(a, b)
    total = _accumulated(distance)
    rows, columns = _path(total)
    residual = distance[rows, columns]
    return Alignment(first.time_s[rows], second.time_s[columns], residual, float(residual.mean()))


def _common(first: Signals, second: Signals) -> tuple[Array, Array]:
    shared = [kind for kind in dict.fromkeys(first.kinds) if kind in second.kinds]
    pick = [
        [i for kind in shared for i, name in enumerate(signals.kinds) if name == kind]
        for signals in (first, second)
    ]
    return first.values[:, pick[0]], second.values[:, pick[1]]


def _distances(a: Array, b: Array) -> Array:
    """Euclidean distances (N, M); infinite outside the band."""
    squares = (a**2).sum(1)[:, None] + (b**2).sum(1)[None] - 2.0 * a @ b.T
    distance = np.sqrt(np.maximum(squares, 0.0))
    rows, columns = np.arange(len(a))[:, None], np.arange(len(b))[None]
    diagonal = rows * (len(b) - 1) / max(len(a) - 1, 1)
    width = max(BAND * max(len(a), len(b)), _MIN_BAND)
    return np.where(np.abs(columns - diagonal) <= width, distance, np.inf)


def _accumulated(distance: Array) -> Array:
    """Cost (N + 1, M + 1) of the cheapest way to each pair; row and column 0 are the border."""
    n, m = distance.shape
    total = np.full((n + 1, m + 1), np.inf)
    total[0, 0] = 0.0
    for diagonal in range(2, n + m + 1):
        i = np.arange(max(1, diagonal - m), min(n, diagonal - 1) + 1)
        j = diagonal - i
        before = np.minimum(np.minimum(total[i - 1, j], total[i, j - 1]), total[i - 1, j - 1])
        total[i, j] = distance[i - 1, j - 1] + before
    return total


def _path(total: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    i, j = total.shape[0] - 1, total.shape[1] - 1
    pairs = []
    while i > 0 and j > 0:
        pairs.append((i - 1, j - 1))
        choice = int(np.argmin((total[i - 1, j - 1], total[i - 1, j], total[i, j - 1])))
        i, j = (i - 1, j - 1) if choice == 0 else (i - 1, j) if choice == 1 else (i, j - 1)
    path = np.array(pairs[::-1], dtype=np.intp)
    return path[:, 0], path[:, 1]
