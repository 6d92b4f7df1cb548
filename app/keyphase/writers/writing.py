"""`write`: segments in any format with one call."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from keyphase.labeling.label import label
from keyphase.labeling.labeling import Labeling
from keyphase.segmentation.segmentation import Segmentation
from keyphase.writers.exporting import planned_export
from keyphase.writers.segmented import SegmentedRecording, found_segment_files
from keyphase.writers.writer import Options

Segmented = Labeling | Segmentation | Path | str
"""What can be written: what is at work, or a segment file, or a folder of them."""


def write(
    segmented: Segmented | Sequence[Segmented],
    to: str,
    output: Path | str,
    *,
    trim_idle: bool = False,
    replace: bool = False,
) -> tuple[Path, ...]:
    """Write segments in the format `to` (docs/exports.md has the list); the files written.

    `segmented` is one labeling, segmentation or segment file, or several. Recordings of one dataset
    come together where the format is a copy of it. `output` is a folder, or the file's path where
    one comes of it. What a format cannot carry is in `keyphase.writers.planned_export(…)`.

    Raises ExportError for an unknown format and where the format cannot hold them,
    FileInTheWayError for something there that keyphase did not write, unless `replace`;
    MissingPackageError where the format's package is not installed.
    """
    several = [segmented] if isinstance(segmented, Segmented) else segmented
    items = [item for one in several for item in _items(one)]
    options = Options(trim_idle=trim_idle, if_there="replace" if replace else "ask")
    planned = planned_export(items, to, Path(output), options)
    return tuple(path for paths in planned.write() for path in paths)


def _items(one: Segmented) -> Iterable[SegmentedRecording]:
    if isinstance(one, Segmentation):
        return [SegmentedRecording.of_labeling(label(one))]
    if isinstance(one, Labeling):
        return [SegmentedRecording.of_labeling(one)]
    return [SegmentedRecording.of_file(file) for file in found_segment_files([Path(one)])]
