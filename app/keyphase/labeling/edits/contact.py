"""Saying whether a boundary is a contact change."""

from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.judging import judged
from keyphase.labeling.edits.places import boundary_at, boundary_number
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class Contact(BaseEdit, frozen=True, tag="contact"):
    """Say whether the boundary at `time_s` is a contact change."""

    time_s: float
    contact_change: bool

    def anchored(self, labeling: Labeling) -> "Contact":
        """At the exact time of the boundary."""
        return Contact(boundary_at(self.time_s, labeling).time_s, self.contact_change)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """A person's word about contact wins over the force's."""
        mark = judged(number, self.time_s, walk, insisted)
        if mark is not None:
            mark.contact_change = self.contact_change

    def step_name(self, labeling: Labeling) -> str:
        """With what it now is."""
        what = "a contact change" if self.contact_change else "no contact change"
        return f"Boundary {boundary_number(self.time_s, labeling)} is {what}"
