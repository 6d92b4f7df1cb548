"""One phase changed in all recordings of a folder: made, taken back and made again as one step.

Every recording keeps its own edit in its own journal, all with the same `step`, so that undo in any
of them, also after a restart, takes it back in all. What is done is left alone unless it is meant,
too, and stays done; what somebody worked on since is left as it is, and that is told.
"""

import secrets
import threading
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from keyphase.errors import LabelingError, RequestError
from keyphase.labeling.edits import DropPhase, PhaseInAll, RenamePhase
from keyphase.labeling.history import Step
from keyphase.labeling.storage.summary import summarize
from keyphase.workbench.desks.asked import Asked
from keyphase.workbench.desks.desk import Desk
from keyphase.workbench.desks.library import Library
from keyphase.workbench.desks.open_recording import OpenRecording
from keyphase.workbench.grid.rows import grid_row
from keyphase.workbench.recording_list import RecordingList
from keyphase.workbench.recordings import Recording
from keyphase.workbench.spread import beside
from keyphase.workbench.view import View


@dataclass(frozen=True)
class Made:
    """A change that can be taken back: its edit, and what it is called."""

    edit: PhaseInAll
    name: str


class ForAll:
    """Changes phases of whole folders. For many threads; what takes long is a page's errand.

    taught  told when recordings that are done, from which others learn, have changed
    """

    def __init__(self, library: Library, recordings: RecordingList) -> None:
        self.taught: Callable[[], None] = lambda: None
        self._library, self._list = library, recordings
        self._lock = threading.Lock()
        self._last: dict[Path, Made] = {}

    def last(self, folder: Path) -> Made | None:
        """What was done last to all recordings of a folder, while this server has run."""
        with self._lock:
            return self._last.get(folder)

    def rename(
        self, desk: Desk, label: str, to: str, asked: Asked, view: View, *, include_done: bool
    ) -> threading.Event:
        """Name a phase otherwise in the folder of a recording, and in its task.

        Raises LabelingError for a name that cannot be one.
        """
        edit = RenamePhase(label, to, secrets.token_hex(6)).checked()
        return self._make(desk, edit, asked, view, include_done=include_done)

    def drop(
        self, desk: Desk, label: str, asked: Asked, view: View, *, include_done: bool
    ) -> threading.Event:
        """Drop a phase in the folder of a recording, likewise."""
        edit = DropPhase(label, secrets.token_hex(6)).checked()
        return self._make(desk, edit, asked, view, include_done=include_done)

    def undo(self, desk: Desk, asked: Asked, view: View) -> threading.Event:
        """Take back what was done last to the folder. Raises RequestError where nothing was."""
        made = self.last(desk.recording.path.parent)
        if made is None:
            raise RequestError("Nothing was changed in all recordings since keyphase was started.")
        return self.take_back(desk, made.edit, asked, view)

    def take_back(self, desk: Desk, edit: PhaseInAll, asked: Asked, view: View) -> threading.Event:
        """Take a change back in all recordings of the folder that have it."""

        def act(recordings: list[Recording], counted: list[str]) -> None:
            self._each(recordings, lambda opened: _undo(opened, edit, counted), asked)
            desk.change(lambda opened: _name_back(opened, edit), None).wait()
            with self._lock:
                last = self._last.get(desk.recording.path.parent)
                if last is not None and last.edit.step == edit.step:
                    del self._last[desk.recording.path.parent]

        return self._run(desk, act, lambda: self._having(desk, edit), "Taken back in", view)

    def make_again(self, desk: Desk, edit: PhaseInAll, asked: Asked, view: View) -> threading.Event:
        """Make a change again that was taken back."""

        def act(recordings: list[Recording], counted: list[str]) -> None:
            self._each(recordings, lambda opened: _redo(opened, edit, counted), asked)
            self._made(desk, edit)

        return self._run(desk, act, lambda: self._having(desk, edit), "Made again in", view)

    def _make(
        self, desk: Desk, edit: PhaseInAll, asked: Asked, view: View, *, include_done: bool
    ) -> threading.Event:
        def apply(opened: OpenRecording, counted: list[str]) -> None:
            if opened.document.done and not include_done:
                return
            if any(_is_meant(segment.label, edit) for segment in opened.labeling.segments):
                opened.apply(edit)
                counted.append(opened.recording.name)

        def act(recordings: list[Recording], counted: list[str]) -> None:
            self._each(recordings, lambda opened: apply(opened, counted), asked)
            self._made(desk, edit)

        return self._run(desk, act, lambda: self._meant(desk, edit), "Changed in", view)

    def _made(self, desk: Desk, edit: PhaseInAll) -> None:
        desk.change(lambda opened: _name_on(opened, edit), None).wait()
        name = f"Rename “{edit.label}”" if isinstance(edit, RenamePhase) else f"Drop “{edit.label}”"
        with self._lock:
            self._last[desk.recording.path.parent] = Made(edit, name)

    def _run(
        self,
        desk: Desk,
        act: Callable[[list[Recording], list[str]], None],
        chosen: Callable[[], list[Recording]],
        told: str,
        view: View,
    ) -> threading.Event:
        over, counted = threading.Event(), list[str]()
        lent = self._library.lend(desk.recording)

        def errand() -> None:
            try:
                act(chosen(), counted)
                self.taught()
                count = f"{len(counted)} recording" + ("" if len(counted) == 1 else "s")
                view.tell("info", f"{told} {count}.")
                view.each(lambda watcher: watcher.show_grid())
            finally:
                self._library.give_back(lent)
                over.set()

        view.errands.submit(errand)
        return over

    def _meant(self, desk: Desk, edit: PhaseInAll) -> list[Recording]:
        """Those that have the phase, or of which nobody knows; nothing only proposed."""
        proposals = self._list.listing.proposals
        rows = [grid_row(one, proposals.get(one.id)) for one in self._beside(desk)]
        return [
            row.recording
            for row in rows
            if row.standing == "waiting"
            or (not row.teachers and any(_is_meant(s.label, edit) for s in row.stretches))
        ]

    def _beside(self, desk: Desk) -> tuple[Recording, ...]:
        return beside(desk.recording, self._list.recordings)

    def _having(self, desk: Desk, edit: PhaseInAll) -> list[Recording]:
        """Those whose journal has the change, in force or taken back."""
        return [one for one in self._beside(desk) if edit.step in summarize(one.path).together]

    def _each(
        self,
        recordings: Iterable[Recording],
        action: Callable[[OpenRecording], None],
        asked: Asked,
    ) -> None:
        """One after another; what is refused is told, and costs no other."""
        for recording in recordings:
            desk = self._library.lend(recording)
            try:
                desk.change(action, replace(asked, event=None)).wait()
            finally:
                self._library.give_back(desk)


