"""Dynamic time warping of two recordings (Sakoe and Chiba 1978), one anti-diagonal at a time.

The band keeps to a quarter of the longer recording around the diagonal, so that long recordings
cost in proportion to their length and no phase is warped onto one at the other end.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.transfer.signals import (
    AS_IT_STANDS,
    SIZES,
    Signals,
    Standing,
    about_vertical,
    in_common,
    unlike,
)

BAND = 0.25
_MIN_BAND = 50

_MAX_TURNS = 2
_FITS_WELL = 0.3
_SAME_TURN_RAD = np.deg2rad(5.0)

_FITS_POORLY = 0.43
_CLEARLY_BETTER = 0.6
_FITS_OTHERWISE = 0.35
"""A recording is turned in any other way only where it fits poorly, so much better then, and well:
of right ones 19 in 20 cost at most 0.31 then, and the worst 0.37. Strangers have a mirror image,
too, that fits less badly."""
_ANY_TURNS = 3


@dataclass(frozen=True, eq=False)
class Alignment:
    """Which moments of two recordings belong together.

    from_s, to_s  (K,) pairs of moments, neither ever falling
    residual      (K,) how far apart the signals are there
    cost          how badly the recordings fit together: their mean, in parts of what it is between
                  recordings of different tasks that have these kinds of signals (`unlike`)
    tempo         how much longer the second takes, long rests left out
    standing      how the second was turned and moved to fit
    """

    from_s: Array
    to_s: Array
    residual: Array
    cost: float
    tempo: float = 1.0
    standing: Standing = AS_IT_STANDS

    def at(self, time_s: float) -> float:
        """The moment of the second recording that belongs to one of the first."""
        near = np.abs(self.from_s - time_s)
        return float(np.median(self.to_s[near <= near.min() + 1e-9]))

    def residual_near(self, time_s: float, within_s: float = 0.5) -> float:
        """How far apart the signals are around a moment of the first recording."""
        near = np.abs(self.from_s - time_s) <= within_s
        return float(self.residual[near].mean() if near.any() else self.residual.mean())


def align(first: Signals, second: Signals) -> Alignment:
    """The cheapest warping of two recordings by the signals both have.

    A second that fits badly may stand turned about the vertical to the robot, or have begun at
    another place: it is turned and moved as the moments aligned so far say, and aligned again,
    where that fits better. One that fits poorly still may be of a robot that hangs from the ceiling
    or stands at a wall, or be the mirror image of the first.
    """
    upright = _upright(first, second)
    if upright.cost < _FITS_POORLY:
        return upright
    other = in_any_frame(first, second)
    return other if clearly(other, upright) else upright


def clearly(other: Alignment, upright: Alignment) -> bool:
    """Whether one in any frame fits well, and so much better that the second does stand so."""
    return other.cost < min(_FITS_OTHERWISE, _CLEARLY_BETTER * upright.cost)


def _upright(first: Signals, second: Signals) -> Alignment:
    """Turned about the vertical at the most."""
    best = _aligned(first, second, AS_IT_STANDS)
    for _ in range(_MAX_TURNS):
        if best.residual.mean() < _FITS_WELL:
            break
        again = [_aligned(first, second, one) for one in _standings(first, second, best)]
        better = min(again, key=lambda one: one.cost, default=best)
        if better.cost >= best.cost:
            break
        best = better
    return best


def in_any_frame(first: Signals, second: Signals) -> Alignment:
    """The cheapest warping however the second stands, its mirror image included.

    By what is the same in every frame to begin with, and turned as the moments then say.
    """
    begun = _aligned(first.only(SIZES), second.only(SIZES), AS_IT_STANDS)
    found: list[Alignment] = []
    for handed in (1.0, -1.0):
        moments = begun
        for _ in range(_ANY_TURNS):
            turn = _turn_between(first, second, moments, handed)
            moments = _upright(first, second.turned(turn))
            found.append(replace(moments, standing=moments.standing.after(turn)))
    return min(found, key=lambda one: one.cost)


def _turn_between(first: Signals, second: Signals, alignment: Alignment, handed: float) -> Array:
    """What brings the second's vectors nearest to the first's (Kabsch 1976); handed -1: as its
    mirror image."""
    both = np.zeros((3, 3))
    for kind in ("velocity", "place", "force"):
        if kind in first.kinds and kind in second.kinds:
            a = first.only([kind]).between(alignment.from_s)
            both += a.T @ second.only([kind]).between(alignment.to_s)
    left, _, right = np.linalg.svd(both)
    left[:, 2] *= handed * np.linalg.det(left @ right)
    return left @ right


def _standings(first: Signals, second: Signals, best: Alignment) -> list[Standing]:
    """How the second may stand by the moments aligned so far: turned, moved, or both."""
    before = best.standing
    angles = [before.turned_rad]
    turned_rad = _turned_between(first, second, best)
    if abs(turned_rad - angles[0]) >= _SAME_TURN_RAD:
        angles.append(turned_rad)
    turns = [about_vertical(angle) for angle in angles]
    moved = [Standing(turn, _moved_between(first, second, best, turn)) for turn in turns]
    turned = [Standing(turn, before.moved) for turn in turns[1:]]
    found = [*turned, *moved]
    if _opposes(first, second, best):
        found += [replace(one, pushed=-one.pushed) for one in (before, *found)]
    return found


def _aligned(first: Signals, second: Signals, standing: Standing) -> Alignment:
    ours, others = in_common(first, second, standing)
    distance = distances(ours.values, others.values)
    _keep_to_band(distance)
    total = _accumulated(distance)
    rows, columns = _path(total)
    residual = distance[rows, columns]
    cost = float(residual.mean()) / unlike(ours.kinds)
    lasting = [len(one.time_s) * one.step_s for one in (first, second)]
    tempo = lasting[1] / lasting[0]
    return Alignment(first.time_s[rows], second.time_s[columns], residual, cost, tempo, standing)


def _opposes(first: Signals, second: Signals, alignment: Alignment) -> bool:
    """Whether the forces point against each other, as where one sensor tells what the tool pushes
    and the other what pushes the tool."""
    ours, others = in_common(first, second, alignment.standing)
    if "force" not in ours.kinds:
        return False
    a = ours.only(["force"]).between(alignment.from_s)
    b = others.only(["force"]).between(alignment.to_s)
    return float((a * b).sum()) < 0.0


def _turned_between(first: Signals, second: Signals, alignment: Alignment) -> float:
    """The angle about the vertical that brings the second's ways onto the first's [rad]."""
    dot = cross = 0.0
    for kind in ("velocity", "place"):
        a = first.only([kind]).between(alignment.from_s)
        b = second.only([kind]).between(alignment.to_s)
        dot += float((a[:, :2] * b[:, :2]).sum())
        cross += float((b[:, 0] * a[:, 1] - b[:, 1] * a[:, 0]).sum())
    return float(np.arctan2(cross, dot))


def _moved_between(
    first: Signals, second: Signals, alignment: Alignment, turn: Array
) -> tuple[float, float, float]:
    """What most places of the second, turned, have to be moved by to lie on the first's."""
    a = first.only(["place"]).between(alignment.from_s)
    b = second.only(["place"]).turned(turn).between(alignment.to_s)
    x, y, z = np.median(a - b, axis=0).tolist()
    return x, y, z


