"""Segment files written from the page, beside the recordings or where there is room for them."""

from pathlib import Path

from keyphase.errors import RequestError, SegmentFileError
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.segment_file import SUFFIX, segment_file_data
from keyphase.labeling.storage.written_files import IfThere
from keyphase.workbench.exporting.beside import Beside

ENDINGS = {"json": SUFFIX, "csv": str(Path(SUFFIX).with_suffix(".csv"))}


def export(labeling: Labeling, recording: Path, kind: str, if_there: IfThere = "ask") -> Path:
    """Write the segment file of a recording; the path it was written to.

    Raises RequestError for another kind than json or csv, FileInTheWayError where somebody else's
    file would be replaced, SegmentFileError where the folder takes none.
    """
    if kind not in ENDINGS:
        raise RequestError(f"A segment file is json or csv, but not {kind!r}.")
    return Beside(recording, if_there).write(
        ENDINGS[kind], lambda path: segment_file_data(labeling, path), SegmentFileError
    )
