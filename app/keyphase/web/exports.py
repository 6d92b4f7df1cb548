"""Segment files written from the page, beside the recordings or where there is room for them."""

import os
from pathlib import Path
from typing import Literal

from keyphase.labeling.labeling import Labeling
from keyphase.labeling.segment_file import SUFFIX, write_segment_file

Format = Literal["json", "csv"]


def export(labeling: Labeling, recording: Path, kind: Format) -> Path:
    """Write the segment file of a recording; the path it was written to.

    It stands beside the recording, or, where nothing may be written there, in the current folder.
    Raises SegmentFileError where neither can be written.
    """
    name = recording.stem + SUFFIX
    folder = recording.parent if os.access(recording.parent, os.W_OK) else Path.cwd()
    path = folder / (name if kind == "json" else Path(name).with_suffix(".csv"))
    write_segment_file(labeling, path)
    return path
