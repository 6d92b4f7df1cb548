"""From a segment file to what is replayed: the recording, checked, and the plan's segments."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from keyphase.demonstration import Demonstration
from keyphase.labeling.recording_of import recording_of
from keyphase.labeling.segment_file import (
    FiledSegment,
    read_segment_file,
    require_same_reading,
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
    recording = recording_of(file, demonstration)
    by_id = {segment.id: segment for segment in file.segments}
    demonstration_read = read(recording, recipe)
    require_same_reading(file, demonstration_read)
    return PlannedReplay(demonstration_read, tuple(by_id[id_] for id_ in file.plan))


def with_configuration_ends(segments: Sequence[FiledSegment]) -> tuple[FiledSegment, ...]:
    """The segments without their force conditions: each is over at its demonstrated pose."""
    return tuple(replace(segment, end_condition=ConfigurationEnd()) for segment in segments)
