"""Saying what one thinks of the recording as a whole."""

from collections.abc import Mapping
from typing import ClassVar

from keyphase.errors import LabelingError
from keyphase.labeling.assessment import Assessment, Outcome
from keyphase.labeling.edits.base import BaseEdit
from keyphase.labeling.edits.reset import Reset
from keyphase.labeling.labeling import Labeling


class Assess(BaseEdit, frozen=True, tag="assess"):
    """Mark the recording as a success or a failure, with its quality from 1 to 5 and a note.

    The three are said together; what is left out is taken back.
    """

    changes_segments: ClassVar[bool] = False

    outcome: Outcome | None = None
    quality: int | None = None
    note: str = ""

    def checked(self) -> "Assess":
        """With a quality on the scale, and a note of one line that is not too long."""
        said = self.assessment.checked()
        return Assess(said.outcome, said.quality, said.note)

    def anchored(self, labeling: Labeling) -> "Assess":
        """Refused where it says what was said already."""
        said = self.checked()
        if said.assessment == labeling.assessment:
            raise LabelingError("The recording is marked so already.")
        return said

    @property
    def assessment(self) -> Assessment:
        """What it says."""
        return Assessment(self.outcome, self.quality, self.note)

    def step_name(self, labeling: Labeling) -> str:
        """With what has changed."""
        before = labeling.assessment
        if self.outcome != before.outcome:
            return f"Mark as {self.outcome}" if self.outcome else "Take back success or failure"
        if self.quality != before.quality:
            return f"Quality {self.quality}" if self.quality else "Take back the quality"
        return "Note on the recording"


def assessment_of(edits: Mapping[int, BaseEdit]) -> Assessment:
    """What a person thinks of the recording; the latest edit counts."""
    found = Assessment()
    for edit in edits.values():
        if isinstance(edit, Reset):
            found = Assessment()
        elif isinstance(edit, Assess):
            found = edit.assessment
    return found
