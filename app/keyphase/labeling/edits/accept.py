"""Saying that a boundary is right as it stands."""

from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.judging import judged
from keyphase.labeling.edits.places import boundary_at, boundary_number
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class Accept(BaseEdit, frozen=True, tag="accept"):
    """The boundary at `time_s` has been seen and found right."""

    time_s: float

    def anchored(self, labeling: Labeling) -> "Accept":
        """At the exact time of the boundary."""
        return Accept(boundary_at(self.time_s, labeling).time_s)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """An accepted boundary gives way to none placed near it."""
        mark = judged(number, self.time_s, walk, insisted)
        if mark is not None:
            mark.accepted = True

    def step_name(self, labeling: Labeling) -> str:
        """With its number."""
        return f"Accept boundary {boundary_number(self.time_s, labeling)}"
