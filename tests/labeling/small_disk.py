"""A disk that really is full, or really can no longer be written: a small one of its own.

Where none can be mounted, a limit of the system on the size of files takes its place.
"""

import contextlib
import os
import resource
import subprocess
from collections.abc import Iterator
from pathlib import Path

_SIZE_KB = 256


class SmallDisk:
    """A folder with little room; `is_mounted` says whether it is a disk of its own."""

    def __init__(self, path: Path, is_mounted: bool) -> None:
        self.path, self.is_mounted = path, is_mounted

    @contextlib.contextmanager
    def full(self) -> Iterator[None]:
        """Without any room."""
        if not self.is_mounted:
            soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
            resource.setrlimit(resource.RLIMIT_FSIZE, (0, hard))
            yield
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
            return
        filler = self.path / "filler"
        with contextlib.suppress(OSError), filler.open("wb", buffering=0) as file:
            while True:
                file.write(bytes(1024))
        yield
        filler.unlink()

    @contextlib.contextmanager
    def read_only(self) -> Iterator[bool]:
        """As after an error of the disk: nothing new can be made there; whether that is so."""
        where = str(self.path)
        if self.is_mounted:
            _mount("--bind", where, where)
            _mount("-o", "remount,ro,bind", where)
        else:
            self.path.chmod(0o555)
        try:
            yield not os.access(self.path, os.W_OK)
        finally:
            if self.is_mounted:
                subprocess.run(["umount", where], check=True)
            self.path.chmod(0o755)


@contextlib.contextmanager
def small_disk(path: Path) -> Iterator[SmallDisk]:
    """A small disk at a folder, made there."""
    path.mkdir()
    options = ("-t", "tmpfs", "-o", f"size={_SIZE_KB}k", "tmpfs")
    mounted = os.geteuid() == 0 and _mount(*options, str(path))
    try:
        yield SmallDisk(path, mounted)
    finally:
        if mounted:
            subprocess.run(["umount", "-l", str(path)], check=True)


def _mount(*arguments: str) -> bool:
    done = subprocess.run(["mount", *arguments], capture_output=True, check=False)
    return done.returncode == 0
