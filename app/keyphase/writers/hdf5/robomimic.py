"""robomimic: filter keys in `mask/`, and which segment each row belongs to."""

import json
from pathlib import Path

import numpy as np

from keyphase.writers.carried import Carried
from keyphase.writers.copies import copy_of
from keyphase.writers.hdf5.rows import EXTRA, changing, first_rows, put, require_hdf5
from keyphase.writers.writer import Items, Options, Writer

SEGMENTED = "segmented"
"""The filter key of all demonstrations that have segments."""

ROWS = "segment_id"
NAMES = "segment_names"


def _write(items: Items, target: Path, _options: Options) -> tuple[Path, ...]:
    source = items[0].container
    masks: dict[str, list[str]] = {SEGMENTED: []}
    with copy_of(source, target) as working, changing(working, source) as file:
        for item in items:
            part = item.part or ""
            group = file["data"][part]
            starts, count = first_rows(item, group)
            edges = np.searchsorted(starts, np.arange(count), side="right") - 1
            put(group, ROWS, edges.astype(np.int64))
            group.attrs[NAMES] = json.dumps([segment.label for segment in item.segments])
            masks[SEGMENTED].append(part)
            for name in dict.fromkeys(segment.label for segment in item.kept):
                masks.setdefault(key_of(name), []).append(part)
        for key, parts in masks.items():
            put(file.require_group("mask"), key, np.array(parts, dtype="S"))
    return (target,)


def key_of(name: str) -> str:
    """The filter key of the demonstrations in which a segment of that name was kept."""
    return f"has_{name.replace('/', '_')}"


ROBOMIMIC = Writer(
    name="robomimic",
    title="robomimic file with filter keys",
    ending="",
    extra=EXTRA,
    carries=frozenset({Carried.NAMES, Carried.SIGNALS}),
    write=_write,
    reads_back=(
        "import h5py\n"
        'masks = h5py.File("PATH")["mask"]\n'
        "print({key: [part.decode() for part in masks[key]] for key in masks})"
    ),
    one_for="container",
    copies=True,
    requires=lambda item: require_hdf5(item, "robomimic", "data"),
    module="h5py",
    remarks=(
        "a filter key chooses whole demonstrations: `segmented`, and `has_NAME` for each name that "
        "was kept; the rows of segments are in data/demo_N/segment_id, which robomimic passes over",
    ),
)