def distances(a: Array, b: Array) -> Array:
    """Euclidean distances (N, M) between signals (N, D) and (M, D)."""
    distance = a @ b.T
    distance *= -2.0
    distance += (a**2).sum(1)[:, None]
    distance += (b**2).sum(1)
    np.maximum(distance, 0.0, out=distance)
    return np.sqrt(distance, out=distance)


def _keep_to_band(distance: Array) -> None:
    """Outside the band distances (N, M) become infinite."""
    rows, columns = distance.shape
    diagonal = np.arange(rows) * ((columns - 1) / max(rows - 1, 1))
    width = _band_width(rows, columns)
    for row, middle in zip(distance, diagonal.tolist(), strict=True):
        row[: max(int(np.ceil(middle - width)), 0)] = np.inf
        row[int(middle + width) + 1 :] = np.inf


def _band_width(rows: int, columns: int) -> float:
    longer, shorter = max(rows, columns), min(rows, columns)
    # As wide as from one row to the next, or a recording of a few samples has no way through.
    return max(BAND * longer, _MIN_BAND, longer / max(shorter - 1, 1))


def _accumulated(distance: Array) -> Array:
    """Cost (N + M, N + 1) of the cheapest way to each pair, by anti-diagonal and first row.

    The pair (i, j) stands at [i + j + 1, i + 1]. One anti-diagonal needs only the two before it.
    """
    n, m = distance.shape
    diagonals = _by_diagonal(distance)
    total = np.full((n + m, n + 1), np.inf)
    before, last = np.full(n + 1, np.inf), np.full(n + 1, np.inf)
    before[0] = 0.0
    for number, costs in enumerate(diagonals, start=1):
        now = total[number]
        np.minimum(last[:-1], last[1:], out=now[1:])
        np.minimum(now[1:], before[:-1], out=now[1:])
        now[1:] += costs
        before, last = last, now
    return total


def _by_diagonal(distance: Array) -> Array:
    """The distances (N + M - 1, N) by anti-diagonal and row: [i + j, i]; infinite where none is."""
    n, m = distance.shape
    padded = np.full((n, n + m), np.inf)
    padded[:, :m] = distance
    # Rows read one shorter than they are shift each by one more.
    skewed = padded.ravel()[: n * (n + m - 1)].reshape(n, n + m - 1)
    return np.ascontiguousarray(skewed.T)


def _path(total: Array) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The cheapest way through; of equal ones that with both steps at once."""
    number, row = len(total) - 1, total.shape[1] - 1
    numbers, rows = [number], [row]
    while number > 1:
        ways = ((number - 2, row - 1), (number - 1, row - 1), (number - 1, row))
        number, row = min(ways, key=total.__getitem__)
        numbers.append(number)
        rows.append(row)
    first = np.array(rows[::-1], dtype=np.intp) - 1
    return first, np.array(numbers[::-1], dtype=np.intp) - 1 - first
