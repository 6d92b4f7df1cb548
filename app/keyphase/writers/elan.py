"""ELAN: tiers of annotations in milliseconds, one with names, one with what the segments do."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from keyphase.writers.carried import Carried
from keyphase.writers.packages import package
from keyphase.writers.putting import put
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Items, Options, Writer

EXTRA = "elan"
NAMES, MOTIONS, KEPT = "segments", "motions", "kept"
_AUTHOR = "keyphase"
_DATE = "1970-01-01T00:00:00+00:00"
"""A date that is the same whenever it is written, so that the bytes are, too."""


def _write(items: Items, target: Path, options: Options) -> tuple[Path, ...]:
    (item,) = items
    document = _document(item)
    with TemporaryDirectory() as folder:
        written = Path(folder) / "document.eaf"
        document.to_file(str(written))
        return (put(item, target, written.read_bytes(), options),)


def _document(item: SegmentedRecording) -> Any:
    document = package("pympi", EXTRA).Elan.Eaf(author=_AUTHOR)
    document.adocument["DATE"] = _DATE
    document.remove_tier("default")
    tiers = {
        NAMES: [segment.label for segment in item.segments],
        MOTIONS: item.motions,
        KEPT: ["kept" if segment.kept else "dropped" for segment in item.segments],
    }
    start = item.segments[0].start_s
    for tier, values in tiers.items():
        document.add_tier(tier)
        for segment, value in zip(item.segments, values, strict=True):
            begin, end = (round(1e3 * (t - start)) for t in (segment.start_s, segment.end_s))
            if end > begin:
                document.add_annotation(tier, begin, end, value)
    return document


ELAN = Writer(
    name="elan",
    title="ELAN annotation file",
    ending=".eaf",
    extra=EXTRA,
    module="pympi",
    carries=frozenset({Carried.NAMES, Carried.MOTIONS, Carried.DROPPED}),
    write=_write,
    reads_back=(
        "import pympi\n"
        'document = pympi.Elan.Eaf("PATH")\n'
        'print(document.get_annotation_data_for_tier("segments"))'
    ),
    remarks=("times are whole milliseconds from the recording's first sample",),
)
