"""Position segmentation: a chronological Gaussian mixture over time and pose (paper II-A).

Dynamic programming finds the cuts, expectation maximisation the Gaussians started from them,
and neighbours that are one stroke are joined. Long recordings are treated in overlapping
windows, so that time and memory grow with their length and no faster.
"""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices, count_in
from keyphase.segmentation.motion import Motion
from keyphase.segmentation.paper.contiguous import (
    EFFECTIVE_HZ,
    Moments,
    best_cut,
    best_cut_into,
)
from keyphase.segmentation.paper.mixture import fit_mixture
from keyphase.segmentation.paper.refinement import refine_cuts
from keyphase.segmentation.paper.strokes import merge_strokes
from keyphase.segmentation.parameters import Estimator

WINDOW_S = 60.0
OVERLAP_S = 6.0

_GRID_S = 0.04
_MIN_DURATION_S = 0.12
_REFINE_REACH_S = 1.2
_REFINE_STRIDE_S = 0.06
_MIN_SPREAD_M = 2e-3
_TIME_FLOOR_S = 0.01
_COARSE_FLOOR_M = 1e-3
_FINE_FLOOR_M = 2e-4
_MAX_FROM_CUT_S = 0.4
_FLOOR_PER_RANGE = 1e-6
_CONTEXT = 2
_FITTED_TOGETHER_S = 30.0
_GRID_POINTS = 1500


@dataclass(frozen=True, eq=False)
class PositionFit:
    """A chronological mixture of K Gaussians, brought back to time and position.

    weight (K,), mean_s (K,), sigma_s (K,), mean_position_m (K, 3), covariance_m2 (K, 3, 3);
    cut_s (K - 1,) is where contiguous stretches meet, None where the fit did not look for them.
    """

    weight: Array
    mean_s: Array
    sigma_s: Array
    mean_position_m: Array
    covariance_m2: Array
    cut_s: Array | None

    def __len__(self) -> int:
        return len(self.weight)

    def intervals_s(self) -> Array:
        """(K - 1, 2) ascending: one standard deviation from the means on both sides."""
        after = self.mean_s[:-1] + self.sigma_s[:-1]
        before = self.mean_s[1:] - self.sigma_s[1:]
        return np.sort(np.column_stack([after, before]), axis=1)

    def boundaries_s(self, estimator: Estimator) -> Array:
        """(K - 1,) ascending: where between its neighbours each boundary is put.

        Where expectation maximisation carried it far from the cut it started from, the cut.
        """
        cross = estimator == "weight-crossing"
        times = weight_crossing(self) if cross else equal_distance(self)
        if self.cut_s is not None:
            strayed = np.abs(times - self.cut_s).max(initial=0.0) > _MAX_FROM_CUT_S
            times = self.cut_s if strayed else times
        return np.maximum.accumulate(times)


def equal_distance(fit: PositionFit) -> Array:
    """Where two neighbours are equally far in standard deviations of time (K - 1,).

    t = (m1 s2 + m2 s1) / (s1 + s2); between the means, exact for segments uniform in time.
    """
    m1, m2, s1, s2 = fit.mean_s[:-1], fit.mean_s[1:], fit.sigma_s[:-1], fit.sigma_s[1:]
    return (m1 * s2 + m2 * s1) / (s1 + s2)


def weight_crossing(fit: PositionFit) -> Array:
    """Where the time weights w N(t; m, s²) of two neighbours cross, between their means.

    The second estimator of Lee et al.; where they do not cross there, the equal distance.
    """
    m1, m2, s1, s2 = fit.mean_s[:-1], fit.mean_s[1:], fit.sigma_s[:-1], fit.sigma_s[1:]
    gap = m2 - m1
    # a x² + b x + c = 0 with x counted from the first mean keeps the digits late in a recording.
    a = 1.0 / s2**2 - 1.0 / s1**2
    b = -2.0 * gap / s2**2
    c = (gap / s2) ** 2 + 2.0 * np.log(fit.weight[:-1] * s2 / (fit.weight[1:] * s1))
    root = np.sqrt(np.maximum(b * b - 4.0 * a * c, 0.0))
    # The root nearest the first mean, in the form that stays finite as a goes to zero.
    x = 2.0 * c / (-b + root)
    crosses = (b * b >= 4.0 * a * c) & (x > 0.0) & (x < gap)
    return np.where(crosses, m1 + x, equal_distance(fit))


