"""HDF5: robomimic and MimicGen (`data/demo_N/…`), REASSEMBLE, ALOHA, and others by a recipe.

Links to other files, virtual and externally stored data are passed over: a file speaks for itself.
"""

import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.files.bounded_memory import memory_bounded
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import UnfitError, damage_told
from keyphase.readers.formats.numeric import (
    in_natural_order,
    is_signal,
    recordings_among,
    refuse_too_large,
    unknown_part,
)
from keyphase.readers.formats.packages import package
from keyphase.readers.formats.upright import is_lying, stood_up

MAGIC = b"\x89HDF\r\n\x1a\n"
EXTRA = "hdf5"

_EPISODES = "data"
_NAMING = ("columns", "column_names", "names", "labels", "fields", "feature_names")
"""How the attribute is called that names an array's columns."""

MAX_DEPTH = 8
MAX_ARRAYS = 20_000
_MAX_DEFLATED = 1032
"""Deflate packs no better."""
_MIN_ROOM_BYTES = 1024**2


def parts_of_hdf5(path: Path) -> tuple[str, ...]:
    """The demonstrations of a file with many (`data/demo_0`, …), or none where it is one."""
    return _layout(path).parts


def names_in_hdf5(path: Path, part: str | None) -> tuple[str, ...]:
    """What the columns of a demonstration are called, without reading any; none where it is not."""
    layout = _layout(path)
    with opened(path) as file:
        episodes = None if layout.parent is None else file[layout.parent]
        group = file if episodes is None else _group(episodes, part) if part else None
        if group is None:
            return ()
        names = ArrayTable(str(path), dict(_signals(group)), {}, (), {}).names
        timed = episodes is not None and _control_rate(episodes) is not None
        return (*names, "time") if timed else names


