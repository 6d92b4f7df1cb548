"""MCAP files without ROS: messages in JSON or Protobuf, each topic with a clock of its own."""

import json
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

from keyphase.readers.formats.packages import package

EXTRA = "mcap"
ROS_PROFILES = ("ros1", "ros2")
_MAX_DEPTH = 8
_MAX_LIST = 512
_STAMPS = ("stamp", "timestamp", "time")

Plain = dict[str, Any]


def profile_of(path: Path) -> str:
    """What an MCAP file says it was recorded by, such as "ros2"; "" where it does not say."""
    reading = package("mcap.reader", EXTRA, path)
    with path.open("rb") as stream:
        return str(reading.make_reader(stream).get_header().profile)


def plain_messages(
    path: Path, pass_over: Callable[[str, str], None] = lambda _topic, _encoding: None
) -> Iterator[tuple[str, str, int, Plain]]:
    """Topic, schema, time of the log [ns] and content of every message that can be understood.

    `pass_over` is told the topics that are neither JSON nor Protobuf, and in what they are written.
    Raises MissingPackageError where mcap or protobuf is not installed, and what they raise over
    damaged files.
    """
    reading = package("mcap.reader", EXTRA, path)
    decoders: dict[int, Callable[[bytes], Plain] | None] = {}
    with path.open("rb") as stream:
        reader = reading.make_reader(stream, validate_crcs=True)
        for schema, channel, message in reader.iter_messages():
            if channel.id not in decoders:
                decoders[channel.id] = _decoder(channel.message_encoding, schema, path)
                if decoders[channel.id] is None:
                    pass_over(channel.topic, channel.message_encoding[:40] or "nothing named")
            decode, kind = decoders[channel.id], schema.name if schema is not None else ""
            if decode is not None:
                yield channel.topic, kind, message.log_time, decode(message.data)


def _decoder(encoding: str, schema: Any, path: Path) -> Callable[[bytes], Plain] | None:
    if encoding == "json":
        return _json
    if encoding != "protobuf" or schema is None:
        return None
    kind = _protobuf_class(schema, path)
    return lambda data: _plain(kind.FromString(data))


def _json(data: bytes) -> Plain:
    content = json.loads(data)
    return content if isinstance(content, dict) else {"value": content}


def _protobuf_class(schema: Any, path: Path) -> Any:
    descriptors = package("google.protobuf.descriptor_pb2", EXTRA, path)
    pools = package("google.protobuf.descriptor_pool", EXTRA, path)
    factory = package("google.protobuf.message_factory", EXTRA, path)
    pool = pools.DescriptorPool()
    for file in descriptors.FileDescriptorSet.FromString(schema.data).file:
        pool.Add(file)
    return factory.GetMessageClass(pool.FindMessageTypeByName(schema.name))


def _plain(message: Any, depth: int = 0) -> Plain:
    """All fields of a Protobuf message, also those that stand at zero and are not sent."""
    if depth > _MAX_DEPTH:
        return {}
    found: Plain = {}
    for one in message.DESCRIPTOR.fields:
        value = getattr(message, one.name)
        if one.message_type is None:
            found[one.name] = list(value) if _is_repeated(value) else value
        elif not _is_repeated(value):
            found[one.name] = _plain(value, depth + 1)
    return found


def _is_repeated(value: Any) -> bool:
    return hasattr(value, "__len__") and not isinstance(value, str | bytes)


def stamp_of(message: Mapping[str, Any]) -> int | None:
    """The time [ns] in a message's header or timestamp, as ROS and Foxglove write it."""
    header = message.get("header")
    places = (header if isinstance(header, dict) else {}, message)
    told = (place.get(name) for place in places for name in _STAMPS)
    stamp = next((one for one in told if isinstance(one, dict)), None)
    if stamp is None:
        return None
    seconds = next((stamp[k] for k in ("sec", "secs", "seconds") if k in stamp), None)
    rest = next((stamp[k] for k in ("nanosec", "nsec", "nsecs", "nanos") if k in stamp), 0)
    if not isinstance(seconds, int) or not isinstance(rest, int):
        return None
    return seconds * 10**9 + rest


def numbers_in(value: Any, before: str = "", depth: int = 0) -> Iterator[tuple[str, Any]]:
    """The numbers, and lists of numbers, of a message by the path to each."""
    if depth > _MAX_DEPTH:
        return
    if isinstance(value, bool | int | float):
        yield before, float(value)
    elif isinstance(value, list) and 0 < len(value) <= _MAX_LIST:
        if all(isinstance(one, bool | int | float) for one in value):
            yield before, [float(one) for one in value]
    elif isinstance(value, dict):
        for name, inner in value.items():
            path = f"{before}.{name}" if before else str(name)
            if path not in ("header", *_STAMPS) or not isinstance(inner, dict):
                yield from numbers_in(inner, path, depth + 1)
