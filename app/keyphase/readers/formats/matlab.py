"""MATLAB files (`.mat`, up to version 7.2) and single NumPy arrays (`.npy`), never unpickled."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from keyphase.errors import DemonstrationError
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import damage_told
from keyphase.readers.formats.numeric import is_signal, refuse_too_large
from keyphase.readers.formats.upright import upright

NPY_MAGIC = b"\x93NUMPY"
MAT_MAGIC = b"MATLAB 5.0 MAT-file"

_MAX_DEPTH = 6


def table_of_npy(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """One array (N, D) as the columns `array[0]`, …, or a structured one by its fields.

    Raises DemonstrationError for what is no whole array of numbers.
    """
    _refuse_part(path, part)
    with damage_told(path, "array", "save it again with numpy.save"):
        _refuse_pickled(path)
        mapped = np.load(path, mmap_mode="r", allow_pickle=False)
        if not isinstance(mapped, np.ndarray):
            raise ValueError("it holds no array")
        refuse_too_large([mapped], str(path), limit_bytes)
        array = np.array(mapped)
    named = {name: array[name] for name in array.dtype.names or ()} or {"array": array}
    signals, notices = _signals(named, str(path))
    return ArrayTable(str(path), signals, {}, notices, {})


def _refuse_pickled(path: Path) -> None:
    with path.open("rb") as stream:
        version = npy.read_magic(stream)
        reading = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
        pickled = version in ((1, 0), (2, 0)) and reading(stream)[2].hasobject
    if pickled:
        raise DemonstrationError(
            f"{path}: it holds pickled Python objects, which can run programs and are never "
            "loaded; load it where you trust it and save its arrays: "
            "numpy.savez('run.npz', **numpy.load('run.npy', allow_pickle=True).item())."
        )


def table_of_mat(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """The variables of a MATLAB file; fields of a struct are `struct.field`.

    Raises DemonstrationError for what cannot be read.
    """
    from scipy.io import loadmat

    _refuse_part(path, part)
    if path.stat().st_size > limit_bytes:
        raise DemonstrationError(
            f"{path}: the file is larger than the limit of {limit_bytes} bytes; cut it or raise "
            "the limit."
        )
    with damage_told(path, "MATLAB file", "save it again with save -v7"):
        content = loadmat(path, struct_as_record=True, squeeze_me=False)
    variables = {name: value for name, value in content.items() if not name.startswith("__")}
    signals, notices = _signals(dict(_flat(variables)), str(path))
    return ArrayTable(str(path), signals, {}, notices, {})


def _flat(values: dict[str, Any], before: str = "", depth: int = 0) -> Iterator[tuple[str, Any]]:
    for name, value in values.items():
        names = getattr(getattr(value, "dtype", None), "names", None)
        if names and getattr(value, "size", 0) == 1 and depth < _MAX_DEPTH:
            record = value.reshape(-1)[0]
            inner = {key: np.asarray(record[key]) for key in names}
            yield from _flat(inner, f"{before}{name}.", depth + 1)
        elif isinstance(value, np.ndarray):
            yield f"{before}{name}", value


def _signals(arrays: dict[str, Any], file: str) -> tuple[dict[str, NDArray[Any]], tuple[str, ...]]:
    """Columns stand upright: a row (1, N) of MATLAB is a column of N numbers."""
    standing, notices = upright(arrays)
    found = {name: value for name, value in standing.items() if is_signal(value)}
    if not found:
        raise DemonstrationError(
            f"{file}: expected arrays of numbers, one row a sample, but it holds none."
        )
    return found, notices


def _refuse_part(path: Path, part: str | None) -> None:
    if part is not None:
        raise DemonstrationError(f"{path}: it is one recording; name it without #{part[:80]}.")
