"""ELAN, Label Studio, Rerun and MCAP: each file opened by the format's own package and compared."""

import json
from xml.etree import ElementTree

import numpy as np
import pympi
import pytest
from jsonschema import Draft202012Validator
from mcap.reader import make_reader
from mcap.writer import Writer as McapWriter
from rerun.chunk import RrdReader
from segmented_recordings import EDGES_S, KEPT, NAMES, item, moving

from keyphase.writers import SegmentedRecording, planned_export


@pytest.fixture(scope="module")
def one(tmp_path_factory):
    return item(tmp_path_factory.mktemp("one"))


def export(item, to, output):
    (paths,) = planned_export([item], to, output).write()
    return paths


def test_elan_shows_names_motions_and_what_was_dropped(one, tmp_path):
    (path,) = export(one, "elan", tmp_path)
    document = pympi.Elan.Eaf(str(path))
    names = [(a, b, name) for a, b, name in document.get_annotation_data_for_tier("segments")]
    spans = zip(EDGES_S[:-1], EDGES_S[1:], NAMES, strict=True)
    assert sorted(names) == [(round(1e3 * a), round(1e3 * b), name) for a, b, name in spans]
    kept = sorted(document.get_annotation_data_for_tier("kept"))
    assert [value == "kept" for *_, value in kept] == list(KEPT)
    motions = [value for *_, value in sorted(document.get_annotation_data_for_tier("motions"))]
    assert motions == list(one.motions)
    again = tmp_path / "again"
    assert export(one, "elan", again)[0].read_bytes() == path.read_bytes()


TASK = {
    "type": "array",
    "items": {
        "type": "object",
        "required": ["data"],
        "properties": {
            "data": {"type": "object"},
            "annotations": {
                "type": "array",
                "items": {
                    "type": "object",
                    "required": ["result"],
                    "properties": {
                        "result": {
                            "type": "array",
                            "items": {
                                "type": "object",
                                "required": ["id", "from_name", "to_name", "type", "value"],
                                "properties": {
                                    "type": {"const": "timeserieslabels"},
                                    "value": {
                                        "type": "object",
                                        "required": ["start", "end", "timeserieslabels"],
                                        "properties": {
                                            "instant": {"type": "boolean"},
                                            "timeserieslabels": {
                                                "type": "array",
                                                "items": {"type": "string"},
                                            },
                                        },
                                    },
                                },
                            },
                        }
                    },
                },
            },
        },
    },
}
"""Label Studio's task format, as far as its documentation says it."""


def test_label_studio_takes_the_task_and_its_set_up_names_what_the_task_uses(one, tmp_path):
    path, setup = export(one, "label-studio", tmp_path)
    tasks = json.loads(path.read_text())
    Draft202012Validator(TASK).validate(tasks)
    results = tasks[0]["annotations"][0]["result"]
    assert [r["value"]["timeserieslabels"] for r in results] == [[name] for name in NAMES]
    assert [r["value"]["start"] for r in results] == list(EDGES_S[:-1])
    view = ElementTree.parse(setup).getroot()
    control, shown = view.find("TimeSeriesLabels"), view.find("TimeSeries")
    assert {r["from_name"] for r in results} == {control.get("name")}
    assert {r["to_name"] for r in results} == {shown.get("name"), control.get("toName")}
    assert {label.get("value") for label in control} == set(NAMES)
    series = tasks[0]["data"][shown.get("value").removeprefix("$")]
    assert {channel.get("column") for channel in shown} == set(series) - {shown.get("timeColumn")}
    np.testing.assert_array_equal(series["force_z"], moving()[3][:, 2])


def test_rerun_has_a_state_timeline_the_path_and_the_signals(one, tmp_path):
    (path,) = export(one, "rerun", tmp_path)
    chunks = {c.entity_path: c.to_record_batch() for c in RrdReader(path).stream()}
    names = chunks["/segments/name"]
    assert [state for (state,) in names["StateChange:state"].to_pylist()] == list(NAMES)
    nanoseconds = names["recording"].cast("int64").to_pylist()
    assert nanoseconds == [round(1e9 * at) for at in EDGES_S[:-1]]
    force = np.ravel(chunks["/force_N/z"]["Scalars:scalars"].to_pylist())
    np.testing.assert_array_equal(force, moving()[3][:, 2])
    place = np.reshape(chunks["/tool"]["Transform3D:translation"].to_pylist(), (-1, 3))
    np.testing.assert_allclose(place, moving()[1], rtol=1e-6)
    assert chunks["/path/2"]["LineStrips3D:labels"].to_pylist() == [["insert"]]


def recorded_mcap(path):
    """Pose and wrench as JSON messages, an attachment and a metadata record."""
    time, position, _, force = moving()
    with path.open("wb") as stream:
        writer = McapWriter(stream)
        writer.start()
        schema = writer.register_schema("pose", "jsonschema", b'{"type": "object"}')
        channels = [
            writer.register_channel("/pose", "json", schema),
            writer.register_channel("/raw", "bytes", 0, {"made": "by hand"}),
        ]
        for row, at in enumerate(time):
            stamp = 1_700_000_000_000_000_000 + round(1e9 * at)
            data = json.dumps({"z": position[row, 2], "f": force[row, 2]}).encode()
            for channel in channels:
                writer.add_message(channel, stamp, data, stamp, row)
        writer.add_attachment(1, 1, "notes.txt", "text/plain", b"a note")
        writer.add_metadata("robot", {"arm": "left"})
        writer.finish()


BY_THE_LOG = """
time = {column = "/pose.log_time", unit = "s"}
position = {columns = ["/pose.z", "/pose.z", "/pose.z"], unit = "m"}
"""


def test_mcap_has_the_segments_beside_every_recorded_message(one, tmp_path):
    recording = tmp_path / "run.mcap"
    recorded_mcap(recording)
    (tmp_path / "run.mcap.recipe.toml").write_text(BY_THE_LOG)
    beside = SegmentedRecording(one.file, recording, held=one.held)
    (path,) = export(beside, "mcap", tmp_path / "out")
    assert messages(path, ["/pose", "/raw"]) == messages(recording, ["/pose", "/raw"])
    segments = messages(path, ["/keyphase/segment"])
    read = [(at - 1_700_000_000_000_000_000, json.loads(data)) for _, at, data, _ in segments]
    assert [(at, one["name"]) for at, one in read] == [
        (round(1e9 * at), name) for at, name in zip(EDGES_S[:-1], NAMES, strict=True)
    ]
    with path.open("rb") as stream:
        reader = make_reader(stream)
        attached = {one.name: one.data for one in reader.iter_attachments()}
        assert attached["notes.txt"] == b"a note"
        assert json.loads(attached["run.segments.json"])["plan"] == [1, 2, 4]
        assert [m.metadata for m in reader.iter_metadata()] == [{"arm": "left"}]


def messages(path, topics):
    with path.open("rb") as stream:
        found = make_reader(stream).iter_messages(topics=topics)
        return [(c.topic, m.log_time, m.data, m.sequence) for _, c, m in found]


def test_mcap_of_another_recording_says_that_the_signals_are_not_in_it(one, tmp_path):
    planned = planned_export([one], "mcap", tmp_path)
    assert any("signals" in remark for remark in planned.remarks)
