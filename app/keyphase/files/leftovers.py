"""What a kill leaves behind: files that were being written when it came."""

import os
import re
import time
from pathlib import Path

from keyphase.files.writing import TEMPORARY

UPLOADED = ".upload-"
"""How the names of files begin that a page is sending."""

_NAMES = re.compile(
    rf"{re.escape(TEMPORARY)}[0-9a-f]{{16}}|{re.escape(UPLOADED)}[a-z0-9_]{{8}}|\.probe-[0-9]+"
)
"""Only names that keyphase makes, so that nobody else's file is taken for a left-over."""

OLD_S = 60.0
"""A file that was not written to for so long is being written by nobody."""


def remove_leftovers(folder: Path) -> tuple[Path, ...]:
    """Remove what kills left in a folder; the files that were there.

    Only files under keyphase's own temporary names that nobody has written to for a minute. A
    folder that cannot be read or written has none.
    """
    removed: list[Path] = []
    before = time.time() - OLD_S
    try:
        entries = [entry for entry in os.scandir(folder) if _NAMES.fullmatch(entry.name)]
    except OSError:
        return ()
    for entry in entries:
        try:
            if entry.is_file(follow_symlinks=False) and entry.stat().st_mtime < before:
                os.unlink(entry.path)
                removed.append(Path(entry.path))
        except OSError:
            continue
    return tuple(removed)
