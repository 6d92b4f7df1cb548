"""Judging only what a reference can judge, and never more kindly than that.

Where a reference labels contact changes only, boundaries that claim none take no part: they are
neither hits nor false, however many there are. Everywhere else every boundary is judged.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from keyphase.scoring.counting import Tally
from keyphase.scoring.truth import Interval, Judged, Kind, ReferenceEvent


@dataclass(frozen=True)
class Claim:
    """What a boundary claims: when, whether contact changed there, how sure that is (0 to 1), and
    whether motion changed there."""

    time_s: float
    contact_change: bool
    confidence: float
    motion: bool = True


@dataclass(frozen=True)
class Verdict:
    """What the claims of one recording are worth.

    tally     counts over the claims that take part; those that do not are among the ignored
    outcomes  (confidence, whether it was right) of every claim that counts
    kinds     counts of contact changes and of motion alone, where the reference tells kinds
    """

    tally: Tally
    outcomes: tuple[tuple[float, bool], ...]
    kinds: dict[Kind, Tally]


def judge(judged: Judged, claims: Sequence[Claim]) -> Verdict:
    """Judge the boundaries of one recording."""
    part = [c for c in claims if c.contact_change] if judged.what == "contact" else list(claims)
    tally, outcomes = _judge(judged, judged.events, part, len(claims) - len(part))
    return Verdict(tally, outcomes, _by_kind(judged, claims))


def match(events: Sequence[ReferenceEvent], times_s: Sequence[float]) -> list[int | None]:
    """For each time the index of its event, or None: as many as possible, then the nearest."""
    from scipy.optimize import linear_sum_assignment

    owner: list[int | None] = [None] * len(times_s)
    if not events or not len(times_s):
        return owner
    late = np.subtract.outer(np.asarray(times_s, float), [event.time_s for event in events])
    before, after = np.array([event.window_s for event in events]).T
    inside = (late >= -before - 1e-9) & (late <= after + 1e-9)
    # Any match outweighs all distances together, so their number comes first.
    worth = 1.0 + float(np.max([before, after])) * (min(late.shape) + 1)
    rows, columns = linear_sum_assignment(np.where(inside, np.abs(late) - worth, 0.0))
    for row, column in zip(rows.tolist(), columns.tolist(), strict=True):
        if inside[row, column]:
            owner[row] = column
    return owner


def _judge(
    judged: Judged, events: Sequence[ReferenceEvent], claims: Sequence[Claim], aside: int
) -> tuple[Tally, tuple[tuple[float, bool], ...]]:
    owner = match(events, [claim.time_s for claim in claims])
    neither = [
        own is None and _counts_neither_way(judged, events, claim)
        for own, claim in zip(owner, claims, strict=True)
    ]
    pairs = list(zip(owner, claims, strict=True))
    distances = [abs(c.time_s - events[own].time_s) for own, c in pairs if own is not None]
    counted = Tally(
        found=len(distances),
        missed=len(events) - len(distances),
        false=len(claims) - len(distances) - sum(neither),
        ignored=aside + sum(neither),
        distances_s=tuple(distances),
    )
    outcomes = [
        (claim.confidence, own is not None)
        for (own, claim), out in zip(pairs, neither, strict=True)
        if not out
    ]
    return counted, tuple(outcomes)


def _counts_neither_way(judged: Judged, events: Sequence[ReferenceEvent], claim: Claim) -> bool:
    """In a stretch to ignore, and no second boundary for an event that has its own."""
    if any(-e.window_s[0] <= claim.time_s - e.time_s <= e.window_s[1] for e in events):
        return False
    if _within(judged.ignore_s, claim.time_s):
        return True
    return not claim.contact_change and _within(judged.ignore_motion_s, claim.time_s)


def _by_kind(judged: Judged, claims: Sequence[Claim]) -> dict[Kind, Tally]:
    """Contact: the claims of a contact change against contact events. Motion: the claims of motion
    against motion events, but an unmatched one that claims a contact change is judged as that."""
    if judged.what == "contact" or any(event.kind is None for event in judged.events):
        return {}
    contact = [event for event in judged.events if event.kind == "contact"]
    motion = [event for event in judged.events if event.kind == "motion"]
    claimed = [claim for claim in claims if claim.contact_change]
    moved = [claim for claim in claims if claim.motion or not claim.contact_change]
    owner = match(motion, [claim.time_s for claim in moved])
    near = _windows(contact)
    counting = [
        claim
        for own, claim in zip(owner, moved, strict=True)
        if own is not None or not (claim.contact_change or _within(near, claim.time_s))
    ]
    return {
        "contact": _judge(judged, contact, claimed, 0)[0],
        "motion": _judge(judged, motion, counting, len(moved) - len(counting))[0],
    }


def _windows(events: Sequence[ReferenceEvent]) -> list[Interval]:
    return [(e.time_s - e.window_s[0], e.time_s + e.window_s[1]) for e in events]


def _within(intervals: Sequence[Interval], time_s: float) -> bool:
    return any(low <= time_s <= high for low, high in intervals)