def fit_position(motion: Motion, count: int | None = None) -> PositionFit:
    """Fit the mixture; `count` Gaussians, or as many as the criterion finds and strokes are."""
    samples = _features(motion)
    if count is not None:
        return _fit(motion, samples, _cuts_into(samples, motion.step_s, count))
    fit = _fit(motion, samples, _automatic_cuts(samples, motion.step_s))
    found = np.searchsorted(motion.time_s, fit.boundaries_s("equal-distance"))
    merged = merge_strokes(motion, np.unique(found[(found > 0) & (found < len(samples))]))
    return fit if len(merged) + 1 == len(fit) else _fit(motion, samples, merged)


def _features(motion: Motion) -> Array:
    """Samples (n, d): time, and the pose on the principal axes along which it spreads."""
    centred = motion.pose_m - motion.pose_m.mean(axis=0)
    variance, axes = np.linalg.eigh(centred.T @ centred / len(centred))
    spread = variance > _MIN_SPREAD_M**2
    spread[-1] = True
    return np.column_stack([motion.time_s - motion.time_s[0], centred @ axes[:, spread]])


def _floor(samples: Array, pose_m: float) -> Array:
    """Least standard deviation (d,): a property of hands, and of digits for absurd ranges."""
    hand = [_TIME_FLOOR_S, *[pose_m] * (samples.shape[1] - 1)]
    return np.maximum(hand, _FLOOR_PER_RANGE * np.ptp(samples, axis=0))


