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


def spaced_scores(time_s: Array, odds: Array, min_distance_s: float) -> Array:
    """Log-odds (C,) of candidates in time order beside likelier ones; -inf where too close."""
    scores = np.full(len(odds), -np.inf)
    use = np.flatnonzero(odds >= MIN_ODDS)
    times, own = time_s[use].tolist(), odds[use].tolist()
    current, taken = list(own), [False] * len(own)
    queue = [(-z, index) for index, z in enumerate(own)]
    heapq.heapify(queue)
    reach = max(CROWDED_S, min_distance_s)
    while queue:
        z, index = heapq.heappop(queue)
        if taken[index] or -z != current[index]:
            continue
        taken[index] = True
        scores[use[index]] = current[index]
        at = times[index]
        for other in range(bisect_left(times, at - reach), bisect_right(times, at + reach)):
            if taken[other]:
                continue
            gap = abs(times[other] - at)
            if gap < min_distance_s:
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


def distance_to(times_s: Array, places_s: Array) -> Array:
    """Distance (C,) from each time to the nearest of some ascending places; inf without any."""
    if not len(places_s):
        return np.full(len(times_s), np.inf)
    after = np.searchsorted(places_s, times_s)
    before = places_s[np.maximum(after - 1, 0)]
    later = places_s[np.minimum(after, len(places_s) - 1)]
    return np.minimum(np.abs(times_s - before), np.abs(times_s - later))
