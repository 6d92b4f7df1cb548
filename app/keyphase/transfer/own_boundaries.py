"""Where the program alone was right on the finished recordings, it is believed on the others.

Its own boundaries stand there then, as many as it finds, moved by what the persons moved them.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from keyphase.segmentation.segmentation import Boundary, Segmentation
from keyphase.transfer.evidence_places import REACH_S
from keyphase.transfer.placing import MIN_GAP_S, Teacher
from keyphase.transfer.taught import Taught

TRUSTED = 0.65
"""From this probability on that a boundary of the program is right, and that it finds a right one,
its own are taken. Of n boundaries with k right it is (k + 1) / (n + 2), after Laplace."""

CLOSE_S = 0.08
"""Persons whose boundaries typically lie farther than this from the program's mean other places."""

APART_S = 0.4
"""A proposed boundary this far from all of the program's is one more."""

SAME_S = 0.2
"""A boundary of the program this near to the evidence of a proposed one is the same."""

SURE_ENOUGH = 0.8
"""A proposed boundary that the program passed over is taken from this confidence on."""


@dataclass(frozen=True)
class ProposedBoundary:
    """A boundary proposed from others.

    evidence_s  the recording's own evidence it belongs to; None where there is none
    """

    time_s: float
    confidence: float
    contact_change: bool
    evidence_s: float | None = None


def is_better(
    taught: Sequence[Taught], proposed: Sequence[ProposedBoundary], segmentation: Segmentation
) -> bool:
    """Whether the program's own boundaries are to be taken rather than those proposed.

    They are where persons kept nearly all of them and added hardly any, and it now finds another
    number than is proposed: something is missing or doubled. Where it finds as many, only if the
    persons had left them where they were.
    """
    if _trust(taught) < TRUSTED:
        return False
    if len(segmentation.boundaries) != len(proposed):
        return True
    offsets = [abs(o) for one in taught for o in _offsets_s(one) if o is not None]
    return bool(offsets) and float(np.median(offsets)) < CLOSE_S


def _trust(taught: Sequence[Taught]) -> float:
    """How probable it is that a boundary of the program is right, and a right one found."""
    kept, found = np.sum([one.agreement for one in taught], axis=0)
    all_found = sum(len(one.found_s) for one in taught)
    all_theirs = sum(len(one.ends_s) for one in taught)
    return float(min((kept + 1) / (all_found + 2), (found + 1) / (all_theirs + 2)))


def with_own(
    teachers: Sequence[Teacher], proposed: Sequence[ProposedBoundary], segmentation: Segmentation
) -> tuple[ProposedBoundary, ...]:
    """The program's own boundaries, and those proposed ones it passed over but has evidence for.

    One that the finished recordings have there, too, is at least as sure as they make it.
    """
    demonstration = segmentation.demonstration
    own = [_confirmed(b, teachers, proposed) for b in segmentation.boundaries]
    times = np.array([b.time_s for b in segmentation.boundaries] or [np.inf])
    more = [
        b
        for b in proposed
        if np.abs(times - b.time_s).min() > APART_S
        and b.confidence >= SURE_ENOUGH
        and b.evidence_s is not None
    ]
    moved = [b.time_s for b in own]
    if bool((np.diff([demonstration.start_s, *moved, demonstration.end_s]) < MIN_GAP_S).any()):
        own = [replace(b, time_s=time) for b, time in zip(own, times.tolist(), strict=True)]
    return tuple(sorted([*own, *more], key=lambda boundary: boundary.time_s))


def _confirmed(
    own: Boundary, teachers: Sequence[Teacher], proposed: Sequence[ProposedBoundary]
) -> ProposedBoundary:
    same = _belonging(own, proposed)
    confidence = own.confidence if same is None else max(own.confidence, same.confidence)
    time_s = own.time_s + _moved_by(own, teachers)
    return ProposedBoundary(time_s, confidence, own.contact_change, own.time_s)


def _belonging(own: Boundary, proposed: Sequence[ProposedBoundary]) -> ProposedBoundary | None:
    """The proposed boundary that belongs to the evidence of one of the program's."""
    near = [
        (abs(b.evidence_s - own.time_s), i)
        for i, b in enumerate(proposed)
        if b.evidence_s is not None and abs(b.evidence_s - own.time_s) <= SAME_S
    ]
    return proposed[min(near)[1]] if near else None


def _moved_by(own: Boundary, teachers: Sequence[Teacher]) -> float:
    """How far persons moved the program's boundary here.

    One of them alone says nothing: of the mean of n a share of (n - 1) / (n + 1) is believed.
    """
    offsets = [
        offset
        for teacher in teachers
        for end_s, offset in zip(teacher.taught.ends_s, _offsets_s(teacher.taught), strict=True)
        if offset is not None and abs(teacher.alignment.at(end_s) - own.time_s) <= REACH_S
    ]
    count = len(offsets)
    return (count - 1) / (count + 1) * float(np.mean(offsets)) if count else 0.0


def _offsets_s(taught: Taught) -> list[float | None]:
    """How far each taught boundary lies from the program's; None where it found none there."""
    found = np.array(taught.found_s)
    nearest = [float(found[np.abs(found - end_s).argmin()]) for end_s in taught.ends_s]
    return [
        end_s - at if abs(end_s - at) <= REACH_S else None
        for end_s, at in zip(taught.ends_s, nearest, strict=True)
    ]
