"""Which candidates become boundaries: a score for each that no line has to be known for.

From the likeliest down, a candidate that is taken makes those beside it less likely, because
phases are rarely short: CROWDING nats right beside it, none half a second away. A candidate
nearer than the minimal distance to a likelier one is none. As scores only fall on the way down,
the boundaries above any line are those whose score is above it: moving a line selects and
computes nothing again.
"""

import heapq
from bisect import bisect_left, bisect_right

import numpy as np

from keyphase.demonstration import Array

CROWDING = 4.0
CROWDED_S = 0.5

MIN_ODDS = -9.0
"""Candidates less likely than this (one in ten thousand) are never boundaries."""


def spaced_scores(
    time_s: Array,
    odds: Array,
    min_distance_s: float,
    seen_s: Array | None = None,
    breadth: Array | None = None,
) -> Array:
    """Log-odds (C,) of candidates beside likelier ones; -inf where too close.

    `seen_s` (C,) is where each was seen, if that is not where it is put: one rise, seen at its
    steepest and put where it begins, is not two changes. Two candidates are as far apart as they
    are in the nearer of both. `breadth` (C,) is how many minimal distances each keeps from likelier
    ones, 1 where none is given.
    """
    scores = np.full(len(odds), -np.inf)
    use = np.flatnonzero(odds >= MIN_ODDS)
    own = odds[use].tolist()
    least = (min_distance_s * (np.ones(len(odds)) if breadth is None else breadth)[use]).tolist()
    places = [_Places(time_s[use])] + ([] if seen_s is None else [_Places(seen_s[use])])
    current, taken = list(own), [False] * len(own)
    queue = [(-z, index) for index, z in enumerate(own)]
    heapq.heapify(queue)
    reach = max([CROWDED_S, *least])
    while queue:
        z, index = heapq.heappop(queue)
        if taken[index] or -z != current[index]:
            continue
        taken[index] = True
        scores[use[index]] = current[index]
        for other in {other for each in places for other in each.near(index, reach)}:
            if taken[other]:
                continue
            gap = min(each.between(index, other) for each in places)
            if gap < least[other]:
                taken[other] = True
                continue
            worse = own[other] - CROWDING * max(0.0, 1.0 - gap / CROWDED_S)
            if worse < current[other]:
                current[other] = worse
                if worse >= MIN_ODDS:
                    heapq.heappush(queue, (-worse, other))
                else:
                    taken[other] = True
    return scores


class _Places:
    """Where candidates lie in time; those near one are found by bisection."""

    def __init__(self, time_s: Array) -> None:
        order = np.argsort(time_s, kind="stable")
        self._own, self._order = time_s.tolist(), order.tolist()
        self._sorted = time_s[order].tolist()

    def near(self, index: int, reach_s: float) -> list[int]:
        """Candidates at most this far from one, itself among them."""
        at = self._own[index]
        first, last = (
            bisect_left(self._sorted, at - reach_s),
            bisect_right(self._sorted, at + reach_s),
        )
        return self._order[first:last]

    def between(self, one: int, other: int) -> float:
        """Time from one candidate to another."""
        return abs(self._own[one] - self._own[other])


def distance_to(times_s: Array, places_s: Array) -> Array:
    """Distance (C,) from each time to the nearest of some ascending places; inf without any."""
    if not len(places_s):
        return np.full(len(times_s), np.inf)
    after = np.searchsorted(places_s, times_s)
    before = places_s[np.maximum(after - 1, 0)]
    later = places_s[np.minimum(after, len(places_s) - 1)]
    return np.minimum(np.abs(times_s - before), np.abs(times_s - later))
