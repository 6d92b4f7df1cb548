"""Files that are about to be replaced, kept as they were under a name of their own."""

import contextlib
import os
import shutil
from pathlib import Path

from keyphase.errors import JournalError


def keep_as_old(path: Path) -> Path | None:
    """Keep what is at a path as `.old-1`, `.old-2`, … too; None where nothing is there.

    A file stays where it is until another takes its place, so no crash leaves nothing there;
    what is no file gives way. Raises JournalError where it cannot be kept.
    """
    if not os.path.lexists(path):
        return None
    names = (path.with_suffix(f".old-{i}") for i in range(1, 1_000_000))
    old = next(name for name in names if not os.path.lexists(name))
    try:
        if path.is_file() and not path.is_symlink():
            _link_or_copy(path, old)
        else:
            path.rename(old)
    except OSError as error:
        raise JournalError(
            f"{path}: a copy must be kept before it is replaced, but that is refused "
            f"({error.strerror}); make room or check the folder."
        ) from error
    return old


def put_back(old: Path, path: Path) -> None:
    """Undo `keep_as_old` where nothing took the place of what was kept."""
    with contextlib.suppress(OSError):
        if os.path.lexists(path):
            old.unlink()
        else:
            old.rename(path)


def _link_or_copy(path: Path, old: Path) -> None:
    try:
        os.link(path, old)
    except OSError:
        shutil.copy2(path, old)
