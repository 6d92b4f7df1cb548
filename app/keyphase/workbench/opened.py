"""One open recording: its document, what was found in it, and what a person made of that."""

from dataclasses import replace
from datetime import datetime
from typing import Any

from keyphase.demonstration import Demonstration
from keyphase.labeling.document import Document
from keyphase.labeling.edits import Done, Edit, Label, Reopen
from keyphase.labeling.label import label
from keyphase.labeling.labeling import LabeledSegment, Labeling
from keyphase.labeling.spreading import Change, preview
from keyphase.labeling.storage.journal import Journal
from keyphase.segmentation import Parameters, Segmenter
from keyphase.web.protocol.document_message import document_message, least_confidence, strip
from keyphase.workbench.folder import Folder
from keyphase.workbench.recordings import Recording, State, printable
from keyphase.workbench.signals import SignalTracks

_FIT = (
    "variant",
    "gaussians",
    "mixture",
    "seed",
    "engine",
    "process_noise_ratio",
    "measurement_noise",
)


class Opened:
    """One open recording; changed only in the session's worker.

    journal         where every change is before anyone is told of it
    folder          what it shares with the recordings beside it
    labeling        what is shown, possibly under parameters that are still being dragged
    kept_labeling   what is shown without those
    """

    def __init__(self, recording: Recording, journal: Journal, folder: Folder) -> None:
        self.recording = recording
        self.folder = folder
        self.journal = journal
        self._segmenter = Segmenter(self.demonstration)
        self._saved_at: datetime | None = None
        self.parameters = self.document.parameters
        self.labeling = self.kept_labeling = self._labeling_under(self.parameters)
        if self.document.needs_freezing and self.journal.read_only is None:
            self._keep(self.document.apply(Done(), self.labeling))
        self.tracks = SignalTracks(self.demonstration, self.labeling.segmentation.curve)

    @property
    def document(self) -> Document:
        """The document as it is on disk."""
        return self.journal.document

    @property
    def demonstration(self) -> Demonstration:
        """The recording itself."""
        return self.document.demonstration

    def fits_anew(self, parameters: Parameters) -> bool:
        """Whether these parameters need another fit, which can take seconds."""
        return any(getattr(parameters, n) != getattr(self.parameters, n) for n in _FIT)

    def preview(self, parameters: Parameters) -> None:
        """Show what `parameters` give, without keeping them."""
        self.labeling = self._labeling_under(parameters)
        self.parameters = parameters

    def keep_parameters(self) -> None:
        """Keep the parameters that are shown. Raises JournalError where they cannot be kept."""
        if self.parameters != self.document.parameters:
            self._keep(self.document.set_parameters(self.parameters))
        else:
            self.kept_labeling = self.labeling

    def reset_parameters(self) -> None:
        """Everything automatic. Raises JournalError where that cannot be kept."""
        automatic = Parameters()
        if self.document.shared == automatic:
            self._keep(self.document.reset_parameters())
        else:
            self._keep(self.document.set_parameters(automatic))

    def apply(self, edit: Edit) -> None:
        """Apply one edit; a name a person made up goes into the vocabulary.

        Raises LabelingError where it cannot be made.
        """
        self.keep_parameters()
        before = self.labeling
        self._keep(self.document.apply(edit, before))
        if isinstance(edit, Label):
            self._learn(edit.label.strip(), before.segments[before.segment_at(edit.time_s)])

    def preview_shared(self, shared: Parameters) -> Change:
        """What it would do to this recording if its folder had other parameters."""
        segmenter = self._segmenter
        return preview(self.document, shared, segmenter.segment, segmenter.segment_between)

    def share_parameters(self) -> None:
        """Give the folder the parameters that are shown; this recording has none of its own then.

        Raises JournalError where that cannot be kept.
        """
        self.keep_parameters()
        self.folder.share(self.parameters)
        self._keep(self.document.share_parameters())

    def undo(self) -> None:
        """Take the last step back. Raises LabelingError where there is none."""
        self._keep(self.document.undo())

    def redo(self) -> None:
        """Make the next step again. Raises LabelingError where there is none."""
        self._keep(self.document.redo())

    def mark_done(self, done: bool) -> None:
        """Say that this recording is, or is not, finished."""
        if done != self.document.done or self.labeling.changed_since_done:
            self.keep_parameters()
            self._keep(self.document.apply(Done() if done else Reopen(), self.labeling))

    def keep_labels(self) -> None:
        """Agree to the recording as it now is, though it was labeled as another."""
        self.journal.keep_labels()
        self._saved_at = datetime.now()

    def close(self) -> None:
        """Let another server edit this recording."""
        self.journal.close()

    def summary(self) -> Recording:
        """The recording's line in the queue."""
        return replace(
            self.recording,
            state=self._state(),
            confidence=least_confidence(self.kept_labeling),
            strip=tuple(strip(self.kept_labeling)),
            error=None,
        )

    def message(self) -> dict[str, Any]:
        """The `document` message without what belongs to the session."""
        message = document_message(self.labeling)
        return {
            **message,
            "id": self.recording.id,
            "folder": printable(self.recording.path.parent.name),
            "notices": [*message["notices"], *self.journal.notices, *self._folder_notices()],
            "state": self._state(),
            "locked": self.journal.read_only,
            "changed": self.journal.changed,
            "edits": len(self.document.edits),
            "undo": self.document.undo_name,
            "redo": self.document.redo_name,
            "saved_at": self._saved_at.strftime("%H:%M:%S") if self._saved_at else None,
        }

    def _keep(self, document: Document) -> None:
        """Put a document on disk, then show it; nothing changes where the disk refuses."""
        if document is not self.document:
            self.journal.save(document)
            self._saved_at = datetime.now()
        self.parameters = document.parameters
        self.labeling = self.kept_labeling = self._labeling_under(self.parameters)

    def recolor(self) -> None:
        """Give segments the colours their names have in the folder's vocabulary by now."""
        same = self.kept_labeling is self.labeling
        self.labeling = self.folder.colored(self.labeling)
        self.kept_labeling = self.labeling if same else self.folder.colored(self.kept_labeling)

    def _learn(self, name: str, segment: LabeledSegment) -> None:
        """An accepted proposal is no word of the person's own, so it is not learnt."""
        if name and name != segment.label:
            self.folder.learn(name, segment.color)
            self.recolor()

    def _labeling_under(self, parameters: Parameters) -> Labeling:
        segmentation = self._segmenter.segment(parameters)
        labeling = label(segmentation, self.document.edits, self._segmenter.segment_between)
        return self.folder.colored(labeling)

    def _folder_notices(self) -> list[str]:
        notice = self.folder.settings.notice
        return [notice] if notice else []

    def _state(self) -> State:
        if self.document.done:
            return "done"
        return "touched" if self.document.history.done else "automatic"
