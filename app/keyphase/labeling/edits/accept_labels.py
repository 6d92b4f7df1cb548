"""Taking the proposed labels as they stand."""

from keyphase.errors import LabelingError
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.label import Label
from keyphase.labeling.edits.places import span_of
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk


class AcceptLabels(BaseEdit, frozen=True, tag="accept_labels"):
    """Take the proposed label of every kept segment as it stands; `labels` is what they were."""

    labels: tuple[Label, ...] | None = None

    def checked(self) -> "AcceptLabels":
        """With labels that are plain text."""
        super().checked()
        return (
            self if self.labels is None else AcceptLabels(tuple(e.checked() for e in self.labels))
        )

    def anchored(self, labeling: Labeling) -> "AcceptLabels":
        """With the proposed labels as they are now."""
        proposed = [s for s in labeling.segments if s.proposed and s.kept and s.label]
        if not proposed:
            raise LabelingError("Every kept segment has a label of yours; there is none to accept.")
        return AcceptLabels(tuple(Label(s.middle_s, s.label, span_of(s)) for s in proposed))

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """As if each had been given by hand."""
        for each in self.labels or ():
            each.apply(number, walk, insisted)

    def step_name(self, labeling: Labeling) -> str:
        """With how many were accepted."""
        count = len(self.labels or ())
        return f"Accept {count} label" + ("" if count == 1 else "s")
