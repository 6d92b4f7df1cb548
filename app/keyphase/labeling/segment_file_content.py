"""From a labeling to what its segment file holds: JSON values and table rows, nothing written."""

import csv
import io
import json
import os
from collections.abc import Iterable
from dataclasses import asdict
from pathlib import Path
from typing import Any

from keyphase import __version__
from keyphase.demonstration import Demonstration
from keyphase.errors import SegmentFileError
from keyphase.labeling.assessment import Assessment
from keyphase.labeling.labeling import LabeledBoundary, LabeledSegment, Labeling
from keyphase.segmentation.end_condition import ContactEnd, EndCondition

SCHEMA_VERSION = 1
"""Version of `segments.schema.json`; a change that old readers cannot follow raises it."""

_DECIMALS = 9

_COLUMNS: tuple[str, ...] = (
    "id",
    "start_s",
    "end_s",
    "label",
    "kept",
    "plan",
    "end_condition",
    "direction_x",
    "direction_y",
    "direction_z",
    "threshold_N",
    "position_tolerance_m",
    "rotation_tolerance_rad",
)


def segment_file_content(labeling: Labeling, path: Path) -> dict[str, Any]:
    """What the segment file of `labeling` at `path` holds, as JSON values in their final order.

    The recording's path is given relative to `path`. Results are rounded to nine decimals, far
    below what they mean, parameters are not. Raises SegmentFileError where the demonstration
    was never read from a file.
    """
    recording = _demonstration(labeling.segmentation.demonstration, path)
    return {
        "schema_version": SCHEMA_VERSION,
        "software_version": f"keyphase {__version__}",
        "demonstration": _rounded(recording),
        "parameters": asdict(labeling.parameters),
        "boundaries": [_rounded(_boundary(b)) for b in labeling.boundaries],
        "segments": [_rounded(_segment(i, s)) for i, s in enumerate(labeling.segments, start=1)],
        "plan": [entry.segment + 1 for entry in labeling.plan],
        **assessment_content(labeling.assessment),
    }


def assessment_content(assessment: Assessment) -> dict[str, Any]:
    """What a person thinks of the recording or a segment, where anybody has said it."""
    said = {name: value for name, value in asdict(assessment).items() if value}
    return {"assessment": said} if said else {}


def as_json(content: dict[str, Any]) -> bytes:
    """The bytes of a segment file."""
    text = json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False)
    # A file name that is no valid UTF-8 holds lone surrogates; as escapes they are valid JSON.
    return f"{text}\n".encode(errors="backslashreplace")


def as_csv(content: dict[str, Any]) -> bytes:
    """The same as a table, one row per segment; `plan` lists its places in the plan, from 1."""
    text = io.StringIO()
    writer = csv.DictWriter(text, _COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(_row(segment, content["plan"]) for segment in content["segments"])
    return text.getvalue().encode(errors="backslashreplace")


def relative_path(recording: Path, segment_file: Path) -> str:
    """`recording` as seen from the folder of `segment_file`, with forward slashes.

    Folders are followed through links. Where no such path exists, as between two drives, it is
    the bare name.
    """
    target = os.path.join(os.path.realpath(recording.parent), recording.name)
    try:
        relative = os.path.relpath(target, os.path.realpath(segment_file.parent))
    except ValueError:
        return recording.name
    return Path(relative).as_posix()


def _demonstration(demonstration: Demonstration, path: Path) -> dict[str, Any]:
    if demonstration.source is None:
        raise SegmentFileError(
            f"{demonstration.name}: a segment file refers to a recording on disk, but this "
            "demonstration was never saved; save it and segment the saved file."
        )
    return {
        "name": demonstration.name,
        "path": relative_path(demonstration.source.path, path),
        "sha256": demonstration.source.sha256,
        "duration_s": demonstration.duration_s,
        "rate_hz": demonstration.rate_hz,
        "recipe": demonstration.source.recipe,
        "recipe_sha256": demonstration.source.recipe_sha256,
        "notices": list(demonstration.notices),
    }


def _boundary(boundary: LabeledBoundary) -> dict[str, Any]:
    return {
        "time_s": boundary.time_s,
        "origin": boundary.origin,
        "interval_s": list(boundary.interval_s),
        "confidence": boundary.confidence,
        "contact_change": boundary.contact_change,
    }


def _segment(number: int, segment: LabeledSegment) -> dict[str, Any]:
    return {
        "id": number,
        "start_s": segment.start_s,
        "end_s": segment.end_s,
        "label": segment.label,
        "kept": segment.kept,
        "end_condition": end_condition_content(segment.end_condition),
        **assessment_content(segment.assessment),
    }


def end_condition_content(end: EndCondition) -> dict[str, Any]:
    """What a reader of the first version needs, then what differs from its defaults."""
    if isinstance(end, ContactEnd):
        values: dict[str, Any] = {
            "kind": "contact",
            "direction": list(end.direction),
            "threshold_N": end.threshold_N,
        }
        values |= {"release": True} if end.release else {}
        values |= {"agrees": end.agrees} if end.agrees is not None else {}
        values |= {"offset_m": end.offset_m} if end.offset_m is not None else {}
    else:
        values = {
            "kind": "configuration",
            "position_tolerance_m": end.position_tolerance_m,
            "rotation_tolerance_rad": end.rotation_tolerance_rad,
        }
        values |= {"gripper": asdict(end.gripper)} if end.gripper is not None else {}
    return values | ({"timeout_s": end.timeout_s} if end.timeout_s is not None else {})


def _rounded(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _rounded(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_rounded(item) for item in value]
    # Zero is added so that a rounded -0.0 is written as 0.0.
    return round(float(value), _DECIMALS) + 0.0 if isinstance(value, float) else value


def _row(segment: dict[str, Any], plan: Iterable[int]) -> dict[str, Any]:
    end = segment["end_condition"]
    directions = dict(zip(_COLUMNS[7:10], end.get("direction", ()), strict=False))
    shared = {key: value for key, value in segment.items() if key in _COLUMNS}
    places = [str(place) for place, id_ in enumerate(plan, start=1) if id_ == segment["id"]]
    numbers = {key: value for key, value in end.items() if key in _COLUMNS}
    kept = "true" if segment["kept"] else "false"
    return {
        **shared,
        **directions,
        **numbers,
        "kept": kept,
        "plan": " ".join(places),
        "end_condition": end["kind"],
    }
