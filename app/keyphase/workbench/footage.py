"""Videos of the recordings at work: found once for each, lent to pages under a name of chance."""

import secrets
import threading
from collections.abc import Callable
from dataclasses import dataclass

from keyphase.cameras import Camera, Footage, footage_of
from keyphase.workbench.recordings import Recording
from keyphase.workbench.tasks import Tasks
from keyphase.workbench.telling import in_words
from keyphase.workbench.worker import Worker

Found = Callable[["LentFootage"], None]


@dataclass(frozen=True)
class LentCamera:
    """A camera and the name under which its file is asked for."""

    id: str
    camera: Camera


@dataclass(frozen=True)
class LentFootage:
    """The cameras of a recording, and what could not be shown of it."""

    recording: str
    cameras: tuple[LentCamera, ...]
    refused: tuple[str, ...]


class FootageShelf:
    """Finds videos in a thread of its own; of a file only its name of chance is ever told."""

    def __init__(self, tasks: Tasks) -> None:
        self._tasks = tasks
        self._lock = threading.Lock()
        self._found: dict[str, LentFootage] = {}
        self._files: dict[str, Camera] = {}
        self._worker = Worker(in_words)

    def find(self, recording: Recording, start_s: float, found: Found) -> None:
        """Tell `found` of the cameras of a recording that begins at `start_s` [s]."""
        self._worker.submit(lambda: found(self._of(recording, start_s)))

    def camera(self, id: str) -> Camera | None:
        """The camera that was lent under this name."""
        with self._lock:
            return self._files.get(id)

    def stop(self) -> None:
        """End the thread when what it does is done."""
        self._worker.stop()

    def _of(self, recording: Recording, start_s: float) -> LentFootage:
        known = self._found.get(recording.id)
        if known is not None and known.cameras:
            return known
        with self._tasks.begin(f"{recording.name}: looking for videos") as task:
            footage = footage_of(recording.path, start_s, tell=task.at)
        lent = self._lend(recording.id, footage)
        with self._lock:
            self._found[recording.id] = lent
        return lent

    def _lend(self, recording: str, footage: Footage) -> LentFootage:
        cameras = tuple(LentCamera(secrets.token_urlsafe(24), one) for one in footage.cameras)
        with self._lock:
            self._files |= {one.id: one.camera for one in cameras}
        return LentFootage(recording, cameras, footage.refused)
