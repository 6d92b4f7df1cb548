"""Where the program alone was right on the finished recordings, it is believed on the others.

Its own boundaries stand there then, as many as it finds, moved by what the persons moved them.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from keyphase.segmentation.segmentation import Boundary, Segmentation
from keyphase.transfer.evidence_places import MIN_PROBABILITY
from keyphase.transfer.meant_places import REACH_S, meant_elsewhere_s, offsets_s
from keyphase.transfer.placing import MIN_GAP_S, Teacher
from keyphase.transfer.weighed import weighed

TRUSTED = 0.6
"""From this probability on that a boundary of the program is right, and that it finds a right one,
its own are taken. Of n boundaries with k right it is (k + 1) / (n + 3): one right of three is
supposed before anything is known, so that three of four are not enough and four are."""

MOST = 2.0 / 3.0
"""More than this share of all must have been right, however many there were."""

CLOSE_S = 0.09
"""Persons who mean boundaries farther than this from the program's mean other places."""

FAR_S = 0.125
"""Who means them farther than this away, half of what makes two boundaries different ones, means
others, where the program finds others than are proposed, too."""

UNSURE = 0.1
"""A program that expects more than this share of its boundaries to be wrong or lacking is not
believed. Where it was right on made recordings done again, all that was proposed was better."""

FITS_WELL = 0.25
"""Nothing is missing or doubled in a recording that costs less to align."""

SURE = 0.05
"""A program that expects fewer than this to be wrong or lacking may be believed even so."""

APART_S = 0.3
"""Evidence this near to one of the program's boundaries is no other boundary."""

SAME_S = 0.2
"""A boundary of the program this near to the evidence of a proposed one is the same."""


@dataclass(frozen=True)
class ProposedBoundary:
    """A boundary proposed from others.

    evidence_s  the recording's own evidence it belongs to; None where there is none
    """

    time_s: float
    confidence: float
    contact_change: bool
    evidence_s: float | None = None


def own_where_better(
    teachers: Sequence[Teacher],
    aligned: Sequence[Teacher],
    proposed: Sequence[ProposedBoundary],
    segmentation: Segmentation,
) -> tuple[ProposedBoundary, ...] | None:
    """The program's own boundaries, weighed and moved, where they are to be taken; else None.

    They are where persons kept nearly all of them and added hardly any, as those `teachers` say who
    fit, where the program is sure of what it finds here, and where persons mean no other places, as
    all that were `aligned` say. Where it finds others than are proposed, something must be missing
    or doubled in this recording.
    """
    stand = replace(segmentation, boundaries=weighed(segmentation.boundaries, teachers, aligned))
    if not stand.boundaries or not _is_trusted(teachers) or _doubt(stand) > UNSURE:
        return None
    same = _are_same(stand.boundaries, proposed)
    if meant_elsewhere_s(aligned) >= (CLOSE_S if same else FAR_S):
        return None
    if same or _may_differ(aligned) or _is_complete(aligned, proposed, stand):
        return with_own(teachers, proposed, stand)
    return None


def _are_same(own: Sequence[Boundary], proposed: Sequence[ProposedBoundary]) -> bool:
    """Whether the program finds as many as are proposed, each of them near its own."""
    if len(own) != len(proposed):
        return False
    pairs = zip(own, proposed, strict=True)
    return all(abs(mine.time_s - one.time_s) <= REACH_S for mine, one in pairs)


def _doubt(segmentation: Segmentation) -> float:
    """Which share of its boundaries the program expects to be wrong or lacking.

    Wrong by their confidence; lacking by the evidence that it did not take for a boundary.
    """
    times = np.array([boundary.time_s for boundary in segmentation.boundaries])
    wrong = sum(1.0 - boundary.confidence for boundary in segmentation.boundaries)
    lacking = sum(
        one.probability
        for one in segmentation.candidates
        if not one.given
        and one.probability >= MIN_PROBABILITY
        and np.abs(times - one.time_s).min() > APART_S
    )
    return (wrong + lacking) / len(times)


def _may_differ(aligned: Sequence[Teacher]) -> bool:
    """Whether something may be missing or doubled: it fits badly, or is in the finished ones."""
    varied = len({one.taught.names for one in aligned}) > 1
    return varied or aligned[0].alignment.cost >= FITS_WELL


def _is_complete(
    aligned: Sequence[Teacher], proposed: Sequence[ProposedBoundary], segmentation: Segmentation
) -> bool:
    """Whether the program never missed a mark, finds all that is proposed here, and is sure."""
    if any(one.taught.agreement[1] < len(one.taught.ends_s) for one in aligned):
        return False
    times = np.array([boundary.time_s for boundary in segmentation.boundaries])
    lacks = any(np.abs(times - one.time_s).min() > REACH_S for one in proposed)
    return not lacks and _doubt(segmentation) <= SURE


def means_own(aligned: Sequence[Teacher]) -> bool:
    """Whether persons mean the places that the program finds, as all that were aligned say."""
    return meant_elsewhere_s(aligned) < CLOSE_S


def _is_trusted(teachers: Sequence[Teacher]) -> bool:
    """Whether a boundary of the program is probably right, and a right one probably found."""
    kept, found = np.sum([one.taught.agreement for one in teachers], axis=0)
    all_found = sum(len(one.taught.found_s) for one in teachers)
    all_theirs = sum(len(one.taught.ends_s) for one in teachers)
    counts = ((kept, all_found), (found, all_theirs))
    return all(k > MOST * n and (k + 1) / (n + 3) >= TRUSTED for k, n in counts)


def with_own(
    teachers: Sequence[Teacher], proposed: Sequence[ProposedBoundary], segmentation: Segmentation
) -> tuple[ProposedBoundary, ...]:
    """The program's own boundaries, where the persons would have moved them to.

    One that the finished recordings have there, too, is at least as sure as they make it.
    """
    demonstration = segmentation.demonstration
    own = tuple(_confirmed(b, teachers, proposed) for b in segmentation.boundaries)
    times = [b.time_s for b in segmentation.boundaries]
    moved = [b.time_s for b in own]
    if bool((np.diff([demonstration.start_s, *moved, demonstration.end_s]) < MIN_GAP_S).any()):
        return tuple(replace(b, time_s=time) for b, time in zip(own, times, strict=True))
    return own


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
    """How far persons moved the program's boundary here, where all moved it to one side.

    One of them alone says nothing: of the mean of n a share of (n - 1) / (n + 1) is believed.
    """
    offsets = [
        offset * teacher.alignment.tempo
        for teacher in teachers
        for end_s, offset in zip(teacher.taught.ends_s, offsets_s(teacher.taught), strict=True)
        if offset is not None and abs(teacher.alignment.at(end_s) - own.time_s) <= REACH_S
    ]
    count = len(offsets)
    if not count or min(offsets) < 0.0 < max(offsets):
        return 0.0
    return (count - 1) / (count + 1) * float(np.mean(offsets))
