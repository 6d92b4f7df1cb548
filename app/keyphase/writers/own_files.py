"""keyphase's own segment files, as JSON and as a table."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

from keyphase.labeling.segment_file import SUFFIX, FiledSegment
from keyphase.labeling.segment_file_content import (
    SCHEMA_VERSION,
    as_csv,
    as_json,
    assessment_content,
    end_condition_content,
    relative_path,
)
from keyphase.writers.carried import Carried, all_but
from keyphase.writers.putting import put
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Items, Options, Writer


def _write_json(items: Items, target: Path, options: Options) -> tuple[Path, ...]:
    (item,) = items
    return (put(item, target, as_json(content_of(item, target)), options),)


def _write_csv(items: Items, target: Path, options: Options) -> tuple[Path, ...]:
    (item,) = items
    return (put(item, target, as_csv(content_of(item, target)), options),)


def content_of(item: SegmentedRecording, target: Path) -> dict[str, Any]:
    """What a segment file at `target` holds, as JSON values in their order."""
    file = item.file
    recording = asdict(file.demonstration) | {"path": relative_path(item.recording, target)}
    return {
        "schema_version": SCHEMA_VERSION,
        "software_version": file.software_version,
        "demonstration": recording,
        "parameters": asdict(file.parameters),
        "boundaries": [asdict(boundary) for boundary in file.boundaries],
        "segments": [_segment(segment) for segment in file.segments],
        "plan": list(file.plan),
        **assessment_content(file.assessment),
    }


def _segment(segment: FiledSegment) -> dict[str, Any]:
    values = {name: value for name, value in asdict(segment).items() if name != "assessment"}
    end = end_condition_content(segment.end_condition)
    return {**values, "end_condition": end, **assessment_content(segment.assessment)}


JSON = Writer(
    name="json",
    title="keyphase segment file",
    ending=SUFFIX,
    extra="",
    carries=all_but(Carried.MOTIONS, Carried.SIGNALS),
    write=_write_json,
    reads_back=(
        "import keyphase\n"
        'file = keyphase.read_segment_file("PATH")\n'
        "print([(s.start_s, s.end_s, s.label) for s in file.segments])"
    ),
)

CSV = Writer(
    name="csv",
    title="table of segments",
    ending=".segments.csv",
    extra="",
    carries=frozenset({Carried.NAMES, Carried.TIMES, Carried.DROPPED, Carried.ORDER, Carried.ENDS}),
    write=_write_csv,
    reads_back=(
        "import csv\n"
        'rows = list(csv.DictReader(open("PATH", encoding="utf-8")))\n'
        'print([(row["start_s"], row["end_s"], row["label"]) for row in rows])'
    ),
    remarks=("of end conditions neither time limits nor how far to go on beyond a contact",),
)
