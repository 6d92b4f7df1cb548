"""What a recording at work is at one revision; it never changes."""

from dataclasses import dataclass, replace

from keyphase.demonstration import Demonstration
from keyphase.labeling.document import Document
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.storage.elsewhere import Elsewhere
from keyphase.labeling.vocabulary import Vocabulary
from keyphase.segmentation import Parameters
from keyphase.workbench.grid.stretches import stretches
from keyphase.workbench.recordings import Recording
from keyphase.workbench.recordings import State as RecordingState
from keyphase.workbench.showing.doubts import least_confidence, strip, unsure_count
from keyphase.workbench.showing.signals import SignalTracks


@dataclass(frozen=True)
class Cause:
    """The request of a page that led to a change."""

    page: str
    event: int


@dataclass(frozen=True, eq=False)
class DeskState:
    """One revision of one recording at work.

    document        as it is on disk
    parameters      what is shown, possibly while a slider is still held
    labeling        what these parameters give, with the edits
    kept_labeling   the same under the parameters that are kept
    vocabulary      of its folder
    notices         of journal and folder
    state           automatic, touched or done
    locked          why nothing can be changed; None where it can
    changed         the file is no longer the one that was labeled
    found_now       of a recording that is done what would be found today, where that differs
    elsewhere       what was done to the same bytes under another name; None where nothing is known
    saved_at        clock time of the last step on disk, HH:MM:SS
    """

    revision: int
    recording: Recording
    document: Document
    parameters: Parameters
    labeling: Labeling
    kept_labeling: Labeling
    tracks: SignalTracks
    vocabulary: Vocabulary
    notices: tuple[str, ...]
    state: RecordingState
    locked: str | None
    changed: bool
    found_now: Labeling | None
    elsewhere: Elsewhere | None
    saved_at: str | None
    cause: Cause | None = None

    @property
    def demonstration(self) -> Demonstration:
        """The recording itself."""
        return self.document.demonstration

    @property
    def line(self) -> Recording:
        """Its line in the list."""
        return replace(
            self.recording,
            state=self.state,
            changed_since_done=self.kept_labeling.changed_since_done,
            confidence=least_confidence(self.kept_labeling),
            unsure=unsure_count(self.kept_labeling),
            strip=strip(self.kept_labeling),
            error=None,
            assessment=self.kept_labeling.assessment,
            marked=tuple(one.assessment for one in self.kept_labeling.segments if one.assessment),
            stretches=stretches(self.kept_labeling),
        )
