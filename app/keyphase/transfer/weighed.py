"""The program's own boundaries of a recording, weighed against those of the finished ones.

Two things persons do otherwise than the program. A short pause, of which it finds the beginning and
the end, they mark once, in its middle. And how a recording begins and ends differs from one to the
next without meaning anything: a rest before the task or after it is no phase of it.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.segmentation import Boundary
from keyphase.transfer.placing import Teacher
from keyphase.transfer.taught import Taught

PAUSE_S = 0.55
"""A longer pause is a phase, whoever marks."""

AROUND_S = 0.3
"""How far outside a pause a mark may arrive, as aligned, and still belong to it."""

OUTSIDE_S = 0.5
"""Earlier than this before the first mark that arrives the task has not begun."""

SURE = 0.86
"""What the program finds there with less than this is no boundary of the task."""


def weighed(
    own: Sequence[Boundary], teachers: Sequence[Teacher], aligned: Sequence[Teacher] = ()
) -> tuple[Boundary, ...]:
    """Those of the program's boundaries that stand; of a pause that persons mark once, its middle.

    A pause is marked once where most pauses of all that were `aligned` are marked so in their own
    recordings: who marks them once, or twice, does so here, too. Where these have no pauses it is
    where most of the teachers have one mark. No teacher may have a phase as short as it.
    """
    habit = _mark_pauses_once([one.taught for one in aligned])
    marks = [np.array([one.alignment.at(end_s) for end_s in one.taught.ends_s]) for one in teachers]
    shortest_s = min([PAUSE_S, *map(_shortest_s, teachers)])
    found: list[Boundary] = []
    for boundary in own:
        if boundary.confidence < SURE and _is_outside(boundary.time_s, marks):
            continue
        if found and _is_one_pause(found[-1], boundary, shortest_s, marks, habit):
            found[-1] = _middle(found[-1], boundary)
        else:
            found.append(boundary)
    return tuple(found)


def _shortest_s(teacher: Teacher) -> float:
    """The shortest phase between two boundaries of a person, in the tempo of the new recording,
    from evidence to evidence as the program's pauses are."""
    taught = teacher.taught
    ends = zip(taught.ends_s, taught.anchors, strict=True)
    lasting = np.diff([end_s if place is None else place.time_s for end_s, place in ends])
    return float(lasting.min()) * teacher.alignment.tempo if len(lasting) else np.inf


def _is_outside(time_s: float, marks: Sequence[Array]) -> bool:
    return not any(len(one) and one[0] - OUTSIDE_S < time_s < one[-1] + OUTSIDE_S for one in marks)


def _is_one_pause(
    first: Boundary, second: Boundary, shortest_s: float, marks: Sequence[Array], habit: bool | None
) -> bool:
    if second.time_s - first.time_s >= shortest_s or _changes(first) or _changes(second):
        return False
    once = [_between(one, first.time_s, second.time_s) == 1 for one in marks]
    return 2 * sum(once) > len(once) if habit is None else habit


def _between(marks: Array, first_s: float, second_s: float) -> int:
    return int(((marks >= first_s - AROUND_S) & (marks <= second_s + AROUND_S)).sum())


def _mark_pauses_once(taught: Sequence[Taught]) -> bool | None:
    """Whether most of the pauses that have a mark in their own recordings have one alone; None
    where there are none."""
    marks = [count for one in taught for count in _marks_at_pauses(one) if count]
    return 2 * marks.count(1) > len(marks) if marks else None


def _marks_at_pauses(taught: Taught) -> Iterator[int]:
    """How many marks there are at each pause of which the program finds beginning and end."""
    still = {place.time_s for place in taught.places.all if place.kind == "motion"}
    for first_s, second_s in pairwise(taught.found_s):
        if second_s - first_s < PAUSE_S and first_s in still and second_s in still:
            yield _between(np.array(taught.ends_s), first_s, second_s)


def _changes(boundary: Boundary) -> bool:
    """Whether more happens there than that the tool stops or goes on."""
    return boundary.contact_change or bool(boundary.gripper)


def _middle(first: Boundary, second: Boundary) -> Boundary:
    return replace(
        first,
        time_s=0.5 * (first.time_s + second.time_s),
        interval_s=(first.interval_s[0], second.interval_s[1]),
        confidence=min(first.confidence, second.confidence),
    )
