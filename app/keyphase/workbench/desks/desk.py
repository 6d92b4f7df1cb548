"""A desk: one recording at work. Whatever changes it runs in its own worker, in order.

A request is bound to its desk when it is made, so that none can land on another recording. Each
names the revision it was made on; one that no longer fits is refused to the page that made it.
"""

import threading
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from keyphase.errors import KeyphaseError, RequestError
from keyphase.labeling.edits import Edit, PhaseInAll
from keyphase.labeling.history import FolderChange
from keyphase.labeling.storage.written_files import IfThere
from keyphase.segmentation import Parameters
from keyphase.workbench.desks.asked import Asked
from keyphase.workbench.desks.authors import Authors
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.desks.differences import differs, told_of
from keyphase.workbench.desks.member import Member
from keyphase.workbench.desks.open_recording import OpenRecording
from keyphase.workbench.desks.revisions import Revisions
from keyphase.workbench.exporting.segment_files import export
from keyphase.workbench.recordings import Recording
from keyphase.workbench.showing.comparing import take_over
from keyphase.workbench.tasks import Task, Tasks
from keyphase.workbench.telling import in_words
from keyphase.workbench.worker import Worker

Opens = Callable[[Recording, Task], OpenRecording]

ToldOfFolder = Callable[[FolderChange | PhaseInAll | None], None]
"""Told what a step that was taken back or made again does to the whole folder."""


def _nobody(_change: FolderChange | PhaseInAll | None) -> None:
    return


