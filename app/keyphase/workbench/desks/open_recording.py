"""One open recording: its document, what was found in it, and what a person makes of that."""

from datetime import datetime

from keyphase.demonstration import Demonstration
from keyphase.labeling.document import Document
from keyphase.labeling.edits import Done, Edit, Label, Reopen
from keyphase.labeling.label import label
from keyphase.labeling.labeling import LabeledSegment, Labeling
from keyphase.labeling.spreading import Change, preview
from keyphase.labeling.storage.journal import Journal
from keyphase.segmentation import Parameters, Segmenter
from keyphase.workbench.desks.desk_state import Cause, DeskState
from keyphase.workbench.desks.folder import Folder
from keyphase.workbench.recordings import Recording, State
from keyphase.workbench.showing.signals import SignalTracks

_REFIT = (
    "variant",
    "gaussians",
    "mixture",
    "seed",
    "engine",
    "process_noise_ratio",
    "measurement_noise",
)


class OpenRecording:
    """One open recording; changed only in its desk's worker.

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
        found = self.labeling.segmentation
        self.tracks = SignalTracks(self.demonstration, found.curve, found.track)

    @property
    def document(self) -> Document:
        """The document as it is on disk."""
        return self.journal.document

    @property
    def demonstration(self) -> Demonstration:
        """The recording itself."""
        return self.document.demonstration

    def needs_refit(self, parameters: Parameters) -> bool:
        """Whether these parameters need another fit, which can take seconds."""
        return any(getattr(parameters, n) != getattr(self.parameters, n) for n in _REFIT)

    def preview(self, parameters: Parameters) -> None:
        """Show what `parameters` give, without keeping them."""
        self.labeling = self._labeling_under(parameters)
        if parameters.variant != self.parameters.variant:
            found = self.labeling.segmentation
            self.tracks = SignalTracks(self.demonstration, found.curve, found.track)
        self.parameters = parameters

    def keep_parameters(self) -> None:
        """Keep the parameters that are shown. Raises JournalError where they cannot be kept."""
        if self.parameters != self.document.parameters:
            self._keep(self.document.set_parameters(self.parameters))
        else:
            self.kept_labeling = self.labeling

    def reset_parameters(self) -> None:
        """Everything automatic, same method. Raises JournalError where that cannot be kept."""
        automatic = Parameters(variant=self.parameters.variant)
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

    def state_at(self, revision: int, cause: Cause | None = None) -> DeskState:
        """How it all stands, under that number."""
        return DeskState(
            revision=revision,
            recording=self.recording,
            document=self.document,
            parameters=self.parameters,
            labeling=self.labeling,
            kept_labeling=self.kept_labeling,
            tracks=self.tracks,
            vocabulary=self.folder.settings.vocabulary,
            notices=(*self.journal.notices, *self._folder_notices()),
            state=self._state(),
            locked=self.journal.read_only,
            changed=self.journal.changed,
            saved_at=self._saved_at.strftime("%H:%M:%S") if self._saved_at else None,
            cause=cause,
        )

    def follow_folder(self) -> None:
        """Take up what the parameters of the folder have become.

        Raises JournalError where the journal cannot be opened again.
        """
        read_only = self.journal.read_only is not None
        self.journal.close()
        shared = self.folder.settings.parameters
        self.journal = Journal(self.demonstration, shared, read_only=read_only)
        self.parameters = self.document.parameters
        self.labeling = self.kept_labeling = self._labeling_under(self.parameters)

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
