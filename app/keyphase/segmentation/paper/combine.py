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
    matched = partner != NONE
    unmatched = np.ones(len(force_s), dtype=bool)
    unmatched[partner[matched]] = False
    alone = np.flatnonzero(unmatched)
    points[matched] = force_s[partner[matched]]
    time = np.concatenate([points, force_s[alone]])
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
    partner = np.full(len(points), NONE, dtype=np.intp)
    rivals = np.bincount(force, minlength=len(force_s))
    undisputed = (counts[point] == 1) & (rivals[force] == 1)
    partner[point[undisputed]] = force[undisputed]
    point, force = point[~undisputed], force[~undisputed]
    distance = np.round(np.abs(points[point] - force_s[force]), 6)
    taken: set[int] = set()
    for pair in np.lexsort((point, force, distance)):
        if partner[point[pair]] == NONE and force[pair] not in taken:
            partner[point[pair]] = force[pair]
            taken.add(int(force[pair]))
    return partner


def _without_duplicates(found: Combination) -> Combination:
    """Drop position points within 0.1 s of a force point, or of a position point before them."""
    keep = np.ones(len(found.time_s), dtype=bool)
    for later in np.flatnonzero(np.diff(found.time_s) < CLOSEST_S) + 1:
        before = later - 1
        while not keep[before]:
            before -= 1
        if found.time_s[later] - found.time_s[before] < CLOSEST_S:
            if found.force[later] == NONE:
                keep[later] = False
            elif found.force[before] == NONE:
                keep[before] = False
    return Combination(found.time_s[keep], found.force[keep], found.position[keep])
