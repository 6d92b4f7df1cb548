"""Videos in parts: a browser asks for a range of bytes, and gets a piece of a bounded size."""

import os
import re
import stat
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from http import HTTPStatus
from pathlib import Path

from websockets.http11 import Response

from keyphase.web.transport.responses import answer, text

VIDEOS = "/app/video/"
"""What is behind it is a name of chance, never a path."""

MAX_PART_BYTES = 1 << 20
"""Every answer is written whole while nobody else is served; the browser asks for the next."""

_RANGE = re.compile(r"bytes=(\d{0,18})-(\d{0,18})")


@dataclass(frozen=True)
class Video:
    """A file and what it is."""

    file: Path
    media_type: str


Videos = Callable[[str], Video | None]
"""The video that was lent under a name, or None."""


def video_part(video: Video | None, headers: Mapping[str, str]) -> Response:
    """206 with the part of the file that was asked for, cut to MAX_PART_BYTES.

    Without a range 200 with a file that fits; 416 for a range that is none of the file's, and for a
    larger file as a whole; 404 where there is none.
    """
    if video is None:
        return text(HTTPStatus.NOT_FOUND, "There is no such video.")
    try:
        descriptor = os.open(video.file, os.O_RDONLY | os.O_CLOEXEC | os.O_NONBLOCK)
    except OSError:
        return text(HTTPStatus.NOT_FOUND, "The video is no longer there.")
    with open(descriptor, "rb") as file:
        about = os.fstat(descriptor)
        if not stat.S_ISREG(about.st_mode):
            return text(HTTPStatus.NOT_FOUND, "The video is no longer there.")
        wanted = headers.get("Range")
        part = _part(wanted, about.st_size)
        if part is None:
            return _outside(about.st_size)
        first, last = part
        file.seek(first)
        body = file.read(last - first + 1)
    status = HTTPStatus.OK if wanted is None else HTTPStatus.PARTIAL_CONTENT
    response = answer(status, body, video.media_type)
    response.headers["Accept-Ranges"] = "bytes"
    if wanted is not None:
        response.headers["Content-Range"] = f"bytes {first}-{last}/{about.st_size}"
    return response


def _part(wanted: str | None, size: int) -> tuple[int, int] | None:
    """First and last byte of what is sent; None where that cannot be."""
    if size == 0:
        return None
    if wanted is None:
        return (0, size - 1) if size <= MAX_PART_BYTES else None
    found = _RANGE.fullmatch(wanted.strip())
    if found is None or found[0] == "bytes=-":
        return None
    if not found[1]:
        first, last = max(size - int(found[2]), 0), size - 1
        if int(found[2]) == 0:
            return None
    else:
        first, last = int(found[1]), min(int(found[2] or size), size - 1)
    if first > last:
        return None
    return first, min(last, first + MAX_PART_BYTES - 1)


def _outside(size: int) -> Response:
    status = HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE
    response = text(
        status, f"Expected one range of bytes, within {size}; at most {MAX_PART_BYTES} are sent."
    )
    response.headers["Content-Range"] = f"bytes */{size}"
    response.headers["Accept-Ranges"] = "bytes"
    return response
