"""Recordings sent from a browser: in pieces, straight to disk, under a name made safe."""

import os
import re
import tempfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import BinaryIO

from keyphase.errors import RequestError

MOST_BYTES = 500 << 20
"""Larger files are put into the folder by hand."""

SUFFIXES = frozenset({".npz", ".csv", ".tsv", ".txt", ".dat", ".log", ".asc"})

_LONGEST_NAME = 80
_UNSAFE = re.compile(r"[^A-Za-z0-9._-]+")


class Upload:
    """One file on its way; `write` is called with its pieces in order.

    Nothing of it is read before it is whole, and nothing in it is ever executed.
    """

    def __init__(self, folder: Path, name: str, size: int) -> None:
        """Raises RequestError for a kind of file that is no recording, or one too large."""
        self._folder = folder
        self._name = safe_name(name)
        if not 0 < size <= MOST_BYTES:
            raise RequestError(
                f"A file sent from the browser has up to {MOST_BYTES >> 20} MB, but {self._name} "
                f"has {size / (1 << 20):.0f}; put it into the folder by hand."
            )
        self._left = size
        descriptor, path = tempfile.mkstemp(prefix=".upload-", dir=folder)
        self._part = Path(path)
        self._file: BinaryIO = os.fdopen(descriptor, "wb")

    @property
    def is_whole(self) -> bool:
        """Whether every byte has come."""
        return self._left == 0

    def write(self, piece: bytes) -> None:
        """Put the next piece on disk. Raises RequestError where more comes than was announced."""
        if len(piece) > self._left:
            self.abandon()
            raise RequestError(f"More of {self._name} came than was announced; send it again.")
        self._file.write(piece)
        self._left -= len(piece)

    def finish(self) -> Path:
        """Give the whole file its name, beside others of that name; where it now is."""
        self._file.flush()
        os.fsync(self._file.fileno())
        self._file.close()
        for path in _free_names(self._folder / self._name):
            try:
                os.link(self._part, path)
            except FileExistsError:
                continue
            self._part.unlink()
            return path
        raise AssertionError("names never end")

    def abandon(self) -> None:
        """Forget what has come so far."""
        self._file.close()
        self._part.unlink(missing_ok=True)


def safe_name(name: str) -> str:
    """A name without folders, spaces and anything a shell or a browser could read otherwise.

    Raises RequestError for a name that is not a recording's.
    """
    last = re.split(r"[/\\]", name)[-1]
    stem, suffix = os.path.splitext(last)
    if suffix.lower() not in SUFFIXES:
        kinds = ", ".join(sorted(SUFFIXES))
        raise RequestError(f"A recording is a file of the kinds {kinds}, but not {last[:80]!r}.")
    stem = _UNSAFE.sub("_", stem).strip("._-")[:_LONGEST_NAME]
    return (stem or "recording") + suffix.lower()


def upload_folder(recordings: Sequence[Path]) -> Path:
    """Where uploads go: beside the first recording, or into the current folder."""
    beside = recordings[0].parent if recordings else Path.cwd()
    return beside if os.access(beside, os.W_OK) else Path.cwd()


def _free_names(path: Path) -> Iterator[Path]:
    yield path
    number = 2
    while True:
        yield path.with_stem(f"{path.stem}_{number}")
        number += 1
