"""MATLAB files (`.mat`, up to version 7.2) and single NumPy arrays (`.npy`), never unpickled."""

import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from keyphase.errors import DemonstrationError
from keyphase.files.reading import DEFAULT_LIMIT_BYTES
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import UnfitError, damage_told
from keyphase.readers.formats.numeric import is_signal, refuse_too_large, unknown_part
from keyphase.readers.formats.upright import upright
from keyphase.readers.mat_elements import plain_variables

NPY_MAGIC = b"\x93NUMPY"
MAT_MAGIC = b"MATLAB 5.0 MAT-file"

_MAX_DEPTH = 6
_MAX_RECORDINGS = 10_000
_AGAIN = "save it again with save -v7"


def table_of_npy(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """One array (N, D) as the columns `array[0]`, …, or a structured one by its fields.

    Raises DemonstrationError for what is no whole array of numbers.
    """
    _refuse_part(path, part)
    with damage_told(path, "array", "save it again with numpy.save"):
        _refuse_pickled(path)
        mapped = np.load(path, mmap_mode="r", allow_pickle=False)
        if not isinstance(mapped, np.ndarray):
            raise UnfitError("it holds no array")
        refuse_too_large([mapped], str(path), limit_bytes)
        array = np.array(mapped)
    named = {name: array[name] for name in array.dtype.names or ()} or {"array": array}
    signals, notices = _signals(named, str(path))
    return ArrayTable(str(path), signals, {}, notices, {})


def _refuse_pickled(path: Path) -> None:
    with path.open("rb") as stream:
        version = npy.read_magic(stream)
        reading = npy.read_array_header_1_0 if version == (1, 0) else npy.read_array_header_2_0
        shape, _, dtype = reading(stream) if version in ((1, 0), (2, 0)) else ((), False, None)
    if dtype is not None and dtype.hasobject:
        # A whole dictionary, or a record for each step.
        arrays = "a.item()" if shape == () else "{k: [one[k] for one in a] for k in a[0]}"
        raise DemonstrationError(
            f"{path}: it holds pickled Python objects, which can run programs and are never "
            "loaded; load it where you trust it, a = numpy.load('run.npy', allow_pickle=True), and "
            f"save its arrays: numpy.savez('run.npz', **{arrays})."
        )


def parts_of_mat(path: Path) -> tuple[str, ...]:
    """The recordings of a cell or struct array of records, `demos_1`, …; none where it is one.

    Raises DemonstrationError for what cannot be read.
    """
    return tuple(_recordings(_content(path, DEFAULT_LIMIT_BYTES)))


def table_of_mat(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """The variables of a MATLAB file; fields of a struct are `struct.field`. Where a list of as
    many words as an array has columns stands in the file, they are called so.

    Raises DemonstrationError for what cannot be read.
    """
    content = _content(path, limit_bytes)
    recordings = _recordings(content)
    if (part is None) == bool(recordings) or (part is not None and part not in recordings):
        raise unknown_part(str(path), part, recordings)
    variables = dict(_flat(content if part is None else recordings[part]))
    signals, notices = _signals(variables, str(path))
    lists = [words for value in variables.values() if (words := _words(value))]
    names_of = {
        name: words
        for name, values in signals.items()
        for words in lists
        if values.ndim == 2 and len(words) == values.shape[1]
    }
    return ArrayTable(str(path), signals, {}, notices, names_of)


def _content(path: Path, limit_bytes: int) -> dict[str, Any]:
    from scipy.io import loadmat

    if path.stat().st_size > limit_bytes:
        raise DemonstrationError(
            f"{path}: the file is larger than the limit of {limit_bytes} bytes; cut it or raise "
            "the limit."
        )
    with damage_told(path, "MATLAB file", _AGAIN):
        data = path.read_bytes()
        names = plain_variables(data, limit_bytes)
        content = loadmat(
            io.BytesIO(data), struct_as_record=True, squeeze_me=False, variable_names=names
        )
    return {name: value for name, value in content.items() if not name.startswith("__")}


def _recordings(content: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """Each record with signals of the first cell or struct array that has several."""
    for name, value in content.items():
        records = [_record(one) for one in np.ravel(value)] if _is_list(value) else []
        if records and all(any(is_signal(v) for _, v in _flat(one)) for one in records):
            return {f"{name}_{i}": one for i, one in enumerate(records, start=1)}
    return {}


def _is_list(value: Any) -> bool:
    several = isinstance(value, np.ndarray) and 1 < value.size <= _MAX_RECORDINGS
    return several and value.dtype.kind in "OV"


def _record(value: Any) -> dict[str, Any]:
    """The fields of a struct, alone or in a cell; none where it is something else."""
    if isinstance(value, np.ndarray) and value.size == 1:
        value = value.reshape(-1)[0]
    names = getattr(getattr(value, "dtype", None), "names", None) or ()
    return {name: np.asarray(value[name]) for name in names}


def _words(value: Any) -> tuple[str, ...]:
    """A list of words that differ, in cells or as rows of letters."""
    if not isinstance(value, np.ndarray) or value.dtype.kind not in "OU" or value.size < 2:
        return ()
    cells = [np.ravel(one) for one in np.ravel(value)]
    if any(len(cell) != 1 or not isinstance(cell[0], str) for cell in cells):
        return ()
    words = tuple(str(cell[0]).strip() for cell in cells)
    return words if len(set(words)) == len(words) and all(map(str.isprintable, words)) else ()


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
