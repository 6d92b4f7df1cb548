"""Putting a boundary where there is none."""

from keyphase.labeling.boundary_line import REACH_S, Mark
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import check_room
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class Add(BaseEdit, frozen=True, tag="add"):
    """Put a boundary at `time_s`; None for contact change: as the force there says."""

    time_s: float
    contact_change: bool | None = None

    def anchored(self, labeling: Labeling) -> "Add":
        """With what the force says there, where there is room."""
        check_room(self.time_s, labeling)
        if self.contact_change is not None:
            return self
        return Add(self.time_s, _force_changes(self.time_s, labeling))

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """Where it finds no room, it waits until there is."""
        walk.forget_holds()
        obstacle = walk.line.obstacle(self.time_s)
        if obstacle is None:
            walk.line.place(Mark(self.time_s, bool(self.contact_change)), self.time_s)
        else:
            text = f"Boundary at {self.time_s:.3f} s: {obstacle}."
            walk.miss(number, self.time_s, self.time_s, text)

    def step_name(self, labeling: Labeling) -> str:
        """With its time, since it has no number yet."""
        return f"Add boundary at {self.time_s:.2f} s"


def _force_changes(time_s: float, labeling: Labeling) -> bool:
    """Whether a peak of the error lies there after which the force stays changed."""
    least = labeling.segmentation.parameters.persistence
    return any(
        abs(peak.time_s - time_s) <= REACH_S and peak.persistence >= least
        for peak in labeling.segmentation.peaks
    )
