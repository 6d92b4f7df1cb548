"""MCAP: a message at the start of each segment, beside the messages that were recorded.

The whole segment file is attached, so that nothing is lost.
"""

import json
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from keyphase.errors import ExportError
from keyphase.labeling.segment_file import SUFFIX
from keyphase.labeling.segment_file_content import as_json, end_condition_content
from keyphase.readers.formats.bags import MCAP_MAGIC
from keyphase.readers.formats.damage import what_is_wrong
from keyphase.writers.carried import EVERYTHING
from keyphase.writers.clock import zero_ns
from keyphase.writers.copies import in_place_of
from keyphase.writers.own_files import content_of
from keyphase.writers.packages import package
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Items, Options, Writer

EXTRA = "mcap"
TOPIC = "/keyphase/segment"
SCHEMA = {
    "type": "object",
    "title": "keyphase.Segment",
    "properties": {
        "id": {"type": "integer"},
        "start_s": {"type": "number"},
        "end_s": {"type": "number"},
        "name": {"type": "string"},
        "motion": {"type": "string"},
        "kept": {"type": "boolean"},
        "end_condition": {"type": "object"},
    },
}


def _write(items: Items, target: Path, _options: Options) -> tuple[Path, ...]:
    (item,) = items
    writing = package("mcap.writer", EXTRA)
    with in_place_of(target) as working, working.open("wb") as stream:
        writer = writing.Writer(stream)
        writer.start(profile="", library="keyphase")
        if is_mcap(item):
            _copy(item.container, writer)
        zero = zero_ns(item.recording, item.recipe)
        _add_segments(item, writer, zero)
        _attach(item, writer, zero, target)
        writer.finish()
    return (target,)


def is_mcap(item: SegmentedRecording) -> bool:
    """Whether the recording's own messages can be beside its segments."""
    if not item.container.is_file():
        return False
    with item.container.open("rb") as file:
        return file.read(len(MCAP_MAGIC)) == MCAP_MAGIC


@dataclass
class _Copied:
    """Which numbers the writer gave to the schemas and channels of the original."""

    schemas: dict[int, int] = field(default_factory=dict)
    channels: dict[int, int] = field(default_factory=dict)


def _copy(source: Path, writer: Any) -> None:
    """Every message, attachment and metadata record as it is, one after another."""
    reading = package("mcap.reader", EXTRA)
    problem = package("mcap.exceptions", EXTRA).McapError
    copied = _Copied()
    try:
        with source.open("rb") as stream:
            reader = reading.make_reader(stream)
            for schema, channel, message in reader.iter_messages(log_time_order=False):
                writer.add_message(
                    channel_id=_channel(copied, writer, schema, channel),
                    log_time=message.log_time,
                    publish_time=message.publish_time,
                    sequence=message.sequence,
                    data=message.data,
                )
            for one in reader.iter_attachments():
                writer.add_attachment(
                    one.create_time, one.log_time, one.name, one.media_type, one.data
                )
            for one in reader.iter_metadata():
                writer.add_metadata(one.name, one.metadata)
    except (problem, OSError, ValueError) as error:
        raise ExportError(
            f"{source}: expected a whole MCAP file, but it cannot be read "
            f"({what_is_wrong(source, error)}); copy it again."
        ) from error


def _channel(copied: _Copied, writer: Any, schema: Any, channel: Any) -> int:
    if channel.id not in copied.channels:
        number = 0
        if schema is not None:
            number = copied.schemas.get(schema.id) or writer.register_schema(
                schema.name, schema.encoding, schema.data
            )
            copied.schemas[schema.id] = number
        copied.channels[channel.id] = writer.register_channel(
            channel.topic, channel.message_encoding, number, channel.metadata
        )
    return copied.channels[channel.id]


def _add_segments(item: SegmentedRecording, writer: Any, zero: int) -> None:
    schema = writer.register_schema(str(SCHEMA["title"]), "jsonschema", json.dumps(SCHEMA).encode())
    channel = writer.register_channel(TOPIC, "json", schema)
    for segment, motion in zip(item.segments, item.motions, strict=True):
        content = {
            "id": segment.id,
            "start_s": segment.start_s,
            "end_s": segment.end_s,
            "name": segment.label,
            "motion": motion,
            "kept": segment.kept,
            "end_condition": end_condition_content(segment.end_condition),
        }
        log_time = _nanoseconds(item, zero, segment.start_s)
        data = json.dumps(content, ensure_ascii=False).encode()
        writer.add_message(channel, log_time, data, log_time, segment.id)


def _attach(item: SegmentedRecording, writer: Any, zero: int, target: Path) -> None:
    at = _nanoseconds(item, zero, item.segments[0].start_s)
    data = as_json(content_of(item, target))
    writer.add_attachment(at, at, f"{item.name}{SUFFIX}", "application/json", data)


def _nanoseconds(item: SegmentedRecording, zero: int, time_s: float) -> int:
    # Seconds since 1970 and those of the recording are added as whole numbers, to keep nanoseconds.
    nanoseconds = zero + round(1e9 * time_s)
    if nanoseconds < 0:
        raise ExportError(
            f"{item.recording}: MCAP has no times before zero, but it begins at {time_s:g} s; "
            "read it with from_zero = true and segment it again."
        )
    return nanoseconds


def _warn(items: Items, _options: Options) -> Iterable[str]:
    if not all(map(is_mcap, items)):
        yield "only recordings that are MCAP files have their signals beside the segments"


MCAP = Writer(
    name="mcap",
    title="MCAP with segments beside the recorded messages",
    ending=".segments.mcap",
    extra=EXTRA,
    carries=EVERYTHING,
    write=_write,
    reads_back=(
        "from mcap.reader import make_reader\n"
        'reader = make_reader(open("PATH", "rb"))\n'
        'print([m.data for _, _, m in reader.iter_messages(topics=["/keyphase/segment"])])'
    ),
    warn=_warn,
    copies=True,
    module="mcap",
)
