"""Ordering the plan."""

from keyphase.errors import LabelingError
from keyphase.labeling.edits.base import BaseEdit, InForce
from keyphase.labeling.edits.places import segment_at, span_of
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.spans import Span
from keyphase.labeling.walk import Walk

MAX_PLAN_LENGTH = 10_000
"""Entries."""


class Plan(BaseEdit, frozen=True, tag="plan"):
    """Execute the segments around these times, in this order; a time may come again.

    spans_s     the segments' spans, one for each time
    left_out_s  spans of the kept segments that are not to be executed
    """

    order: tuple[float, ...]
    spans_s: tuple[Span, ...] | None = None
    left_out_s: tuple[Span, ...] = ()

    def checked(self) -> "Plan":
        """Of a length that a plan can have."""
        spans = self.spans_s
        too_long = max(len(self.order), len(self.left_out_s)) > MAX_PLAN_LENGTH
        if too_long or (spans is not None and len(spans) != len(self.order)):
            raise LabelingError(
                f"A plan has at most {MAX_PLAN_LENGTH} entries and a span for each or none, but "
                f"this one has {len(self.order)}."
            )
        return super().checked()

    def anchored(self, labeling: Labeling) -> "Plan":
        """With the spans of what is executed and of what is left out; kept segments only."""
        segments = [segment_at(time, labeling) for time in self.order]
        for segment in segments:
            if not segment.kept:
                raise LabelingError(
                    f"The plan holds kept segments only, but “{segment.label}” at "
                    f"{segment.start_s:.3f} s is dropped; keep it first."
                )
        left_out = [s for s in labeling.segments if s.kept and s not in segments]
        return Plan(
            tuple(segment.middle_s for segment in segments),
            tuple(span_of(segment) for segment in segments),
            tuple(span_of(segment) for segment in left_out),
        )

    def enter(self, number: int, in_force: InForce) -> None:
        """Of several plans only the last counts."""
        if in_force.plan is not None:
            in_force.forget(in_force.plan)
        in_force.plan = number
        in_force.edits[number] = self

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """Replace the plan."""
        spans = self.spans_s or tuple(walk.around(time) for time in self.order)
        walk.set_plan(spans, self.left_out_s)

    def step_name(self, labeling: Labeling) -> str:
        """One name for every order."""
        return "Change the plan"
