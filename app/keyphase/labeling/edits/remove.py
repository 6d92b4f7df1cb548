"""Taking a boundary away."""

from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import boundary_at, boundary_number
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class Remove(BaseEdit, frozen=True, tag="remove"):
    """Take the boundary at `time_s` away."""

    time_s: float

    def anchored(self, labeling: Labeling) -> "Remove":
        """At the exact time of the boundary."""
        return Remove(boundary_at(self.time_s, labeling).time_s)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """Where the boundary is not found there is nothing to do."""
        walk.forget_holds()
        walk.settle(self.time_s)
        mark = walk.line.find(self.time_s)
        if mark is not None:
            walk.line.take_away(mark)

    def step_name(self, labeling: Labeling) -> str:
        """With the number it had."""
        return f"Remove boundary {boundary_number(self.time_s, labeling)}"
