"""ROS 1 bags, ROS 2 bags and MCAP: every topic is a stream with a clock of its own.

A number in a message is the column `TOPIC.field.field`, such as `/wrench.wrench.force.x`; the
topic's clocks are `TOPIC.stamp` (of the message's header, where it has one) and `TOPIC.log_time`,
both in seconds from the beginning of the bag; stamps by a clock that tells another time than the
recorder's count from their own first. A transform is the topic `/tf[parent>child]`, also
one over several links. MCAP files without ROS hold messages in JSON or Protobuf.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from keyphase.errors import DemonstrationError
from keyphase.files.bounded_memory import memory_bounded
from keyphase.files.reading import first_bytes
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.damage import UnfitError, damage_told
from keyphase.readers.formats.messages import ROS_PROFILES, plain_messages, profile_of
from keyphase.readers.formats.packages import package
from keyphase.readers.formats.streams import Streams
from keyphase.readers.formats.transforms import with_chains

EXTRA = "ros"
ROS1_MAGIC = b"#ROSBAG V"
MCAP_MAGIC = b"\x89MCAP0\r\n"
ROS2_INFO = "metadata.yaml"

_PACKED = ".zstd"
_FRAME, _SKIPPED = b"\x28\xb5\x2f\xfd", b"\x50\x2a\x4d\x18"
_MOST_OVER = 32
_ROOM_BYTES = 64 << 20
"""A bag packed as a whole may unpack to so many times its size, and so much beside."""
_STEP_BYTES = 1 << 20

BULKY = ("Image", "PointCloud2", "LaserScan", "OccupancyGrid", "CompressedImage", "CompressedVideo")


def is_ros2_bag(path: Path) -> bool:
    """Whether a folder is a ROS 2 bag."""
    if not (path / ROS2_INFO).is_file():
        return False
    files = list(path.iterdir())
    held = any(file.suffix in (".db3", ".mcap", _PACKED) for file in files)
    return held and all(file.is_file() or file.is_dir() for file in files)


def table_of_bag(path: Path, part: str | None, limit_bytes: int) -> ArrayTable:
    """All numbers of all topics; images and point clouds are passed over.

    Raises DemonstrationError for a bag that cannot be read, MissingPackageError where rosbags is
    not installed.
    """
    if part is not None:
        raise DemonstrationError(f"{path}: a bag is one recording; name it without #{part[:80]}.")
    plain = is_without_ros(path)
    streams = Streams(str(path), limit_bytes, of_ros=not plain)
    if plain:
        told = damage_told(path, "MCAP file", "copy or record it again")
        with told, memory_bounded(path):
            for topic, _, log_ns, content in plain_messages(path, streams.pass_over):
                streams.add_plain(topic, log_ns, content)
    else:
        told = damage_told(path, "bag", "copy or record it again")
        with told, memory_bounded(path):
            for topic, log_ns, message in _messages(path, streams):
                streams.add(topic, log_ns, message)
    arrays = with_chains(streams.arrays())
    return ArrayTable(
        str(path), arrays, {}, streams.notices(), {}, streams.remarks(), streams.zeros()
    )


def is_without_ros(path: Path) -> bool:
    """Whether it is an MCAP file whose messages are not those of ROS."""
    if path.is_dir() or not first_bytes(path, len(MCAP_MAGIC)).startswith(MCAP_MAGIC):
        return False
    with damage_told(path, "MCAP file", "copy or record it again"):
        return profile_of(path) not in ROS_PROFILES


@contextmanager
def opened_bag(path: Path) -> Iterator[tuple[Any, Callable[[bytes, str], Any]]]:
    """A reader of its messages, and what makes them of their bytes.

    Raises DemonstrationError for a bag that cannot be read, MissingPackageError where rosbags is
    not installed.
    """
    highlevel = package("rosbags.highlevel", EXTRA, path)
    stores = package("rosbags.typesys", EXTRA, path)
    store = stores.get_typestore(stores.Stores.ROS2_HUMBLE)
    with damage_told(path, "bag", "copy or record it again"):
        for file in sorted(path.glob("*")):
            if file.is_file() and _is_packed(file):
                _refuse_bloated(file)
        with highlevel.AnyReader([path], default_typestore=store) as reader:
            yield reader, reader.deserialize


def _is_packed(file: Path) -> bool:
    """Whether it begins as a frame of zstd does, or one of those that are skipped over; whatever
    it is called, what describes the bag may say that it is packed."""
    begins = first_bytes(file, 4)
    return begins == _FRAME or (begins[1:] == _SKIPPED[1:] and begins[0] & 0xF0 == _SKIPPED[0])


def _refuse_bloated(file: Path) -> None:
    """Raise UnfitError where a packed file would fill the disk, to which it is unpacked."""
    zstd = package("rosbags.rosbag2.reader", EXTRA, file).zstd
    left = _MOST_OVER * file.stat().st_size + _ROOM_BYTES
    with zstd.open(file, "rb") as unpacked:
        while size := len(unpacked.read(_STEP_BYTES)):
            left -= size
            if left < 0:
                raise UnfitError(f"{file.name} unpacks to more than {_MOST_OVER} times its size")


def _messages(path: Path, streams: Streams) -> Iterator[tuple[str, int, Any]]:
    with opened_bag(path) as (reader, deserialize):
        wanted = [
            connection
            for connection in reader.connections
            if connection.msgtype.rpartition("/")[2] not in BULKY
        ]
        for connection, log_ns, raw in reader.messages(connections=wanted):
            if streams.passes_over(connection.topic):
                continue
            try:
                message = deserialize(raw, connection.msgtype)
            except KeyError:
                # A bag of ROS 2 before Iron does not say what its own messages are.
                streams.pass_over(connection.topic, connection.msgtype)
                continue
            for topic, one in parted(connection.topic, message):
                yield topic, log_ns, one


def parted(topic: str, message: Any) -> Iterator[tuple[str, Any]]:
    """A message of transforms is one message of each of them."""
    transforms = getattr(message, "transforms", None)
    if transforms is None:
        yield topic, message
        return
    for one in transforms:
        yield f"{topic}[{one.header.frame_id}>{one.child_frame_id}]", one
