"""Whether a demonstration ends at its own end condition, when its poses and forces are fed to it.

A skill whose condition does not end its own demonstration will not end a replay either.
"""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition.travel import RATE_HZ, last_way, sampled
from keyphase.segmentation.end_condition.values import ContactEnd, EndCondition
from keyphase.segmentation.end_condition.watch import (
    DEBOUNCE_S,
    Arming,
    arming_for,
    contact_time,
)

WITHIN_S = 0.25
"""A demonstration ends at its condition if that is found so near to where it ended."""

EARLY_S = 0.05
"""A boundary that lies further before its contact than this was not put at it."""

DRAGGED_S = 0.2
"""A boundary that lies no further from its contact than this has not left it."""

MOVED_S = (0.0, -0.05, 0.05, -0.1, 0.1, -0.15, 0.15, -DRAGGED_S, DRAGGED_S)
"""Where the contact of such a boundary is looked for, the nearest first."""

LEAST_S = 0.1
"""What follows a contact is left at least this long."""


@dataclass(frozen=True, eq=False)
class OwnDemonstration:
    """The stretch of a demonstration that a skill repeats, ready to be asked many times.

    position_m, force_N (M, 3) at 250 Hz from `start_s` until 0.25 s beyond `end_s`
    way                 (3,) the last 10 mm before the end; None where the tool hardly moved
    """

    start_s: float
    end_s: float
    position_m: Array
    force_N: Array
    way: Array | None

    @classmethod
    def of(cls, demonstration: Demonstration, start_s: float, end_s: float) -> "OwnDemonstration":
        """The stretch of a demonstration with force."""
        until = min(end_s + WITHIN_S, demonstration.end_s)
        _, position, force = sampled(demonstration, start_s, until)
        assert force is not None
        own = max(round((end_s - start_s) * RATE_HZ), 1) + 1
        way = last_way(position[:own])
        return cls(start_s, end_s, position, force, None if way is None else way[0])

    def travel(self, end: ContactEnd) -> Array:
        """(3,) in which the tool meets the contact: by its way, else against the force."""
        return -np.asarray(end.direction) if self.way is None else self.way

    def arming(self, travel: Array) -> Arming:
        """From where on a contact counts on this way."""
        way = float((self._end_m() - self.position_m[0]) @ travel)
        return arming_for(way, self.end_s - self.start_s)

    def ended_s(self, end: ContactEnd) -> float | None:
        """When the condition is met, in the demonstration's time; None where it never is."""
        travel = self.travel(end)
        before = (self._end_m() - self.position_m) @ travel
        along = self.force_N @ np.asarray(end.direction)
        time = contact_time(self.arming(travel), before, along, end.threshold_N, 1.0 / RATE_HZ)
        return None if time is None else self.start_s + time

    def misses_by(self, end: ContactEnd, event_s: float | None = None) -> float:
        """How far from its end it is over [s]; infinite where it never is.

        The end is the boundary or, where a person has dragged that, the contact: whichever of the
        two, or of the moments between them, is nearest.
        """
        ended = self.ended_s(end)
        if ended is None:
            return np.inf
        early, late = sorted((self.end_s, self.end_s if event_s is None else event_s))
        return max(early - ended, ended - late, 0.0)

    def _end_m(self) -> Array:
        own = max(round((self.end_s - self.start_s) * RATE_HZ), 1)
        return self.position_m[min(own, len(self.position_m) - 1)]


def agrees(demonstration: Demonstration, start_s: float, end_s: float, end: ContactEnd) -> bool:
    """Whether the stretch from `start_s` to `end_s` ends at `end` within 0.25 s of its end."""
    if demonstration.force_N is None:
        return False
    return OwnDemonstration.of(demonstration, start_s, end_s).misses_by(end) < WITHIN_S


def met_beside_s(
    demonstration: Demonstration, start_s: float, end_s: float, end: EndCondition
) -> float | None:
    """When the demonstration met the contact of a segment that was cut beside it [s].

    None where there is no contact, where the boundary lies at it, or after it and still ends at it,
    and where the demonstration would not end at it if it were cut there.
    """
    if not isinstance(end, ContactEnd) or end.agrees is False or demonstration.force_N is None:
        return None
    # How far it is to the contact says from where on a force counts: one that agreed before its
    # boundary was dragged is tried as if it were cut elsewhere.
    for moved_s in MOVED_S if end.agrees else (0.0,):
        cut_s = end_s + moved_s
        if cut_s - start_s < LEAST_S:
            continue
        ended_s = OwnDemonstration.of(demonstration, start_s, cut_s).ended_s(end)
        if ended_s is None or abs(ended_s - cut_s) >= WITHIN_S:
            continue
        met_s = ended_s - DEBOUNCE_S
        if moved_s == 0.0 and met_s <= end_s + EARLY_S:
            return None
        if met_s - start_s >= LEAST_S and agrees(demonstration, start_s, met_s, end):
            return met_s
        if moved_s == 0.0:
            return None
    return None
