"""From a segment file to what is replayed: the recording, checked, and the plan's segments."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path, PureWindowsPath

from keyphase.demonstration import Demonstration
from keyphase.errors import SegmentFileError
from keyphase.files.shipped import shipped
from keyphase.labeling.segment_file import (
    FiledSegment,
    SegmentFile,
    read_segment_file,
    require_same_reading,
    require_same_recording,
)
from keyphase.readers import read
from keyphase.segmentation.end_condition import ConfigurationEnd


@dataclass(frozen=True)
class PlannedReplay:
    """A demonstration and the segments of its plan, in the order they are executed."""

    demonstration: Demonstration
    segments: tuple[FiledSegment, ...]


def planned_replay(
    segment_file: Path, demonstration: Path | None = None, recipe: Path | None = None
) -> PlannedReplay:
    """What a segment file plans, over the recording it was made from.

    The recording is the one given; else that at the path in the segment file; else one of its name
    beside the segment file; else one in the bundled data. Its bytes, and the recipe they are
    read with, must be those that were segmented. Raises SegmentFileError where none is,
    DemonstrationError where it cannot be read.
    """
    file = read_segment_file(segment_file, check_recording=False)
    recording = _recording(file, demonstration)
    by_id = {segment.id: segment for segment in file.segments}
    demonstration_read = read(recording, recipe)
    require_same_reading(file, demonstration_read)
    return PlannedReplay(demonstration_read, tuple(by_id[id_] for id_ in file.plan))


def with_configuration_ends(segments: Sequence[FiledSegment]) -> tuple[FiledSegment, ...]:
    """The segments without their force conditions: each is over at its demonstrated pose."""
    return tuple(replace(segment, end_condition=ConfigurationEnd()) for segment in segments)


def _recording(file: SegmentFile, given: Path | None) -> Path:
    """Where the recording with the right bytes is; the first refusal where there is none."""
    refusals: list[SegmentFileError] = []
    for candidate in [given] if given is not None else _candidates(file):
        try:
            require_same_recording(file, candidate)
        except SegmentFileError as refusal:
            refusals.append(refusal)
        else:
            return candidate
    raise refusals[0]


def _candidates(file: SegmentFile) -> Iterator[Path]:
    # The name is the last part of the path on either system's terms.
    name = PureWindowsPath(file.demonstration.path).name
    yield file.recording
    yield file.path.parent / name
    yield shipped("data") / name
