"""Files that only their owner can read: what is in them opens the page."""

import os
import secrets
import stat
from pathlib import Path


def private_folder(path: Path) -> Path:
    """Make `path` a folder that nobody else can look into.

    Raises OSError where it is not ours, or cannot be made so.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    path.mkdir(mode=0o700, exist_ok=True)
    found = path.lstat()
    if not stat.S_ISDIR(found.st_mode) or found.st_uid != os.geteuid():
        raise PermissionError(f"{path} is not a folder of this user.")
    if found.st_mode & 0o077:
        path.chmod(0o700)
    return path


def write_private(path: Path, data: bytes) -> None:
    """Put `data` at `path`, whole, readable by its owner only from the first byte on."""
    temporary = path.with_name(f".{secrets.token_hex(8)}")
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW
    descriptor = os.open(temporary, flags, 0o600)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        temporary.replace(path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def read_private(path: Path, most_bytes: int = 1 << 16) -> bytes | None:
    """What is in `path`; None where it is missing, not ours, or others could have read it."""
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    except OSError:
        return None
    with os.fdopen(descriptor, "rb") as file:
        found = os.fstat(file.fileno())
        is_private = stat.S_ISREG(found.st_mode) and not found.st_mode & 0o077
        if not is_private or found.st_uid != os.geteuid() or found.st_size > most_bytes:
            return None
        return file.read(most_bytes)
