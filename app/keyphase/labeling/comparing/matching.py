"""Two sets of boundaries of one recording: which belong together, and how well they agree."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike


@dataclass(frozen=True)
class Match:
    """Indices of a reference time and of the found time that belongs to it."""

    reference: int
    found: int


def match_times(reference: ArrayLike, found: ArrayLike, tolerance_s: float) -> tuple[Match, ...]:
    """One-to-one matches no farther apart than `tolerance_s`, ascending in the reference.

    As many as possible; of those the ones with the least sum of distances.
    """
    from scipy.optimize import linear_sum_assignment

    distance = np.abs(np.subtract.outer(np.asarray(reference, float), np.asarray(found, float)))
    if not distance.size:
        return ()
    near = distance <= tolerance_s
    # Any match outweighs all distances together, so their number comes first.
    worth = 1.0 + tolerance_s * (min(distance.shape) + 1)
    rows, columns = linear_sum_assignment(np.where(near, distance - worth, 0.0))
    pairs = zip(rows.tolist(), columns.tolist(), strict=True)
    return tuple(Match(i, j) for i, j in pairs if near[i, j])


def covering(
    reference: Sequence[float], found: Sequence[float], span_s: tuple[float, float]
) -> float:
    """How well the segments between `found` cover those between `reference`, 0 to 1.

    Arbeláez et al. 2011: the mean, weighted by duration, over the reference's segments of the
    greatest intersection over union with a found segment.
    """
    parts = _segments(found, span_s)
    total = 0.0
    for start, end in _segments(reference, span_s):
        shared = np.minimum(end, parts[:, 1]) - np.maximum(start, parts[:, 0])
        joint = np.maximum(end, parts[:, 1]) - np.minimum(start, parts[:, 0])
        total += (end - start) * max(0.0, float((shared / joint).max()))
    return total / (span_s[1] - span_s[0])


def _segments(times: Sequence[float], span_s: tuple[float, float]) -> np.ndarray:
    inside = sorted({float(time) for time in times if span_s[0] < time < span_s[1]})
    return np.array(list(pairwise([span_s[0], *inside, span_s[1]])))