def _is_meant(label: str, edit: PhaseInAll) -> bool:
    return label == edit.label


def _is_same(step: Step | None, edit: PhaseInAll) -> bool:
    change = step.change if step else None
    return isinstance(change, RenamePhase | DropPhase) and change.step == edit.step


def _undo(opened: OpenRecording, edit: PhaseInAll, counted: list[str]) -> None:
    history = opened.document.history
    if _is_same(history.last_done, edit):
        opened.undo()
        counted.append(opened.recording.name)
    elif any(_is_same(step, edit) for step in history.done):
        raise LabelingError(
            f"{opened.recording.name} was worked on since, so it is left as it is; undo it there."
        )
    elif any(_is_same(step, edit) for step in history.steps):
        counted.append(opened.recording.name)


def _redo(opened: OpenRecording, edit: PhaseInAll, counted: list[str]) -> None:
    history = opened.document.history
    if _is_same(history.next_undone, edit):
        opened.redo()
    if any(_is_same(step, edit) for step in opened.document.history.done):
        counted.append(opened.recording.name)


def _name_on(opened: OpenRecording, edit: PhaseInAll) -> None:
    if isinstance(edit, RenamePhase):
        opened.folder.rename_phase(edit.label, edit.to)


def _name_back(opened: OpenRecording, edit: PhaseInAll) -> None:
    if isinstance(edit, RenamePhase):
        opened.folder.rename_phase(edit.to, edit.label)
