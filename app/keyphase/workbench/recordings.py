"""The queue of recordings: what is known of each without having it open."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from keyphase.files.parts import stem_of

State = Literal["automatic", "touched", "done"]


@dataclass(frozen=True)
class Recording:
    """One line of the queue.

    state, confidence, strip   what its segmentation has come to; empty until it was looked at
    error                      why it cannot be opened
    """

    id: str
    path: Path
    state: State = "automatic"
    confidence: float | None = None
    strip: tuple[dict[str, Any], ...] = ()
    error: str | None = None

    @property
    def name(self) -> str:
        """The file's name for people, whatever bytes it is made of."""
        return printable(stem_of(self.path))


def queue(paths: Sequence[Path]) -> tuple[Recording, ...]:
    """A line for each path, in the given order."""
    return tuple(Recording(str(number), path) for number, path in enumerate(paths, start=1))


def recordings_message(recordings: Sequence[Recording], current: str | None) -> dict[str, Any]:
    """The `recordings` message."""
    return {
        "type": "recordings",
        "folder": folder_name(recordings),
        "current": current,
        "items": [
            {
                "id": recording.id,
                "name": recording.name,
                "state": recording.state,
                "confidence": recording.confidence,
                "strip": list(recording.strip),
                "error": recording.error,
            }
            for recording in recordings
        ],
    }


def folder_name(recordings: Sequence[Recording]) -> str:
    """Name of the folder all recordings share, or nothing."""
    folders = {recording.path.parent for recording in recordings}
    return printable(folders.pop().name) if len(folders) == 1 else ""


def printable(name: str) -> str:
    """A file name as text that can be sent; bytes that are no text become a mark."""
    return name.encode("utf-8", "replace").decode("utf-8")