class Desk:
    """One recording at work. Methods may be called from any thread by who has it on loan.

    state    its newest revision; None until the recording is open
    failure  why it cannot be opened; None where it can
    """

    def __init__(
        self,
        recording: Recording,
        opens: Opens,
        tasks: Tasks,
        revisions: Iterator[int],
        on_idle: Callable[[], None],
    ) -> None:
        self.recording = recording
        self.state: DeskState | None = None
        self.failure: KeyphaseError | None = None
        self.on_change: Callable[[DeskState], None] = lambda _state: None
        self.on_folder: Callable[[Desk, bool], None] = lambda _desk, _parameters: None
        self._opens, self._tasks, self._numbers = opens, tasks, revisions
        self._lock = threading.RLock()
        self._members_lock = threading.Lock()
        self._members: tuple[Member, ...] = ()
        self._revisions = Revisions()
        self._authors = Authors()
        self._open: OpenRecording | None = None
        self._wanted: Parameters | None = None
        self._let_go = False
        self._asked = 0
        self._worker = Worker(self._defect, on_idle)
        self._worker.submit(self._begin)

    @property
    def is_free(self) -> bool:
        """Whether nothing runs or waits."""
        return self._worker.is_free()

    def join(self, member: Member) -> None:
        """Tell `member` of this desk from now on, first of how it stands."""
        with self._lock:
            self._change_members(lambda members: (*members, member))
            if self.state is not None:
                member.desk_opened(self, self.state)
            elif self.failure is not None:
                member.desk_failed(self, self.failure)

    def leave(self, member: Member) -> None:
        """Tell `member` no more."""
        self._change_members(lambda members: tuple(one for one in members if one is not member))

    def close(self) -> None:
        """Let another server edit this recording; only where nothing runs or waits."""
        self._worker.stop()
        if self._open is not None:
            self._open.close()

    def stop(self) -> None:
        """Finish what runs, forget what waits, close."""
        self._worker.stop()
        self._worker.join()
        if self._open is not None:
            self._open.close()

    # -- what pages ask; each gives back what is set when it was done, or will not be

    def edit(self, edit: Edit, asked: Asked) -> threading.Event:
        """Apply one edit, where it is still about what its page saw."""

        def act(opened: OpenRecording) -> None:
            self._revisions.check_edit(asked, edit, opened.labeling)
            opened.apply(edit)

        return self.change(act, asked)

    def undo(self, asked: Asked, told: ToldOfFolder = _nobody) -> threading.Event:
        """Take the last step back; `told` where it was about the whole folder."""

        def act(opened: OpenRecording) -> None:
            step = opened.document.history.last_done
            told(opened.undo())
            self._authors.tell_undone(step, asked.page, self._members)

        return self._change_seen(act, asked)

    def redo(self, asked: Asked, told: ToldOfFolder = _nobody) -> threading.Event:
        """Make the next step again, likewise."""
        return self._change_seen(lambda opened: told(opened.redo()), asked)

    def mark_done(self, done: bool, asked: Asked) -> threading.Event:
        """Say that it is, or is not, finished."""
        return self._change_seen(lambda opened: opened.mark_done(done), asked)

    def reset_parameters(self, asked: Asked) -> threading.Event:
        """Everything automatic."""
        return self.change(OpenRecording.reset_parameters, asked)

    def keep_labels(self, asked: Asked) -> threading.Event:
        """Agree to the recording as it now is."""
        return self.change(OpenRecording.keep_labels, asked)

    def take_journal(self, asked: Asked) -> threading.Event:
        """Make what was done to the same bytes under another name this recording's."""
        return self._change_seen(OpenRecording.take_journal, asked)

    def forget_label(self, label: str, asked: Asked) -> threading.Event:
        """Take a label out of the folder's vocabulary."""
        return self.change(lambda opened: opened.folder.forget(label), asked)

    def take_over(self, other: str, asked: Asked) -> threading.Event:
        """Make another segmentation this recording's own."""
        return self._change_seen(lambda opened: take_over(opened, other), asked)

    def share_parameters(self, asked: Asked, reopened: Sequence[str] = ()) -> threading.Event:
        """Give all recordings of the folder the parameters that are shown."""
        return self._change_seen(lambda opened: opened.share_parameters(reopened), asked)

    def follow_folder(self) -> threading.Event:
        """Take up what the folder's vocabulary and parameters have become."""
        return self.change(OpenRecording.follow_folder, None)

    def set_parameters(
        self, change: Callable[[Parameters], Parameters], asked: Asked, *, held: bool
    ) -> threading.Event:
        """Change parameters; while `held` the change is shown but not kept.

        Of values that wait only the newest is worked out. Raises ParameterError for a value that
        is out of range, RequestError where the recording is not open.
        """
        with self._lock:
            if self.state is None:
                raise RequestError("This recording is not open yet; wait until it is shown.")
            self._wanted = change(self._wanted or self.state.parameters)
            self._let_go = self._let_go or not held
            kind = f"parameters of {asked.page} after {self._asked}"
        return self._worker.submit(lambda: self._run(self._preview, asked), kind)

    def opened(self) -> DeskState:
        """How the recording stands. Raises RequestError while it is not open."""
        if self.state is None:
            raise RequestError("This recording is not open yet; wait until it is shown.")
        return self.state

    def export(
        self, kind: str, asked: Asked, saved: Callable[[Path], None], if_there: IfThere = "ask"
    ) -> threading.Event:
        """Write the segment file as `json` or `csv`; `saved` is told where it was written."""

        def write(opened: OpenRecording) -> None:
            saved(export(opened.kept_labeling, opened.recording.path, kind, if_there))

        return self.change(write, asked)

    def _change_members(self, change: Callable[[tuple[Member, ...]], tuple[Member, ...]]) -> None:
        """Under a lock of its own: who leaves one desk may be told by another at that moment."""
        with self._members_lock:
            self._members = change(self._members)

    # -- in the worker

    def _begin(self) -> None:
        try:
            with self._tasks.begin(f"{self.recording.name}: reading") as task:
                opened = self._opens(self.recording, task)
        except KeyphaseError as error:
            with self._lock:
                self.failure = error
                for member in self._members:
                    member.desk_failed(self, error)
            return
        self._open = opened
        state = opened.state_at(next(self._numbers))
        self._authors.note(opened.document.history, None)
        with self._lock:
            self.state = state
            self._revisions.add(state, None)
            for member in self._members:
                member.desk_opened(self, state)
        self.on_change(state)

    def _change_seen(
        self, action: Callable[[OpenRecording], None], asked: Asked
    ) -> threading.Event:
        """A change of all there is: only by who has seen all there is."""

        def act(opened: OpenRecording) -> None:
            self._revisions.check_unchanged(asked)
            action(opened)

        return self.change(act, asked)

    def change(
        self, action: Callable[[OpenRecording], None], asked: Asked | None
    ) -> threading.Event:
        """Change the recording, after all that was asked of it before; its errors go to `asked`."""
        with self._lock:
            self._asked += 1
        return self._worker.submit(lambda: self._run(action, asked))

    def _run(self, action: Callable[[OpenRecording], None], asked: Asked | None) -> None:
        opened = self._open
        if opened is None:
            self._refuse(RequestError("This recording cannot be opened."), asked)
            return
        before, shared = told_of(opened), opened.folder.settings.parameters
        try:
            action(opened)
        except Exception as error:
            self._refuse(error, asked)
        finally:
            after = told_of(opened)
            if differs(before, after):
                self._publish(opened, asked)
            if after[1] is not before[1]:
                self.on_folder(self, opened.folder.settings.parameters != shared)

    def _preview(self, opened: OpenRecording) -> None:
        with self._lock:
            wanted, let_go = self._wanted or opened.parameters, self._let_go
            self._let_go = False
        try:
            if opened.needs_refit(wanted):
                with self._tasks.begin(f"{self.recording.name}: segmenting"):
                    opened.preview(wanted)
            else:
                opened.preview(wanted)
            if let_go:
                opened.keep_parameters()
        except KeyphaseError:
            opened.preview(opened.document.parameters)
            raise
        finally:
            with self._lock:
                if self._wanted is wanted:
                    self._wanted = None

    def _publish(self, opened: OpenRecording, asked: Asked | None) -> None:
        cause = asked.cause if asked else None
        state = opened.state_at(next(self._numbers), cause)
        self._authors.note(opened.document.history, asked.page if asked else None)
        with self._lock:
            self.state = state
            self._revisions.add(state, asked.page if asked else None)
            for member in self._members:
                member.desk_changed(self, state)
        self.on_change(state)

    def _refuse(self, error: Exception, asked: Asked | None) -> None:
        if asked is None:
            self._defect(error)
        else:
            asked.refuse(error)

    def _defect(self, error: Exception) -> None:
        in_words(error)
