"""Lines of a journal: one JSON object each, with a checksum, so that damage is seen."""

import json
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from keyphase.files.strict_json import MAX_VALUES, parsed_json, values_in

Record = Mapping[str, Any]

MAX_LINES = 200_000
"""What comes after so many is not looked at; a journal is rewritten long before."""


@dataclass(frozen=True)
class ReadRecords:
    """What could be read of a journal.

    damaged     numbers, from 1, of lines that could not be read
    torn        the last line is incomplete, as a crash while writing leaves it
    clean       the file can be appended to as it is
    """

    records: tuple[Record, ...]
    damaged: tuple[int, ...]
    torn: bool
    clean: bool


def encode(record: Record) -> bytes:
    """The line that holds a record: CRC-32 of the JSON in eight hexadecimal digits, the JSON."""
    text = json.dumps(record, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    # A file name that is no valid UTF-8 holds lone surrogates; as escapes they are valid JSON.
    content = text.encode(errors="backslashreplace")
    return b"%08x %s\n" % (zlib.crc32(content), content)


def decode(data: bytes) -> ReadRecords:
    """All records of a journal that are whole; what is not is left out and counted."""
    *lines, rest = data.split(b"\n", MAX_LINES)
    if b"\n" in rest:
        lines, rest = [*lines, rest], b""
    read = _decoded(lines)
    damaged = tuple(i for i, record in enumerate(read, start=1) if record is None)
    last = _decode_line(rest) if rest else None
    records = tuple(record for record in (*read, last) if record is not None)
    return ReadRecords(records, damaged, bool(rest) and last is None, not damaged and not rest)


def _decoded(lines: list[bytes]) -> list[Record | None]:
    """The record of each line, None for one that cannot be read, or for which no room is left."""
    records: list[Record | None] = []
    room = MAX_VALUES
    for line in lines:
        room -= values_in(line)
        records.append(_decode_line(line) if room >= 0 else None)
    return records


def _decode_line(line: bytes) -> Record | None:
    checksum, _, content = line.partition(b" ")
    if checksum != b"%08x" % zlib.crc32(content):
        return None
    try:
        record = parsed_json(content)
    except ValueError:
        return None
    return record if isinstance(record, dict) else None
