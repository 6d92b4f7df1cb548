"""Files as one piece: read once within a limit and hashed, or replaced as a whole."""

import hashlib
import os
import secrets
from dataclasses import dataclass
from pathlib import Path

from keyphase.demonstration import Source
from keyphase.errors import DemonstrationError

DEFAULT_LIMIT_BYTES = 2 * 1024**3
"""The most a recording may unpack to unless the caller says otherwise."""


@dataclass(frozen=True)
class WholeFile:
    """The bytes of one file and where they came from; what is parsed is what was hashed."""

    data: bytes
    source: Source

    @property
    def name(self) -> str:
        """The path as messages show it."""
        return str(self.source.path)


def read_whole(path: Path, limit_bytes: int) -> WholeFile:
    """Read a regular, non-empty file of at most `limit_bytes`.

    Raises DemonstrationError where there is none, or it is empty, too large or unreadable.
    """
    if os.path.isdir(path):
        raise DemonstrationError(
            f"{path}: expected a recording, but this is a folder; name a file in it."
        )
    if not os.path.isfile(path):
        raise DemonstrationError(
            f"{path}: expected a recording, but there is no such file; check the path."
        )
    try:
        with path.open("rb") as file:
            size = os.fstat(file.fileno()).st_size
            data = file.read(min(size, limit_bytes) + 1)
    except OSError as error:
        raise DemonstrationError(
            f"{path}: the file cannot be read ({error.strerror}); check its permissions."
        ) from error
    if not data:
        raise DemonstrationError(f"{path}: the file is empty; record or export it again.")
    if len(data) > limit_bytes:
        raise DemonstrationError(
            f"{path}: the file is larger than the limit of {limit_bytes} bytes; "
            "cut the recording or raise the limit."
        )
    return WholeFile(data, Source(path, hashlib.sha256(data).hexdigest()))


def write_whole(path: Path, data: bytes) -> None:
    """Put `data` at `path` so that a crash leaves either the old file or the new one.

    Raises DemonstrationError where the folder takes no files.
    """
    try:
        _replace(path, data)
    except OSError as error:
        raise DemonstrationError(
            f"{path}: the file cannot be written ({error.strerror}); check the folder."
        ) from error


def _replace(path: Path, data: bytes) -> None:
    temporary = path.with_name(f".keyphase-{secrets.token_hex(8)}")
    try:
        with temporary.open("xb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    _sync_folder(path.parent)


def _sync_folder(folder: Path) -> None:
    """Make the rename itself durable; only POSIX systems can open a folder."""
    if os.name != "posix":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
