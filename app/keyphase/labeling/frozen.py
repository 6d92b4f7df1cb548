"""What a person saw when finishing with a recording, as values that nothing changes later.

Other parameters and newer methods find other boundaries; whoever said "done" said it of these.
"""

from collections.abc import Mapping
from dataclasses import asdict, fields
from itertools import pairwise
from typing import Any

import msgspec

from keyphase import __version__
from keyphase.errors import KeyphaseError, LabelingError
from keyphase.labeling.labeling import LabeledBoundary, LabeledSegment, Labeling
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, EndCondition
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Boundary, Origin, Segment

MAX_SEGMENTS = 100_000
MAX_ENTRIES = 100_000
"""Of a plan."""


class FrozenBoundary(msgspec.Struct, frozen=True, omit_defaults=True):
    """A boundary as it stood; see `LabeledBoundary`."""

    time_s: float
    origin: Origin
    interval_s: tuple[float, float]
    confidence: float
    contact_change: bool
    was_s: float | None = None
    accepted: bool = False
    taken_from: str | None = None

    @classmethod
    def of(cls, boundary: LabeledBoundary) -> "FrozenBoundary":
        """The values of a boundary."""
        return cls(**{name: getattr(boundary, name) for name in cls.__struct_fields__})

    def as_labeled(self, found: Boundary | None) -> LabeledBoundary:
        """The boundary again, with what the program finds there by now as its evidence."""
        values = {name: getattr(self, name) for name in self.__struct_fields__}
        return LabeledBoundary(**values, automatic=found)


class FrozenSegment(msgspec.Struct, frozen=True, omit_defaults=True):
    """A segment as it stood; see `LabeledSegment`. `undecided`: nobody said whether to keep it."""

    start_s: float
    end_s: float
    label: str
    proposed: bool
    kept: bool
    idle: bool
    color: int
    end_condition: dict[str, Any]
    undecided: bool = False

    @classmethod
    def of(cls, segment: LabeledSegment, undecided: bool) -> "FrozenSegment":
        """The values of a segment."""
        shared = {n: getattr(segment, n) for n in cls.__struct_fields__ if hasattr(segment, n)}
        end = end_condition_as_json(segment.end_condition)
        return cls(**{**shared, "end_condition": end, "undecided": undecided})

    @property
    def span_s(self) -> tuple[float, float]:
        """Start and end [s]."""
        return self.start_s, self.end_s

    def as_segment(self) -> Segment:
        """The segment as the program would propose it, had it found this one."""
        end = end_condition_from_json(self.end_condition)
        return Segment(self.start_s, self.end_s, self.label, self.idle, end)


class Frozen(msgspec.Struct, frozen=True, omit_defaults=True):
    """Boundaries, segments and plan as values; `plan` holds indices of segments.

    parameters, software  what had made them
    """

    boundaries: tuple[FrozenBoundary, ...]
    segments: tuple[FrozenSegment, ...]
    plan: tuple[int, ...]
    parameters: dict[str, Any]
    software: str

    @classmethod
    def of(cls, labeling: Labeling) -> "Frozen":
        """What is seen now."""
        undecided = set(labeling.proposed_drops)
        return cls(
            tuple(map(FrozenBoundary.of, labeling.boundaries)),
            tuple(FrozenSegment.of(s, i in undecided) for i, s in enumerate(labeling.segments)),
            tuple(entry.segment for entry in labeling.plan),
            asdict(labeling.parameters),
            f"keyphase {__version__}",
        )

    def checked(self) -> "Frozen":
        """The same; raises LabelingError where the values contradict each other."""
        times = [boundary.time_s for boundary in self.boundaries]
        if len(self.segments) > MAX_SEGMENTS or len(self.plan) > MAX_ENTRIES:
            raise LabelingError("A finished recording has at most 100 000 segments and entries.")
        if [s.start_s for s in self.segments[1:]] != times:
            raise LabelingError("Finished segments must meet at their boundaries.")
        if [s.end_s for s in self.segments[:-1]] != times or not self.segments:
            raise LabelingError("Finished segments must meet at their boundaries.")
        edges = [self.segments[0].start_s, *times, self.segments[-1].end_s]
        if any(b <= a for a, b in pairwise(edges)):
            raise LabelingError("Finished segments must ascend in time.")
        if any(not 0 <= i < len(self.segments) for i in self.plan):
            raise LabelingError("The plan of a finished recording must name its segments.")
        for segment in self.segments:
            end_condition_from_json(segment.end_condition)
        return self

    def made_with(self) -> Parameters:
        """The parameters that had made it, as far as this version knows them."""
        known = {each.name for each in fields(Parameters)}
        try:
            return Parameters(**{n: v for n, v in self.parameters.items() if n in known})
        except (KeyphaseError, ArithmeticError, TypeError, ValueError):
            return Parameters()


def end_condition_as_json(end: EndCondition) -> dict[str, Any]:
    """An end condition as JSON values, with its kind: what a journal gives back is the same."""
    kind = "contact" if isinstance(end, ContactEnd) else "configuration"
    return {"kind": kind, **msgspec.json.decode(msgspec.json.encode(asdict(end)))}


def end_condition_from_json(content: Mapping[str, Any]) -> EndCondition:
    """The end condition that JSON values describe; fields that are not known are left out.

    Raises LabelingError where they describe none.
    """
    kind = ContactEnd if content.get("kind") == "contact" else ConfigurationEnd
    known = {each.name for each in fields(kind)}
    try:
        return msgspec.convert({n: v for n, v in content.items() if n in known}, kind)
    except (KeyphaseError, msgspec.ValidationError, OverflowError) as error:
        raise LabelingError(f"A finished segment has no end condition: {error}") from error
