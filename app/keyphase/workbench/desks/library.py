"""Recordings on disk: lent as desks, or only looked at for the list."""

import itertools
import threading
import time
from collections import OrderedDict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from keyphase.errors import RequestError
from keyphase.labeling.storage.folder_settings import FolderSettings, read_folder_settings
from keyphase.labeling.storage.journal import Journal
from keyphase.readers import Recipe, load_recipe, read
from keyphase.workbench.apart.apart import ReadingApart
from keyphase.workbench.desks.desk import Desk
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.desks.folder import Folder
from keyphase.workbench.desks.open_recording import OpenRecording
from keyphase.workbench.recordings import Recording
from keyphase.workbench.tasks import Task, Tasks
from keyphase.workbench.uploads import Upload

KEPT_OPEN = 3
"""So many desks nobody looks at stay as they are, so that going back to one is quick."""


class Library:
    """Lends desks. One that is lent, or has work waiting, is never closed. For many threads.

    recipe      how to read tables that are not in keyphase's own form
    read_only   journals are opened for looking only

    reading     what reads for it, in a process of its own where a file could end that
    """

    def __init__(
        self, tasks: Tasks, recipe: Path | None = None, *, read_only: bool = False
    ) -> None:
        self.on_change: Callable[[DeskState], None] = lambda _state: None
        self.on_parameters: Callable[[], None] = lambda: None
        self._recipe: Recipe | None = load_recipe(recipe) if recipe else None
        self._read_only = read_only
        self._tasks = tasks
        # Milliseconds, so that what a page saw of an earlier server is none of our revisions.
        self._revisions = itertools.count(time.time_ns() // 1_000_000)
        self._lock = threading.RLock()
        self._folders: dict[Path, Folder] = {}
        self._desks: OrderedDict[str, Desk] = OrderedDict()
        self._loans: dict[str, int] = {}
        self._closed = False
        self.reading = ReadingApart()

    @property
    def recipe(self) -> Recipe | None:
        """How tables are read that are not in keyphase's own form, where one was given for all."""
        return self._recipe

    @property
    def is_free(self) -> bool:
        """Whether no desk has anything to do."""
        with self._lock:
            return all(desk.is_free for desk in self._desks.values())

    def lend(self, recording: Recording) -> Desk:
        """The desk of a recording, opened where it is not; give it back after use."""
        with self._lock:
            known = self._desks.get(recording.id)
            if known is not None and known.failure is not None and not self._loans[recording.id]:
                self._forget(known)
            desk = self._desks.get(recording.id) or self._new(recording)
            self._desks.move_to_end(recording.id)
            self._loans[recording.id] += 1
            return desk

    def give_back(self, desk: Desk) -> None:
        """It is no longer needed by one of those who lent it."""
        with self._lock:
            if self._desks.get(desk.recording.id) is desk:
                self._loans[desk.recording.id] -= 1
        self.tidy()

    @contextmanager
    def at(self, recording_id: str) -> Iterator[Desk]:
        """The desk of a recording that is open, on loan for as long as something is asked of it.

        Raises RequestError where it is not open.
        """
        with self._lock:
            desk = self._desks.get(recording_id)
            if desk is None:
                raise RequestError("That recording is no longer open; open it and ask again.")
            self._loans[recording_id] += 1
        try:
            yield desk
        finally:
            self.give_back(desk)

    def has_open(self, recording_id: str) -> bool:
        """Whether there is a desk, so that there is no need to look at the recording."""
        with self._lock:
            desk = self._desks.get(recording_id)
            return desk is not None and desk.failure is None

    def beside(self, desk: Desk) -> tuple[Desk, ...]:
        """The other desks of its folder."""
        folder = desk.recording.path.parent
        with self._lock:
            return tuple(
                one
                for one in self._desks.values()
                if one is not desk and one.recording.path.parent == folder
            )

    def settings_of(self, path: Path) -> FolderSettings:
        """What the recordings of a folder share; takes no lock, so that any thread may ask."""
        known = self._folders.get(path)
        return known.settings if known else read_folder_settings(path)

    def look(self, recording: Recording) -> OpenRecording:
        """The recording as it stands on disk, which is not kept open; close it after use."""
        return self._opened(recording, None, read_only=True)

    def take_in(self, upload: Upload, open_sha256: str | None) -> Path:
        """A file that was sent, read and named; a segment file is about the recording with a hash.

        Raises RequestError with the reason where it cannot be used.
        """
        return upload.finish(self._recipe, open_sha256, self.reading.call)

    def tidy(self) -> None:
        """Close desks nobody has looked at for long."""
        with self._lock:
            spare = [
                desk
                for id, desk in self._desks.items()
                if not self._loans[id] and desk.is_free and not self._closed
            ]
            for desk in spare[: max(len(spare) - KEPT_OPEN, 0)]:
                self._forget(desk)

    def close(self) -> None:
        """Finish what runs, and let other servers edit what was open."""
        with self._lock:
            self._closed = True
            desks = tuple(self._desks.values())
        self.reading.close()
        for desk in desks:
            desk.stop()
        with self._lock:
            self._desks.clear()

    def _new(self, recording: Recording) -> Desk:
        desk = Desk(recording, self._opens, self._tasks, self._revisions, self.tidy)
        desk.on_change, desk.on_folder = self._changed, self._folder_changed
        self._desks[recording.id] = desk
        self._loans[recording.id] = 0
        return desk

    def _forget(self, desk: Desk) -> None:
        """Closed before another desk of the same recording can be made, which needs its journal."""
        desk.close()
        del self._desks[desk.recording.id]
        del self._loans[desk.recording.id]

    def _changed(self, state: DeskState) -> None:
        self.on_change(state)

    def _folder_changed(self, desk: Desk, parameters: bool) -> None:
        for other in self.beside(desk):
            other.follow_folder()
        if parameters:
            self.on_parameters()

    def _opens(self, recording: Recording, task: Task) -> OpenRecording:
        return self._opened(recording, task, self._read_only)

    def _opened(self, recording: Recording, task: Task | None, read_only: bool) -> OpenRecording:
        demonstration = self.reading.call(recording.path, read, recording.path, self._recipe)
        folder = self._folder(recording.path.parent)
        journal = Journal(demonstration, folder.settings.parameters, read_only=read_only)
        if task is not None:
            task.at(None, f"{recording.name}: segmenting")
        try:
            return OpenRecording(recording, journal, folder)
        except BaseException:
            journal.close()
            raise

    def _folder(self, path: Path) -> Folder:
        with self._lock:
            if path not in self._folders:
                self._folders[path] = Folder(path)
            return self._folders[path]
