"""Force segmentation, second half: which peaks of the normalized error are contact changes.

Everything a decision needs is computed once for every local maximum (`candidates_of`), so that
moving a threshold only selects among them (`rejections`).
"""

from dataclasses import dataclass
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.segmentation.bins import BIN_S, Indices, typical_step_s
from keyphase.segmentation.paper.combine import CLOSEST_S, away_from_ends
from keyphase.segmentation.segmentation import ErrorCurve, Rejection
from keyphase.segmentation.windows import AFTER_S, BEFORE_S

REJECTIONS: tuple[Rejection, ...] = get_args(Rejection)
"""What the codes of `rejections` stand for; code 0 is a peak that is used."""

_REFINE_S = (-0.06, 0.04)
_HALF_SPLIT_S = 0.04
_CANDIDATES_AT_ONCE = 2048

Codes = NDArray[np.int8]


@dataclass(frozen=True, eq=False)
class Candidates:
    """The local maxima of a normalized-error curve, C of them, in time order.

    bin (C,) into the curve; time_s (C,) refined at full rate, within earliest_s...latest_s;
    height (C,); ratio (C,) over the running median; step (C, D) mean wrench after minus before;
    persistence (C,) norm of the step in noise levels, over sqrt(D)
    """

    bin: Indices
    bin_time_s: Array
    time_s: Array
    earliest_s: Array
    latest_s: Array
    height: Array
    ratio: Array
    step: Array
    persistence: Array

    def __len__(self) -> int:
        return len(self.bin)


def local_maxima(error: Array) -> Indices:
    """Indices of the local maxima of a curve (M,), its ends included."""
    from scipy.signal import find_peaks

    found, _ = find_peaks(np.concatenate([[-np.inf], error, [-np.inf]]))
    return found - 1


def spaced(bin_times_s: Array, heights: Array, distance_s: float) -> NDArray[np.bool_]:
    """Which of some local maxima (C,) stay when the lower of two closer than `distance_s` goes.

    Decided from the highest down, as scipy's `find_peaks` does, on a curve in which the long
    gaps between the maxima are shortened.
    """
    from scipy.signal import find_peaks

    if len(heights) < 2:
        return np.ones(len(heights), dtype=bool)
    distance = max(2, round(distance_s / BIN_S))
    gaps = np.round(np.diff(bin_times_s) / BIN_S)
    place = np.concatenate([[1], 1 + np.cumsum(np.clip(gaps, 2, distance))]).astype(np.intp)
    curve = np.full(place[-1] + 2, -1.0)
    curve[place] = heights
    kept, _ = find_peaks(curve, distance=distance)
    stays = np.zeros(len(curve), dtype=bool)
    stays[kept] = True
    return stays[place]


def peaks_of_curve(
    time_s: Array, error: Array, threshold: float, min_distance_s: float = 0.0
) -> Array:
    """Times of the peaks of a bare normalized-error curve, by height and distance alone."""
    maxima = local_maxima(error)
    maxima = maxima[error[maxima] >= threshold]
    return time_s[maxima[spaced(time_s[maxima], error[maxima], min_distance_s)]]


def candidates_of(time_s: Array, wrench: Array, curve: ErrorCurve, noise: Array) -> Candidates:
    """Every local maximum of the curve with what selecting among them needs.

    time_s (N,) and wrench (N, D) at full rate; noise (D,) variances of the binned wrench.
    """
    bins = local_maxima(curve.error)
    at = curve.time_s[bins]
    sums = np.vstack([np.zeros(wrench.shape[1]), np.cumsum(wrench, axis=0)])
    step = _mean_around(time_s, sums, at, AFTER_S) - _mean_around(time_s, sums, at, BEFORE_S)
    persistence = np.sqrt(np.mean(step**2 / noise, axis=1))
    refined, earliest, latest = _refined(time_s, sums, noise, at)
    median = np.maximum(curve.running_median[bins], 1e-12)
    height = curve.error[bins]
    return Candidates(
        bins, at, refined, earliest, latest, height, height / median, step, persistence
    )


def _mean_around(time_s: Array, sums: Array, at: Array, window_s: tuple[float, float]) -> Array:
    """Mean wrench (C, D) over a window beside each time; the nearest sample where it is empty."""
    first = np.searchsorted(time_s, at + window_s[0])
    last = np.searchsorted(time_s, at + window_s[1])
    empty = first >= last
    nearest = np.where(window_s[0] < 0.0, first - 1, first)
    first = np.where(empty, np.clip(nearest, 0, len(time_s) - 1), first)
    last = np.where(empty, first + 1, last)
    return (sums[last] - sums[first]) / (last - first)[:, None]


