"""The best cut of a motion into contiguous Gaussians, by dynamic programming (paper II-A).

Every stretch between two cuts is one Gaussian over [time, pose]; the cost of a stretch is its
negative log-likelihood under its own Gaussian, mixing weight included. The number of stretches
follows from the Bayesian information criterion with an effective number of samples: neighbouring
samples of a motion are correlated, and counting them all would split without end.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices

EFFECTIVE_HZ = 15.0
"""Independent samples a second of hand-guided motion is worth."""

_PAIRS_AT_ONCE = 8192
_COLUMNS = 64


@dataclass(frozen=True, eq=False)
class Moments:
    """Running sums of samples (n, d) over their floor, from which any stretch's Gaussian follows.

    The floor (d,) is the standard deviation added to each axis; counted in floors it is the
    identity. first (d, n + 1), second (d, d, n + 1) below and on its diagonal; log_floor is the
    sum of the floors' logarithms.
    """

    first: Array
    second: Array
    log_floor: float

    @classmethod
    def of(cls, samples: Array, floor: Array) -> "Moments":
        """Sums over `samples`, centred first so that no digits are lost."""
        scaled = ((samples - samples.mean(axis=0)) / floor).T
        d, n = scaled.shape
        first, second = np.zeros((d, n + 1)), np.zeros((d, d, n + 1))
        np.cumsum(scaled, axis=1, out=first[:, 1:])
        for r in range(d):
            np.cumsum(scaled[r] * scaled[: r + 1], axis=1, out=second[r, : r + 1, 1:])
        return cls(first, second, float(np.log(floor).sum()))

    def __len__(self) -> int:
        return self.first.shape[1] - 1

    def costs(self, begin: Indices, end: Indices, least: int = 1) -> Array:
        """Negative log-likelihood (B, E) of the stretches [begin, end), mixing weight included.

        m/2 (ln det(V + F) + tr((V + F)^-1 V) + d ln 2 pi) - m ln(m / n) for m of n samples with
        covariance V and floor F; infinite for stretches of fewer than `least` samples.
        """
        length = (end[None, :] - begin[:, None]).astype(float)
        too_short = length < least
        count = np.where(too_short, 1.0, length)
        share = np.where(too_short, 0.0, 1.0 / count)
        log_det, trace = _log_det_and_trace(self._covariances(begin, end, share))
        constant = 2.0 * self.log_floor + len(self.first) * (1.0 + np.log(2.0 * np.pi))
        cost = count * (0.5 * (log_det - trace + constant) - np.log(count / len(self)))
        cost[too_short] = np.inf
        return cost

    def _covariances(self, begin: Indices, end: Indices, share: Array) -> list[list[Array]]:
        """Lower rows of V, each entry (B, E); `share` is one over the stretches' lengths."""
        mean = [(sums[end] - sums[begin][:, None]) * share for sums in self.first]
        rows: list[list[Array]] = []
        for r, products in enumerate(self.second):
            rows.append([])
            for c in range(r + 1):
                entry = products[c, end] - products[c, begin][:, None]
                entry *= share
                entry -= mean[r] * mean[c]
                rows[r].append(entry)
        return rows


def _log_det_and_trace(covariance: list[list[Array]]) -> tuple[Array, Array]:
    """ln det(V + I) and tr((V + I)^-1) of many V at once, given by their lower rows.

    One factorisation L D Lᵀ and one inverse of L, written over all matrices: calling linear
    algebra for each would take ten times as long.
    """
    lower: list[list[Array]] = []
    inverse: list[list[Array]] = []
    det = trace = np.ones(1)
    pivots: list[Array] = []
    for r, row in enumerate(covariance):
        scaled = list(row[:r])
        pivot = row[r] + 1.0
        for c in range(r):
            for k in range(c):
                scaled[c] -= scaled[k] * lower[c][k]
        lower.append([entry / pivots[c] for c, entry in enumerate(scaled)])
        for entry, factor in zip(scaled, lower[r], strict=True):
            pivot -= entry * factor
        # Below one only by rounding.
        pivots.append(np.maximum(pivot, 1.0))
        inverse.append(_inverse_row(lower[r], inverse))
        squares = sum((entry * entry for entry in inverse[r]), np.ones(1))
        det = det * pivots[r]
        trace = trace + squares / pivots[r]
    return np.log(det), trace - 1.0


def _inverse_row(row: list[Array], above: list[list[Array]]) -> list[Array]:
    """The next row of the inverse of a unit lower matrix, left of its diagonal."""
    found: list[Array] = []
    for c, entry in enumerate(row):
        total = entry.copy()
        for k in range(c + 1, len(row)):
            total += row[k] * above[k][c]
        found.append(np.negative(total, out=total))
    return found


