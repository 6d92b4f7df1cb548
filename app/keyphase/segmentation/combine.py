"""The paper's rule for joining boundaries from position and from force (II-C), deterministic."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices

CLOSEST_S = 0.1
"""No two boundaries, and no boundary and an end of the recording, are closer than this."""

SHARE_OF_SEGMENT = 0.35
"""A force point moves a boundary by no more than this part of its shorter segment."""

NONE = -1


@dataclass(frozen=True, eq=False)
class Combination:
    """Combined boundaries (B,) in time order.

    `force` and `position` index what each came from, NONE where it did not.
    """

    time_s: Array
    force: Indices
    position: Indices


def combine(
    position_s: Array, force_s: Array, start_s: float, end_s: float, tolerance_s: float
) -> Combination:
    """Match points one to one, nearest first, and keep what is left of either kind.

    A force point f and a position point i may match where |f - i| is at most the tolerance and
    0.35 of the shorter of the two segments at i. A matched boundary lies at f. Force points left
    over are added; position points left over stay, unless they are within 0.1 s of another.
    `position_s` and `force_s` ascend.
    """
    inside = np.flatnonzero(away_from_ends(position_s, start_s, end_s))
    points = position_s[inside]
    segments = np.diff(np.concatenate([[start_s], points, [end_s]]))
    reach = np.minimum(tolerance_s, SHARE_OF_SEGMENT * np.minimum(segments[:-1], segments[1:]))
    partner = _match(points, force_s, reach)
    matched = partner[partner != NONE]
    alone = np.setdiff1d(np.arange(len(force_s)), matched)
    time = np.concatenate(
        [
            np.where(partner != NONE, force_s[partner], points) if len(force_s) else points,
            force_s[alone],
        ]
    )
    force = np.concatenate([partner, alone])
    position = np.concatenate([inside, np.full(len(alone), NONE)])
    order = np.argsort(time, kind="stable")
    return _without_duplicates(Combination(time[order], force[order], position[order]))


def away_from_ends(times_s: Array, start_s: float, end_s: float) -> np.ndarray:
    """Which times are at least 0.1 s inside the recording."""
    return (times_s >= start_s + CLOSEST_S) & (times_s <= end_s - CLOSEST_S)


def _match(points: Array, force_s: Array, reach: Array) -> Indices:
    """For each point the force point it is matched with, or NONE.

    Nearest first; of equally near ones the earlier force point, then the earlier position.
    """
    first = np.searchsorted(force_s, points - reach)
    last = np.searchsorted(force_s, points + reach, side="right")
    counts = np.maximum(last - first, 0)
    point = np.repeat(np.arange(len(points)), counts)
    offset = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    force = first[point] + offset
    distance = np.abs(points[point] - force_s[force])
    partner = np.full(len(points), NONE, dtype=np.intp)
    taken = np.zeros(len(force_s), dtype=bool)
    for pair in np.lexsort((point, force, np.round(distance, 6))):
        if partner[point[pair]] == NONE and not taken[force[pair]]:
            partner[point[pair]] = force[pair]
            taken[force[pair]] = True
    return partner


def _without_duplicates(found: Combination) -> Combination:
    """Drop position points within 0.1 s of a force point, or of a position point before them."""
    keep: list[int] = []
    for i in range(len(found.time_s)):
        if keep and found.time_s[i] - found.time_s[keep[-1]] < CLOSEST_S:
            if found.force[i] == NONE:
                continue
            if found.force[keep[-1]] == NONE:
                keep.pop()
        keep.append(i)
    return Combination(found.time_s[keep], found.force[keep], found.position[keep])
