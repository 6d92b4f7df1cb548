"""Cameras of bags and MCAP files: each topic of pictures made into a video once.

The video has a steady rate, the median of the pictures'; every instant of it shows the one that was
taken nearest to it.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.cameras.bag_pictures import EXTRA, Picture, Topic, pictures_of, topics_of
from keyphase.cameras.camera import MAX_NAME_LENGTH, Stretch
from keyphase.cameras.encoding import Encoder, encoder
from keyphase.cameras.kept import Kept
from keyphase.cameras.packets import begins_anew, decoded, is_steady, remux
from keyphase.errors import CameraError
from keyphase.readers.beginnings import Zeros
from keyphase.readers.formats.damage import what_is_wrong
from keyphase.readers.formats.packages import package

MAX_IMAGE_BYTES = 32 << 20
_CODECS = {b"\xff\xd8": "mjpeg", b"\x89P": "png"}
_MOST_PIXELS = 64_000_000
_MAX_CAMERAS = 32
_MOST_REPEATS = 50
"""Longer without a picture, the video stands still only so many frames for each that there is."""


@dataclass(frozen=True, eq=False)
class _Taken:
    """A topic of a file, and when its pictures were taken, from `skipped` on [s], shape (N,)."""

    path: Path
    name: str
    kind: str
    skipped: int
    times_s: NDArray[np.float64]

    @property
    def fps(self) -> float:
        return float(np.clip(1.0 / np.median(np.diff(self.times_s)), 0.1, 240.0))

    def pictures(self) -> Iterator[Picture]:
        return (
            one
            for number, one in enumerate(pictures_of(self.path, self.name))
            if number >= self.skipped
        )


def videos_in_bag(path: Path, kept: Kept, tell: Callable[[float], None]) -> Iterator[Stretch]:
    """A video of every topic of pictures; `tell` how far the making of them is.

    Raises DemonstrationError for a file that cannot be read, CameraError for pictures that cannot.
    """
    starts: dict[str, int] = {}
    counts: dict[str, int] = {}

    def hear(name: str, data: bytes) -> None:
        """A decoder begins at the first frame that needs none before it."""
        number = counts[name] = counts.get(name, -1) + 1
        if name not in starts and begins_anew(data):
            starts[name] = number

    topics, zeros = topics_of(path, hear)
    chosen = [name for name in topics if len(topics[name].logs) > 1][:_MAX_CAMERAS]
    for number, name in enumerate(chosen):
        one = topics[name]
        skipped = starts.get(name, 0) if one.kind == "video" else 0
        taken = _Taken(path, name, one.kind, skipped, _times_s(one, zeros)[skipped:])
        if len(taken.times_s) < 2:
            continue

        def so_far(share: float, number: int = number) -> None:
            tell((number + share) / len(chosen))

        def make(to: Path, taken: _Taken = taken) -> None:
            _write(taken, to, so_far)

        file = kept.made(path, name, make)
        yield Stretch(_short(name), file, begins_s=float(taken.times_s[0]))


def _times_s(topic: Topic, zeros: Zeros) -> NDArray[np.float64]:
    """By the stamps where all have one, they ascend and signals go by their clock, too; else by
    the log.
    """
    zero = zeros.of_stamp(topic.stamps[0])
    stamped = zero is not None and all(topic.stamps) and (np.diff(topic.stamps) > 0).all()
    times = np.array(topic.stamps if stamped else topic.logs, dtype=np.int64)
    begin = zero.own_ns if zero is not None and stamped else zeros.log.own_ns
    return ((times - begin) * 1e-9).astype(np.float64)


def _short(topic: str) -> str:
    words = [word for word in topic.split("/") if word not in ("compressed", "image_raw", "image")]
    return ("/".join(filter(None, words)) or topic)[:MAX_NAME_LENGTH]


def _write(taken: _Taken, to: Path, tell: Callable[[float], None]) -> None:
    steps = np.diff(taken.times_s)
    if (steps < 0).any() or not np.median(steps) > 0:
        raise CameraError(
            f"{taken.path}: the pictures of {taken.name} are not in the order of their times."
        )
    if taken.kind == "image":
        images = (_decoded(taken.path, one) for one in taken.pictures())
        _write_steadily(taken, enumerate(images), to, tell)
        return
    first = next(taken.pictures(), None)
    if first is not None and first.format.lower() == "h264" and is_steady(taken.times_s):
        remux(taken.path, taken.pictures(), taken.fps, to)
        return
    _write_steadily(taken, decoded(taken.path, taken.pictures()), to, tell)


def _write_steadily(
    taken: _Taken, frames: Iterator[tuple[int, Any]], to: Path, tell: Callable[[float], None]
) -> None:
    """Each picture as often as the steady rate asks for."""
    times_s, fps = taken.times_s, taken.fps
    ends_s = np.append(times_s[:-1] + 0.5 * np.diff(times_s), times_s[-1]) - times_s[0]
    last = np.floor(ends_s * fps + 1e-6).astype(np.int64)
    counts = np.clip(np.diff(np.concatenate([[-1], last])), 0, _MOST_REPEATS)
    with encoder(to, fps) as writing:
        for index, frame in frames:
            if index < len(counts):
                _repeat(writing, frame, int(counts[index]))
            if index % 50 == 0:
                tell(index / len(times_s))


def _repeat(writing: Encoder, frame: Any, count: int) -> None:
    for _ in range(count):
        writing.add(frame)


def _decoded(path: Path, image: Picture) -> Any:
    """The picture of one message."""
    av = package("av", EXTRA, path)
    name = _CODECS.get(image.data[:2])
    if name is None or len(image.data) > MAX_IMAGE_BYTES:
        raise CameraError(
            f"{path}: expected JPEG or PNG of at most {MAX_IMAGE_BYTES >> 20} MiB for each image, "
            f"but one of {image.format[:40]!r} came."
        )
    codec = av.CodecContext.create(name, "r")
    codec.options = {"max_pixels": str(_MOST_PIXELS)}
    try:
        frames = [*codec.decode(av.Packet(image.data)), *codec.decode(None)]
    except (av.FFmpegError, ValueError) as error:
        raise CameraError(
            f"{path}: an image cannot be read ({what_is_wrong(path, error)})."
        ) from error
    if not frames:
        raise CameraError(f"{path}: an image holds no picture.")
    return frames[0]
