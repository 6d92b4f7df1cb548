"""Files written whole: beside, synced and renamed, so that nothing is ever half there."""

import os
import secrets
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from keyphase.errors import KeyphaseError

TEMPORARY = ".keyphase-"
"""How the names of files begin that are being written; a kill leaves them behind."""


def write_whole(path: Path, data: bytes, refusal: type[KeyphaseError] = KeyphaseError) -> None:
    """Put `data` at `path` so that a crash leaves either the old file or the new one.

    A link is followed, and a file that is there keeps its mode and, where that is allowed, its
    owner. Raises `refusal` where the folder takes no files, or something that is no file is in the
    way.
    """
    target = Path(os.path.realpath(path))
    try:
        before = _status(target)
        with _beside(target, data, before) as temporary:
            temporary.replace(target)
        sync_folder(target.parent)
    except (OSError, ValueError) as error:
        raise _refused(path, error, refusal) from error


def write_new(path: Path, data: bytes, refusal: type[KeyphaseError] = KeyphaseError) -> None:
    """Put `data` at `path`, where nothing is yet, likewise; a link to nothing is followed.

    Raises FileExistsError where something is there by now, whoever put it there.
    """
    target = Path(os.path.realpath(path))
    try:
        with _beside(target, data, None) as temporary:
            _claim(temporary, target)
        sync_folder(target.parent)
    except FileExistsError:
        raise
    except (OSError, ValueError) as error:
        raise _refused(path, error, refusal) from error


def require_writable(path: Path, refusal: type[KeyphaseError] = KeyphaseError) -> None:
    """Before long work: raise `refusal` where the folder of `path` takes no files."""
    target = Path(os.path.realpath(path))
    try:
        with _beside(target, b"", None):
            pass
    except (OSError, ValueError) as error:
        raise _refused(path, error, refusal) from error


def _claim(temporary: Path, target: Path) -> None:
    try:
        os.link(temporary, target)
    except FileExistsError:
        raise
    except OSError:
        # A file system without hard links: the name is claimed first, then filled.
        target.open("xb").close()
        temporary.replace(target)


@contextmanager
def _beside(path: Path, data: bytes, like: os.stat_result | None) -> Iterator[Path]:
    """The data in a file beside `path`, on disk, with the mode and owner of `like`."""
    temporary = path.with_name(f"{TEMPORARY}{secrets.token_hex(8)}")
    try:
        with temporary.open("xb") as file:
            if like is not None:
                with suppress(OSError):
                    os.fchown(file.fileno(), like.st_uid, like.st_gid)
                os.fchmod(file.fileno(), stat.S_IMODE(like.st_mode))
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        yield temporary
    finally:
        temporary.unlink(missing_ok=True)


def _refused(
    path: Path, error: OSError | ValueError, refusal: type[KeyphaseError]
) -> KeyphaseError:
    reason = error.strerror if isinstance(error, OSError) else str(error)
    return refusal(f"{path}: the file cannot be written ({reason}); check the folder.")


def _status(path: Path) -> os.stat_result | None:
    """The file that is replaced; None where there is none."""
    try:
        status = os.stat(path)
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(status.st_mode):
        raise OSError(22, "something that is no file is in the way")
    return status


def sync_folder(folder: Path) -> None:
    """Make a rename or a new name in a folder durable."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
