"""Files written whole: beside, synced and renamed, so that nothing is ever half there."""

import os
import secrets
import stat
from pathlib import Path

from keyphase.errors import KeyphaseError

TEMPORARY = ".keyphase-"
"""How the names of files begin that are being written; a kill leaves them behind."""


def write_whole(path: Path, data: bytes, refusal: type[KeyphaseError] = KeyphaseError) -> None:
    """Put `data` at `path` so that a crash leaves either the old file or the new one.

    A link is followed, and a file that is there keeps its mode. Raises `refusal` where the folder
    takes no files, or something that is no file is in the way.
    """
    try:
        _replace(Path(os.path.realpath(path)), data)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise refusal(
            f"{path}: the file cannot be written ({reason}); check the folder."
        ) from error


def _replace(path: Path, data: bytes) -> None:
    mode = _mode(path)
    temporary = path.with_name(f"{TEMPORARY}{secrets.token_hex(8)}")
    try:
        with temporary.open("xb") as file:
            if mode is not None:
                os.fchmod(file.fileno(), mode)
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    sync_folder(path.parent)


def _mode(path: Path) -> int | None:
    """The mode of the file that is replaced; None where there is none."""
    try:
        status = os.stat(path)
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(status.st_mode):
        raise OSError(22, "something that is no file is in the way")
    return stat.S_IMODE(status.st_mode)


def sync_folder(folder: Path) -> None:
    """Make a rename or a new name in a folder durable."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
