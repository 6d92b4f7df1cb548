"""A recording as one piece: read once, within a limit, and hashed."""

import hashlib
import os
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
