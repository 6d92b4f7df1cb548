"""Files written beside a recording, or where there is room for them; never over a stranger's."""

import os
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path

from keyphase.errors import FileInTheWayError, KeyphaseError, RequestError
from keyphase.files.parts import stem_of
from keyphase.labeling.storage.written_files import IfThere, write_unasked


@dataclass(frozen=True)
class InTheWay:
    """A file that would be replaced, and why that is asked first, for people."""

    name: str
    whose: str

    @classmethod
    def of(cls, error: FileInTheWayError) -> "InTheWay":
        """What was refused."""
        return cls(error.path.name, error.whose)


@dataclass(frozen=True)
class Beside:
    """Where files about a recording go, and what becomes of those that are in the way."""

    recording: Path
    if_there: IfThere = "ask"

    def write(
        self, ending: str, data: bytes | Callable[[Path], bytes], refusal: type[KeyphaseError]
    ) -> Path:
        """Write a file that is named after the recording; the path it now has.

        `data` may depend on the path. Raises FileInTheWayError where somebody else's file is
        there, `refusal` where the folder takes no files.
        """
        path = self.path(ending)
        content = data if isinstance(data, bytes) else data(path)
        made_from = self.recording.name
        return write_unasked(
            path, content, made_from, refusal, if_there=self.if_there, ending=ending
        )

    def path(self, ending: str) -> Path:
        """Beside the recording, or, where nothing may be written there, in the current folder."""
        return self.folder / f"{stem_of(self.recording)}{ending}"

    @property
    def folder(self) -> Path:
        """That of the recording, or, where nothing may be written there, the current one."""
        folder = self.recording.parent
        return folder if os.access(folder, os.W_OK) else Path.cwd()


def require_own_names(recording: Path, recordings: Iterable[Path]) -> None:
    """Raise RequestError where another of the recordings would be written to the same files."""
    other = sharing_names(recordings).get(recording)
    if other is not None:
        raise same_names(recording, other)


def sharing_names(recordings: Iterable[Path]) -> Mapping[Path, Path]:
    """Recordings that would be written to the same files as another, each with that other."""
    named: dict[str, Path] = {}
    shared: dict[Path, Path] = {}
    for recording in dict.fromkeys(recordings):
        other = named.setdefault(os.path.normcase(Beside(recording).path("")), recording)
        if other != recording:
            shared[recording] = other
            shared.setdefault(other, recording)
    return shared


def same_names(recording: Path, other: Path) -> RequestError:
    """Why nothing is written for either."""
    return RequestError(
        f"{recording.name} and {other.name} would both be written to {stem_of(recording)}.…; give "
        "one of them another name."
    )
