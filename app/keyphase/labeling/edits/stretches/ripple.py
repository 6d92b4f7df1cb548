"""Moving a boundary and all later ones with it, as when something before them took longer."""

from keyphase.errors import LabelingError
from keyphase.labeling.boundary_line import SAME_S, Mark
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import boundary_at, boundary_number
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class Ripple(BaseEdit, frozen=True, tag="ripple"):
    """Move the boundary at `from_s`, and all later ones, by `by_s`.

    `all_s` are the times of all of them, which `anchored` fills in.
    """

    from_s: float
    by_s: float
    all_s: tuple[float, ...] = ()

    def anchored(self, labeling: Labeling) -> "Ripple":
        """With the exact times; refused where the first or the last has no room."""
        first = boundary_at(self.from_s, labeling)
        index = labeling.boundaries.index(first)
        all_s = tuple(boundary.time_s for boundary in labeling.boundaries[index:])
        demonstration = labeling.segmentation.demonstration
        gap = 1.0 / demonstration.rate_hz
        room = max(SAME_S, gap) if index else gap
        low = labeling.segments[index].start_s + room - all_s[0]
        high = demonstration.end_s - gap - all_s[-1]
        if not low <= self.by_s <= high:
            raise LabelingError(
                f"Boundary {index + 1} and those after it can be moved by {low:.3f} to {high:.3f} "
                f"s, so that they stay after the one before and inside the recording, but "
                f"{self.by_s:.3f} s was given."
            )
        return Ripple(first.time_s, self.by_s, all_s)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """The foremost in the direction of the move goes first, so that none is in the way."""
        walk.forget_holds()
        found = [(time_s, walk.line.find(time_s)) for time_s in self.all_s or (self.from_s,)]
        for time_s, mark in found if self.by_s < 0.0 else reversed(found):
            to_s = time_s + self.by_s
            what = f"Boundary moved from {time_s:.3f} to {to_s:.3f} s with the others"
            obstacle = walk.line.obstacle(to_s, moving=mark)
            if mark is None and not insisted:
                walk.miss(number, time_s, to_s, f"{what}: it is no longer found.")
            elif obstacle is not None:
                walk.miss(number, time_s, to_s, f"{what}: {obstacle}.")
            else:
                walk.line.move_by_hand(mark or Mark(time_s, contact_change=False), to_s)

    def step_name(self, labeling: Labeling) -> str:
        """With the number of the first."""
        return f"Move boundary {boundary_number(self.from_s, labeling)} and all later ones"
