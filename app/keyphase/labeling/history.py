"""The history of a document: every step, and how far it has been taken back."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from keyphase.errors import LabelingError
from keyphase.labeling.edits import DropPhase, Edit, PhaseInAll, RenamePhase


@dataclass(frozen=True)
class FolderChange:
    """All recordings of a folder got other parameters with a step of one of them.

    before, after  the parameters of the folder
    reopened       names of recordings that were done and were opened again for it
    """

    before: Mapping[str, Any]
    after: Mapping[str, Any]
    reopened: tuple[str, ...] = ()


@dataclass(frozen=True)
class ParameterChange:
    """From here on the recording's own parameters are these; all others are the folder's."""

    own: Mapping[str, Any]
    folder: FolderChange | None = None


@dataclass(frozen=True)
class Step:
    """One thing that undo takes back. `number` is unique in a history and never used again."""

    number: int
    name: str
    change: Edit | ParameterChange


def folder_change_of(step: Step | None) -> FolderChange | PhaseInAll | None:
    """What a step did to the whole folder; None where it was about its recording alone."""
    change = step.change if step else None
    if isinstance(change, RenamePhase | DropPhase):
        return change
    return change.folder if isinstance(change, ParameterChange) else None


@dataclass(frozen=True)
class History:
    """Steps in the order they were made; those from `position` on have been taken back."""

    steps: tuple[Step, ...] = ()
    position: int = 0

    @property
    def done(self) -> tuple[Step, ...]:
        """The steps in force."""
        return self.steps[: self.position]

    @property
    def last_done(self) -> Step | None:
        """The step that undo would take back."""
        return self.steps[self.position - 1] if self.position else None

    @property
    def next_undone(self) -> Step | None:
        """The step that redo would make again."""
        return self.steps[self.position] if self.position < len(self.steps) else None

    def with_step(self, step: Step) -> "History":
        """One step more; what had been taken back is gone."""
        return History((*self.done, step), self.position + 1)

    def undone(self) -> "History":
        """The last step taken back. Raises LabelingError where there is none."""
        if self.last_done is None:
            raise LabelingError("There is nothing to undo.")
        return replace(self, position=self.position - 1)

    def redone(self) -> "History":
        """The next step made again. Raises LabelingError where there is none."""
        if self.next_undone is None:
            raise LabelingError("There is nothing to redo.")
        return replace(self, position=self.position + 1)
