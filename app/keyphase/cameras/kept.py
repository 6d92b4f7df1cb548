"""Videos that were made from something else, kept with the user's other caches."""

import hashlib
import os
from collections.abc import Callable
from pathlib import Path

from platformdirs import user_cache_path

from keyphase.errors import CameraError

MOST_KEPT_BYTES = 20 * 1024**3


class Kept:
    """A folder of made videos; the ones that were used longest ago go when it grows too large."""

    def __init__(self, folder: Path | None = None) -> None:
        self._folder = folder or user_cache_path("keyphase", appauthor=False) / "videos"

    def made(self, source: Path, what: str, make: Callable[[Path], None]) -> Path:
        """The video that `make` writes of `what` in `source`, written once for as long as both are.

        Raises CameraError where it cannot be written.
        """
        try:
            about = os.stat(source)
            key = f"{os.path.abspath(source)}\0{about.st_mtime_ns}\0{about.st_size}\0{what}"
            digest = hashlib.sha256(key.encode("utf-8", "surrogateescape")).hexdigest()[:32]
            file = self._folder / f"{digest}.mp4"
            if file.is_file():
                os.utime(file)
                return file
            self._folder.mkdir(parents=True, exist_ok=True, mode=0o700)
            part = self._folder / f"{digest}.{os.getpid()}.part"
            try:
                make(part)
                os.replace(part, file)
            finally:
                part.unlink(missing_ok=True)
            self._tidy(file)
        except OSError as error:
            raise CameraError(
                f"{source}: its video cannot be kept in {self._folder} ({error.strerror}); make "
                "room there, or name another folder with XDG_CACHE_HOME."
            ) from error
        return file

    def _tidy(self, newest: Path) -> None:
        files = sorted(self._folder.glob("*.mp4"), key=lambda one: one.stat().st_mtime)
        sizes = {one: one.stat().st_size for one in files}
        while sum(sizes.values()) > MOST_KEPT_BYTES and files[0] != newest:
            oldest = files.pop(0)
            del sizes[oldest]
            oldest.unlink(missing_ok=True)
