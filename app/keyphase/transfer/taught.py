"""What a finished recording teaches: its boundaries and the names between them."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import LabelingError
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.segment_file import SegmentFile
from keyphase.segmentation import Segmentation, segment
from keyphase.transfer.evidence_places import Place, places_of
from keyphase.transfer.signals import Signals, signals_of

AGREE_S = 0.25
"""Boundaries of a person and of the program this near are one."""


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
    """A finished recording: its phases tile it, in order."""

    name: str
    demonstration: Demonstration
    phases: tuple[Phase, ...]

    @property
    def names(self) -> tuple[str, ...]:
        """The names of its phases in order: two recordings of one task have the same."""
        return tuple(phase.name for phase in self.phases)

    @cached_property
    def segmentation(self) -> Segmentation:
        """What the program finds in it by itself."""
        return segment(self.demonstration)

    @cached_property
    def agreement(self) -> tuple[float, float]:
        """How many of the program's boundaries the person kept, and how many of theirs it found."""
        own = np.array([boundary.time_s for boundary in self.segmentation.boundaries])
        theirs = np.array([phase.end_s for phase in self.phases[:-1]])
        if not (own.size and theirs.size):
            return 0.0, 0.0
        away = np.abs(own[:, None] - theirs[None])
        near = away <= AGREE_S
        return float(near.any(axis=1).mean()), float(near.any(axis=0).mean())

    @cached_property
    def anchors(self) -> tuple[Place | None, ...]:
        """The evidence each boundary belongs to; None where there is none near. No two share it."""
        places = places_of(self.segmentation)
        found = [places.of(phase.end_s) for phase in self.phases[:-1]]
        return tuple(
            place if place is not None and self._is_nearest(i, place, found) else None
            for i, place in enumerate(found)
        )

    def _is_nearest(self, number: int, place: Place, found: Sequence[Place | None]) -> bool:
        sharing = [i for i, other in enumerate(found) if other == place]
        return number == min(sharing, key=lambda i: abs(self.phases[i].end_s - place.time_s))

    @cached_property
    def signals(self) -> Signals:
        """What others are compared with."""
        return signals_of(self.demonstration)


def taught_by(labeling: Labeling) -> Taught:
    """What a labeling teaches."""
    demonstration = labeling.segmentation.demonstration
    contacts = [boundary.contact_change for boundary in labeling.boundaries]
    return _taught(demonstration, labeling.segments, contacts)


def taught_by_file(file: SegmentFile, demonstration: Demonstration) -> Taught:
    """What a segment file of this demonstration teaches."""
    contacts = [boundary.contact_change for boundary in file.boundaries]
    return _taught(demonstration, file.segments, contacts)


class _Named(Protocol):
    @property
    def start_s(self) -> float: ...
    @property
    def end_s(self) -> float: ...
    @property
    def label(self) -> str: ...
    @property
    def kept(self) -> bool: ...


def _taught(
    demonstration: Demonstration, segments: Iterable[_Named], contacts: Sequence[bool]
) -> Taught:
    phases = tuple(
        Phase(one.start_s, one.end_s, one.label, one.kept, i < len(contacts) and contacts[i])
        for i, one in enumerate(segments)
    )
    if not phases:
        raise LabelingError(f"{demonstration.name}: expected phases to learn from, but has none.")
    return Taught(demonstration.name, demonstration, phases)
