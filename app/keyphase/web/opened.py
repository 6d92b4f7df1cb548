"""One open recording: its demonstration, what was found in it, and what a person made of that."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from keyphase.demonstration import Demonstration
from keyphase.labeling.labeling import Labeling
from keyphase.segmentation.parameters import Parameters
from keyphase.web.document_message import document_message, least_confidence, strip
from keyphase.web.recordings import Recording
from keyphase.web.signals import SignalTracks


class Opened:
    """One open recording; changed only in the session's worker.

    labeling        what is shown, possibly with parameters still being dragged
    kept_labeling   what it was when parameters were last let go
    """

    def __init__(
        self,
        recording: Recording,
        demonstration: Demonstration,
        compute: Callable[[Parameters], Labeling],
    ) -> None:
        self.recording = recording
        self.demonstration = demonstration
        self.parameters = Parameters()
        self._compute = compute
        self.labeling = compute(self.parameters)
        self.kept_labeling = self.labeling
        self.tracks = SignalTracks(demonstration, self.labeling.segmentation.curve)

    def preview(self, parameters: Parameters) -> None:
        """Show what `parameters` give, without keeping them."""
        self.parameters = parameters
        self.labeling = self._compute(parameters)

    def keep_parameters(self) -> None:
        """Write the parameters shown to the journal."""
        self.kept_labeling = self.labeling

    def summary(self) -> Recording:
        """The recording's line in the queue."""
        return replace(
            self.recording,
            confidence=least_confidence(self.labeling),
            strip=tuple(strip(self.labeling)),
            error=None,
        )

    def message(self) -> dict[str, Any]:
        """The `document` message without what belongs to the session."""
        return {
            "id": self.recording.id,
            "folder": self.recording.path.parent.name,
            **document_message(self.labeling),
            "edits": 0,
            "undo": None,
            "redo": None,
            "saved_at": None,
        }
