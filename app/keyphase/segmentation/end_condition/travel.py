"""The way on which a tool comes to a contact."""

import numpy as np

from keyphase.demonstration import Array, Demonstration

WAY_M = 0.01
"""The direction of travel is that of the last 10 mm: a hand slows down before it touches."""

MIN_WAY_M = 0.003
"""A tool that moved less than this did not travel; it presses against the force."""

RATE_HZ = 250.0


def last_way(position_m: Array) -> tuple[Array, int] | None:
    """Unit vector (3,) of the last 10 mm of a path (M, 3), and where they begin; None without way.

    A path that is shorter counts from where it was furthest away.
    """
    away = position_m - position_m[-1]
    far = np.sqrt((away * away).sum(axis=1))
    beyond = np.flatnonzero(far >= WAY_M)
    first = int(beyond[-1]) if len(beyond) else int(far.argmax())
    if far[first] < MIN_WAY_M:
        return None
    return -away[first] / far[first], first


def travelled(demonstration: Demonstration, start_s: float, end_s: float) -> Array | None:
    """Unit vector (3,) in which the tool came to `end_s`; None where it hardly moved."""
    _, position, _ = sampled(demonstration, start_s, end_s)
    way = last_way(position)
    return None if way is None else way[0]


def sampled(
    demonstration: Demonstration, start_s: float, end_s: float
) -> tuple[Array, Array, Array | None]:
    """Times (M,), positions (M, 3) and forces (M, 3) at 250 Hz, linear in between samples."""
    count = max(round((end_s - start_s) * RATE_HZ), 1) + 1
    moments = start_s + np.arange(count) / RATE_HZ
    first, last = np.searchsorted(demonstration.time_s, (moments[0], moments[-1])).tolist()
    rows = slice(max(first - 1, 0), last + 1)
    time = demonstration.time_s[rows]

    def at(values: Array) -> Array:
        return np.stack([np.interp(moments, time, column) for column in values[rows].T], axis=1)

    force = demonstration.force_N
    return moments, at(demonstration.position_m), None if force is None else at(force)
