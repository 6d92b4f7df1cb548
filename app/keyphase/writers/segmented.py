"""A recording with its segments, as a writer is given it."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from keyphase.demonstration import Demonstration
from keyphase.files.parts import split_part, stem_of
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.recording_of import recording_of
from keyphase.labeling.segment_file import (
    SUFFIX,
    FiledSegment,
    SegmentFile,
    read_segment_file,
    require_same_reading,
    segment_file_of,
)
from keyphase.readers import read
from keyphase.segmentation.end_condition import ContactEnd


@dataclass(frozen=True, eq=False)
class SegmentedRecording:
    """What a segment file says, and the recording it is about.

    recording   its path, in a file of many with its part
    recipe      what it is read with, where its own or its folder's is not it
    held        the demonstration, where it was read already
    """

    file: SegmentFile
    recording: Path
    recipe: Path | None = None
    held: Demonstration | None = None

    @classmethod
    def of_file(
        cls, path: Path, recording: Path | None = None, recipe: Path | None = None
    ) -> "SegmentedRecording":
        """What the segment file at `path` says; its recording is sought as `recording_of` does.

        Raises SegmentFileError for a malformed file or where no such recording is.
        """
        file = read_segment_file(path, check_recording=False)
        return cls(file, recording_of(file, recording), recipe)

    @classmethod
    def of_labeling(cls, labeling: Labeling) -> "SegmentedRecording":
        """The same of what is at work. Raises SegmentFileError where it was never saved."""
        source = labeling.segmentation.demonstration.source
        here = source.path if source else Path(labeling.segmentation.demonstration.name)
        file = segment_file_of(labeling, here.with_name(stem_of(here) + SUFFIX))
        return cls(file, here, held=labeling.segmentation.demonstration)

    @property
    def name(self) -> str:
        """The recording's name without the ending of its file."""
        return stem_of(self.recording)

    @property
    def container(self) -> Path:
        """The file or folder the recording is in."""
        return split_part(self.recording)[0]

    @property
    def part(self) -> str | None:
        """Which recording it is in a file of many."""
        return split_part(self.recording)[1]

    @property
    def segments(self) -> tuple[FiledSegment, ...]:
        """All segments in the order of time."""
        return self.file.segments

    @property
    def kept(self) -> tuple[FiledSegment, ...]:
        """The segments that were not dropped, in the order of time."""
        return tuple(segment for segment in self.file.segments if segment.kept)

    @property
    def planned(self) -> tuple[FiledSegment, ...]:
        """The segments of the plan, in its order."""
        return tuple(self.file.segments[number - 1] for number in self.file.plan)

    def demonstration(self) -> Demonstration:
        """The recording, read anew each time, so that a thousand need the memory of one.

        Raises DemonstrationError where it cannot be read, SegmentFileError where it was segmented
        with another recipe.
        """
        if self.held is not None:
            return self.held
        demonstration = read(self.recording, self.recipe)
        require_same_reading(self.file, demonstration)
        return demonstration

    def labeling(self) -> Labeling:
        """What the segment file says as edits over the segmentation with its parameters."""
        from keyphase.labeling.comparing.taking_over import taking_over
        from keyphase.labeling.label import label
        from keyphase.segmentation import segment

        segmentation = segment(self.demonstration(), self.file.parameters)
        return label(segmentation, {0: taking_over(self.file, segmentation)})

    @cached_property
    def motions(self) -> tuple[str, ...]:
        """What each segment does, in keyphase's own words, whatever a person called it."""
        from keyphase.segmentation import Segmenter

        between = Segmenter(self.demonstration()).segment_between
        return tuple(
            between(segment.start_s, segment.end_s, contact).label
            for segment, contact in zip(self.segments, self._contact_changes, strict=True)
        )

    @property
    def _contact_changes(self) -> tuple[bool, ...]:
        """Whether each segment ends with a contact change."""
        last = isinstance(self.segments[-1].end_condition, ContactEnd)
        return (*(boundary.contact_change for boundary in self.file.boundaries), last)


def found_segment_files(paths: Iterable[Path]) -> tuple[Path, ...]:
    """Segment files among the paths and below folders, each once, sorted within each folder."""
    found: dict[Path, None] = {}
    for path in paths:
        inside = sorted(path.rglob(f"*{SUFFIX}")) if path.is_dir() else [path]
        for one in inside:
            if not any(part.startswith(".") for part in one.relative_to(path).parts):
                found[one] = None
    return tuple(found)
