"""Which kind of video a file is, by its first bytes, and what is in it."""

import os
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

from keyphase.errors import CameraError
from keyphase.files.reading import first_bytes
from keyphase.readers.formats.damage import what_is_wrong
from keyphase.readers.formats.packages import package

EXTRA = "video"
LONGEST_HEAD = 12
MAX_FILE_BYTES = 256 * 1024**3

PLAYED = ("h264", "av1", "vp8", "vp9")
"""What every browser keyphase is tried in plays."""

_DEMUXERS = {"video/mp4": "mp4", "video/webm": "webm"}
MOST_INDEX_BYTES = 512 * 1024**2
"""So much of a file is read to learn what is in it; an index of ten hours takes a tenth of it."""

_MOST_PIXELS = 64_000_000
_RATES = (0.1, 1000.0)


@dataclass(frozen=True)
class Video:
    """What is in a file."""

    media_type: str
    codec: str
    fps: float
    frames: int
    width: int
    height: int


def media_type_of(head: bytes) -> str | None:
    """The kind of video that begins so, or None."""
    if head[4:8] == b"ftyp":
        return "video/mp4"
    return "video/webm" if head[:4] == b"\x1a\x45\xdf\xa3" else None


def looked_at(file: Path) -> Video:
    """What is in a video file.

    Raises CameraError for what is no video, has no end or no picture, MissingPackageError where
    PyAV is not installed.
    """
    media_type = _media_type(file)
    with opened_video(file, media_type) as container:
        if not container.streams.video:
            raise CameraError(f"{file}: expected a video, but it holds no pictures.")
        stream = container.streams.video[0]
        fps = float(stream.average_rate or 0.0)
        width, height = int(stream.width or 0), int(stream.height or 0)
        seconds = float(stream.duration * stream.time_base) if stream.duration else 0.0
        seconds = seconds or float(container.duration or 0) / 1e6
        frames = int(stream.frames or 0) or round(seconds * fps)
        codec = str(stream.codec_context.name)
    codec = "av1" if "av1" in codec or "dav1d" in codec else codec.removeprefix("lib")
    if not _RATES[0] <= fps <= _RATES[1] or frames < 1 or not 0 < width * height <= _MOST_PIXELS:
        raise CameraError(
            f"{file}: expected a video with an end, at {_RATES[0]:g} to {_RATES[1]:g} frames a "
            f"second, but this one has {frames} frames of {width}x{height} at {fps:g}; "
            "export it again as mp4."
        )
    return Video(media_type, codec, fps, frames, width, height)


@contextmanager
def opened_video(file: Path, media_type: str, most_bytes: int = MOST_INDEX_BYTES) -> Iterator[Any]:
    """The container of a file, read through a handle of ours: it can name no other file.

    Raises CameraError for one that cannot be read, or of which more than `most_bytes` is read.
    """
    av = package("av", EXTRA, file)
    with _regular(file) as handle:
        try:
            with av.open(_Bounded(handle, most_bytes), format=_DEMUXERS[media_type]) as container:
                yield container
        except (av.FFmpegError, ValueError, OverflowError, EOFError, IndexError) as error:
            raise CameraError(
                f"{file}: expected a whole video, but it cannot be read "
                f"({what_is_wrong(file, error)}); copy or export it again."
            ) from error


def _media_type(file: Path) -> str:
    try:
        media_type = media_type_of(first_bytes(file, LONGEST_HEAD))
    except OSError as error:
        raise CameraError(f"{file}: the video cannot be read ({error.strerror}).") from error
    if media_type is None:
        raise CameraError(f"{file}: expected a video, mp4 or webm, but it begins as neither does.")
    return media_type


@contextmanager
def _regular(file: Path) -> Iterator[BinaryIO]:
    descriptor = os.open(file, os.O_RDONLY | os.O_CLOEXEC | getattr(os, "O_NONBLOCK", 0))
    with open(descriptor, "rb") as handle:
        about = os.fstat(descriptor)
        if not stat.S_ISREG(about.st_mode) or about.st_size > MAX_FILE_BYTES:
            raise CameraError(
                f"{file}: expected a regular file of at most {MAX_FILE_BYTES >> 30} GiB."
            )
        yield handle


class _Bounded:
    """A file of which only so much is read; seeking is free."""

    def __init__(self, handle: BinaryIO, most_bytes: int) -> None:
        self._handle, self._left = handle, most_bytes
        self.seek, self.tell = handle.seek, handle.tell

    def read(self, count: int) -> bytes:
        """The next bytes."""
        self._left -= count
        if self._left < 0:
            raise ValueError("its index does not end")
        return self._handle.read(count)
