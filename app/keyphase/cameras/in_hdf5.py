"""Videos inside HDF5 files, as REASSEMBLE has them: the bytes of an mp4 in a dataset."""

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.cameras.camera import MAX_NAME_LENGTH, Stretch
from keyphase.cameras.container import LONGEST_HEAD, media_type_of
from keyphase.cameras.kept import Kept
from keyphase.readers.formats.hdf5 import opened

MAX_BYTES = 8 * 1024**3
_MAX_CAMERAS = 32
_CLOCKS = "timestamps"


def videos_in_hdf5(path: Path, part: str | None, start_s: float, kept: Kept) -> Iterator[Stretch]:
    """The videos of a file, each copied out once; `timestamps/NAME` says when they were taken.

    Frames counted from the file's own zero are laid on the recording's clock, which begins at
    `start_s`. Raises DemonstrationError for a file that cannot be read.
    """
    with opened(path) as file:
        group = file if part is None else file.get(f"data/{part}", file)
        names = [name for name in group if _is_video(group, name)][:_MAX_CAMERAS]
        zero = _first(file, f"{_CLOCKS}/pose")
        for name in names:
            begins = _first(file, f"{_CLOCKS}/{name}")
            if begins is not None and zero is not None and start_s < zero:
                begins -= zero
            copy = kept.made(path, f"{part}/{name}", lambda to, of=group[name]: _write(of, to))
            yield Stretch(name[:MAX_NAME_LENGTH], copy, begins_s=begins)


def _is_video(group: Any, name: str) -> bool:
    """Whether a dataset of this file itself begins as a video does."""
    import h5py

    if not isinstance(group.get(name, getlink=True), h5py.HardLink):
        return False
    item = group[name]
    if not isinstance(item, h5py.Dataset) or item.is_virtual or item.external:
        return False
    if item.nbytes > MAX_BYTES or not _holds_bytes(item):
        return False
    head = _bytes(item, LONGEST_HEAD)
    return media_type_of(head) is not None


def _holds_bytes(item: Any) -> bool:
    if item.shape == ():
        return item.dtype.kind in "VSO"
    return len(item.shape) == 1 and item.dtype in (np.uint8, np.int8)


def _bytes(item: Any, count: int | None = None) -> bytes:
    """The first bytes of it; a single value is read as a whole."""
    raw = item[()] if item.shape == () else item[:count]
    data = raw.tobytes() if isinstance(raw, np.ndarray | np.void) else bytes(raw)
    return data if count is None else data[:count]


def _write(item: Any, to: Path) -> None:
    with open(to, "wb") as file:
        file.write(_bytes(item))
        os.fsync(file.fileno())


def _first(file: Any, name: str) -> float | None:
    """The first of a list of times."""
    found = file.get(name)
    if found is None or getattr(found, "shape", ())[:1] < (1,):
        return None
    first = float(np.ravel(found[:1])[0])
    return first if np.isfinite(first) else None
