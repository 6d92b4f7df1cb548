"""Segment files written from the page, beside the recordings or where there is room for them."""

import os
from pathlib import Path

from keyphase.errors import RequestError
from keyphase.files.parts import stem_of
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.segment_file import SUFFIX, write_segment_file


def export(labeling: Labeling, recording: Path, kind: str) -> Path:
    """Write the segment file of a recording; the path it was written to.

    It stands beside the recording, or, where nothing may be written there, in the current folder.
    Raises RequestError for another kind than json or csv, SegmentFileError where neither folder
    can be written.
    """
    if kind not in ("json", "csv"):
        raise RequestError(f"A segment file is json or csv, but not {kind!r}.")
    name = stem_of(recording) + SUFFIX
    folder = recording.parent if os.access(recording.parent, os.W_OK) else Path.cwd()
    path = folder / (name if kind == "json" else Path(name).with_suffix(".csv"))
    write_segment_file(labeling, path)
    return path
