"""Making one segment of several."""

from keyphase.errors import LabelingError
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.places import segment_number
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class Merge(BaseEdit, frozen=True, tag="merge"):
    """Make one segment of all from `from_s` to `to_s`: every boundary strictly between goes."""

    from_s: float
    to_s: float

    def anchored(self, labeling: Labeling) -> "Merge":
        """From the middle of the first segment to the middle of the last.

        So their own sides may wander.
        """
        low, high = sorted((self.from_s, self.to_s))
        between = [b.time_s for b in labeling.boundaries if low < b.time_s < high]
        if not between:
            raise LabelingError(
                f"Expected a boundary between {low:.3f} and {high:.3f} s to merge over, but there "
                "is none; choose a stretch over several segments."
            )
        first = labeling.segments[labeling.segment_at(between[0]) - 1]
        last = labeling.segments[labeling.segment_at(between[-1])]
        return Merge(first.middle_s, last.middle_s)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """Take all boundaries between the two times away."""
        walk.forget_holds()
        walk.settle_between(self.from_s, self.to_s)
        for mark in walk.line.between(self.from_s, self.to_s):
            walk.line.take_away(mark)

    def step_name(self, labeling: Labeling) -> str:
        """With the numbers of the outer segments."""
        first = segment_number(self.from_s, labeling)
        return f"Merge segments {first} to {segment_number(self.to_s, labeling)}"
