"""Keeping or dropping a segment."""

from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import segment_at, segment_number, span_of
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.spans import Span
from keyphase.labeling.walk import Walk


class Keep(BaseEdit, frozen=True, tag="keep"):
    """Keep or drop the segment around `time_s`."""

    time_s: float
    kept: bool
    span_s: Span | None = None

    def anchored(self, labeling: Labeling) -> "Keep":
        """At the middle of its segment, with the segment's span."""
        segment = segment_at(self.time_s, labeling)
        return Keep(segment.middle_s, self.kept, span_of(segment))

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """The latest decision about a segment wins."""
        walk.decide_kept(number, walk.held(self.time_s, self.span_s, insisted), self.kept)

    def step_name(self, labeling: Labeling) -> str:
        """With the number of the segment."""
        verb = "Keep" if self.kept else "Drop"
        return f"{verb} segment {segment_number(self.time_s, labeling)}"
