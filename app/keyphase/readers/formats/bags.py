"""ROS 1 bags, ROS 2 bags and MCAP: every topic is a stream with a clock of its own.

A number in a message is the column `TOPIC.field.field`, such as `/wrench.wrench.force.x`; the
topic's clocks are `TOPIC.stamp` (of the message's header, where it has one) and `TOPIC.log_time`,
both in seconds from the beginning of the bag. A direct transform of `/tf` is the topic
`/tf[parent>child]`.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, fields, is_dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.errors import DemonstrationError
from keyphase.notices import Caution
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import damage_told
from keyphase.readers.formats.numeric import MAX_NUMBERS_A_ROW
from keyphase.readers.formats.packages import package

EXTRA = "ros"
ROS1_MAGIC = b"#ROSBAG V"
MCAP_MAGIC = b"\x89MCAP0\r\n"
ROS2_INFO = "metadata.yaml"

BULKY = ("Image", "PointCloud2", "LaserScan", "OccupancyGrid", "CompressedImage")
_MAX_DEPTH = 8


def is_ros2_bag(path: Path) -> bool:
    """Whether a folder is a ROS 2 bag."""
    if not (path / ROS2_INFO).is_file():
        return False
    files = list(path.iterdir())
    held = any(file.suffix in (".db3", ".mcap") for file in files)
    return held and all(file.is_file() or file.is_dir() for file in files)


def table_of_bag(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """All numbers of all topics; images and point clouds are passed over.

    Raises DemonstrationError for a bag that cannot be read, MissingPackageError where rosbags is
    not installed.
    """
    if part is not None:
        raise DemonstrationError(f"{path}: a bag is one recording; name it without #{part[:80]}.")
    streams = _Streams(str(path), limit_bytes)
    with damage_told(path, "bag", "copy or record it again"):
        for topic, log_ns, message in _messages(path):
            streams.add(topic, log_ns, message)
    return ArrayTable(str(path), streams.arrays(), {}, streams.notices(), {})


@contextmanager
def opened_bag(path: Path) -> Iterator[tuple[Any, Callable[[bytes, str], Any]]]:
    """A reader of its messages, and what makes them of their bytes.

    Raises DemonstrationError for a bag that cannot be read, MissingPackageError where rosbags is
    not installed.
    """
    highlevel = package("rosbags.highlevel", EXTRA, path)
    stores = package("rosbags.typesys", EXTRA, path)
    store = stores.get_typestore(stores.Stores.ROS2_HUMBLE)
    with (
        damage_told(path, "bag", "copy or record it again"),
        highlevel.AnyReader([path], default_typestore=store) as reader,
    ):
        yield reader, reader.deserialize


def _messages(path: Path) -> Iterator[tuple[str, int, Any]]:
    with opened_bag(path) as (reader, deserialize):
        wanted = [
            connection
            for connection in reader.connections
            if connection.msgtype.rpartition("/")[2] not in BULKY
        ]
        for connection, log_ns, raw in reader.messages(connections=wanted):
            message = deserialize(raw, connection.msgtype)
            yield from _parted(connection.topic, log_ns, message)


def _parted(topic: str, log_ns: int, message: Any) -> Iterator[tuple[str, int, Any]]:
    """A message of transforms is one message of each of them."""
    transforms = getattr(message, "transforms", None)
    if transforms is None:
        yield topic, log_ns, message
        return
    for one in transforms:
        yield f"{topic}[{one.header.frame_id}>{one.child_frame_id}]", log_ns, one


@dataclass
class _Stream:
    """One topic as it is read."""

    getters: dict[str, Callable[[Any], Any]]
    stamped: bool
    rows: list[list[Any]] = field(default_factory=list)
    stamps_ns: list[int] = field(default_factory=list)
    logs_ns: list[int] = field(default_factory=list)


class _Streams:
    """The topics of a bag while it is read, within a limit of memory."""

    def __init__(self, file: str, limit_bytes: int) -> None:
        self._file, self._limit = file, limit_bytes
        self._streams: dict[str, _Stream] = {}
        self._numbers = 0

    def add(self, topic: str, log_ns: int, message: Any) -> None:
        """One message more."""
        if topic not in self._streams:
            self._streams[topic] = _Stream(dict(_numbers_of(message)), hasattr(message, "header"))
        stream = self._streams[topic]
        row = [get(message) for get in stream.getters.values()]
        self._numbers += sum(np.size(value) for value in row) + 2
        if 8 * self._numbers > self._limit:
            raise DemonstrationError(
                f"{self._file}: the bag takes more memory than the limit of {self._limit} bytes; "
                "cut it, leave topics out, or raise the limit."
            )
        stream.rows.append(row)
        stream.logs_ns.append(log_ns)
        if stream.stamped:
            stamp = message.header.stamp
            stream.stamps_ns.append(stamp.sec * 10**9 + stamp.nanosec)

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Columns and clocks of every topic with at least two messages."""
        used = {topic: one for topic, one in self._streams.items() if len(one.rows) > 1}
        begin = min((one.logs_ns[0] for one in used.values()), default=0)
        stamped = [one.stamps_ns[0] for one in used.values() if one.stamped and one.stamps_ns[0]]
        first = min(stamped, default=begin)
        found: dict[str, NDArray[Any]] = {}
        for topic, one in used.items():
            found[f"{topic}.log_time"] = (np.array(one.logs_ns) - begin) * 1e-9
            if one.stamped:
                found[f"{topic}.stamp"] = (np.array(one.stamps_ns) - first) * 1e-9
            for name, values in zip(one.getters, zip(*one.rows, strict=True), strict=True):
                array = _stacked(values)
                if array is not None:
                    found[f"{topic}.{name}"] = array
        return found

    def notices(self) -> tuple[str, ...]:
        """Which topics said too little to be read."""
        few = [topic for topic, one in self._streams.items() if len(one.rows) < 2]
        told = f"Topics of one message were passed over: {', '.join(few[:5])}."
        return (Caution(told),) if few else ()


def _stacked(values: tuple[Any, ...]) -> NDArray[Any] | None:
    """Numbers of all messages, or None for lists whose length changes."""
    if len({np.size(value) for value in values}) > 1:
        return None
    array = np.array(values, dtype=np.float64)
    return array.reshape(len(values), -1) if array.ndim > 1 else array


def _numbers_of(
    value: Any,
    before: str = "",
    get: Callable[[Any], Any] = lambda message: message,
    depth: int = 0,
) -> Iterator[tuple[str, Callable[[Any], Any]]]:
    """The numbers in a message, by the path to each, and how to fetch it from another one."""
    if depth > _MAX_DEPTH:
        return
    for one in fields(value):
        if one.name in ("header", "__msgtype__") or one.name.startswith("_"):
            continue
        inner = getattr(value, one.name)
        name = f"{before}{one.name}"

        def fetch(message: Any, get: Callable[[Any], Any] = get, key: str = one.name) -> Any:
            return getattr(get(message), key)

        if is_dataclass(inner):
            yield from _numbers_of(inner, f"{name}.", fetch, depth + 1)
        elif isinstance(inner, bool | int | float) or _is_row(inner):
            yield name, fetch


def _is_row(value: Any) -> bool:
    is_numbers = isinstance(value, np.ndarray) and value.dtype.kind in "fiub"
    return is_numbers and 0 < value.size <= MAX_NUMBERS_A_ROW
