"""One open recording: its document, what was found in it, and what a person makes of that."""

from collections.abc import Mapping, Sequence
from datetime import datetime
from typing import Any

from keyphase.demonstration import Demonstration
from keyphase.errors import JournalError, LabelingError
from keyphase.labeling.document import Document
from keyphase.labeling.edits import Done, Edit, Label, PhaseInAll, Reopen
from keyphase.labeling.history import FolderChange, folder_change_of
from keyphase.labeling.label import label
from keyphase.labeling.labeling import LabeledSegment, Labeling
from keyphase.labeling.spreading import Change, preview
from keyphase.labeling.storage.journal import Journal
from keyphase.notices import Caution
from keyphase.segmentation import Parameters, Segmentation, Segmenter
from keyphase.workbench.desks.desk_state import Cause, DeskState
from keyphase.workbench.desks.folder import Folder
from keyphase.workbench.recordings import Recording, State
from keyphase.workbench.showing.found_now import found_now, told
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
        self._found: tuple[Parameters, Segmentation] | None = None
        self._folder_kept: str | None = None
        self._compared: Document | None = None
        self._now: Labeling | None = None
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

    def preview_shared(self, shared: Parameters, include_done: bool) -> Change:
        """What it would do to this recording if its folder had other parameters."""
        return preview(
            self.document,
            shared,
            self._segmenter.segment,
            self._segmenter.segment_between,
            include_done=include_done,
        )

    def share_parameters(self, reopened: Sequence[str] = ()) -> None:
        """Give the folder the parameters that are shown; this recording has none of its own then.

        `reopened` are recordings that are opened again with it. Raises JournalError where that
        cannot be kept.
        """
        self.keep_parameters()
        before = self.folder.settings.parameters
        self.folder.share(self.parameters)
        self._keep(self.document.with_shared(before).share_parameters(reopened))

    def undo(self) -> FolderChange | PhaseInAll | None:
        """Take the last step back; what that did to the whole folder is taken back with it.

        Raises LabelingError where there is none.
        """
        change = folder_change_of(self.document.history.last_done)
        document = self.document.undo()
        if isinstance(change, FolderChange):
            self._swap_parameters(change.after, change.before)
        self._keep(document.with_shared(self.folder.settings.parameters))
        return change

    def redo(self) -> FolderChange | PhaseInAll | None:
        """Make the next step again, likewise. Raises LabelingError where there is none."""
        change = folder_change_of(self.document.history.next_undone)
        document = self.document.redo()
        if isinstance(change, FolderChange):
            self._swap_parameters(change.before, change.after)
        self._keep(document.with_shared(self.folder.settings.parameters))
        return change

    def reopen(self, name: str) -> None:
        """Open it again as part of a step of another recording, under that step's name."""
        self._keep(self.document.reopened(name))

    def close_again(self, name: str) -> None:
        """Take `reopen` back. Raises LabelingError where a person has gone on with it since."""
        last = self.document.history.last_done
        if last is None or last.name != name or not isinstance(last.change, Reopen):
            raise LabelingError(
                f"{self.recording.name} was worked on since it was opened again, so it is left as "
                "it is; mark it as done once more."
            )
        self._keep(self.document.undo())

    def mark_done(self, done: bool) -> None:
        """Say that this recording is, or is not, finished."""
        if done != self.document.done or self.labeling.changed_since_done:
            self.keep_parameters()
            self._keep(self.document.apply(Done() if done else Reopen(), self.labeling))
            if done:
                self.folder.show_task(self.labeling)

    def take_journal(self) -> None:
        """Make what was done to the same bytes under another name this recording's.

        Raises JournalError where nothing was, or it cannot be kept.
        """
        if self.journal.elsewhere is None:
            raise JournalError("Nothing is known of these bytes under another name.")
        self.journal.take_over(self.journal.elsewhere)
        self._saved_at = datetime.now()
        self._keep(self.document)

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
            vocabulary=self.folder.vocabulary,
            notices=(*self._cautions(), *self._told_of_now()),
            state=self._state(),
            locked=self.journal.read_only,
            changed=self.journal.changed,
            found_now=self._found_now(),
            elsewhere=self.journal.elsewhere,
            saved_at=self._saved_at.strftime("%H:%M:%S") if self._saved_at else None,
            cause=cause,
        )

    def follow_folder(self) -> None:
        """Take up what the folder's vocabulary and parameters have become."""
        shared = self.folder.settings.parameters
        if shared == self.document.shared:
            self.recolor()
            return
        self.journal.follow_folder(shared)
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

    def _swap_parameters(self, before: Mapping[str, Any], after: Mapping[str, Any]) -> None:
        """Give the folder other parameters, unless somebody gave it others meanwhile."""
        if not self.folder.swap(Parameters(**before), Parameters(**after)):
            self._folder_kept = (
                "The folder has other parameters by now than this step gave it, so they were left "
                "as they are."
            )

    def _learn(self, name: str, segment: LabeledSegment) -> None:
        """An accepted proposal is no word of the person's own, so it is not learnt."""
        if name and name != segment.label:
            self.folder.learn(name, segment.color)
            self.recolor()

    def _segmentation_under(self, parameters: Parameters) -> Segmentation:
        """Edits change no parameter: what was found is kept until one changes, once for all."""
        if self._found is None or self._found[0] != parameters:
            self._found = parameters, self._segmenter.segment(parameters)
        return self._found[1]

    def _labeling_under(self, parameters: Parameters) -> Labeling:
        segmentation = self._segmentation_under(parameters)
        labeling = label(segmentation, self.document.edits, self._segmenter.segment_between)
        return self.folder.colored(labeling)

    def _found_now(self) -> Labeling | None:
        """Worked out once for a document."""
        if self._compared is not self.document:
            self._compared = self.document
            self._now = found_now(self.document, self._segmenter, self.kept_labeling)
        return self._now

    def _told_of_now(self) -> list[str]:
        now = self._found_now()
        return [] if now is None else [told(self.kept_labeling, now)]

    def _cautions(self) -> list[Caution]:
        """What journal and folder say."""
        of_folder = (self.folder.settings.notice, self._folder_kept)
        return [Caution(one) for one in (*self.journal.notices, *of_folder) if one]

    def _state(self) -> State:
        if self.document.done:
            return "done"
        return "touched" if self.document.history.done else "automatic"
