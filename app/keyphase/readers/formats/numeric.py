"""Which arrays of a file are signals of a recording: numbers, one row a sample, no images."""

import re
from collections.abc import Iterable
from math import prod
from typing import Protocol

import numpy as np

from keyphase.errors import DemonstrationError

MAX_NUMBERS_A_ROW = 512
"""Signals have fewer; what has more in a row is an image or a point cloud."""

_WORD = r"(episode|ep|demo|demonstration|trial|run|traj|trajectory|take|recording|rollout|sequence"
_WORD += r"|sample|repetition|rep|session)"
_NUMBERED = re.compile(rf"{_WORD}[\s_-]?\d+", re.I)
_GATHERED = re.compile(rf"{_WORD}s|data|trajectories", re.I)
_ASIDE = re.compile(r"mask|meta|metadata|info|config|attributes|splits?|stats", re.I)

_DIGITS = re.compile(r"(\d+)")


class Arraylike(Protocol):
    """What h5py and zarr say of an array before any of it is read."""

    @property
    def shape(self) -> tuple[int, ...]: ...  # noqa: D102
    @property
    def dtype(self) -> np.dtype: ...  # noqa: D102


def is_signal(array: Arraylike) -> bool:
    """Whether it holds numbers, at least two rows of at most MAX_NUMBERS_A_ROW each."""
    if array.dtype.kind not in "fiub" or not array.shape or array.shape[0] < 2:
        return False
    return len(array.shape) < 4 and prod(array.shape[1:]) <= MAX_NUMBERS_A_ROW


def refuse_too_large(arrays: Iterable[Arraylike], file: str, limit_bytes: int) -> None:
    """Refuse before reading what would take more memory than the limit, counted as floats."""
    size = sum(8 * prod(array.shape) for array in arrays)
    if size > limit_bytes:
        raise DemonstrationError(
            f"{file}: the recording takes {size} bytes of memory, more than the limit of "
            f"{limit_bytes}; cut it or raise the limit."
        )


def recordings_among(groups: Iterable[str], parent: str) -> tuple[str, ...]:
    """The groups of a group `parent` that are a recording each by their names, in natural order;
    none where some other group stands beside them that says more than what they are.
    """
    wanted = [name for name in groups if not _ASIDE.fullmatch(name)]
    gathered = _GATHERED.fullmatch(parent) is not None
    if all(_NUMBERED.fullmatch(one) or (gathered and one.isdigit()) for one in wanted):
        return tuple(in_natural_order(wanted))
    return ()


def in_natural_order(names: Iterable[str]) -> list[str]:
    """demo_2 before demo_10."""

    def key(name: str) -> list[tuple[int, int, str]]:
        pieces = _DIGITS.split(name)
        return [(0, int(p), "") if p.isdecimal() else (1, 0, p) for p in pieces if p]

    return sorted(names, key=key)


def unknown_part(file: str, part: str | None, parts: Iterable[str]) -> DemonstrationError:
    """The refusal of a recording that is not in the file, with those that are."""
    there = list(parts)
    shown = ", ".join(there[:5]) + (f", … ({len(there)} in all)" if len(there) > 5 else "")
    asked = "none was named" if part is None else f"there is no {part[:80]!r}"
    example = f"{file}#{there[0]}" if there else file
    return DemonstrationError(
        f"{file}: expected one of the recordings in it, {shown or 'but it holds none'}; {asked}; "
        f"name it as {example}."
    )
