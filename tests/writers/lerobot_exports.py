"""Exports of a LeRobot dataset of which the first and third episode are segmented."""

import json
from pathlib import Path

from segmented_recordings import with_segment_file

from keyphase.files.parts import with_part
from keyphase.writers import Options, SegmentedRecording, planned_export

LABELED = (0, 2)


def segment_files(path: Path, kept=None):
    """Segment files beside the dataset; `kept` says of each of the four segments whether it is."""
    files = []
    for number in LABELED:
        file = with_segment_file(path.parent, with_part(path, f"episode_{number}"))
        content = json.loads(file.read_text())
        if kept is not None:
            for one, keep in zip(content["segments"], kept, strict=True):
                one["kept"] = keep
            content["plan"] = [one["id"] for one in content["segments"] if one["kept"]]
            file.write_text(json.dumps(content))
        files.append(file)
    return files


def items(path: Path, kept=None):
    """The same as writers are given them."""
    return [SegmentedRecording.of_file(file) for file in segment_files(path, kept)]


def exported(path: Path, output: Path, to="lerobot", **options) -> Path:
    """The copy of the dataset in the folder `output`."""
    ((written,),) = planned_export(items(path), to, output, Options(**options)).write()
    return written


def trimmed(path: Path, output: Path) -> Path:
    """The copy without the first and the last segment of its labelled episodes."""
    dropped = items(path, kept=(False, True, True, False))
    planned = planned_export(dropped, "lerobot", output, Options(trim_idle=True))
    ((written,),) = planned.write()
    return written
