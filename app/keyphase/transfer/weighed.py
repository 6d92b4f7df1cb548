"""The program's own boundaries of a recording, weighed against those of the finished ones.

Two things persons do otherwise than the program. A short pause, of which it finds the beginning and
the end, they mark once, in its middle. And how a recording begins and ends differs from one to the
next without meaning anything: a rest before the task or after it is no phase of it.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.segmentation import Boundary
from keyphase.transfer.placing import Teacher

PAUSE_S = 0.55
"""A longer pause is a phase, whoever marks."""

AROUND_S = 0.3
"""How far outside a pause a mark may arrive, as aligned, and still belong to it."""

OUTSIDE_S = 0.5
"""Earlier than this before the first mark that arrives the task has not begun."""

SURE = 0.86
"""What the program finds there with less than this is no boundary of the task."""


def weighed(own: Sequence[Boundary], teachers: Sequence[Teacher]) -> tuple[Boundary, ...]:
    """Those of the program's boundaries that stand; of a pause that persons mark once, its middle.

    A pause is marked once where most of the teachers have one mark there, and none of them has a
    phase as short as it.
    """
    marks = [np.array([one.alignment.at(end_s) for end_s in one.taught.ends_s]) for one in teachers]
    shortest_s = min([PAUSE_S, *map(_shortest_s, teachers)])
    found: list[Boundary] = []
    for boundary in own:
        if boundary.confidence < SURE and _is_outside(boundary.time_s, marks):
            continue
        if found and _is_one_pause(found[-1], boundary, shortest_s, marks):
            found[-1] = _middle(found[-1], boundary)
        else:
            found.append(boundary)
    return tuple(found)


def _shortest_s(teacher: Teacher) -> float:
    """The shortest phase between two boundaries of a person, in the tempo of the new recording."""
    lasting = np.diff(teacher.taught.ends_s)
    return float(lasting.min()) * teacher.alignment.tempo if len(lasting) else np.inf


def _is_outside(time_s: float, marks: Sequence[Array]) -> bool:
    return not any(len(one) and one[0] - OUTSIDE_S < time_s < one[-1] + OUTSIDE_S for one in marks)


def _is_one_pause(
    first: Boundary, second: Boundary, shortest_s: float, marks: Sequence[Array]
) -> bool:
    if second.time_s - first.time_s >= shortest_s or _changes(first) or _changes(second):
        return False
    low, high = first.time_s - AROUND_S, second.time_s + AROUND_S
    once = [int(((one >= low) & (one <= high)).sum()) == 1 for one in marks]
    return 2 * sum(once) > len(once)


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
