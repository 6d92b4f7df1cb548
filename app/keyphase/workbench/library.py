"""Recordings on disk: opened for editing, or only looked at for the queue."""

from collections import OrderedDict
from pathlib import Path

from keyphase.labeling.storage.journal import Journal
from keyphase.readers import Recipe, load_recipe, read
from keyphase.workbench.folder import Folder
from keyphase.workbench.opened import Opened
from keyphase.workbench.recordings import Recording
from keyphase.workbench.telling import Progress
from keyphase.workbench.uploads import Upload

KEPT_OPEN = 3
"""So many recordings stay open, so that going back to one is quick."""


class Library:
    """Opens recordings. Not for use by several threads at once.

    recipe      how to read tables that are not in keyphase's own form
    read_only   journals are opened for looking only
    """

    def __init__(self, recipe: Path | None = None, *, read_only: bool = False) -> None:
        self._recipe: Recipe | None = load_recipe(recipe) if recipe else None
        self._read_only = read_only
        self._folders: dict[Path, Folder] = {}
        self._open: OrderedDict[str, Opened] = OrderedDict()

    def open(self, recording: Recording, progress: Progress) -> Opened:
        """The recording for editing, read and segmented.

        Raises DemonstrationError, RecipeError or JournalError for what cannot be opened.
        """
        if not self.has_open(recording):
            self._open[recording.id] = self._opened(recording, progress, self._read_only)
        self._open.move_to_end(recording.id)
        while len(self._open) > KEPT_OPEN:
            self._open.popitem(last=False)[1].close()
        return self._open[recording.id]

    def has_open(self, recording: Recording) -> bool:
        """Whether the recording is open, so that there is no need to look at it."""
        return recording.id in self._open

    def look(self, recording: Recording) -> Opened:
        """The recording as it stands on disk, which is not kept open; close it after use."""
        return self._opened(recording, lambda _what, _fraction: None, read_only=True)

    def take_in(self, upload: Upload, beside: Opened | None) -> Path:
        """A file that was sent, read and named; `beside` is open, and a segment file is about it.

        Raises RequestError with the reason where it cannot be used.
        """
        source = beside.demonstration.source if beside else None
        return upload.finish(self._recipe, source.sha256 if source else None)

    def drop(self, recording_id: str) -> None:
        """Close a recording that is no longer in the list."""
        opened = self._open.pop(recording_id, None)
        if opened is not None:
            opened.close()

    def close(self) -> None:
        """Let other servers edit what was open."""
        for opened in self._open.values():
            opened.close()
        self._open.clear()

    def _opened(self, recording: Recording, progress: Progress, read_only: bool) -> Opened:
        progress("reading", None)
        demonstration = read(recording.path, self._recipe)
        folder = self._folder(recording.path.parent)
        journal = Journal(demonstration, folder.settings.parameters, read_only=read_only)
        progress("segmenting", None)
        try:
            return Opened(recording, journal, folder)
        except BaseException:
            journal.close()
            raise

    def _folder(self, path: Path) -> Folder:
        if path not in self._folders:
            self._folders[path] = Folder(path)
        return self._folders[path]
