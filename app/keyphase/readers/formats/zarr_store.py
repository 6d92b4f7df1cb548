"""Zarr: the replay buffers of Diffusion Policy, UMI, RDP and ManipForce.

`data/*` holds all episodes one after the other, `meta/episode_ends` where each ends. Streams at
other rates have ends of their own, `meta/episode_NAME_ends` for the arrays that begin with NAME.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import UnfitError, damage_told
from keyphase.readers.formats.numeric import (
    is_signal,
    recordings_among,
    refuse_too_large,
    unknown_part,
)
from keyphase.readers.formats.packages import package
from keyphase.readers.formats.zarr_files import folder_store, zip_store

EXTRA = "zarr"
SUFFIXES = (".zarr", ".zarr.zip")
MARKS = (".zgroup", "zarr.json")

_ENDS = "episode_ends"
_MAX_EPISODES = 10_000_000
_MAX_DEPTH = 4


def is_zarr(path: Path) -> bool:
    """Whether a folder, or a zip file by its name, is a Zarr store."""
    if path.is_dir():
        return any((path / mark).is_file() for mark in MARKS)
    return path.name.lower().endswith(SUFFIXES[1]) and path.is_file()


def parts_of_zarr(path: Path) -> tuple[str, ...]:
    """episode_0, episode_1, …, or the groups that are a recording each; none where it is one."""
    with _opened(path) as store:
        ends = _ends(store, _ENDS)
        if ends is not None:
            return tuple(f"episode_{i}" for i in range(len(ends)))
        return _groups(store)[1]


def names_in_zarr(path: Path, part: str | None) -> tuple[str, ...]:
    """What the columns of an episode are called, without reading any; none where it is not."""
    with _opened(path) as store:
        group, names = _groups(store)
        if names and part not in names:
            return ()
        data = group[part] if names else store.get("data", store)
        found = {name: array for name, array in _arrays(data) if is_signal(array)}
        return ArrayTable(str(path), found, {}, (), {}).names


def table_of_zarr(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """The signals of one episode, of which only the chunks that hold it are read.

    Raises DemonstrationError for a store or part that cannot be read, MissingPackageError where
    zarr is not installed.
    """
    shown = str(path) if part is None else f"{path}#{part}"
    with _opened(path) as store:
        ends = _ends(store, _ENDS)
        group, names = (store, ()) if ends is not None else _groups(store)
        number = _number(part, 0 if ends is None else len(ends))
        known = part in names if names else (ends is None) == (part is None)
        if not known or (ends is not None and number is None):
            raise unknown_part(str(path), part, parts_of_zarr(path))
        data = group[part] if names else store.get("data", store)
        found = {name: array for name, array in _arrays(data) if is_signal(array)}
        spans = {name: _span(store, name, array, number) for name, array in found.items()}
        wanted = [_Rows(spans[n], a.shape[1:], a.dtype) for n, a in found.items()]
        refuse_too_large(wanted, shown, limit_bytes)
        arrays = {name: np.asarray(array[slice(*spans[name])]) for name, array in found.items()}
    return ArrayTable(shown, arrays, {}, (), {})


def _groups(store: Any) -> tuple[Any, tuple[str, ...]]:
    """The group whose groups are a recording each (the store or `data`), with their names."""
    for group, name in ((store, ""), (store.get("data"), "data")):
        inner = [] if not hasattr(group, "groups") else [key for key, _ in group.groups()]
        if names := recordings_among(inner, name):
            return group, names
    return store, ()


def _arrays(group: Any, before: str = "", depth: int = 0) -> Iterator[tuple[str, Any]]:
    yield from ((f"{before}{name}", array) for name, array in group.arrays())
    if depth < _MAX_DEPTH:
        for name, inner in group.groups():
            yield from _arrays(inner, f"{before}{name}/", depth + 1)


class _Rows:
    """The rows of an array that are wanted, as large as they will be."""

    def __init__(self, span: tuple[int, int], row: tuple[int, ...], dtype: np.dtype) -> None:
        self.shape = (span[1] - span[0], *row)
        self.dtype = dtype


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    zarr = package("zarr", EXTRA, path)
    with damage_told(path, "Zarr store"):
        if path.is_dir():
            yield zarr.open_group(folder_store(path), mode="r")
        else:
            with zip_store(path) as store:
                yield zarr.open_group(store, mode="r")


def _ends(store: Any, name: str) -> NDArray[np.int64] | None:
    key = f"meta/{name}"
    if key not in store:
        return None
    array = store[key]
    if len(array.shape) != 1 or array.shape[0] > _MAX_EPISODES or array.dtype.kind not in "iu":
        raise UnfitError(f"{key} must be a list of whole numbers")
    ends = np.asarray(array[:]).astype(np.int64)
    if (np.diff(ends, prepend=0) < 0).any():
        raise UnfitError(f"{key} must not decrease")
    return ends


def _number(part: str | None, count: int) -> int | None:
    digits = (part or "").removeprefix("episode_")
    if not digits.isdecimal() or len(digits) > 9 or int(digits) >= count:
        return None
    return int(digits)


def _span(store: Any, name: str, array: Any, number: int | None) -> tuple[int, int]:
    """First row and the one after the last of an episode in an array, by its stream's ends."""
    if number is None:
        return 0, array.shape[0]
    own = _ends(store, f"episode_{name.partition('_')[0]}_ends")
    ends = _ends(store, _ENDS) if own is None else own
    if ends is None or number >= len(ends) or ends[-1] > array.shape[0]:
        raise UnfitError(f"{name} has {array.shape[0]} rows, which its episodes' ends do not fit")
    return (int(ends[number - 1]) if number else 0), int(ends[number])
