"""The best cut of a motion into contiguous Gaussians, by dynamic programming (paper II-A).

Every stretch between two cuts is one Gaussian over [time, pose]; the cost of a stretch is its
negative log-likelihood under its own Gaussian, mixing weight included. The number of stretches
follows from the Bayesian information criterion with an effective number of samples: neighbouring
samples of a motion are correlated, and counting them all would split without end.
"""

import itertools
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices

EFFECTIVE_HZ = 15.0
"""Independent samples a second of hand-guided motion is worth."""

_PAIRS_AT_ONCE = 60_000


@dataclass(frozen=True, eq=False)
class Moments:
    """Running sums of samples (n, d), from which any stretch's Gaussian follows at once.

    first (n + 1, d), second (n + 1, d, d); floor (d,) standard deviations added to each axis.
    """

    first: Array
    second: Array
    floor: Array

    @classmethod
    def of(cls, samples: Array, floor: Array) -> "Moments":
        """Sums over `samples`, centred first so that no digits are lost."""
        centred = samples - samples.mean(axis=0)
        products = centred[:, :, None] * centred[:, None, :]
        return cls(_running_sum(centred), _running_sum(products), floor)

    def __len__(self) -> int:
        return len(self.first) - 1

    def costs(self, begin: Indices, end: Indices) -> Array:
        """Negative log-likelihood of the stretches [begin, end) (P,), mixing weight included.

        m/2 (ln det(V + F) + tr((V + F)^-1 V) + d ln 2 pi) - m ln(m / n) for m of n samples with
        covariance V and floor F.
        """
        count = (end - begin).astype(float)
        mean = ((self.first[end] - self.first[begin]) / count[:, None]).T
        square = np.moveaxis((self.second[end] - self.second[begin]), 0, -1) / count
        log_det, trace = _log_det_and_trace(square - mean[:, None] * mean[None], self.floor**2)
        fit = log_det + trace + len(self.floor) * np.log(2 * np.pi)
        return 0.5 * count * fit - count * np.log(count / len(self))


def _running_sum(values: Array) -> Array:
    sums = np.zeros((len(values) + 1, *values.shape[1:]))
    np.cumsum(values, axis=0, out=sums[1:])
    return sums


def _log_det_and_trace(covariance: Array, floor2: Array) -> tuple[Array, Array]:
    """ln det(V + F) and tr((V + F)^-1 V) of V (d, d, P) and diagonal F, by one Cholesky for all.

    Written over the P matrices at once, which is twenty times faster than one call for each.
    """
    d = len(floor2)
    lower = np.zeros_like(covariance)
    inverse = np.zeros_like(covariance)
    log_det = np.zeros(covariance.shape[-1])
    for c in range(d):
        column = covariance[c:, c] - np.einsum("rkp,kp->rp", lower[c:, :c], lower[c, :c])
        pivot = np.maximum(column[0] + floor2[c], 1e-3 * floor2[c])
        root = np.sqrt(pivot)
        lower[c, c] = root
        lower[c + 1 :, c] = column[1:] / root
        log_det += np.log(pivot)
        inverse[c, :c] = -np.einsum("kp,kcp->cp", lower[c, :c], inverse[:c, :c]) / root
        inverse[c, c] = 1.0 / root
    return log_det, d - np.einsum("rcp,rcp,c->p", inverse, inverse, floor2)


def parameters_per_gaussian(dimensions: int) -> int:
    """Numbers that one more Gaussian adds to a mixture: mean, covariance and weight."""
    return dimensions + dimensions * (dimensions + 1) // 2 + 1


def best_cut(moments: Moments, grid: Indices, least: int, effective: float) -> Indices:
    """Inner cuts, chosen from `grid`, that minimise the Bayesian information criterion.

    BIC = 2 (effective / n) * cost + p ln(effective) with `effective` samples. p grows by the
    same number for each stretch, so one pass over the grid finds the best cut of any number of
    stretches, each of at least `least` samples. `grid` begins with 0 and ends with n.
    """
    penalty = parameters_per_gaussian(moments.first.shape[1]) * np.log(max(effective, 2.0))
    weight = 2.0 * effective / len(moments)
    best = np.full(len(grid), np.inf)
    best[0] = 0.0
    came_from = np.zeros(len(grid), dtype=np.intp)
    for i, reach, costs in _rows(moments, grid, least):
        total = best[i] + weight * costs + penalty
        better = total < best[reach:]
        best[reach:][better] = total[better]
        came_from[reach:][better] = i
    return _walk_back(grid, came_from)


def _rows(moments: Moments, grid: Indices, least: int):
    """For each grid point: its index, the first index in reach, and the costs from there on."""
    size = len(grid)
    rows = max(1, _PAIRS_AT_ONCE // size)
    reach = np.searchsorted(grid, grid + least)
    for top in range(0, size - 1, rows):
        block = np.arange(top, min(top + rows, size - 1))
        lengths = size - reach[block]
        begin = np.repeat(grid[block], lengths)
        end = np.concatenate([grid[reach[i] :] for i in block])
        costs = np.split(moments.costs(begin, end), np.cumsum(lengths)[:-1])
        yield from zip(block.tolist(), reach[block].tolist(), costs, strict=True)


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
    for i, reach, costs in _rows(moments, grid, least):
        cost[i, reach:] = costs
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


def refine_cuts(moments: Moments, cuts: Indices, reach: int, least: int) -> Indices:
    """Move each cut by up to `reach` samples so that all stretches together cost least."""
    choices = [np.zeros(1, dtype=np.intp)]
    for cut in cuts:
        low, high = max(cut - reach, least), min(cut + reach, len(moments) - least)
        choices.append(np.arange(low, high + 1) if low <= high else np.array([cut]))
    choices.append(np.array([len(moments)]))
    best = np.zeros(1)
    came_from = []
    for before, after in itertools.pairwise(choices):
        total = best[:, None] + _costs_between(moments, before, after, least)
        came_from.append(total.argmin(axis=0))
        best = total.min(axis=0)
    refined = []
    at = 0
    for options, step in zip(reversed(choices[1:-1]), reversed(came_from[1:]), strict=True):
        at = step[at]
        refined.append(options[at])
    return np.array(refined[::-1], dtype=np.intp) if np.isfinite(best[0]) else cuts


def _costs_between(moments: Moments, before: Indices, after: Indices, least: int) -> Array:
    begin, end = np.broadcast_arrays(before[:, None], after[None, :])
    cost = np.full(begin.shape, np.inf)
    long_enough = end - begin >= min(least, len(moments))
    cost[long_enough] = moments.costs(begin[long_enough], end[long_enough])
    return cost
