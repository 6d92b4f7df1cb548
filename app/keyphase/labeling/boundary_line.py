"""The boundaries of one demonstration while edits are applied to them, one after another."""

from bisect import bisect_left, bisect_right, insort
from collections.abc import Iterable
from dataclasses import dataclass, replace

from keyphase.labeling.labeling import LabeledBoundary
from keyphase.segmentation.segmentation import Boundary

REACH_S = 0.15
"""How far a boundary of the program may have wandered and still be the one that was edited: half
the default minimal distance of force boundaries."""

SAME_S = 0.05
"""A boundary of the program this near to one placed by hand is the same, and gives way."""

_EXACT_S = 1e-6


@dataclass(eq=False, slots=True)
class Mark:
    """A boundary under edit; spans of segments hold on to it, so it keeps its identity.

    proposed_confidence  how sure the proposal was that it was taken over from, where it was
    taken_from           whose it was, where it was added by taking over
    """

    time_s: float
    contact_change: bool
    automatic: Boundary | None = None
    by_hand: bool = False
    was_s: float | None = None
    accepted: bool = False
    taken_away: bool = False
    proposed_confidence: float | None = None
    taken_from: str | None = None
    frozen: LabeledBoundary | None = None

    @property
    def as_frozen(self) -> bool:
        """Whether it still is what it was when the recording was done."""
        return (
            self.frozen is not None
            and self.frozen.time_s == self.time_s
            and self.frozen.contact_change == self.contact_change
        )

    def as_boundary(self) -> LabeledBoundary:
        """The value it ends up as."""
        if self.frozen is not None and self.as_frozen:
            return replace(self.frozen, accepted=self.accepted)
        found = self.automatic
        confidence = 1.0 if self.by_hand or found is None else found.confidence
        low, high = found.interval_s if found else (self.time_s, self.time_s)
        return LabeledBoundary(
            self.time_s,
            origin="user" if self.by_hand or found is None else found.origin,
            interval_s=(min(low, self.time_s), max(high, self.time_s))
            if self.by_hand
            else (low, high),
            confidence=confidence if (own := self.proposed_confidence) is None else own,
            contact_change=self.contact_change,
            was_s=self.was_s,
            accepted=self.accepted,
            automatic=found,
            taken_from=self.taken_from,
        )


class BoundaryLine:
    """All marks of one demonstration in the order of time.

    `gap_s` is the least distance to either end of the recording and between marks: one sample.
    """

    def __init__(
        self, start_s: float, end_s: float, gap_s: float, boundaries: Iterable[Boundary]
    ) -> None:
        self.start_s = start_s
        self.end_s = end_s
        self.gap_s = gap_s
        self.marks = [Mark(b.time_s, b.contact_change, b) for b in boundaries]

    def find(self, time_s: float) -> Mark | None:
        """The mark an edit at `time_s` means: the one exactly there, else the program's nearest.

        One placed by hand stays where it was put, so it is only meant by its very time.
        """
        near = self._within(time_s, REACH_S)
        exact = [mark for mark in near if abs(mark.time_s - time_s) <= _EXACT_S]
        candidates = exact or [mark for mark in near if not mark.by_hand]
        return min(candidates, key=lambda mark: abs(mark.time_s - time_s), default=None)

    def between(self, from_s: float, to_s: float) -> list[Mark]:
        """Marks strictly between two times."""
        first = bisect_right(self.marks, from_s, key=_time)
        return self.marks[first : bisect_left(self.marks, to_s, key=_time)]

    def obstacle(self, time_s: float, moving: Mark | None = None) -> str | None:
        """Why no boundary can be put at `time_s`, or None where one can."""
        if not self.start_s + self.gap_s <= time_s <= self.end_s - self.gap_s:
            return f"{time_s:.3f} s is not inside the recording"
        for mark in self._within(time_s, self.gap_s):
            too_near = abs(mark.time_s - time_s) < self.gap_s - _EXACT_S
            if mark is not moving and too_near and not _gives_way(mark):
                return f"there is a boundary at {mark.time_s:.3f} s already"
        return None

    def place(self, mark: Mark, time_s: float) -> None:
        """Put a mark at `time_s` by hand, where there is no obstacle.

        Marks of the program within SAME_S give way; the nearest becomes this one's evidence.
        """
        if mark in self.marks:
            self.marks.remove(mark)
        near = [
            other for other in self._within(time_s, max(SAME_S, self.gap_s)) if _gives_way(other)
        ]
        for other in sorted(near, key=lambda other: abs(other.time_s - time_s)):
            self.marks.remove(other)
            mark.automatic = mark.automatic or other.automatic
        mark.time_s, mark.by_hand = time_s, True
        insort(self.marks, mark, key=_time)

    def move_by_hand(self, mark: Mark, time_s: float) -> None:
        """Put a mark elsewhere by hand; where the program had it is remembered."""
        if not mark.by_hand and mark.automatic is not None:
            mark.was_s = mark.automatic.time_s
        mark.proposed_confidence = mark.taken_from = None
        self.place(mark, time_s)

    def take_away(self, mark: Mark) -> None:
        """Remove a mark by hand."""
        self.marks.remove(mark)
        mark.taken_away = True

    def _within(self, time_s: float, reach_s: float) -> list[Mark]:
        first = bisect_left(self.marks, time_s - reach_s, key=_time)
        return self.marks[first : bisect_right(self.marks, time_s + reach_s, key=_time)]


def _time(mark: Mark) -> float:
    return mark.time_s


def _gives_way(mark: Mark) -> bool:
    return not mark.by_hand and not mark.accepted
