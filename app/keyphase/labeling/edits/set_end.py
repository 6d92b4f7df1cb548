"""Saying when a segment is over."""

from typing import Any

from keyphase.errors import LabelingError
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import segment_at, segment_number, span_of
from keyphase.labeling.frozen import end_condition_from_json
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.spans import Span
from keyphase.labeling.walk import Walk
from keyphase.segmentation.end_condition import ContactEnd, EndCondition


class SetEnd(BaseEdit, frozen=True, tag="end"):
    """Give the segment around `time_s` an end condition; None gives it back the program's own.

    end  as a segment file has it: kind, direction, threshold_N, release, tolerances, offset_m,
         timeout_s; whether the demonstration agrees is found anew
    """

    time_s: float
    end: dict[str, Any] | None = None
    span_s: Span | None = None

    def checked(self) -> "SetEnd":
        """With a condition that can be met."""
        self.condition()
        return super().checked()

    def condition(self) -> EndCondition | None:
        """What the segment is to end at. Raises LabelingError where `end` describes nothing."""
        if self.end is None:
            return None
        try:
            if self.end.get("kind") not in ("contact", "configuration"):
                raise LabelingError("its kind must be contact or configuration")
            return end_condition_from_json({**self.end, "agrees": None})
        except LabelingError as error:
            raise LabelingError(
                f"An end condition must be that of a contact (direction, threshold_N) or of a "
                f"configuration (tolerances): {error}."
            ) from error

    def anchored(self, labeling: Labeling) -> "SetEnd":
        """At the middle of its segment, with the segment's span."""
        self.condition()
        segment = segment_at(self.time_s, labeling)
        return SetEnd(segment.middle_s, self.end, span_of(segment))

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """The latest end condition of a segment wins."""
        held = walk.held(self.time_s, self.span_s, insisted)
        walk.decide_end(number, held, self.condition())

    def step_name(self, labeling: Labeling) -> str:
        """With what the segment now ends at."""
        segment, end = segment_number(self.time_s, labeling), self.condition()
        if end is None:
            return f"Give segment {segment} its proposed end"
        if isinstance(end, ContactEnd):
            return f"End segment {segment} at {end.threshold_N:.1f} N"
        return f"End segment {segment} within {1e3 * end.position_tolerance_m:.3g} mm"
