"""In which order the phases of a finished recording are found in another one.

A warping keeps the order of what is warped: a phase that is missing, done twice or in another place
is forced onto what is there. Here the way through the finished recording may leap, from the end of
any phase to the beginning of any other, where it follows the new one so much better: a segmental
hidden Markov model (Rabiner 1989) whose states are the samples of the finished recording.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.labeling.tasks.task import TaskPhase
from keyphase.transfer.alignment import align, clearly, distances, in_any_frame
from keyphase.transfer.placing import Teacher
from keyphase.transfer.rests import LONGEST_S, WITHIN_S
from keyphase.transfer.signals import Signals, in_common, unlike

LEAP_S = 0.1
"""What a leap costs: so many seconds of being as far apart as unlike tasks are."""

_FASTEST = 2.5
"""A phase may be done this much faster than the whole."""

BRIEF_S = 0.75
"""Whether a phase that takes less time is there cannot be told at the beginning and the end, nor
by how well it fits: moments are aligned to some tenths of a second."""

_LEAST_STEPS = 3
_BETTER = 0.97
_GAP = 1.5
_LEAST_SAMPLES = 5


@dataclass(frozen=True)
class Difference:
    """How the phases of a recording differ from those of the finished ones.

    at    the name of the phase to look at
    told  in words
    """

    at: str
    told: str


def as_done(
    teachers: Sequence[Teacher], signals: Signals, phases: Sequence[TaskPhase] = ()
) -> tuple[Difference | None, Sequence[Teacher]]:
    """How the other's phases differ, and the best teacher as it would be, done like that.

    The teachers as they are where nothing differs: where most of them find their phases in order,
    or where one that is done like that fits hardly better. What goes the other way round in a
    mirror seems to be another phase: where a finished recording fits better that way, it is that.
    """
    found: list[tuple[Difference | None, Sequence[Teacher]]] = []
    for teacher in teachers:
        order = _with_brief_ends(phase_order(teacher, signals), teacher)
        if order == tuple(range(len(teacher.taught.phases))):
            continue
        differs = how_it_differs(order, teacher.taught.names, phases)
        reordered = teacher.taught.in_order(order)
        if len(reordered.signals.time_s) < _LEAST_SAMPLES:
            continue
        alignment = align(reordered.signals, signals)
        stands = in_any_frame(teacher.taught.signals, signals)
        if stands.cost < alignment.cost:
            if clearly(stands, teacher.alignment):
                found.append((None, [Teacher(teacher.taught, stands)]))
        elif alignment.cost < _BETTER * teacher.alignment.cost:
            found.append((differs, [Teacher(reordered, alignment)]))
    return found[0] if 2 * len(found) > len(teachers) else (None, teachers)


def phase_order(teacher: Teacher, signals: Signals) -> tuple[int, ...]:
    """The numbers of the finished recording's phases, in the order in which the other has them."""
    theirs, mine = in_common(teacher.taught.signals, signals, teacher.alignment.standing)
    edges = [phase.start_s for phase in teacher.taught.phases]
    starts = np.unique(np.searchsorted(theirs.time_s, edges).clip(0, len(theirs.time_s) - 1))
    distance = distances(theirs.values, mine.values) / unlike(theirs.kinds)
    resting = _in_a_cut_rest(mine)
    distance[:, resting] = 0.0
    fastest = int(np.ceil(_FASTEST * len(theirs.values) / len(mine.values)))
    rows = _followed(
        distance,
        starts,
        np.where(resting, np.inf, LEAP_S / mine.step_s),
        max(fastest, _LEAST_STEPS),
    )
    number = np.searchsorted(edges, theirs.time_s[rows], side="right") - 1
    new = np.flatnonzero((np.diff(rows) < 0) | (np.diff(number) != 0)) + 1
    return tuple(number[[0, *new]].tolist())


def _with_brief_ends(order: tuple[int, ...], teacher: Teacher) -> tuple[int, ...]:
    """With the phases before the first and after the last of them where those are brief."""
    phases, tempo = teacher.taught.phases, teacher.alignment.tempo
    before, after = range(order[0]), range(order[-1] + 1, len(phases))
    if set(before).isdisjoint(order):
        brief = tempo * (phases[order[0]].start_s - phases[0].start_s) < BRIEF_S
        order = (*before, *order) if brief else order
    if set(after).isdisjoint(order):
        brief = tempo * (phases[-1].end_s - phases[order[-1]].end_s) < BRIEF_S
        order = (*order, *after) if brief else order
    return order


