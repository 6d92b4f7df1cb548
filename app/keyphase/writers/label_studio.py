"""Label Studio: a task to import with its time series inside, the labelling set-up beside it."""

import json
from pathlib import Path
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from keyphase.demonstration import Array, Demonstration
from keyphase.writers.carried import Carried
from keyphase.writers.putting import put
from keyphase.writers.segmented import SegmentedRecording
from keyphase.writers.writer import Items, Options, Writer

ENDING = ".label-studio.json"
SETUP_ENDING = ".label-studio.xml"
SERIES = "series"
_LABELS, _SHOWN = "segment", "recording"


def _write(items: Items, target: Path, options: Options) -> tuple[Path, ...]:
    (item,) = items
    columns = _columns(item.demonstration())
    text = json.dumps([_task(item, columns)], ensure_ascii=False, allow_nan=False, indent=1)
    put(item, target, text.encode(), options)
    setup = target.with_name(f"{target.name.removesuffix('.json')}.xml")
    put(item, setup, _setup(item, columns), options)
    return (target, setup)


def _columns(demonstration: Demonstration) -> dict[str, Array]:
    """Time and the signals that are shown, by name."""
    columns = {"time": demonstration.time_s}
    for name, values in (("position", demonstration.position_m), ("force", demonstration.force_N)):
        if values is not None:
            columns |= {f"{name}_{axis}": values[:, i] for i, axis in enumerate("xyz")}
    return columns


def _task(item: SegmentedRecording, columns: dict[str, Array]) -> dict[str, Any]:
    series = {name: values.tolist() for name, values in columns.items()}
    results = [
        {
            "id": f"segment-{segment.id}",
            "from_name": _LABELS,
            "to_name": _SHOWN,
            "type": "timeserieslabels",
            "value": {
                "start": segment.start_s,
                "end": segment.end_s,
                "instant": False,
                "timeserieslabels": [segment.label],
            },
            "meta": {"text": [motion] if segment.kept else [motion, "dropped"]},
        }
        for segment, motion in zip(item.segments, item.motions, strict=True)
    ]
    data = {SERIES: series, "recording": item.recording.name}
    return {"data": data, "annotations": [{"result": results}]}


def _setup(item: SegmentedRecording, columns: dict[str, Array]) -> bytes:
    """The labelling interface: the signals, and the names there are."""
    view = Element("View")
    labels = SubElement(view, "TimeSeriesLabels", name=_LABELS, toName=_SHOWN)
    for name in dict.fromkeys(segment.label for segment in item.segments):
        SubElement(labels, "Label", value=name)
    shown = SubElement(
        view,
        "TimeSeries",
        name=_SHOWN,
        value=f"${SERIES}",
        valueType="json",
        timeColumn="time",
        timeDisplayFormat=".2f",
    )
    for name in columns:
        if name != "time":
            SubElement(shown, "Channel", column=name, units="N" if "force" in name else "m")
    ElementTree.indent(view)
    return ElementTree.tostring(view, encoding="utf-8") + b"\n"


LABEL_STUDIO = Writer(
    name="label-studio",
    title="Label Studio task",
    ending=ENDING,
    extra="",
    carries=frozenset(
        {Carried.NAMES, Carried.MOTIONS, Carried.TIMES, Carried.DROPPED, Carried.SIGNALS}
    ),
    write=_write,
    reads_back=(
        "import json\n"
        '(task,) = json.load(open("PATH", encoding="utf-8"))\n'
        'print([one["value"] for one in task["annotations"][0]["result"]])'
    ),
    remarks=("of the signals position and force; the set-up lies beside it, *.label-studio.xml",),
)