def _refined(time_s: Array, sums: Array, noise: Array, at: Array) -> tuple[Array, Array, Array]:
    """Best split (C,) of the wrench near each time, and the earliest and latest good ones."""
    if typical_step_s(time_s) > 0.75 * BIN_S:
        earlier = time_s[np.maximum(np.searchsorted(time_s, at) - 1, 0)]
        return at, np.minimum(earlier, at), at
    parts = [
        _best_splits(time_s, sums, noise, at[i : i + _CANDIDATES_AT_ONCE])
        for i in range(0, len(at), _CANDIDATES_AT_ONCE)
    ]
    refined, earliest, latest = (np.concatenate(part) for part in zip(*parts, strict=True))
    return refined, earliest, latest


def _best_splits(time_s: Array, sums: Array, noise: Array, at: Array) -> tuple[Array, Array, Array]:
    """The split of two 40 ms windows whose mean wrenches differ most, within -60...+40 ms.

    Splits whose difference squared is at least half as much span the uncertainty.
    """
    first = np.searchsorted(time_s, at + _REFINE_S[0])
    last = np.searchsorted(time_s, at + _REFINE_S[1])
    split = first[:, None] + np.arange(max(int((last - first).max()), 1))
    inside = split < last[:, None]
    split = np.minimum(split, len(time_s) - 1)
    half_step = 0.5 * typical_step_s(time_s)
    low = np.searchsorted(time_s, time_s[split] - _HALF_SPLIT_S - half_step)
    high = np.searchsorted(time_s, time_s[split] + _HALF_SPLIT_S - half_step)
    before, after = split - low, high - split
    usable = inside & (before > 0) & (after > 0)
    before, after = np.maximum(before, 1), np.maximum(after, 1)
    gain = np.zeros(split.shape)
    for channel, variance in zip(sums.T, noise, strict=True):
        middle = channel[split]
        jump = (channel[high] - middle) / after - (middle - channel[low]) / before
        gain += jump**2 / variance
    gain = np.where(usable, gain * (before * after / (before + after)), -1.0)
    best = gain.argmax(axis=1)
    rows = np.arange(len(at))
    found = gain[rows, best] > 0.0
    times = time_s[split]
    good = gain >= 0.5 * gain[rows, best][:, None]
    earliest = np.where(good, times, np.inf).min(axis=1)
    latest = np.where(good, times, -np.inf).max(axis=1)
    return (
        np.where(found, times[rows, best], at),
        np.where(found, earliest, at),
        np.where(found, latest, at),
    )


def rejections(
    candidates: Candidates,
    threshold: float,
    ratio: float,
    min_distance_s: float,
    persistence: float,
    recording_s: tuple[float, float],
) -> Codes:
    """For each candidate the index into REJECTIONS of why it is not used, 0 where it is.

    A used peak is at least `threshold` high, `ratio` times its running median, 0.1 s inside the
    recording, the highest within `min_distance_s`, and its step stays `persistence` noise
    levels. Raising a threshold never needs more than these comparisons.
    """
    codes = np.full(len(candidates), REJECTIONS.index("below threshold"), dtype=np.int8)
    left = np.flatnonzero(candidates.height >= threshold)
    for reason, keeps in (
        ("below ratio", lambda i: candidates.ratio[i] >= ratio),
        ("at an end", lambda i: away_from_ends(candidates.time_s[i], *recording_s)),
        ("too close", lambda i: _far_apart(candidates, i, min_distance_s)),
        ("does not stay", lambda i: candidates.persistence[i] >= persistence),
    ):
        kept = keeps(left)
        codes[left[~kept]] = REJECTIONS.index(reason)
        left = left[kept]
    codes[left] = 0
    return codes


def _far_apart(candidates: Candidates, chosen: Indices, distance_s: float) -> NDArray[np.bool_]:
    """Spacing in the curve, and no two refined times closer than boundaries may be."""
    heights = candidates.height[chosen]
    kept = spaced(candidates.bin_time_s[chosen], heights, max(distance_s, CLOSEST_S))
    times = candidates.time_s[chosen]
    stay = np.flatnonzero(kept)
    while len(close := np.flatnonzero(np.diff(times[stay]) < CLOSEST_S)):
        pair = stay[close[0] : close[0] + 2]
        lower = pair[np.argmin(heights[pair])]
        kept[lower] = False
        stay = stay[stay != lower]
    return kept
