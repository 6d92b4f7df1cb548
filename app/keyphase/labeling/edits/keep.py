"""Keeping or dropping a segment."""

from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import segments_numbered, stretch_at
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.spans import Span
from keyphase.labeling.walk import Walk


class Keep(BaseEdit, frozen=True, tag="keep"):
    """Keep or drop the segment around `time_s`, or all from there to the one around `to_s`."""

    time_s: float
    kept: bool
    span_s: Span | None = None
    to_s: float | None = None

    def anchored(self, labeling: Labeling) -> "Keep":
        """At the middle of its segment, with the span of all it is about."""
        first, *more = stretch_at(self.time_s, self.to_s, labeling)
        last = more[-1] if more else first
        span = first.start_s, last.end_s
        return Keep(first.middle_s, self.kept, span, last.middle_s if more else None)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """The latest decision about a segment wins."""
        walk.decide_kept(number, walk.held(self.time_s, self.span_s, insisted), self.kept)

    def step_name(self, labeling: Labeling) -> str:
        """With the number of the segment, or of the first and the last."""
        verb = "Keep" if self.kept else "Drop"
        return f"{verb} {segments_numbered(self.time_s, self.to_s, labeling)}"
