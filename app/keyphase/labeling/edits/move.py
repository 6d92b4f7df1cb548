"""Moving a boundary between its neighbours."""

from keyphase.errors import LabelingError
from keyphase.labeling.boundary_line import Mark
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import boundary_at, boundary_number, check_room
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class Move(BaseEdit, frozen=True, tag="move"):
    """Move the boundary at `from_s` to `to_s`."""

    from_s: float
    to_s: float

    def anchored(self, labeling: Labeling) -> "Move":
        """From the exact time of the boundary, to a place between its neighbours."""
        boundary = boundary_at(self.from_s, labeling)
        index = labeling.boundaries.index(boundary)
        before = labeling.segments[index].start_s
        after = labeling.segments[index + 1].end_s
        if not before < self.to_s < after:
            raise LabelingError(
                f"A boundary stays between its neighbours, here from {before:.3f} to {after:.3f} "
                f"s, but was moved to {self.to_s:.3f} s; merge the segments in between first."
            )
        check_room(self.to_s, labeling, moving=boundary)
        return Move(boundary.time_s, self.to_s)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """Insisted on, it adds the boundary where it is gone."""
        walk.forget_holds()
        mark = walk.line.find(self.from_s)
        what = f"Boundary moved from {self.from_s:.3f} to {self.to_s:.3f} s"
        obstacle = walk.line.obstacle(self.to_s, moving=mark)
        if mark is None and not insisted:
            walk.miss(number, self.from_s, self.to_s, f"{what}: it is no longer found.")
        elif obstacle is not None:
            walk.miss(number, self.from_s, self.to_s, f"{what}: {obstacle}.")
        else:
            walk.line.move_by_hand(mark or Mark(self.from_s, contact_change=False), self.to_s)

    def step_name(self, labeling: Labeling) -> str:
        """With the number it had."""
        return f"Move boundary {boundary_number(self.from_s, labeling)}"
