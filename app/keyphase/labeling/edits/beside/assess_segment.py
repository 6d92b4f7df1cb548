"""Saying what one thinks of a single segment, or of several in a row."""

from collections.abc import Mapping
from typing import ClassVar

import msgspec

from keyphase.errors import LabelingError
from keyphase.labeling.assessment import Assessment, Outcome
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import segments_numbered, stretch_at
from keyphase.labeling.edits.reset import Reset
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.spans import Decision, HeldSpan, Span, assign


class AssessSegment(BaseEdit, frozen=True, tag="assess_segment"):
    """Mark the segment around `time_s`, or all from there to the one around `to_s`.

    Outcome, quality from 1 to 5 and note are said together; what is left out is taken back.
    """

    changes_segments: ClassVar[bool] = False

    time_s: float
    outcome: Outcome | None = None
    quality: int | None = None
    note: str = ""
    span_s: Span | None = None
    to_s: float | None = None

    def checked(self) -> "AssessSegment":
        """With a quality on the scale, and a note of one line that is not too long."""
        said = self.assessment.checked()
        return msgspec.structs.replace(super().checked(), quality=said.quality, note=said.note)

    def anchored(self, labeling: Labeling) -> "AssessSegment":
        """At the middle of its segment; refused where it says what was said already."""
        said = self.checked()
        stretch = stretch_at(said.time_s, said.to_s, labeling)
        first, last = stretch[0], stretch[-1]
        if all(segment.assessment == said.assessment for segment in stretch):
            named = segments_numbered(said.time_s, said.to_s, labeling)
            raise LabelingError(f"Marked so already: {named}.")
        return msgspec.structs.replace(
            said,
            time_s=first.middle_s,
            span_s=(first.start_s, last.end_s),
            to_s=last.middle_s if len(stretch) > 1 else None,
        )

    @property
    def assessment(self) -> Assessment:
        """What it says."""
        return Assessment(self.outcome, self.quality, self.note)

    def step_name(self, labeling: Labeling) -> str:
        """With what has changed."""
        before = labeling.segments[labeling.segment_at(self.time_s)].assessment
        named = segments_numbered(self.time_s, self.to_s, labeling)
        return f"Mark {named} {self.assessment.change_from(before)}"


def segment_assessments(edits: Mapping[int, BaseEdit]) -> list[Decision[Assessment]]:
    """What was said of single segments, in order; finishing a recording changes nothing of it."""
    said: list[Decision[Assessment]] = []
    for number, edit in edits.items():
        if isinstance(edit, Reset):
            said.clear()
        elif isinstance(edit, AssessSegment) and edit.span_s:
            said.append(Decision(number, HeldSpan(*edit.span_s), edit.assessment))
    return said


def marked(edits: Mapping[int, BaseEdit]) -> tuple[Assessment, ...]:
    """What is said of segments, without knowing which segments there now are."""
    said = segment_assessments(edits)
    middles = sorted({sum(decision.span.span_s) / 2 for decision in said})
    return tuple(filter(None, assign(said, middles)[0].values()))
