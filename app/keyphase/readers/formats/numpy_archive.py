"""NumPy archives (`.npz`) with names of somebody else's: their arrays as columns, by a recipe."""

import zipfile
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from keyphase.errors import DemonstrationError
from keyphase.files.reading import DEFAULT_LIMIT_BYTES
from keyphase.notices import Caution
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import UnfitError, damage_told
from keyphase.readers.formats.numeric import is_signal
from keyphase.readers.formats.upright import upright
from keyphase.readers.npz_members import Member, member_of, numbers_of

_SUFFIX = ".npy"
_NATIVE = ("time_s", "position_m")
_MAX_MEMBERS = 10_000
_ALSO = "bUS"
"""Buttons, and words such as what is done at each step."""


def is_foreign_archive(path: Path) -> bool:
    """Whether an archive of arrays has none of the names that a native one needs."""
    try:
        # Opening a pipe would wait, and a list of members can be as large as its file.
        if path.suffix.lower() != ".npz" or not path.is_file():
            return False
        if path.stat().st_size > DEFAULT_LIMIT_BYTES:
            return False
        with zipfile.ZipFile(path) as archive:
            names = archive.namelist()
    except (OSError, ValueError, zipfile.BadZipFile, RecursionError):
        return False
    arrays = {name.removesuffix(_SUFFIX) for name in names if name.endswith(_SUFFIX)}
    return bool(arrays) and arrays.isdisjoint(_NATIVE)


def table_of_npz(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """Every array of numbers in the archive, within the limit; pickled ones are never loaded.

    Raises DemonstrationError for a damaged archive, or one without arrays of numbers.
    """
    if part is not None:
        raise DemonstrationError(f"{path}: it is one recording; name it without #{part[:80]}.")
    with damage_told(path, "NPZ archive"), zipfile.ZipFile(path) as archive:
        members, left_out = _members(archive, str(path))
        unpacked = sum(max(one.bytes_in_memory, one.info.file_size) for one in members.values())
        if unpacked > limit_bytes:
            raise DemonstrationError(
                f"{path}: the archive unpacks to {unpacked} bytes, more than the limit of "
                f"{limit_bytes}; cut the recording or raise the limit."
            )
        arrays = {name: numbers_of(archive, one, str(path)) for name, one in members.items()}
    texts = {name: _words(values) for name, values in arrays.items() if values.dtype.kind in "US"}
    arrays = {name: values for name, values in arrays.items() if name not in texts}
    standing, notices = upright(arrays)
    signals = {name: values for name, values in standing.items() if is_signal(values)}
    if not signals:
        raise DemonstrationError(
            f"{path}: expected arrays of numbers, one row a sample, but it holds none."
        )
    if left_out:
        shown = ", ".join(repr(name[:60]) for name in left_out[:5])
        notices = (*notices, Caution(f"Left out members that hold no plain numbers: {shown}."))
    columns = {name: words for name, words in texts.items() if len(words) > 1}
    return ArrayTable(str(path), signals, columns, notices, {})


def _words(values: NDArray[Any]) -> list[str]:
    """A word for each row; none where it is no such list."""
    if values.ndim != 1:
        return []
    if values.dtype.kind == "S":
        return [word.decode("utf-8", "replace") for word in values.tolist()]
    return values.tolist()


def _members(archive: zipfile.ZipFile, file: str) -> tuple[dict[str, Member], list[str]]:
    """The arrays of numbers by name, and the names of what holds something else."""
    infos = [info for info in archive.infolist() if info.filename.endswith(_SUFFIX)]
    if len(infos) > _MAX_MEMBERS:
        raise UnfitError(f"it has {len(infos)} members, more than a recording does")
    found: dict[str, Member] = {}
    left_out = []
    for info in infos:
        name = info.filename.removesuffix(_SUFFIX)
        try:
            found[name] = member_of(archive, info, name, file, also=_ALSO)
        except DemonstrationError:
            left_out.append(name)
    return found, left_out
