"""The file of a journal while it is open: looked at again before each line is appended.

Programs that keep folders alike replace files by renaming, and people delete folders. A file that
is open takes lines all the same, and they are gone with it.
"""

import contextlib
import os
import stat
from pathlib import Path

from keyphase.files.writing import sync_folder

_TAIL_BYTES = 512


class FileChangedError(Exception):
    """The file is not what it was; `what` became of it, as in "it was deleted"."""

    def __init__(self, what: str) -> None:
        super().__init__(what)
        self.what = what


class JournalFile:
    """A file to append to, that must stay what it was when it was last read or written."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._descriptor: int | None = None
        self._size = 0
        self._tail = b""

    def expect(self, data: bytes) -> None:
        """The file holds `data`, as was just read or written; b"" where there is none."""
        self.close()
        self._size, self._tail = len(data), data[-_TAIL_BYTES:]
        if data:
            self._descriptor = os.open(self.path, os.O_RDWR | os.O_APPEND | os.O_CLOEXEC)

    @property
    def is_new(self) -> bool:
        """Whether nothing has been written yet."""
        return self._size == 0

    def append(self, data: bytes) -> None:
        """Put `data` at the end, on disk before returning.

        Raises FileChangedError where the file is no longer what it was, and OSError where the disk
        refuses; then the file is as before.
        """
        if self._descriptor is None:
            self._create()
        assert self._descriptor is not None
        self._look(self._descriptor)
        try:
            _write_all(self._descriptor, data)
            os.fsync(self._descriptor)
        except OSError:
            # Half a line would make the next one unreadable.
            with contextlib.suppress(OSError):
                os.ftruncate(self._descriptor, self._size)
            raise
        self._size += len(data)
        self._tail = (self._tail + data)[-_TAIL_BYTES:]
        self._look(self._descriptor)

    def close(self) -> None:
        """Let the file go."""
        if self._descriptor is not None:
            os.close(self._descriptor)
            self._descriptor = None

    def _create(self) -> None:
        flags = os.O_RDWR | os.O_APPEND | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC
        try:
            self._descriptor = os.open(self.path, flags, 0o644)
        except FileExistsError as error:
            raise FileChangedError("another was put in its place") from error
        except FileNotFoundError as error:
            raise FileChangedError("its folder was deleted") from error
        sync_folder(self.path.parent)
        sync_folder(self.path.parent.parent)

    def _look(self, descriptor: int) -> None:
        try:
            there = os.stat(self.path)
        except FileNotFoundError as error:
            raise FileChangedError("it was deleted") from error
        if not stat.S_ISREG(there.st_mode) or not os.path.samestat(there, os.fstat(descriptor)):
            raise FileChangedError("another was put in its place")
        if there.st_size != self._size:
            raise FileChangedError("it was cut" if there.st_size < self._size else "it grew")
        if os.pread(descriptor, _TAIL_BYTES, max(0, self._size - _TAIL_BYTES)) != self._tail:
            raise FileChangedError("it was changed")


def _write_all(descriptor: int, data: bytes) -> None:
    view = memoryview(data)
    while view:
        view = view[os.write(descriptor, view) :]