def how_it_differs(
    order: Sequence[int], names: Sequence[str], phases: Sequence[TaskPhase] = ()
) -> Difference | None:
    """What is other than in the finished recording; None where nothing is.

    Of the task's `phases` those that are optional may be missing, repeated ones may come again.
    """
    may_miss = {phase.name for phase in phases if phase.optional}
    may_repeat = {phase.name for phase in phases if phase.repeated}
    numbers = range(len(names))
    missing = [i for i in numbers if i not in order and names[i] not in may_miss]
    again = [i for i in numbers if list(order).count(i) > 1 and names[i] not in may_repeat]
    earlier = [(a, b) for a, b in pairwise(order) if b < a and order.count(b) == 1]
    told = [f"{_listed(names, missing)} missing"] if missing else []
    told += [f"{_listed(names, again)} done again"] if again else []
    told += [f"{quoted(names[a])} comes before {quoted(names[b])}" for a, b in earlier]
    if not told:
        return None
    after_missing = [i for i in order if i > min(missing, default=len(names))]
    at = [*again, *(a for a, _ in earlier), *after_missing, order[-1]][0]
    return Difference(names[at], " and ".join(told))


def quoted(name: str) -> str:
    """A name of a phase as it is told."""
    return f"'{name}'" if name else "a phase without a name"


def _listed(names: Sequence[str], numbers: Sequence[int]) -> str:
    return ", ".join(quoted(names[i]) for i in numbers) + (" are" if len(numbers) > 1 else " is")


def _in_a_cut_rest(signals: Signals) -> NDArray[np.bool_]:
    """Which samples (M,) are what is left of a long rest: a rest may come anywhere."""
    cut = np.flatnonzero(np.diff(signals.time_s) > _GAP * signals.step_s)
    beside = round((0.5 * LONGEST_S + WITHIN_S) / signals.step_s)
    samples = np.arange(len(signals.time_s))
    near = np.abs(samples[:, None] - cut - 0.5) <= beside
    return np.asarray(near.any(axis=1))


def _followed(
    distance: Array, starts: NDArray[np.intp], leap: Array, fastest: int
) -> NDArray[np.intp]:
    """The row (M,) that is followed at each column of distances (N, M): the cheapest way.

    From a column to the next it stays, goes on by up to `fastest` rows, or leaps for its price to
    one of `starts`, from the row before one of them or from the last. It begins at the first row,
    or at another start for the price of a leap, and ends likewise.
    """
    count, columns = distance.shape
    ends = np.append(starts[1:] - 1, count - 1)
    rows, steps = np.arange(count), np.arange(fastest + 1)[:, None]
    came_from = np.empty((columns, count), dtype=np.intp)
    total = np.full(count, np.inf)
    total[starts] = leap[0]
    total[0] = 0.0
    total += distance[:, 0]
    padded = np.full(fastest + count, np.inf)
    shifted = fastest + rows - steps
    for column in range(1, columns):
        padded[fastest:] = total
        reached = padded[shifted]
        best = reached.argmin(axis=0)
        came_from[column] = rows - best
        last = ends[total[ends].argmin()]
        total = reached[best, rows]
        leapt = padded[fastest + last] + leap[column]
        there = starts[total[starts] > leapt]
        came_from[column, there] = last
        total[there] = leapt
        total += distance[:, column]
    return _back(came_from, _last(total, ends, leap[-1]))


def _last(total: Array, ends: NDArray[np.intp], leap: float) -> int:
    stopped = ends[total[ends].argmin()]
    return int(stopped) if total[stopped] + leap < total[-1] else len(total) - 1


def _back(came_from: NDArray[np.intp], row: int) -> NDArray[np.intp]:
    rows = [row]
    for before in came_from[:0:-1]:
        rows.append(int(before[rows[-1]]))
    return np.array(rows[::-1], dtype=np.intp)
