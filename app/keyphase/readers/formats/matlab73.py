"""MATLAB files of version 7.3, which are HDF5 with axes in MATLAB's order."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.errors import DemonstrationError
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import UnfitError
from keyphase.readers.formats.hdf5 import MAX_ARRAYS, MAX_DEPTH, is_own_data, opened, refuse_hollow
from keyphase.readers.formats.numeric import is_signal, refuse_too_large
from keyphase.readers.formats.upright import upright

MAGIC = b"MATLAB 7.3 MAT-file"
_MAX_WIDTH = 512
_MAX_CLASS_BYTES = 64


def table_of_mat73(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """The variables; fields of a struct are `struct.field`. Cells and texts are passed over.

    Raises DemonstrationError for what cannot be read, MissingPackageError where h5py is not
    installed.
    """
    if part is not None:
        raise DemonstrationError(f"{path}: it is one recording; name it without #{part[:80]}.")
    with opened(path) as file:
        found = dict(_variables(file))
        refuse_too_large(found.values(), str(path), limit_bytes)
        refuse_hollow(found)
        arrays = {name: np.asarray(dataset[()]).T for name, dataset in found.items()}
    standing, notices = upright(arrays)
    signals = {name: values for name, values in standing.items() if is_signal(values)}
    if not signals:
        raise DemonstrationError(
            f"{path}: expected variables of numbers, one row a sample, but it holds none."
        )
    return ArrayTable(str(path), signals, {}, notices, {})


def _variables(group: Any, before: str = "", depth: int = 0) -> Iterator[tuple[str, Any]]:
    import h5py

    if depth > MAX_DEPTH or len(group) > MAX_ARRAYS:
        raise UnfitError("it is nested deeper, or holds more, than a recording does")
    for name in group:
        if name.startswith("#") or not isinstance(group.get(name, getlink=True), h5py.HardLink):
            continue
        item = group[name]
        if isinstance(item, h5py.Group):
            yield from _variables(item, f"{before}{name}.", depth + 1)
        elif is_own_data(item) and item.dtype.kind in "fiub" and _is_variable(item):
            yield f"{before}{name}", item


def _is_variable(item: Any) -> bool:
    """Numbers in at most two axes, one of them short; texts are marked as such."""
    is_text = _class_of(item) == b"char" or "MATLAB_empty" in item.attrs
    return not is_text and 0 < item.ndim < 4 and min(item.shape) <= _MAX_WIDTH


def _class_of(item: Any) -> bytes:
    """What MATLAB calls its type. A text of another kind than MATLAB's is not read: its length
    stands elsewhere in the file and may be anything.
    """
    if "MATLAB_class" not in item.attrs:
        return b"double"
    kept = item.attrs.get_id("MATLAB_class")
    is_short = kept.dtype.kind == "S" and kept.dtype.itemsize <= _MAX_CLASS_BYTES
    return bytes(item.attrs["MATLAB_class"]) if is_short and kept.shape == () else b"double"
