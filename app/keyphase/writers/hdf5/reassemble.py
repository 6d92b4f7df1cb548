"""REASSEMBLE: `segments_info`, a group for each segment with its times in the file's clock."""

from pathlib import Path

from keyphase.writers.carried import Carried
from keyphase.writers.clock import zero_s
from keyphase.writers.copies import copy_of
from keyphase.writers.hdf5.rows import EXTRA, changing, require_hdf5
from keyphase.writers.packages import package
from keyphase.writers.writer import Items, Options, Writer

INFO = "segments_info"


def _write(items: Items, target: Path, _options: Options) -> tuple[Path, ...]:
    (item,) = items
    text = package("h5py", EXTRA).string_dtype()
    zero = zero_s(item.recording, item.recipe)
    with copy_of(item.container, target) as working, changing(working, item.container) as file:
        if INFO in file:
            del file[INFO]
        for number, segment in enumerate(item.segments):
            group = file.create_group(f"{INFO}/{number}")
            group["start"] = zero + segment.start_s
            group["end"] = zero + segment.end_s
            group["success"] = segment.kept
            group.create_dataset("text", data=segment.label, dtype=text)
    return (target,)


REASSEMBLE = Writer(
    name="reassemble",
    title="REASSEMBLE file with segments",
    ending="",
    extra=EXTRA,
    carries=frozenset({Carried.NAMES, Carried.TIMES, Carried.DROPPED, Carried.SIGNALS}),
    write=_write,
    reads_back=(
        "import h5py\n"
        'info = h5py.File("PATH")["segments_info"]\n'
        'print([(info[i]["start"][()], info[i]["text"][()].decode()) for i in sorted(info)])'
    ),
    one_for="container",
    copies=True,
    requires=lambda item: require_hdf5(item, "REASSEMBLE", "timestamps"),
    module="h5py",
    remarks=(
        "segments that were in the file are replaced, with their low-level ones",
        "`success` says whether a segment was kept",
    ),
)
