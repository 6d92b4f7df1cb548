"""Where keyphase keeps what people did: beside the recordings, or with the user's own state."""

import hashlib
import os
from dataclasses import dataclass
from pathlib import Path

from platformdirs import user_state_path

from keyphase.errors import JournalError

NAME = ".keyphase"
"""Folder beside the recordings that holds their journals and the folder's settings."""

_MAX_NAME_LENGTH = 200
"""Bytes; file systems take 255, and what is kept beside a journal is named after it."""


@dataclass(frozen=True)
class StateFolder:
    """The folder in use, whether it can be written, and what a person should know about it.

    `other` is the second of the two places; what was written there while this one could not be
    is not forgotten.
    """

    path: Path
    other: Path
    writable: bool
    notice: str | None = None

    def both(self, name: str) -> tuple[Path, ...]:
        """The files of that name in the two places, the one in use first."""
        return tuple(
            folder / name for folder in (self.path, self.other) if os.path.lexists(folder / name)
        )

    def newest(self, name: str) -> Path | None:
        """The file of that name, from whichever of the two places it was last written in."""
        files = [file for file in self.both(name) if os.path.isfile(file)]
        return max(files, key=lambda file: file.stat().st_mtime_ns, default=None)


def state_folder(recordings: Path, *, create: bool = True) -> StateFolder:
    """The state folder for the recordings in a folder.

    It lies beside them. Where nothing can be written there, it lies in the user's state folder
    (`$XDG_STATE_HOME` or ~/.local/state), under a name made from the recordings' absolute path.
    Without `create` nothing is made or tried. Raises JournalError where neither can be written.
    """
    beside = recordings / NAME
    own = _own(recordings)
    if not create:
        return StateFolder(beside, own, writable=False)
    if _usable(beside):
        return StateFolder(beside, own, writable=True)
    if _usable(own):
        notice = f"{recordings} cannot be written, so edits are kept in {own}."
        return StateFolder(own, beside, writable=True, notice=notice)
    raise JournalError(
        f"Edits can be kept neither in {beside} nor in {own}, because neither folder can be "
        "written; make one of them writable or open with --read-only."
    )


def state_name(recording: Path, suffix: str) -> str:
    """The name under which something about a recording is kept.

    A name that would be too long for a file system is cut and told apart by its hash.
    """
    name = os.fsencode(recording.name)
    if len(name) + len(suffix) <= _MAX_NAME_LENGTH:
        return f"{recording.name}{suffix}"
    cut = name[: _MAX_NAME_LENGTH - len(suffix) - 20].decode("utf-8", "ignore")
    return f"{cut}~{hashlib.sha256(name).hexdigest()[:16]}{suffix}"


def journal_path(recording: Path, folder: Path) -> Path:
    """The journal of a recording in a state folder."""
    return folder / state_name(recording, ".journal")


def own_state() -> Path:
    """The user's own folder for keyphase's state; it need not be there."""
    return user_state_path("keyphase", appauthor=False)


def _own(recordings: Path) -> Path:
    absolute = Path(os.path.realpath(recordings))
    digest = hashlib.sha256(os.fsencode(absolute)).hexdigest()[:12]
    return own_state() / f"{absolute.name[:60] or 'root'}-{digest}"


def _usable(folder: Path) -> bool:
    """Whether a file can be made in the folder; permissions alone do not tell."""
    probe = folder / f".probe-{os.getpid()}"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe.touch()
        probe.unlink()
    except (OSError, ValueError):
        return False
    return True
