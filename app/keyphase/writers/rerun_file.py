"""Rerun: the segments as a state timeline over the tool's path and the recorded signals."""

from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.writers.carried import Carried
from keyphase.writers.packages import package
from keyphase.writers.putting import put
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Items, Options, Writer

EXTRA = "rerun"
NAMES, MOTIONS, KEPT = "segments/name", "segments/motion", "segments/kept"
TIMELINE = "recording"
"""The timeline everything is on: seconds of the recording."""


def _write(items: Items, target: Path, options: Options) -> tuple[Path, ...]:
    (item,) = items
    rerun = package("rerun", EXTRA)
    identity = item.file.demonstration.sha256
    stream = rerun.RecordingStream("keyphase", recording_id=identity, send_properties=False)
    with TemporaryDirectory() as folder:
        written = Path(folder) / "recording.rrd"
        stream.save(str(written))
        demonstration = item.demonstration()
        _send_segments(rerun, stream, item)
        _send_path(rerun, stream, item, demonstration)
        _send_signals(rerun, stream, demonstration)
        stream.flush()
        stream.disconnect()
        return (put(item, target, written.read_bytes(), options),)


def _send_segments(rerun: Any, stream: Any, item: SegmentedRecording) -> None:
    starts = np.array([segment.start_s for segment in item.segments])
    states: dict[str, Sequence[str]] = {
        NAMES: [segment.label for segment in item.segments],
        MOTIONS: item.motions,
        KEPT: ["kept" if segment.kept else "dropped" for segment in item.segments],
    }
    for entity, state in states.items():
        columns = rerun.StateChange.columns(state=list(state))
        stream.send_columns(entity, indexes=[_clock(rerun, starts)], columns=columns)


def _send_path(
    rerun: Any, stream: Any, item: SegmentedRecording, demonstration: Demonstration
) -> None:
    """The tool over time, and a line for each segment, which is there at all times."""
    pose = {"translation": demonstration.position_m}
    if demonstration.orientation_wxyz is not None:
        pose["quaternion"] = np.roll(demonstration.orientation_wxyz, -1, axis=1)
    columns = rerun.Transform3D.columns(**pose)
    stream.send_columns("tool", indexes=[_clock(rerun, demonstration.time_s)], columns=columns)
    times = demonstration.time_s
    for segment in item.segments:
        first, last = np.searchsorted(times, (segment.start_s, segment.end_s)).tolist()
        strip = demonstration.position_m[first : last + 1]
        if len(strip) > 1:
            line = rerun.LineStrips3D([strip], labels=[segment.label], show_labels=False)
            stream.log(f"path/{segment.id}", line, static=True)


def _send_signals(rerun: Any, stream: Any, demonstration: Demonstration) -> None:
    clock = _clock(rerun, demonstration.time_s)
    channels: dict[str, Array | None] = {
        "force_N": demonstration.force_N,
        "torque_Nm": demonstration.torque_Nm,
    }
    for name, values in channels.items():
        for at, axis in enumerate("xyz") if values is not None else ():
            columns = rerun.Scalars.columns(scalars=np.asarray(values)[:, at])
            stream.send_columns(f"{name}/{axis}", indexes=[clock], columns=columns)
    if demonstration.gripper is not None:
        columns = rerun.Scalars.columns(scalars=demonstration.gripper)
        stream.send_columns("gripper", indexes=[clock], columns=columns)


def _clock(rerun: Any, seconds: Array) -> Any:
    return rerun.TimeColumn(TIMELINE, duration=seconds)


RERUN = Writer(
    name="rerun",
    title="Rerun recording",
    ending=".rrd",
    extra=EXTRA,
    module="rerun",
    carries=frozenset(
        {Carried.NAMES, Carried.MOTIONS, Carried.TIMES, Carried.DROPPED, Carried.SIGNALS}
    ),
    write=_write,
    reads_back=(
        "from rerun.chunk import RrdReader\n"
        'chunks = {chunk.entity_path: chunk for chunk in RrdReader("PATH").stream()}\n'
        'print(chunks["/segments/name"].to_record_batch()["StateChange:state"].to_pylist())'
    ),
    remarks=(
        "Rerun numbers its rows by the time of writing, so that the bytes differ from one writing "
        "to the next",
    ),
)
