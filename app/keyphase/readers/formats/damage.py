"""What a format's library raises over bytes that are not what they should be, as one refusal.

A library speaks of its own parts, in words that change with its version. What a person is told is
what can be seen of the file; the library's error stays the cause of ours.
"""

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path

from keyphase.errors import DemonstrationError, KeyphaseError
from keyphase.files.reading import first_bytes

_ENDS = (
    (b"\x89MCAP0\r\n", b"\x89MCAP0\r\n", "; `mcap recover` saves what is in it"),
    (b"PAR1", b"PAR1", ""),
)
"""How files of a kind begin and end, and what mends one without an end."""

_POINTER = b"version https://git-lfs.github.com"
_NOT_FETCHED = "only what stands for it is there: git lfs pull brings it"

_CUT = "its end is missing, as after a recording or a copy that was broken off"
_CHANGED = "what it says of its own parts does not fit together: bytes were changed or lost"

_WORDS = (
    (
        ("plugin", "required filter", "codec not available", "unsupported compression"),
        "it is packed in a way that is unknown here; gzip is known, for one",
    ),
    (("password", "encrypted"), "it is locked with a password"),
    (("lock file", "already open"), "another program has it open for writing"),
    (("unindexed", "not indexed", "index looks damaged"), f"{_CUT}; `rosbag reindex` mends that"),
    (("truncated", "not a zip file", "eof", "end of file", "read enough", "too small"), _CUT),
    (("no messages", "nothing to read"), "there is nothing in it"),
)
"""What libraries say, in lower case, and what of it a person can act on."""

_LEAST, _MOST_LOOKED_AT = 12, 2000


class UnfitError(ValueError):
    """What keyphase itself finds in a file that cannot be, in words for people."""


@contextmanager
def damage_told(path: Path, kind: str, advice: str = "copy or export it again") -> Iterator[None]:
    """Turn whatever is raised within into a DemonstrationError that names the file in one line.

    A library raises whatever the bytes lead it to; none of it is a defect of keyphase.
    """
    try:
        yield
    except (KeyphaseError, ImportError):
        raise
    except Exception as error:
        reason = what_is_wrong(path, error)
        raise DemonstrationError(
            f"{path}: expected a whole {kind}, but it cannot be read ({reason}); {advice}."
        ) from error


def what_is_wrong(path: Path, error: Exception) -> str:
    """What can be said of a file over which an error was raised."""
    if isinstance(error, UnfitError):
        return str(error)
    if isinstance(error, MemoryError):
        return "it asks for far more memory than a file of its size needs"
    if isinstance(error, RecursionError):
        return "it is nested too deeply"
    if (cut := _without_end(path)) is not None:
        return cut
    said = str(error).lower()
    for marks, words in _WORDS:
        if any(mark in said for mark in marks):
            return words
    if isinstance(error, OSError) and error.errno is not None and error.errno in errno.errorcode:
        return os.strerror(error.errno)
    if isinstance(error, EOFError):
        return _CUT
    return "a text in it is not in UTF-8" if isinstance(error, UnicodeError) else _CHANGED


def _without_end(path: Path) -> str | None:
    """That a file, or one of a folder, does not end as all of its kind do, or was not fetched."""
    try:
        if not path.is_dir():
            return _missing_end(path)
        inside = (one for one in sorted(path.rglob("*")) if one.suffix in (".mcap", ".parquet"))
        for one in islice(inside, _MOST_LOOKED_AT):
            if (cut := _missing_end(one)) is not None:
                return f"of {one.relative_to(path)} {cut}"
    except (OSError, ValueError):
        pass
    return None


def _missing_end(file: Path) -> str | None:
    head, size = first_bytes(file, len(_POINTER)), file.stat().st_size
    if head == _POINTER:
        return _NOT_FETCHED
    with file.open("rb") as opened:
        opened.seek(-min(16, size), 2)
        tail = opened.read()
    for begins, ends, mending in _ENDS:
        if head.startswith(begins) and (not tail.endswith(ends) or size < _LEAST):
            return f"{_CUT}{mending}"
    return None
