"""Where the recording of a segment file is now."""

from collections.abc import Iterator
from pathlib import Path, PureWindowsPath

from keyphase.errors import SegmentFileError
from keyphase.files.shipped import shipped
from keyphase.labeling.segment_file import SegmentFile, require_same_recording


def recording_of(file: SegmentFile, given: Path | None = None) -> Path:
    """The recording a segment file was made from, with the same numbers in it.

    It is the one given; else that at the path in the segment file; else one of its name beside the
    segment file; else one in the bundled data. Raises SegmentFileError where none is.
    """
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