def table_of_hdf5(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """The signals of one demonstration, read without the rest of the file.

    Raises DemonstrationError for a file or part that cannot be read, MissingPackageError where
    h5py is not installed.
    """
    shown = str(path) if part is None else f"{path}#{part}"
    layout = _layout(path)
    with opened(path) as file:
        episodes = None if layout.parent is None else file[layout.parent]
        group = file if episodes is None else _group(episodes, part) if part else None
        if group is None or (episodes is None and part is not None):
            raise unknown_part(str(path), part, parts_of_hdf5(path))
        found = dict(_signals(group))
        refuse_too_large(found.values(), shown, limit_bytes)
        refuse_hollow(found)
        arrays = {name: np.asarray(dataset[()]) for name, dataset in found.items()}
        arrays, notices = stood_up(arrays)
        if episodes is not None and (rate := _control_rate(episodes)):
            count = max((len(values) for values in arrays.values()), default=0)
            arrays["time"] = np.arange(count) / rate
            notices = (
                *notices,
                f"Time is counted at the control rate the file states, {rate:g} Hz.",
            )
        names_of = {n: names for n, one in found.items() if (names := column_names(one, arrays[n]))}
    return ArrayTable(shown, arrays, {}, notices, names_of)


@contextmanager
def opened(path: Path) -> Iterator[Any]:
    """The file, for as long as the `with` statement lasts; damage is told in a sentence."""
    h5py = package("h5py", EXTRA, path)
    with damage_told(path, "HDF5 file"), memory_bounded(path), h5py.File(path, "r") as file:
        yield file


@dataclass(frozen=True)
class _Layout:
    """Where the groups that are a recording each lie, and their names.

    It is `data`, the file itself ("/"), or a group right in it; None where the file is one.
    """

    parent: str | None
    parts: tuple[str, ...]


def _layout(path: Path) -> _Layout:
    try:
        status = path.stat()
    except OSError:
        with opened(path) as file:
            return _layout_in(file)
    return _layout_as_of(path, (status.st_ino, status.st_size, status.st_mtime_ns))


@lru_cache(maxsize=8)
def _layout_as_of(path: Path, _stamp: tuple[int, int, int]) -> _Layout:
    """Of a file as it is now: all demonstrations of a file are read one after the other."""
    with opened(path) as file:
        return _layout_in(file)


def _layout_in(file: Any) -> _Layout:
    group = _group(file, _EPISODES)
    if group is not None and len(names := _groups(group)) == len(group):
        return _Layout(_EPISODES, tuple(in_natural_order(names)))
    if names := recordings_among(_groups(file), ""):
        return _Layout("/", names)
    inner = {name: recordings_among(_groups(file[name]), name) for name in _groups(file)}
    whole = [name for name, names in inner.items() if names]
    return _Layout(whole[0], inner[whole[0]]) if len(whole) == 1 else _Layout(None, ())


def _groups(parent: Any) -> list[str]:
    return [name for name in parent if _is_group(parent, name)]


def _group(parent: Any, name: str) -> Any:
    """A group that lies in this file, or None."""
    return parent[name] if name in parent and _is_group(parent, name) else None


def _is_group(parent: Any, name: str) -> bool:
    """Asked of HDF5 itself: through h5py's own objects a thousand demonstrations take long."""
    from h5py import h5g  # pyright: ignore[reportAttributeAccessIssue]

    told = h5g.get_objinfo(parent.id, name.encode(errors="surrogateescape"), follow_link=False)
    return told.type == h5g.GROUP


def _signals(group: Any, before: str = "", depth: int = 0) -> Iterator[tuple[str, Any]]:
    import h5py

    if depth > MAX_DEPTH or len(group) > MAX_ARRAYS:
        raise UnfitError("it is nested deeper, or holds more, than a recording does")
    for name in group:
        if not isinstance(group.get(name, getlink=True), h5py.HardLink):
            continue
        item = group[name]
        if isinstance(item, h5py.Group):
            yield from _signals(item, f"{before}{name}/", depth + 1)
        elif is_own_data(item):
            signals = [("", item)] if item.dtype.names is None else _fields(item)
            yield from (
                (f"{before}{name}{at}", one)
                for at, one in signals
                if is_signal(one) or is_lying(one)
            )


def column_names(dataset: Any, values: NDArray[Any]) -> tuple[str, ...]:
    """The names of the columns of an array (N, D), where it or what lies beside it says them: an
    attribute such as `columns`, or the items of a frame of pandas.
    """
    if values.ndim != 2 or isinstance(dataset, _Field):
        return ()
    told = next((dataset.attrs[key] for key in _NAMING if key in dataset.attrs), None)
    own = str(dataset.name).rpartition("/")[2]
    beside = own.replace("_values", "_items")
    if told is None and own != beside and is_own_data(dataset.parent.get(beside)):
        told = dataset.parent[beside][()]
    if told is None or np.shape(told) != (values.shape[1],):
        return ()
    names = [one.decode(errors="replace") if isinstance(one, bytes) else one for one in told]
    plain = all(isinstance(one, str) and one.isprintable() for one in names)
    return tuple(names) if plain and len(set(names)) == len(names) else ()


def is_own_data(item: Any) -> bool:
    """Whether it is an array whose numbers lie in this file; an empty one has no shape."""
    import h5py

    own = isinstance(item, h5py.Dataset) and not (item.is_virtual or item.external)
    return own and item.shape is not None


class _Field:
    """One column of a table of records, as an array."""

    def __init__(self, records: Any, name: str) -> None:
        self._records, self._name = records, name
        dtype = records.dtype[name]
        self.dtype, self.shape = dtype.base, (*records.shape, *dtype.shape)
        self.id, self.nbytes = records.id, records.nbytes

    def __getitem__(self, _all: Any) -> Any:
        return self._records[self._name]


def _fields(records: Any) -> Iterator[tuple[str, Any]]:
    for name in records.dtype.names:
        yield f"/{name}", _Field(records, name)


def refuse_hollow(found: dict[str, Any]) -> None:
    """A shape that what is stored cannot fill was never recorded, however small the file is."""
    for name, dataset in found.items():
        stored = dataset.id.get_storage_size()
        if dataset.nbytes > _MAX_DEFLATED * stored + _MIN_ROOM_BYTES:
            raise UnfitError(
                f"{name} has shape {dataset.shape}, which its {stored} stored bytes cannot fill"
            )


def _control_rate(episodes: Any) -> float | None:
    """The rate robomimic and MimicGen write beside their demonstrations, in `env_args`."""
    raw = episodes.attrs.get("env_args")
    try:
        rate = json.loads(raw)["env_kwargs"]["control_freq"] if raw is not None else None
    except (ValueError, KeyError, TypeError, RecursionError):
        return None
    if not isinstance(rate, int | float) or isinstance(rate, bool) or not 0 < rate < 1e6:
        return None
    return float(rate)
