"""One writer for each journal: a lock the system lets go of when its process ends, however.

The filelock package empties the file before it has the lock, so that the second to come would wipe
out the name of the first; hence our own.
"""

import contextlib
import fcntl
import os
from pathlib import Path

from keyphase.files.reading import first_bytes


class JournalLock:
    """A lock on a file, held until `release` or the end of the process, a kill included."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._descriptor: int | None = None

    def acquire(self) -> bool:
        """Take the lock; False where another holds it. Raises OSError where it cannot be made."""
        descriptor = os.open(self._path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            os.close(descriptor)
            if isinstance(error, BlockingIOError):
                return False
            raise
        self._descriptor = descriptor
        # On a full disk the lock holds, though it cannot say for whom.
        with contextlib.suppress(OSError):
            os.ftruncate(descriptor, 0)
            os.pwrite(descriptor, f"{os.getpid()}\n".encode(), 0)
        return True

    def still_held(self) -> bool:
        """Whether the file that is locked is still the one others would lock."""
        if self._descriptor is None:
            return False
        try:
            there = os.stat(self._path)
        except OSError:
            return False
        return os.path.samestat(there, os.fstat(self._descriptor))

    def holder(self) -> str:
        """Who holds it, for people."""
        try:
            process = first_bytes(self._path, 20).decode("ascii").strip()
        except (OSError, UnicodeDecodeError):
            process = ""
        return f"another keyphase (process {process})" if process.isdigit() else "another keyphase"

    def release(self) -> None:
        """Let go; the file stays, since removing it would race with another's taking it."""
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None
