"""Files written into people's folders: what keyphase did not write is not replaced unasked.

Beside the journals of a folder lies a list of what was written there, a line for each file with its
hash and the recording it was made from. What is not in it, or is not as it was written, is somebody
else's.
"""

import contextlib
import hashlib
import itertools
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

from keyphase.errors import FileInTheWayError, JournalError, KeyphaseError
from keyphase.files.reading import read_regular
from keyphase.files.writing import write_new, write_whole
from keyphase.labeling.storage.records import decode, encode
from keyphase.labeling.storage.state_folder import state_folder

NAME = "written"

IfThere = Literal["ask", "replace", "keep both"]
"""What becomes of a file in the way that keyphase did not write as it is: FileInTheWayError is
raised, or it is replaced, or the new one gets another name."""

_LIMIT_BYTES = 64 * 1024**2
_LARGEST_BYTES = 4 * 1024**3


def write_unasked(
    path: Path,
    data: bytes,
    made_from: str,
    refusal: type[KeyphaseError] = KeyphaseError,
    *,
    if_there: IfThere = "ask",
    ending: str = "",
) -> Path:
    """Put `data` at `path` unless somebody else's file would be lost by it; where it now is.

    `made_from` names the recording it was made from. What was written there for the same recording,
    and is as it was, is replaced. `ending` is what stays of the name where both are kept:
    `a.segments.json` becomes `a_2.segments.json`. Raises FileInTheWayError, and `refusal` where
    the folder takes no files.
    """
    path = (
        _free(path, ending) if if_there == "keep both" and _whose(path, data, made_from) else path
    )
    whose = None if if_there == "replace" else _whose(path, data, made_from)
    if whose is not None:
        raise FileInTheWayError(path, whose)
    if os.path.lexists(os.path.realpath(path)):
        write_whole(path, data, refusal)
    else:
        _write_new(path, data, refusal)
    _remember(path, data, made_from)
    return path


def require_free(path: Path, made_from: str) -> None:
    """Raise FileInTheWayError where `write_unasked` would, whatever it were given to write."""
    whose = _whose(path, None, made_from)
    if whose is not None:
        raise FileInTheWayError(path, whose)


def _write_new(path: Path, data: bytes, refusal: type[KeyphaseError]) -> None:
    try:
        write_new(path, data, refusal)
    except FileExistsError as error:
        raise FileInTheWayError(path, "it appeared this moment") from error


def _whose(path: Path, data: bytes | None, made_from: str) -> str | None:
    """Why what is there is not to be replaced unasked; None where nothing would be lost."""
    target = Path(os.path.realpath(path))
    if not os.path.lexists(target):
        return None
    there = _hash_of(target)
    if there is None or (data is not None and there == _hash(data)):
        # What is no file is refused by whoever writes; what is the same already is not lost.
        return None
    written = _lines(path.parent, path.name)
    if any(line["sha256"] == there and line["made_from"] == made_from for line in written):
        return None
    of_others = [line["made_from"] for line in written if line["sha256"] == there]
    if of_others:
        return f"keyphase wrote it for {of_others[-1]}"
    return "it was changed since keyphase wrote it" if written else "keyphase did not write it"


def _lines(folder: Path, name: str) -> list[dict[str, str]]:
    """What is known of files of that name."""
    found = []
    for file in state_folder(folder, create=False).both(NAME):
        with contextlib.suppress(OSError):
            for record in decode(read_regular(file, _LIMIT_BYTES)).records:
                line = {k: str(record.get(k)) for k in ("name", "sha256", "made_from")}
                if line["name"] == name:
                    found.append(line)
    return found


def _remember(path: Path, data: bytes, made_from: str) -> None:
    """A list that cannot be written costs a question later, not the file."""
    line = encode({"name": path.name, "sha256": _hash(data), "made_from": made_from})
    # A line that a kill cut off must not spoil the next.
    line = b"\n" + line
    with contextlib.suppress(JournalError, OSError):
        file = state_folder(path.parent).path / NAME
        descriptor = os.open(file, os.O_WRONLY | os.O_APPEND | os.O_CREAT | os.O_CLOEXEC, 0o644)
        try:
            os.write(descriptor, line)
        finally:
            os.close(descriptor)


def _free(path: Path, ending: str) -> Path:
    return next(name for name in _names(path, ending) if not os.path.lexists(name))


def _names(path: Path, ending: str) -> Iterator[Path]:
    ending = ending if ending and path.name.endswith(ending) else path.suffix
    stem = path.name.removesuffix(ending)
    return (path.with_name(f"{stem}_{number}{ending}") for number in itertools.count(2))


def _hash_of(path: Path) -> str | None:
    try:
        with path.open("rb") as file:
            if os.fstat(file.fileno()).st_size > _LARGEST_BYTES:
                return ""
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError:
        return None


def _hash(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()
