"""Segments as rows of a demonstration in an HDF5 file."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.errors import ExportError
from keyphase.readers.formats.damage import what_is_wrong
from keyphase.writers.packages import package
from keyphase.writers.segmented import SegmentedRecording

EXTRA = "hdf5"


@contextmanager
def changing(path: Path, shown: Path) -> Iterator[Any]:
    """The copy of an HDF5 file at `path`, open for writing; `shown` is what messages name."""
    h5py = package("h5py", EXTRA)
    try:
        with h5py.File(path, "r+") as file:
            yield file
    except (OSError, RuntimeError, KeyError, ValueError, TypeError) as error:
        raise ExportError(
            f"{shown}: expected a whole HDF5 file, but it cannot be written into "
            f"({what_is_wrong(path, error)}); copy it again."
        ) from error


def require_hdf5(item: SegmentedRecording, layout: str, holds: str) -> None:
    """Raise ExportError unless the recording is in an HDF5 file that has a group `holds`."""
    h5py = package("h5py", EXTRA)
    path = item.container
    if path.is_file() and h5py.is_hdf5(path):
        with h5py.File(path, "r") as file:
            if holds in file:
                return
    raise ExportError(
        f"{path}: expected an HDF5 file of {layout} with a group {holds!r}, since it is written "
        "into a copy of the file that was recorded; choose another format for this recording."
    )


def first_rows(item: SegmentedRecording, group: Any) -> tuple[list[int], int]:
    """The first row of each segment, and how many rows the demonstration has in the file.

    Raises ExportError where the recording was read with other rows than the file has.
    """
    count = _rows(group)
    demonstration = item.demonstration()
    if len(demonstration) != count:
        raise ExportError(
            f"{item.recording}: it was read as {len(demonstration)} samples, but has {count} rows; "
            "read it without leaving rows out and segment it again."
        )
    starts = np.array([segment.start_s for segment in item.segments]) - 1e-6
    rows = np.searchsorted(demonstration.time_s, starts).tolist()
    return [0, *rows[1:]], count


def _rows(group: Any) -> int:
    if "actions" in group:
        return int(group["actions"].shape[0])
    if "num_samples" in group.attrs:
        return int(group.attrs["num_samples"])
    return max(len(values) for values in group["obs"].values())


def put(group: Any, name: str, values: Any) -> None:
    """Write a dataset, in place of one that is there."""
    if name in group:
        del group[name]
    group[name] = values
