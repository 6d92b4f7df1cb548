"""Compressed images of bags and MCAP files, each topic made into a video once.

The video has a steady rate, the median of the images'; every instant of it shows the image that was
taken nearest to it.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from keyphase.cameras.camera import MAX_NAME_LENGTH, Stretch
from keyphase.cameras.container import EXTRA
from keyphase.cameras.encoding import encoder
from keyphase.cameras.kept import Kept
from keyphase.errors import CameraError
from keyphase.readers.formats.bags import BULKY, opened_bag
from keyphase.readers.formats.packages import package

MAX_IMAGE_BYTES = 32 << 20
_CODECS = {b"\xff\xd8": "mjpeg", b"\x89P": "png"}
_MOST_PIXELS = 64_000_000
_MAX_CAMERAS = 32
_MOST_REPEATS = 50
"""Longer without an image, the video stands still only so many frames for each that there is."""


@dataclass
class _Topic:
    """When the images of a topic were taken [ns], by the clock of all stamps, or of the log."""

    stamps: list[int] = field(default_factory=list)
    logs: list[int] = field(default_factory=list)


def videos_in_bag(path: Path, kept: Kept, tell: Callable[[float], None]) -> Iterator[Stretch]:
    """A video of every topic of compressed images; `tell` how far the making of them is.

    Raises DemonstrationError for a bag that cannot be read, CameraError for images that cannot be.
    """
    with opened_bag(path) as (reader, deserialize):
        images = [one for one in reader.connections if _is_compressed(one.msgtype)]
        if not images:
            return
        topics, zero_stamp, zero_log = _times(reader, deserialize, images)
    chosen = [name for name in topics if len(topics[name].logs) > 1][:_MAX_CAMERAS]
    for number, name in enumerate(chosen):
        one = topics[name]
        stamped = zero_stamp and all(one.stamps) and (np.diff(one.stamps) > 0).all()
        times = np.array(one.stamps if stamped else one.logs, dtype=np.int64)
        times_s = (times - (zero_stamp if stamped else zero_log)) * 1e-9

        def so_far(share: float, number: int = number) -> None:
            tell((number + share) / len(chosen))

        def make(to: Path, name: str = name, times_s: Any = times_s) -> None:
            _write(path, name, times_s, to, so_far)

        file = kept.made(path, name, make)
        yield Stretch(_short(name), file, begins_s=float(times_s[0]))


def _is_compressed(kind: str) -> bool:
    return kind.rpartition("/")[2] == "CompressedImage"


def _short(topic: str) -> str:
    words = [word for word in topic.split("/") if word not in ("compressed", "image_raw", "image")]
    return ("/".join(filter(None, words)) or topic)[:MAX_NAME_LENGTH]


def _times(
    reader: Any, deserialize: Any, images: Sequence[Any]
) -> tuple[dict[str, _Topic], int, int]:
    """When images were taken, and the zero of stamps and of the log, as the signals have them."""
    topics = {one.topic: _Topic() for one in images}
    first_logs, first_stamps = dict[str, int](), dict[str, int]()
    signals = [one for one in reader.connections if one.msgtype.rpartition("/")[2] not in BULKY]
    for connection, log_ns, raw in reader.messages(connections=[*images, *signals]):
        name = connection.topic
        if name in topics:
            topics[name].stamps.append(_stamp_ns(deserialize(raw, connection.msgtype)))
            topics[name].logs.append(log_ns)
        elif name not in first_logs:
            first_logs[name] = log_ns
            first_stamps[name] = _stamp_ns(deserialize(raw, connection.msgtype))
    stamps = [one for one in first_stamps.values() if one]
    every = [log for one in topics.values() for log in one.logs[:1]]
    return topics, min(stamps, default=0), min(first_logs.values(), default=min(every, default=0))


def _stamp_ns(message: Any) -> int:
    stamp = getattr(getattr(message, "header", None), "stamp", None)
    return stamp.sec * 10**9 + stamp.nanosec if stamp is not None else 0


def _write(path: Path, topic: str, times_s: Any, to: Path, tell: Callable[[float], None]) -> None:
    """Each image as often as the steady rate asks for."""
    steps = np.diff(times_s)
    if (steps < 0).any() or not np.median(steps) > 0:
        raise CameraError(f"{path}: the images of {topic} are not in the order of their times.")
    fps = float(np.clip(1.0 / np.median(steps), 0.1, 240.0))
    ends_s = np.append(times_s[:-1] + 0.5 * steps, times_s[-1]) - times_s[0]
    last = np.floor(ends_s * fps + 1e-6).astype(np.int64)
    counts = np.clip(np.diff(np.concatenate([[-1], last])), 0, _MOST_REPEATS)
    with opened_bag(path) as (reader, deserialize), encoder(to, fps) as writing:
        wanted = [one for one in reader.connections if one.topic == topic]
        images = reader.messages(connections=wanted)
        for index, (connection, _, raw) in enumerate(images):
            if counts[index]:
                frame = _decoded(path, deserialize(raw, connection.msgtype))
                for _ in range(counts[index]):
                    writing.add(frame)
            if index % 50 == 0:
                tell(index / len(times_s))


def _decoded(path: Path, message: Any) -> Any:
    """The picture of one message."""
    av = package("av", EXTRA, path)
    data = bytes(message.data)
    name = _CODECS.get(data[:2])
    if name is None or len(data) > MAX_IMAGE_BYTES:
        raise CameraError(
            f"{path}: expected JPEG or PNG of at most {MAX_IMAGE_BYTES >> 20} MiB for each image, "
            f"but one of {str(message.format)[:40]!r} came."
        )
    codec = av.CodecContext.create(name, "r")
    codec.options = {"max_pixels": str(_MOST_PIXELS)}
    try:
        frames = [*codec.decode(av.Packet(data)), *codec.decode(None)]
    except (av.FFmpegError, ValueError) as error:
        raise CameraError(f"{path}: an image cannot be read ({error}).") from error
    if not frames:
        raise CameraError(f"{path}: an image holds no picture.")
    return frames[0]
