"""MimicGen: `datagen_info` with a term signal for each kept segment but the last.

MimicGen takes the first row at which a signal is 1 for the last row of its subtask.
"""

import re
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Demonstration
from keyphase.errors import ExportError
from keyphase.writers.carried import Carried
from keyphase.writers.copies import copy_of
from keyphase.writers.hdf5.rows import EXTRA, changing, first_rows, put, require_hdf5
from keyphase.writers.names import numbered
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Items, Options, Writer

INFO = "datagen_info"
SIGNALS = "subtask_term_signals"


def _write(items: Items, target: Path, _options: Options) -> tuple[Path, ...]:
    source = items[0].container
    names = signal_names(items)
    with copy_of(source, target) as working, changing(working, source) as file:
        for item in items:
            group = file["data"][item.part or ""]
            info = group.require_group(INFO)
            for name, signal in zip(names, _signals(item, group), strict=True):
                put(info.require_group(SIGNALS), name, signal)
            pose = _poses(item.demonstration())
            if "eef_pose" not in info and pose is not None:
                info["eef_pose"] = pose
    return (target,)


def signal_names(items: Sequence[SegmentedRecording]) -> tuple[str, ...]:
    """A signal for each kept segment but the last, by their names where all call them the same.

    Raises ExportError where the recordings have different numbers of kept segments.
    """
    counts = {len(item.kept): item for item in items}
    if len(counts) > 1 or 0 in counts:
        shown = ", ".join(f"{item.name} has {count}" for count, item in sorted(counts.items()))
        raise ExportError(
            f"MimicGen needs the same number of kept segments in every demonstration, but {shown}; "
            "merge or drop some."
        )
    if _one_order(items):
        plain = [re.sub(r"\W+", "_", segment.label) for segment in items[0].kept[:-1]]
        return tuple(name.replace(" ", "_") for name in numbered(plain))
    return tuple(f"subtask_{i}" for i in range(1, len(items[0].kept)))


def _one_order(items: Sequence[SegmentedRecording]) -> bool:
    return len({tuple(segment.label for segment in item.kept) for item in items}) == 1


def _signals(item: SegmentedRecording, group: Any) -> Iterable[NDArray[np.int64]]:
    """For each kept segment but the last 0 before its last row and 1 from there on."""
    starts, count = first_rows(item, group)
    behind = [*starts[1:], count]
    before = 0
    for segment in item.kept[:-1]:
        last = behind[segment.id - 1] - 1
        if last <= before:
            raise ExportError(
                f"{item.recording}: segment {segment.id}, {segment.label!r}, is shorter than a "
                "row, which MimicGen cannot tell from its neighbours; merge it with one."
            )
        before = last
        yield (np.arange(count) >= last).astype(np.int64)


def _poses(demonstration: Demonstration) -> NDArray[np.float64] | None:
    """The tool's pose (T, 4, 4), where its orientation was recorded."""
    if demonstration.orientation_wxyz is None:
        return None
    from scipy.spatial.transform import Rotation

    poses = np.tile(np.eye(4), (len(demonstration), 1, 1))
    xyzw = np.roll(demonstration.orientation_wxyz, -1, axis=1)
    poses[:, :3, :3] = Rotation.from_quat(xyzw).as_matrix()
    poses[:, :3, 3] = demonstration.position_m
    return poses


def _warn(items: Items, _options: Options) -> Iterable[str]:
    yield f"the term signals are {', '.join(signal_names(items)) or 'none'}"
    if not _one_order(items):
        yield "the demonstrations name their segments differently, so that signals are numbered"


MIMICGEN = Writer(
    name="mimicgen",
    title="MimicGen source dataset with term signals",
    ending="",
    extra=EXTRA,
    carries=frozenset({Carried.NAMES, Carried.SIGNALS}),
    write=_write,
    reads_back=(
        "import h5py\n"
        'demos = h5py.File("PATH")["data"]\n'
        'print({demo: list(demos[demo]["datagen_info/subtask_term_signals"]) for demo in demos '
        'if "datagen_info" in demos[demo]})'
    ),
    one_for="container",
    copies=True,
    requires=lambda item: require_hdf5(item, "MimicGen", "data"),
    module="h5py",
    remarks=(
        "poses of objects and of the controller's target are no part of a recording: what "
        "prepare_src_dataset wrote is kept, and where it wrote nothing only eef_pose is added",
        "MimicGen has no gaps: a dropped segment belongs to the kept one after it",
    ),
    warn=_warn,
)
