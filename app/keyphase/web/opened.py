"""One open recording: its document, what was found in it, and what a person made of that."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from keyphase.demonstration import Demonstration
from keyphase.labeling.document import Document
from keyphase.labeling.edits import Edit
from keyphase.labeling.label import label
from keyphase.labeling.labeling import Labeling
from keyphase.readers import Recipe, read
from keyphase.segmentation import Parameters, Segmenter
from keyphase.web.document_message import document_message, least_confidence, strip
from keyphase.web.recordings import Recording, State, printable
from keyphase.web.signals import SignalTracks

SURE = 0.75
"""A boundary at least this certain need not be looked at."""


_FIT = ("gaussians", "variant", "seed", "engine", "process_noise_ratio", "measurement_noise")


class Opened:
    """One open recording; changed only in the session's worker.

    document        what is kept
    labeling        what is shown, possibly under parameters that are still being dragged
    kept_labeling   what is shown without those
    """

    def __init__(self, recording: Recording, document: Document) -> None:
        self.recording = recording
        self.document = document
        self._segmenter = Segmenter(document.demonstration)
        self.parameters = document.parameters
        self.labeling = self.kept_labeling = self._labeling_under(self.parameters)
        self.tracks = SignalTracks(document.demonstration, self.labeling.segmentation.curve)

    @property
    def demonstration(self) -> Demonstration:
        """The recording itself."""
        return self.document.demonstration

    def preview(self, parameters: Parameters) -> None:
        """Show what `parameters` give, without keeping them."""
        self.labeling = self._labeling_under(parameters)
        self.parameters = parameters

    def fits_anew(self, parameters: Parameters) -> bool:
        """Whether these parameters need another fit, which can take seconds."""
        return any(getattr(parameters, n) != getattr(self.parameters, n) for n in _FIT)

    def keep_parameters(self) -> None:
        """Keep the parameters that are shown."""
        self._keep(self.document.set_parameters(self.parameters))

    def apply(self, edit: Edit) -> None:
        """Apply one edit. Raises LabelingError where it cannot be made."""
        self.keep_parameters()
        self._keep(self.document.apply(edit, self.labeling))

    def undo(self) -> None:
        """Take the last step back. Raises LabelingError where there is none."""
        self._keep(self.document.undo())

    def redo(self) -> None:
        """Make the next step again. Raises LabelingError where there is none."""
        self._keep(self.document.redo())

    def _keep(self, document: Document) -> None:
        self.document = document
        self.parameters = document.parameters
        self.labeling = self.kept_labeling = self._labeling_under(self.parameters)

    def _labeling_under(self, parameters: Parameters) -> Labeling:
        segmentation = self._segmenter.segment(parameters)
        return label(segmentation, self.document.edits, self._segmenter.segment_between)

    def summary(self) -> Recording:
        """The recording's line in the queue."""
        return replace(
            self.recording,
            state=self._state(),
            confidence=least_confidence(self.kept_labeling),
            strip=tuple(strip(self.labeling)),
            error=None,
        )

    def _state(self) -> State:
        """Done is a recording a person has touched and in which nothing is left to decide."""
        if not self.document.history.done:
            return "automatic"
        labeling = self.kept_labeling
        unsure = (least_confidence(labeling) or 1.0) < SURE
        unnamed = any(segment.kept and segment.proposed for segment in labeling.segments)
        return "touched" if unsure or unnamed or labeling.proposed_drops else "done"

    def message(self) -> dict[str, Any]:
        """The `document` message without what belongs to the session."""
        return {
            "id": self.recording.id,
            "folder": printable(self.recording.path.parent.name),
            **document_message(self.labeling),
            "edits": len(self.document.edits),
            "undo": self.document.undo_name,
            "redo": self.document.redo_name,
            "saved_at": None,
        }


def open_recording(
    recording: Recording,
    progress: Callable[[str, float | None], None],
    recipe: Recipe | Path | None = None,
) -> Opened:
    """Read a recording and segment it.

    Raises DemonstrationError for a file that cannot be read.
    """
    progress("reading", None)
    demonstration = read(recording.path, recipe)
    progress("segmenting", None)
    return Opened(recording, Document(demonstration))
