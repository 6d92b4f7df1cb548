"""Labels in HDF5 files: REASSEMBLE's segments, words for each step, and keyphase's own rows."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.auditing.given import GivenSegment, runs
from keyphase.auditing.lerobot import WORDS, Named
from keyphase.demonstration import Demonstration
from keyphase.errors import ExportError
from keyphase.files.parts import split_part
from keyphase.writers.hdf5.reassemble import INFO
from keyphase.writers.hdf5.robomimic import NAMES, ROWS
from keyphase.writers.hdf5.rows import EXTRA
from keyphase.writers.packages import package

_MAX_SEGMENTS = 100_000


def hdf5_labels(recording: Path, demonstration: Demonstration, zero_s: float) -> Iterator[Named]:
    """What an HDF5 file says of a recording, each with the place it was found in.

    `zero_s` is what the demonstration's time zero is in the file's clock.
    """
    path, part = split_part(recording)
    h5py = package("h5py", EXTRA)
    try:
        with h5py.File(path, "r") as file:
            group = file["data"][part] if part else file
            if INFO in file:
                yield INFO, tuple(_segments(file[INFO], zero_s))
            yield from _steps(group, demonstration)
    except (OSError, RuntimeError, KeyError, ValueError, TypeError) as error:
        raise ExportError(f"{path}: its labels cannot be read ({error}); copy it again.") from error


def _segments(info: Any, zero_s: float) -> Iterator[GivenSegment]:
    if len(info) > _MAX_SEGMENTS:
        raise ValueError(f"it has {len(info)} segments")
    for name in info:
        one = info[name]
        start, end = (float(one[key][()]) - zero_s for key in ("start", "end"))
        yield GivenSegment(start, end, _text(one["text"][()]))


def _steps(group: Any, demonstration: Demonstration) -> Iterator[Named]:
    """Words, or numbers of words, for each row of the demonstration."""
    found: list[tuple[str, list[str]]] = []
    for name in WORDS:
        for place in (name, f"obs/{name}"):
            if place in group and group[place].dtype.kind in "OSU":
                found.append((place, [_text(value) for value in group[place][()].ravel()]))
    if ROWS in group and NAMES in group.attrs:
        names = json.loads(group.attrs[NAMES])
        found.append((ROWS, [names[int(number)] for number in group[ROWS][()]]))
    for place, words in found:
        if len(words) == len(demonstration):
            yield place, runs(words, demonstration.time_s.tolist(), demonstration.end_s)


def _text(value: Any) -> str:
    if isinstance(value, np.ndarray):
        value = value.ravel()[0]
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)
