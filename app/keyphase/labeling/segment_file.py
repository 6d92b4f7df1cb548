"""Segment files: written whole, and read back only if they are what they claim to be."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any

from keyphase.demonstration import Demonstration
from keyphase.errors import KeyphaseError, LabelingError, SegmentFileError
from keyphase.files.reading import read_regular
from keyphase.files.strict_json import parsed_json, violation
from keyphase.files.writing import write_whole
from keyphase.labeling.assessment import NOTHING_SAID, Assessment
from keyphase.labeling.earlier import parameters_as_meant
from keyphase.labeling.edits import MAX_PLAN_LENGTH, check_label
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.segment_file_content import as_csv, as_json, segment_file_content
from keyphase.readers import fingerprint
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, EndCondition
from keyphase.segmentation.end_condition.values import GripperEnd
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Origin

SUFFIX = ".segments.json"
"""How the names of segment files end."""

MAX_SEGMENTS = 5_000

_LIMIT_BYTES = 64 * 1024**2


@dataclass(frozen=True)
class FiledDemonstration:
    """The recording a segment file is about; `path` is relative to the segment file.

    recipe, recipe_sha256  what it was read with; both None for keyphase's own forms
    notices                what was said when it was read
    """

    name: str
    path: str
    sha256: str
    duration_s: float
    rate_hz: float
    recipe: str | None = None
    recipe_sha256: str | None = None
    notices: tuple[str, ...] = ()


@dataclass(frozen=True)
class FiledBoundary:
    """A boundary as a segment file holds it."""

    time_s: float
    origin: Origin
    interval_s: tuple[float, float]
    confidence: float
    contact_change: bool


@dataclass(frozen=True)
class FiledSegment:
    """A segment as a segment file holds it; `id` counts from 1 in time order."""

    id: int
    start_s: float
    end_s: float
    label: str
    kept: bool
    end_condition: EndCondition
    assessment: Assessment = NOTHING_SAID


@dataclass(frozen=True)
class SegmentFile:
    """What a segment file says; `plan` holds ids of segments."""

    path: Path
    software_version: str
    demonstration: FiledDemonstration
    parameters: Parameters
    boundaries: tuple[FiledBoundary, ...]
    segments: tuple[FiledSegment, ...]
    plan: tuple[int, ...]
    assessment: Assessment = NOTHING_SAID

    @property
    def recording(self) -> Path:
        """Where the recording is expected."""
        return self.path.parent / self.demonstration.path


def schema() -> dict[str, Any]:
    """The published JSON Schema (2020-12) of segment files."""
    text = resources.files("keyphase.labeling").joinpath("segments.schema.json").read_text("utf-8")
    return json.loads(text)


def write_segment_file(labeling: Labeling, path: Path | str) -> None:
    """Write the segment file of `labeling` to `path`, as CSV where the name ends in .csv.

    A crash leaves either the old file or the new one; one that is there is replaced. Raises
    SegmentFileError where the demonstration has no file, or the folder takes none.
    """
    path = Path(path)
    write_whole(path, segment_file_data(labeling, path), refusal=SegmentFileError)


def segment_file_data(labeling: Labeling, path: Path) -> bytes:
    """What the segment file of `labeling` at `path` holds. Raises SegmentFileError likewise."""
    content = segment_file_content(labeling, path)
    return as_csv(content) if path.suffix.lower() == ".csv" else as_json(content)


def segment_file_of(labeling: Labeling, path: Path) -> SegmentFile:
    """What a segment file of `labeling` at `path` says, without writing it.

    Raises SegmentFileError where the demonstration has no file.
    """
    return _parsed(segment_file_content(labeling, path), path)


def read_segment_file(path: Path | str, *, check_recording: bool = True) -> SegmentFile:
    """The segment file at `path`, checked against the schema and against its recording's hash.

    Raises SegmentFileError where it is malformed or contradicts itself, and, unless
    `check_recording` is False, where the recording is missing or no longer the same.
    """
    path = Path(path)
    content = _json(path)
    _refuse_too_many(content, path)
    _check_schema(content, path)
    file = _parsed(content, path)
    _check_consistency(file)
    if check_recording:
        require_same_recording(file, file.recording)
    return file


def require_same_recording(file: SegmentFile, recording: Path) -> None:
    """Raise SegmentFileError unless what is at `recording` is what was segmented."""
    try:
        found = fingerprint(recording)
    except (KeyphaseError, OSError, ValueError) as error:
        raise SegmentFileError(
            f"{file.path}: its recording was expected at {recording}, but cannot be read there; "
            "put it back or segment it again."
        ) from error
    if found != file.demonstration.sha256:
        raise SegmentFileError(
            f"{file.path}: its recording {recording} has changed since (SHA-256 {found[:12]}… "
            f"instead of {file.demonstration.sha256[:12]}…); segment it again."
        )


def require_same_reading(file: SegmentFile, demonstration: Demonstration) -> None:
    """Raise SegmentFileError unless a recording was read as when it was segmented.

    With another recipe the same numbers are another demonstration. Files from before recipes were
    named in them are taken as they are.
    """
    source = demonstration.source
    made_with, now = file.demonstration.recipe_sha256, source.recipe_sha256 if source else None
    known = "keyphase 0.1" not in file.software_version
    if made_with == now or (made_with is None and not known):
        return
    then, today = file.demonstration.recipe, source.recipe if source else None
    if then == today:
        raise SegmentFileError(
            f"{file.path}: it was made of {file.demonstration.name} as read with "
            f"{_called(then)}, which has changed since, or the wrench file it names has; bring "
            "that back, or segment again."
        )
    raise SegmentFileError(
        f"{file.path}: it was made of {file.demonstration.name} as read with {_called(then)}, "
        f"not with {_called(today)}; give that recipe, or segment again."
    )


def _called(recipe: str | None) -> str:
    return f"the recipe {recipe}" if recipe else "no recipe"


def _json(path: Path) -> Any:
    try:
        data = read_regular(path, _LIMIT_BYTES)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise SegmentFileError(
            f"{path}: the segment file cannot be read ({reason}); check the path."
        ) from error
    try:
        return parsed_json(data)
    except ValueError as error:
        raise _no_segment_file(path, data, error) from error


def _no_segment_file(path: Path, data: bytes, error: ValueError) -> SegmentFileError:
    """A damaged one is written again; whoever names a recording or a table is told the way."""
    if path.suffix == ".json" or data.lstrip()[:1] in (b"{", b""):
        return SegmentFileError(
            f"{path}: expected JSON, but it cannot be parsed ({error}); write the file again."
        )
    if path.name.endswith(".segments.csv"):
        return SegmentFileError(
            f"{path}: expected a segment file (*{SUFFIX}), but this is its table, which is only "
            f"written; name {path.with_suffix('.json').name}."
        )
    return SegmentFileError(
        f"{path}: expected a segment file (*{SUFFIX}), but this seems to be a recording; segment "
        f"it first (keyphase segment {path} --output FOLDER) and name what that writes."
    )


def _refuse_too_many(content: Any, path: Path) -> None:
    """Before the schema is checked, which takes a while for each."""
    limits = {"segments": MAX_SEGMENTS, "boundaries": MAX_SEGMENTS, "plan": MAX_PLAN_LENGTH}
    for name, most in limits.items():
        items = content.get(name) if isinstance(content, Mapping) else None
        if isinstance(items, list) and len(items) > most:
            raise SegmentFileError(
                f"{path}: a segment file has at most {most} {name}, but this one has {len(items)}; "
                "divide the recording."
            )


def _check_schema(content: Any, path: Path) -> None:
    broken = violation(content, schema())
    if broken is not None:
        raise SegmentFileError(
            f"{path}: not a segment file of version 1, {broken}; "
            "mend that field or write the file again."
        )


def _parsed(content: Mapping[str, Any], path: Path) -> SegmentFile:
    try:
        return SegmentFile(
            path,
            content["software_version"],
            FiledDemonstration(
                **{
                    **content["demonstration"],
                    "notices": tuple(content["demonstration"].get("notices", ())),
                }
            ),
            Parameters(**parameters_as_meant(content["parameters"])),
            tuple(_boundary(item) for item in content["boundaries"]),
            tuple(_segment(item) for item in content["segments"]),
            tuple(content["plan"]),
            Assessment(**content.get("assessment", {})),
        )
    except (KeyphaseError, ArithmeticError, TypeError, ValueError) as error:
        raise SegmentFileError(f"{path}: {error}; write the file again.") from error


def _boundary(item: Mapping[str, Any]) -> FiledBoundary:
    early, late = item["interval_s"]
    return FiledBoundary(**{**item, "interval_s": (early, late)})


def _segment(item: Mapping[str, Any]) -> FiledSegment:
    values = {key: value for key, value in item["end_condition"].items() if key != "kind"}
    if item["end_condition"]["kind"] == "contact":
        condition: EndCondition = ContactEnd(**{**values, "direction": tuple(values["direction"])})
    else:
        grip = values.pop("gripper", None)
        condition = ConfigurationEnd(**values, gripper=GripperEnd(**grip) if grip else None)
    said = Assessment(**item.get("assessment", {}))
    return FiledSegment(**{**item, "end_condition": condition, "assessment": said})


def _check_consistency(file: SegmentFile) -> None:
    """What a schema cannot say: order, tiling, and that the plan names kept segments."""
    times = [boundary.time_s for boundary in file.boundaries]
    starts = [segment.start_s for segment in file.segments]
    ends = [segment.end_s for segment in file.segments]
    if [segment.id for segment in file.segments] != list(range(1, len(ends) + 1)):
        raise _contradiction(file, "segment ids must count 1, 2, … in time order")
    if starts[1:] != times or ends[:-1] != times:
        raise _contradiction(file, "neighbouring segments must meet at the boundaries")
    if any(end <= start for start, end in zip(starts, ends, strict=True)):
        raise _contradiction(file, "times must ascend from segment to segment")
    if any(b.interval_s[0] > b.interval_s[1] for b in file.boundaries):
        raise _contradiction(file, "interval_s must be ascending")
    for segment in file.segments:
        try:
            check_label(segment.label)
        except LabelingError as error:
            raise SegmentFileError(f"{file.path}: segment {segment.id}: {error}") from error
    kept = {segment.id for segment in file.segments if segment.kept}
    if not kept.issuperset(file.plan):
        unknown = next(id_ for id_ in file.plan if id_ not in kept)
        raise _contradiction(file, f"the plan may name kept segments only, but names {unknown}")


def _contradiction(file: SegmentFile, rule: str) -> SegmentFileError:
    return SegmentFileError(f"{file.path}: {rule}; write the file again.")
