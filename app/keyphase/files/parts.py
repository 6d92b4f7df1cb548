"""A recording inside a file of many is a path with its part: `data.hdf5#demo_3`."""

import hashlib
import os
from pathlib import Path

PART = "#"
"""What stands between a file and the recording in it."""


def split_part(path: Path) -> tuple[Path, str | None]:
    """The file, and which recording in it, or None where the path is the recording itself.

    A file whose own name holds a # is that file.
    """
    if PART not in path.name or os.path.lexists(path):
        return path, None
    name, _, part = path.name.rpartition(PART)
    return (path.with_name(name), part) if name and part else (path, None)


def with_part(file: Path, part: str) -> Path:
    """The path of one recording in a file of many."""
    return file.with_name(f"{file.name}{PART}{part}")


def sha256_of_part(sha256: str, part: str | None) -> str:
    """By what one recording in a file is known, where the file's hash (hex) is that of them all.

    So the segments of one arm are never taken for those of the other.
    """
    return sha256 if part is None else hashlib.sha256(f"{sha256}{PART}{part}".encode()).hexdigest()


def stem_of(path: Path) -> str:
    """A recording's name without the ending of its file: `run.csv` is run, `a.hdf5#b` is a#b."""
    file, part = split_part(path)
    return file.stem if part is None else f"{file.stem}{PART}{part}"
