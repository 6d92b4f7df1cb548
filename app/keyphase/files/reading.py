"""A file as one piece: read once, within a limit, and hashed; never a device or a pipe."""

import errno
import hashlib
import os
import stat
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

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


def read_regular(path: Path, limit_bytes: int) -> bytes:
    """The bytes of a regular file of at most `limit_bytes`.

    Raises OSError where it cannot be read, is a folder, a device or a pipe, or is larger. It never
    waits, as opening a pipe would.
    """
    with _opened(path) as file:
        data = file.read(min(os.fstat(file.fileno()).st_size, limit_bytes) + 1)
    if len(data) > limit_bytes:
        raise OSError(27, f"it is larger than the limit of {limit_bytes} bytes", str(path))
    return data


def first_bytes(path: Path, count: int) -> bytes:
    """The first bytes of a regular file. Raises OSError as `read_regular` does."""
    with _opened(path) as file:
        return file.read(count)


def _opened(path: Path) -> BinaryIO:
    descriptor = os.open(path, os.O_RDONLY | os.O_CLOEXEC | getattr(os, "O_NONBLOCK", 0))
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        os.close(descriptor)
        raise OSError(errno.EINVAL, "it is no regular file", str(path))
    return open(descriptor, "rb")


def read_whole(path: Path, limit_bytes: int) -> WholeFile:
    """Read a regular, non-empty file of at most `limit_bytes`.

    Raises DemonstrationError where there is none, or it is empty, too large or unreadable.
    """
    try:
        mode = os.stat(path).st_mode
        if stat.S_ISDIR(mode):
            os.listdir(path)
            raise DemonstrationError(
                f"{path}: expected a recording, but this is a folder; name a file in it."
            )
        data = read_regular(path, limit_bytes)
    except (OSError, ValueError) as error:
        # A name that is too long or holds a NUL names no file either.
        if isinstance(error, ValueError) or error.errno in (errno.ENOENT, errno.ENAMETOOLONG):
            raise DemonstrationError(
                f"{path}: expected a recording, but there is no such file; check the path."
            ) from error
        raise DemonstrationError(
            f"{path}: the file cannot be read ({error.strerror}); check its kind, size and "
            "permissions."
        ) from error
    if not data:
        raise DemonstrationError(f"{path}: the file is empty; record or export it again.")
    return WholeFile(data, Source(path, hashlib.sha256(data).hexdigest()))
