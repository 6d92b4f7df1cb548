"""Where keyphase keeps what people did: beside the recordings, or with the user's own state."""

import hashlib
import os
from dataclasses import dataclass
from pathlib import Path

from keyphase.errors import JournalError

NAME = ".keyphase"
"""Folder beside the recordings that holds their journals and the folder's settings."""


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

    def newest(self, name: str) -> Path | None:
        """The file of that name, from whichever of the two places it was last written in."""
        files = [folder / name for folder in (self.path, self.other) if (folder / name).is_file()]
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


def _own(recordings: Path) -> Path:
    base = os.environ.get("XDG_STATE_HOME") or os.path.expanduser("~/.local/state")
    absolute = Path(os.path.realpath(recordings))
    digest = hashlib.sha256(os.fsencode(absolute)).hexdigest()[:12]
    return Path(base, "keyphase", f"{absolute.name or 'root'}-{digest}")


def _usable(folder: Path) -> bool:
    """Whether a file can be made in the folder; permissions alone do not tell."""
    probe = folder / f".probe-{os.getpid()}"
    try:
        folder.mkdir(parents=True, exist_ok=True)
        probe.touch()
        probe.unlink()
    except OSError:
        return False
    return True
