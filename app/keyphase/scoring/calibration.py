"""Whether confidences mean what they say: of a hundred given with 0.8, eighty are right."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

BINS = 10
SURE = 0.9
"""From this confidence on a boundary counts as sure."""


@dataclass(frozen=True)
class Bin:
    """Boundaries whose confidence lies from `low` to `high`: how many, their mean confidence, and
    the share of them that is right."""

    low: float
    high: float
    count: int
    confidence: float
    right: float


@dataclass(frozen=True)
class Calibration:
    """Of `count` judged boundaries.

    error        expected calibration error: the mean over all of |confidence − share right| by bin
    sure, sure_right   boundaries given with 0.9 or more, and how many of them are right
    """

    count: int
    bins: tuple[Bin, ...]
    error: float | None
    sure: int
    sure_right: int


def calibration(outcomes: Sequence[tuple[float, bool]], bins: int = BINS) -> Calibration:
    """The calibration of (confidence, whether it was right), in equally wide bins."""
    if not outcomes:
        return Calibration(0, (), None, 0, 0)
    given = np.array([confidence for confidence, _ in outcomes], float)
    right = np.array([was for _, was in outcomes], bool)
    which = np.minimum((given * bins).astype(int), bins - 1)
    filled = tuple(
        Bin(
            index / bins,
            (index + 1) / bins,
            int(inside.sum()),
            float(given[inside].mean()),
            float(right[inside].mean()),
        )
        for index in range(bins)
        if (inside := which == index).any()
    )
    error = sum(each.count * abs(each.confidence - each.right) for each in filled) / len(given)
    sure = given >= SURE
    return Calibration(len(given), filled, error, int(sure.sum()), int((sure & right).sum()))
