"""What a finished recording teaches: its boundaries and the names between them."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Protocol

import numpy as np

from keyphase.demonstration import Demonstration, Source
from keyphase.errors import LabelingError
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.segment_file import SegmentFile
from keyphase.segmentation import Parameters, Segmentation, segment
from keyphase.transfer.evidence_places import Place, PlaceKind, Places, places_of
from keyphase.transfer.signals import Signals, signals_of

AGREE_S = 0.25
"""Boundaries of a person and of the program this near are one."""

_AROUND_S = np.linspace(0.05, 0.4, 8)


@dataclass(frozen=True, eq=False)
class Phase:
    """One phase as it was taught: its name, whether it is kept, whether contact ends it."""

    start_s: float
    end_s: float
    name: str
    kept: bool
    ends_in_contact: bool


@dataclass(frozen=True, eq=False)
class Taught:
    """A finished recording, as far as others are compared with it: small, whatever its length.

    phases  tile it, in order
    places  where it has evidence of its own
    found_s boundaries that the program finds in it by itself
    source  the file it was read from
    """

    name: str
    phases: tuple[Phase, ...]
    signals: Signals
    places: Places
    found_s: tuple[float, ...]
    source: Source | None = None

    @property
    def names(self) -> tuple[str, ...]:
        """The names of its phases in order: two recordings of one task have the same."""
        return tuple(phase.name for phase in self.phases)

    @property
    def ends_s(self) -> tuple[float, ...]:
        """Its boundaries: the ends of all phases but the last."""
        return tuple(phase.end_s for phase in self.phases[:-1])

    @cached_property
    def agreement(self) -> tuple[int, int]:
        """How many of the program's boundaries the person kept, and how many of theirs it found."""
        if not (self.found_s and self.ends_s):
            return 0, 0
        away = np.abs(np.array(self.found_s)[:, None] - np.array(self.ends_s)[None])
        near = away <= AGREE_S
        return int(near.any(axis=1).sum()), int(near.any(axis=0).sum())

    @cached_property
    def anchors(self) -> tuple[Place | None, ...]:
        """The evidence each boundary belongs to; None where there is none near. No two share it."""
        found = [self.places.of(end_s) for end_s in self.ends_s]
        return tuple(
            place if place is not None and self._is_nearest(i, place, found) else None
            for i, place in enumerate(found)
        )

    @cached_property
    def kinds(self) -> tuple[str, ...]:
        """What happens at each boundary: its evidence, of motion whether it begins or stops."""
        found = zip(self.ends_s, self.anchors, strict=True)
        return tuple(
            "none" if place is None else kind_of(place.kind, end_s, self.signals)
            for end_s, place in found
        )

    def in_order(self, order: Sequence[int]) -> "Taught":
        """As it would be, had its phases been done in this order: some left out, some again."""
        pieces = [self._piece(order[0], None)]
        for number in order[1:]:
            pieces.append(self._piece(number, pieces[-1]))
        return replace(
            self,
            phases=tuple(piece.phases[0] for piece in pieces),
            signals=replace(
                self.signals,
                time_s=np.concatenate([piece.signals.time_s for piece in pieces]),
                values=np.concatenate([piece.signals.values for piece in pieces]),
            ),
            places=Places(tuple(place for piece in pieces for place in piece.places.all)),
            found_s=tuple(time_s for piece in pieces for time_s in piece.found_s),
        )

    def _piece(self, number: int, before: "Taught | None") -> "Taught":
        """One phase alone, so much later that its samples follow those of the one before."""
        phase = self.phases[number]
        time_s, is_last = self.signals.time_s, number == len(self.phases) - 1
        rows = (time_s >= phase.start_s) & ((time_s < phase.end_s) | is_last)
        begun_s = self.phases[0].start_s if before is None else before.phases[0].end_s
        later_s = begun_s - phase.start_s
        if before is not None:
            later_s = before.signals.time_s[-1] + self.signals.step_s - time_s[rows][0]
        places = [one for one in self.places.all if phase.start_s <= one.time_s < phase.end_s]
        found = [at_s for at_s in self.found_s if phase.start_s <= at_s < phase.end_s]
        return replace(
            self,
            phases=(replace(phase, start_s=begun_s, end_s=phase.end_s + later_s),),
            signals=replace(
                self.signals, time_s=time_s[rows] + later_s, values=self.signals.values[rows]
            ),
            places=Places(tuple(replace(one, time_s=one.time_s + later_s) for one in places)),
            found_s=tuple(at_s + later_s for at_s in found),
        )

    def _is_nearest(self, number: int, place: Place, found: Sequence[Place | None]) -> bool:
        sharing = [i for i, other in enumerate(found) if other == place]
        return number == min(sharing, key=lambda i: abs(self.ends_s[i] - place.time_s))


def taught_by(labeling: Labeling) -> Taught:
    """What a labeling teaches."""
    contacts = [boundary.contact_change for boundary in labeling.boundaries]
    return taught_from(labeling.segmentation, _phases(labeling.segments, contacts))


def taught_by_file(file: SegmentFile, demonstration: Demonstration) -> Taught:
    """What a segment file of this demonstration teaches."""
    contacts = [boundary.contact_change for boundary in file.boundaries]
    return taught_from(segment(demonstration), _phases(file.segments, contacts))


def taught_from(segmentation: Segmentation, phases: tuple[Phase, ...]) -> Taught:
    """What these phases teach of the recording of a segmentation.

    Its evidence is what the program finds with its own parameters, whatever a person has set.

    Raises LabelingError where there are no phases.
    """
    demonstration = segmentation.demonstration
    if not phases:
        raise LabelingError(f"{demonstration.name}: expected phases to learn from, but has none.")
    is_own = segmentation.parameters == Parameters()
    own = segmentation if is_own else segment(demonstration)
    return Taught(
        demonstration.name,
        phases,
        signals_of(demonstration),
        places_of(own),
        tuple(boundary.time_s for boundary in own.boundaries),
        demonstration.source,
    )


def kind_of(kind: PlaceKind, time_s: float, signals: Signals) -> str:
    """The kind of a boundary; where the motion changes, whether it begins or stops there."""
    if kind != "motion":
        return kind
    speed = signals.only(["speed"])
    faster = speed.between(time_s + _AROUND_S).mean() > speed.between(time_s - _AROUND_S).mean()
    return "begins" if faster else "stops"


class _Named(Protocol):
    @property
    def start_s(self) -> float: ...
    @property
    def end_s(self) -> float: ...
    @property
    def label(self) -> str: ...
    @property
    def kept(self) -> bool: ...


def _phases(segments: Iterable[_Named], contacts: Sequence[bool]) -> tuple[Phase, ...]:
    return tuple(
        Phase(one.start_s, one.end_s, one.label, one.kept, i < len(contacts) and contacts[i])
        for i, one in enumerate(segments)
    )
