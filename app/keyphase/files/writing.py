"""Files written whole: beside, synced and renamed, so that nothing is ever half there."""

import os
import secrets
from pathlib import Path

from keyphase.errors import KeyphaseError


def write_whole(path: Path, data: bytes, refusal: type[KeyphaseError] = KeyphaseError) -> None:
    """Put `data` at `path` so that a crash leaves either the old file or the new one.

    Raises `refusal` where the folder takes no files.
    """
    try:
        _replace(path, data)
    except OSError as error:
        raise refusal(
            f"{path}: the file cannot be written ({error.strerror}); check the folder."
        ) from error


def _replace(path: Path, data: bytes) -> None:
    temporary = path.with_name(f".keyphase-{secrets.token_hex(8)}")
    try:
        with temporary.open("xb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    _sync_folder(path.parent)


def _sync_folder(folder: Path) -> None:
    """Make the rename itself durable; only POSIX systems can open a folder."""
    if os.name != "posix":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
