"""Another person's segment files of the same recordings, and where the two do not agree."""

import threading
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

from keyphase.errors import KeyphaseError, LabelingError
from keyphase.files.parts import stem_of
from keyphase.labeling.comparing.agreement import Disagreement, disagreements
from keyphase.labeling.comparing.comparison import Outline, compare
from keyphase.labeling.segment_file import SUFFIX, SegmentFile, read_segment_file
from keyphase.workbench.grid.stretches import Stretch
from keyphase.workbench.recordings import Recording


class SecondPerson:
    """A folder of segment files with the names of the recordings. For many threads.

    Raises LabelingError where there is no such folder.
    """

    def __init__(self, folder: Path) -> None:
        if not folder.is_dir():
            raise LabelingError(
                f"Expected a folder of another person's segment files, but {folder} is none."
            )
        self._folder, self._lock = folder, threading.Lock()
        self._files: dict[Path, SegmentFile | None] = {}

    def file_of(self, recording: Path) -> SegmentFile | None:
        """What the other person wrote of a recording; None where that cannot be read."""
        path = self._folder / f"{stem_of(recording)}{SUFFIX}"
        with self._lock:
            if path not in self._files:
                self._files[path] = _read(path)
            return self._files[path]

    def counted(self, line: Recording) -> Recording:
        """The line with how often the two differ in what is kept of it; None: not compared."""
        if not line.stretches or (file := self.file_of(line.path)) is None:
            return replace(line, differences=None)
        found = differences(outline_of(line.stretches), Outline.of_file(file))
        return replace(line, differences=len(found))


def differences(own: Outline, other: Outline) -> tuple[Disagreement, ...]:
    """Every moment at which two people differ, in the order of the recording."""
    return tuple(disagreements("", own, other, compare(own, other)))


def outline_of(stretches: tuple[Stretch, ...]) -> Outline:
    """Times and names of a row of the grid."""
    return Outline(
        tuple(later.start_s for _, later in pairwise(stretches)),
        tuple(one.label for one in stretches),
        (stretches[0].start_s, stretches[-1].end_s),
    )


def _read(path: Path) -> SegmentFile | None:
    try:
        return read_segment_file(path, check_recording=False)
    except (KeyphaseError, OSError):
        return None
