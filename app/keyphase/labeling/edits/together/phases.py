"""A phase named otherwise, or dropped, in all recordings of a folder that have it."""

from typing import Annotated

import msgspec

from keyphase.errors import LabelingError
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.keep import Keep
from keyphase.labeling.edits.label import Label, check_label, shortened
from keyphase.labeling.edits.places import span_of
from keyphase.labeling.labeling import LabeledSegment, Labeling
from keyphase.labeling.walk import Walk

MAX_MEANT = 100_000
"""Segments of one recording that have the name, at most."""

StepId = Annotated[str, msgspec.Meta(min_length=1, max_length=64)]


class RenamePhase(BaseEdit, frozen=True, tag="rename_phase"):
    """Name every segment that is called `label` `to` instead.

    step    the same in all recordings in which it was done together
    labels  the segments it is about; None in what a person asks for
    """

    label: str
    to: str
    step: StepId
    labels: Annotated[tuple[Label, ...], msgspec.Meta(max_length=MAX_MEANT)] | None = None

    def checked(self) -> "RenamePhase":
        """With names that are plain text, and not the same."""
        label, to = _name(self.label), _name(self.to)
        if label == to:
            raise LabelingError(f"The phase “{label}” is called so already; choose another name.")
        labels = super().checked().labels
        whole = None if labels is None else tuple(each.checked() for each in labels)
        return RenamePhase(label, to, self.step, whole)

    def anchored(self, labeling: Labeling) -> "RenamePhase":
        """With the segments of that name. Raises LabelingError where there is none."""
        asked = self.checked()
        meant = _called(asked.label, labeling.segments)
        labels = tuple(Label(one.middle_s, asked.to, span_of(one)) for one in meant)
        return msgspec.structs.replace(asked, labels=labels)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """As if each had been named by hand."""
        for each in self.labels or ():
            each.apply(number, walk, insisted)

    def step_name(self, labeling: Labeling) -> str:
        """With both names."""
        return f"Rename “{shortened(self.label)}” to “{shortened(self.to)}” in all"


class DropPhase(BaseEdit, frozen=True, tag="drop_phase"):
    """Drop every segment that is called `label`; `step` and `drops` as in RenamePhase."""

    label: str
    step: StepId
    drops: Annotated[tuple[Keep, ...], msgspec.Meta(max_length=MAX_MEANT)] | None = None

    def checked(self) -> "DropPhase":
        """With a name that is plain text."""
        return DropPhase(_name(self.label), self.step, super().checked().drops)

    def anchored(self, labeling: Labeling) -> "DropPhase":
        """With the kept segments of that name. Raises LabelingError where there is none."""
        asked = self.checked()
        meant = _called(asked.label, [one for one in labeling.segments if one.kept])
        drops = tuple(Keep(one.middle_s, False, span_of(one)) for one in meant)
        return msgspec.structs.replace(asked, drops=drops)

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """As if each had been dropped by hand."""
        for each in self.drops or ():
            each.apply(number, walk, insisted)

    def step_name(self, labeling: Labeling) -> str:
        """With its name."""
        return f"Drop “{shortened(self.label)}” in all"


PhaseInAll = RenamePhase | DropPhase
"""What is done to a phase in all recordings of a folder."""


def _name(text: str) -> str:
    name = check_label(text)
    if not name:
        raise LabelingError("Expected the name of a phase, but it is empty.")
    return name


def _called(
    name: str, segments: tuple[LabeledSegment, ...] | list[LabeledSegment]
) -> list[LabeledSegment]:
    meant = [one for one in segments if one.label == name]
    if not meant:
        raise LabelingError(f"No segment here is called “{shortened(name)}”.")
    return meant