def parameters_per_gaussian(dimensions: int) -> int:
    """Numbers that one more Gaussian adds to a mixture: mean, covariance and weight."""
    return dimensions + dimensions * (dimensions + 1) // 2 + 1


def best_cut(moments: Moments, grid: Indices, least: int, effective: float) -> Indices:
    """Inner cuts, chosen from `grid`, that minimise the Bayesian information criterion.

    BIC = 2 (effective / n) * cost + p ln(effective) with `effective` samples. p grows by the
    same number for each stretch, so one pass over the grid finds the best cut of any number of
    stretches, each of at least `least` samples. `grid` begins with 0 and ends with n.
    """
    effective = max(effective, 2.0)
    penalty = parameters_per_gaussian(len(moments.first)) * np.log(effective)
    weight = 2.0 * effective / len(moments)
    best = np.full(len(grid), np.inf)
    best[0] = 0.0
    came_from = np.zeros(len(grid), dtype=np.intp)
    alive = np.zeros(1, dtype=np.intp)
    for top in range(1, len(grid), _COLUMNS):
        block = np.arange(top, min(top + _COLUMNS, len(grid)))
        outer = weight * moments.costs(grid[alive], grid[block], least) + penalty
        inner = weight * moments.costs(grid[block], grid[block], least) + penalty
        total = best[alive][:, None] + outer
        came_from[block] = alive[total.argmin(axis=0)]
        best[block] = total.min(axis=0)
        _within(block, inner, best, came_from)
        alive = np.concatenate([alive, block])
        following = grid[min(block[-1] + 1, len(grid) - 1)]
        cut = int(np.searchsorted(grid[block], following - least, side="right")) - 1
        if cut >= 0:
            costs = np.concatenate([outer[:, cut], inner[:, cut]]) - penalty
            alive = alive[_still_useful(grid, alive, block[cut], best, costs, weight)]
    return _walk_back(grid, came_from)


def _within(block: Indices, costs: Array, best: Array, came_from: Indices) -> None:
    """Let stretches that begin and end in one block of the grid improve what is best there."""
    for row, start in enumerate(block):
        total = best[start] + costs[row]
        better = total < best[block]
        best[block[better]] = total[better]
        came_from[block[better]] = start


def _still_useful(
    grid: Indices, starts: Indices, cut: int, best: Array, costs: Array, weight: float
) -> NDArray[np.bool_]:
    """Which starts can begin an optimal stretch that ends far enough behind the cut.

    Without its mixing weights a stretch costs at least as much as its two parts. So where, at
    some point `cut` on the way, beginning anew is cheaper by more than what the weights
    -m ln m can gain by joining the longest possible second part, it stays cheaper for good.
    `costs` are weighted and those of the first parts; where one is infinite the start is kept.
    """
    long = np.isfinite(costs)
    part = (grid[cut] - grid[starts[long]]).astype(float)
    rest = float(grid[-1] - grid[cut])
    gain = (part + rest) * np.log(part + rest) - part * np.log(part) - rest * np.log(rest)
    useful = np.ones(len(starts), dtype=bool)
    useful[long] = best[starts[long]] + costs[long] - weight * gain <= best[cut]
    return useful


def _rows(moments: Moments, grid: Indices, least: int) -> Iterator[tuple[int, Array]]:
    """For each grid point: its index, and the costs of the stretches from it to later points."""
    size = len(grid)
    top = 0
    while top < size - 1:
        bottom = min(top + max(1, _PAIRS_AT_ONCE // (size - top)), size - 1)
        costs = moments.costs(grid[top:bottom], grid[top + 1 :], least)
        for i in range(top, bottom):
            yield i, costs[i - top, i - top :]
        top = bottom


def _walk_back(grid: Indices, came_from: Indices) -> Indices:
    cuts = []
    at = came_from[-1]
    while at > 0:
        cuts.append(grid[at])
        at = came_from[at]
    return np.array(cuts[::-1], dtype=np.intp)


def best_cut_into(moments: Moments, grid: Indices, least: int, count: int) -> Indices:
    """Inner cuts, chosen from `grid`, of the cheapest `count` stretches of `least` samples.

    Where so many do not fit, as many as do.
    """
    size = len(grid)
    cost = np.full((size, size), np.inf)
    for i, costs in _rows(moments, grid, least):
        cost[i, i + 1 :] = costs
    best = cost[0]
    came_from = []
    for _ in range(count - 1):
        total = best[:, None] + cost
        if not np.isfinite(total[:, -1]).any():
            break
        came_from.append(total.argmin(axis=0))
        best = total.min(axis=0)
    cuts = []
    at = size - 1
    for step in reversed(came_from):
        at = step[at]
        cuts.append(grid[at])
    return np.array(cuts[::-1], dtype=np.intp)
