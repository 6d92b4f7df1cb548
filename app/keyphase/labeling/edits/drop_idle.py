"""Dropping all idle segments at once."""

from keyphase.errors import LabelingError
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class DropIdle(BaseEdit, frozen=True, tag="drop_idle"):
    """Drop every idle segment."""

    def anchored(self, labeling: Labeling) -> "DropIdle":
        """Refused where no idle segment is left to drop."""
        if not any(s.idle and s.kept for s in labeling.segments) and not labeling.proposed_drops:
            raise LabelingError("No idle segment is left to drop.")
        return self

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """It overrules what was decided about idle segments before."""
        walk.drop_idle()

    def step_name(self, labeling: Labeling) -> str:
        """With how many there are to drop."""
        count = sum(
            s.idle and (s.kept or i in labeling.proposed_drops)
            for i, s in enumerate(labeling.segments)
        )
        return f"Drop {count} idle segment" + ("" if count == 1 else "s")
