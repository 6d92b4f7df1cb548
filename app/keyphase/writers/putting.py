"""Putting a file that was made of a recording where it belongs, never over a stranger's."""

from pathlib import Path

from keyphase.errors import ExportError
from keyphase.labeling.storage.written_files import write_unasked
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Options


def put(item: SegmentedRecording, target: Path, data: bytes, options: Options) -> Path:
    """Write `data`, made of the recording, to `target`; where it now is.

    What keyphase wrote there for the same recording is replaced. Raises FileInTheWayError where
    something else is there, unless the options say what becomes of it; ExportError where the folder
    takes no files.
    """
    made_from, named = item.recording.name, target.name.startswith(item.name)
    ending = target.name.removeprefix(item.name) if named else ""
    return write_unasked(
        target, data, made_from, ExportError, if_there=options.if_there, ending=ending
    )