def _automatic_cuts(samples: Array, step_s: float) -> Indices:
    """Cuts by the criterion, found in overlapping windows where the recording is long."""
    n = len(samples)
    window = count_in(WINDOW_S, step_s, 500, n)
    overlap = count_in(OVERLAP_S, step_s, 100, n)
    cuts = _window_cuts(samples[:window], step_s)
    end = window
    while end < n:
        begin, end_before = end - overlap, end
        end = min(begin + window, n)
        later = begin + _window_cuts(samples[begin:end], step_s)
        seam = _widest_gap(cuts, later, begin + overlap // 4, end_before - overlap // 4)
        cuts = np.concatenate([cuts[cuts < seam], later[later >= seam]])
    return cuts


def _window_cuts(samples: Array, step_s: float) -> Indices:
    n = len(samples)
    least = count_in(_MIN_DURATION_S, step_s, 2, n)
    effective = min(EFFECTIVE_HZ * float(samples[-1, 0] - samples[0, 0]), float(n))
    grid = np.append(np.arange(0, n, count_in(_GRID_S, step_s, 1, n)), n)
    coarse = Moments.of(samples, _floor(samples, _COARSE_FLOOR_M))
    return _refined(samples, best_cut(coarse, grid, least, effective), step_s)


def _refined(
    samples: Array, cuts: Indices, step_s: float, reach_s: float = _REFINE_REACH_S
) -> Indices:
    """The cuts moved to the full grid, where a finer floor tells the exact moment.

    It sees pauses and turns of a few millimetres, which may lie far from the coarse cut.
    """
    n = len(samples)
    fine = Moments.of(samples, _floor(samples, _FINE_FLOOR_M))
    reach, stride = count_in(reach_s, step_s, 1, n), count_in(_REFINE_STRIDE_S, step_s, 1, n)
    return refine_cuts(fine, cuts, reach, count_in(_MIN_DURATION_S, step_s, 2, n), stride)


def _widest_gap(earlier: Indices, later: Indices, low: int, high: int) -> int:
    """Middle of the longest stretch from `low` to `high` in which neither window has a cut."""
    cuts = np.union1d(earlier, later)
    edges = np.concatenate([[low], cuts[(cuts > low) & (cuts < high)], [high]])
    widest = int(np.argmax(np.diff(edges)))
    return int(edges[widest] + edges[widest + 1]) // 2


def _cuts_into(samples: Array, step_s: float, count: int) -> Indices:
    """Cuts into a given number of stretches; the grid is coarser the longer the recording."""
    n = len(samples)
    least = count_in(_MIN_DURATION_S, step_s, 2, n)
    step = max(count_in(_GRID_S, step_s, 1, n), n // _GRID_POINTS)
    grid = np.append(np.arange(0, n, step), n)
    coarse = Moments.of(samples, _floor(samples, _COARSE_FLOOR_M))
    cuts = best_cut_into(coarse, grid, least, count)
    return _refined(samples, cuts, step_s, max(_REFINE_REACH_S, step * step_s))


def _fit(motion: Motion, samples: Array, cuts: Indices) -> PositionFit:
    """Gaussians by expectation maximisation from the stretches between the cuts."""
    edges = np.concatenate([[0], cuts, [len(samples)]])
    groups = _groups(edges, count_in(_FITTED_TOGETHER_S, motion.step_s, 500, len(samples)))
    parts = [_fit_group(motion, samples, edges, first, last) for first, last in groups]
    weight, mean, sigma, position, covariance = (
        np.concatenate(part) for part in zip(*parts, strict=True)
    )
    order = np.argsort(mean, kind="stable")
    return PositionFit(
        weight[order],
        mean[order],
        sigma[order],
        position[order],
        covariance[order],
        motion.time_s[cuts],
    )


def _groups(edges: Indices, most: int) -> list[tuple[int, int]]:
    """Runs [first, last) of stretches that together have at most `most` samples, or are one."""
    groups = []
    first = 0
    for last in range(1, len(edges)):
        if last == len(edges) - 1 or edges[last + 1] - edges[first] > most:
            groups.append((first, last))
            first = last
    return groups


def _fit_group(
    motion: Motion, samples: Array, edges: Indices, first: int, last: int
) -> tuple[Array, Array, Array, Array, Array]:
    """Weight, mean and sigma in time, mean and covariance in space of stretches [first, last).

    Stretches on both sides are fitted with them and then left out: responsibilities reach no
    further, so a long recording is fitted piece by piece.
    """
    outer, beyond = max(first - _CONTEXT, 0), min(last + _CONTEXT, len(edges) - 1)
    low, high = edges[outer], edges[beyond]
    labels = np.repeat(np.arange(beyond - outer), np.diff(edges[outer : beyond + 1]))
    piece = samples[low:high]
    mixture = fit_mixture(piece, labels, beyond - outer, _floor(piece, _FINE_FLOOR_M))
    mine = slice(first - outer, last - outer)
    mean, covariance = _in_space(motion.position_m[low:high], mixture.responsibility[:, mine])
    return (
        mixture.weight[mine] * (high - low) / len(samples),
        mixture.mean[mine, 0] + motion.time_s[0],
        np.sqrt(mixture.covariance[mine, 0, 0]),
        mean,
        covariance,
    )


def _in_space(position_m: Array, responsibility: Array) -> tuple[Array, Array]:
    """Mean (K, 3) and covariance (K, 3, 3) of positions (n, 3) under responsibilities (n, K)."""
    share = responsibility / np.maximum(responsibility.sum(axis=0), 1e-12)
    centre = position_m.mean(axis=0)
    offset = position_m - centre
    mean = share.T @ offset
    square = np.einsum("nk,ni,nj->kij", share, offset, offset, optimize=True)
    covariance = square - mean[:, :, None] * mean[:, None, :] + _FINE_FLOOR_M**2 * np.eye(3)
    return mean + centre, covariance
