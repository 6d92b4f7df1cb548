"""Pictures among the messages of bags and MCAP files: single images, and packets of a video.

A packet of a video (Foxglove's CompressedVideo) is one frame that can be decoded after those before
it; an image stands alone.
"""

import base64
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from keyphase.cameras.container import EXTRA
from keyphase.readers.beginnings import Zeros, zeros_of
from keyphase.readers.formats.bags import BULKY, is_without_ros, opened_bag, parted
from keyphase.readers.formats.damage import damage_told
from keyphase.readers.formats.messages import plain_messages, stamp_of

Kind = Literal["image", "video"]
_KINDS: dict[str, Kind] = {"CompressedImage": "image", "CompressedVideo": "video"}

__all__ = ["EXTRA", "Kind", "Picture", "Topic", "pictures_of", "topics_of"]


@dataclass(frozen=True)
class Picture:
    """One image or packet, as it was recorded."""

    data: bytes
    format: str


@dataclass
class Topic:
    """A topic of pictures, and when each was taken [ns]: by its stamp (0: none), and by the log."""

    kind: Kind
    stamps: list[int] = field(default_factory=list)
    logs: list[int] = field(default_factory=list)


def kind_of(name: str) -> Kind | None:
    """What a message of that type holds, as `sensor_msgs/msg/CompressedImage`."""
    return _KINDS.get(name.replace(".", "/").rpartition("/")[2])


def topics_of(
    path: Path, hear: Callable[[str, bytes], None] = lambda _topic, _data: None
) -> tuple[dict[str, Topic], Zeros]:
    """The topics of pictures, and from when the clocks of the signals count.

    `hear` is told every picture. Raises DemonstrationError for a file that cannot be read.
    """
    topics: dict[str, Topic] = {}
    firsts, several = dict[str, tuple[int, int | None]](), set[str]()
    messages = _plain if (without_ros := is_without_ros(path)) else _of_ros
    for name, kind, log_ns, stamp_ns, picture in messages(path):
        if kind is not None and picture is not None:
            topic = topics.setdefault(name, Topic(kind))
            topic.stamps.append(stamp_ns)
            topic.logs.append(log_ns)
            hear(name, picture.data)
        if kind is None or without_ros:
            if name in firsts:
                several.add(name)
            firsts.setdefault(name, (log_ns, stamp_ns))
    signals = {name: first for name, first in firsts.items() if name in several}
    pictures = {name: (one.logs[0], one.stamps[0]) for name, one in topics.items() if one.logs}
    return topics, zeros_of(signals or pictures)


def pictures_of(path: Path, topic: str) -> Iterator[Picture]:
    """The pictures of a topic, in the order of the log."""
    messages = _plain(path) if is_without_ros(path) else _of_ros(path, topic)
    return (one for name, _, _, _, one in messages if name == topic and one is not None)


_Heard = tuple[str, Kind | None, int, int, Picture | None]
"""Topic, what it holds, time of the log, stamp or 0, and the picture if it holds one."""


def _of_ros(path: Path, only: str | None = None) -> Iterator[_Heard]:
    with opened_bag(path) as (reader, deserialize):
        wanted = [
            one
            for one in reader.connections
            if (only is None or one.topic == only)
            and (kind_of(one.msgtype) or one.msgtype.rpartition("/")[2] not in BULKY)
        ]
        for connection, log_ns, raw in reader.messages(connections=wanted):
            kind = kind_of(connection.msgtype)
            message = deserialize(raw, connection.msgtype)
            picture = Picture(bytes(message.data), str(message.format)) if kind else None
            for name, one in parted(connection.topic, message):
                yield name, kind, log_ns, _stamp_ns(one), picture


def _stamp_ns(message: Any) -> int:
    header = getattr(message, "header", None)
    stamp = getattr(header, "stamp", None) or getattr(message, "timestamp", None)
    sec, nanosec = getattr(stamp, "sec", None), getattr(stamp, "nanosec", None)
    return sec * 10**9 + nanosec if isinstance(sec, int) and isinstance(nanosec, int) else 0


def _plain(path: Path) -> Iterator[_Heard]:
    with damage_told(path, "MCAP file", "copy or record it again"):
        for topic, kind_name, log_ns, content in plain_messages(path):
            kind = kind_of(kind_name)
            data, stamp = content.get("data"), stamp_of(content) or 0
            picture = None
            if kind is not None:
                raw = base64.b64decode(data) if isinstance(data, str) else bytes(data or b"")
                picture = Picture(raw, str(content.get("format", "")))
            yield topic, kind, log_ns, stamp, picture
