"""Making one named segment of a stretch of time, as by holding a key while it plays."""

from keyphase.errors import LabelingError
from keyphase.labeling.boundary_line import SAME_S, Mark
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.label import check_label, shortened
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class NameStretch(BaseEdit, frozen=True, tag="name_stretch"):
    """Make what lies from `from_s` to `to_s` one segment and name it.

    A boundary that is there already, give or take SAME_S, is its side; those between go. Where a
    side is an end of the recording, it is that.
    """

    from_s: float
    to_s: float
    label: str

    def checked(self) -> "NameStretch":
        """With a label that is plain text, and times that ascend."""
        super().checked()
        label = check_label(self.label)
        if not label:
            raise LabelingError("Expected the name of a stretch, but it is empty.")
        start_s, end_s = sorted((self.from_s, self.to_s))
        return NameStretch(start_s, end_s, label)

    def anchored(self, labeling: Labeling) -> "NameStretch":
        """With its sides where boundaries are; refused where it is too short."""
        asked = self.checked()
        demonstration = labeling.segmentation.demonstration
        ends = [demonstration.start_s, demonstration.end_s]
        known = [*ends, *(boundary.time_s for boundary in labeling.boundaries)]
        start_s, end_s = (_side(time, known, *ends) for time in (asked.from_s, asked.to_s))
        if end_s - start_s < max(SAME_S, 2.0 / demonstration.rate_hz):
            raise LabelingError(
                f"Expected a stretch of at least {SAME_S} s inside the recording, but it is "
                f"{end_s - start_s:.3f} s long; hold the key longer."
            )
        return NameStretch(start_s, end_s, asked.label)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """As if both boundaries were put there, those between removed, and the segment named."""
        walk.forget_holds()
        walk.settle_between(self.from_s, self.to_s)
        for mark in walk.line.between(self.from_s + SAME_S, self.to_s - SAME_S):
            walk.line.take_away(mark)
        for side_s in (self.from_s, self.to_s):
            near = walk.line.between(side_s - SAME_S, side_s + SAME_S)
            if not near and walk.line.obstacle(side_s) is None:
                walk.line.place(Mark(side_s, contact_change=False), side_s)
        held = walk.held(0.5 * (self.from_s + self.to_s), (self.from_s, self.to_s), insisted=False)
        walk.decide_label(number, held, self.label)

    def step_name(self, labeling: Labeling) -> str:
        """With its name and times."""
        return f"“{shortened(self.label)}” from {self.from_s:.2f} to {self.to_s:.2f} s"


def _side(time_s: float, known_s: list[float], start_s: float, end_s: float) -> float:
    inside = min(max(time_s, start_s), end_s)
    nearest = min(known_s, key=lambda known: abs(known - inside))
    return nearest if abs(nearest - inside) <= SAME_S else inside
