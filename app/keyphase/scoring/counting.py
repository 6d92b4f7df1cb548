"""Counts of boundaries against events, and the figures that follow from them."""

from collections.abc import Sequence
from dataclasses import dataclass
from statistics import median

from keyphase.labeling.comparing.matching import match_times
from keyphase.scoring.truth import Truth


@dataclass(frozen=True)
class Tally:
    """Counts of boundaries, and the distances of the matched ones from their events [s].

    found, missed   events with and without a boundary of their own
    false, ignored  boundaries without an event, that count against and that count neither way
    """

    found: int
    missed: int
    false: int
    ignored: int
    distances_s: tuple[float, ...]

    @property
    def precision(self) -> float | None:
        """Part of the boundaries that belong to an event; None without boundaries."""
        return _ratio(self.found, self.found + self.false)

    @property
    def recall(self) -> float | None:
        """Part of the events that have a boundary; None without events."""
        return _ratio(self.found, self.found + self.missed)

    @property
    def f1(self) -> float | None:
        """Harmonic mean of precision and recall; None without boundaries and events."""
        return _ratio(2 * self.found, 2 * self.found + self.false + self.missed)

    @property
    def timing_error_s(self) -> float | None:
        """Median distance of the matched boundaries from their events; None without any."""
        return median(self.distances_s) if self.distances_s else None


def tally(truth: Truth, found_s: Sequence[float]) -> Tally:
    """The strict count: every boundary at `found_s` against every event, within the tolerance."""
    matches = match_times(truth.events_s, found_s, truth.tolerance_s)
    matched = {match.found for match in matches}
    others = [time for i, time in enumerate(found_s) if i not in matched]
    ignored = sum(any(a <= time <= b for a, b in truth.ignore_s) for time in others)
    return Tally(
        found=len(matches),
        missed=len(truth.events_s) - len(matches),
        false=len(others) - ignored,
        ignored=ignored,
        distances_s=tuple(abs(truth.events_s[m.reference] - found_s[m.found]) for m in matches),
    )


def together(tallies: Sequence[Tally]) -> Tally:
    """The counts of several recordings as one."""
    return Tally(
        found=sum(each.found for each in tallies),
        missed=sum(each.missed for each in tallies),
        false=sum(each.false for each in tallies),
        ignored=sum(each.ignored for each in tallies),
        distances_s=tuple(distance for each in tallies for distance in each.distances_s),
    )


def _ratio(part: int, whole: int) -> float | None:
    return part / whole if whole else None
