"""Segment files hold what was labeled, and are read back only if they are what they claim."""

import csv
import json
import os
from dataclasses import replace
from typing import get_args

import jsonschema
import pytest
from handmade import Person, demonstration, described, labels, segmentation

from keyphase.errors import SegmentFileError
from keyphase.labeling.edits import Contact, Keep, Label, Plan
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import (
    read_segment_file,
    schema,
    write_segment_file,
)
from keyphase.labeling.segment_file_content import segment_file_content
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Origin, Segment


@pytest.fixture
def labeled(tmp_path):
    made_from = demonstration(path=tmp_path / "demo.npz")
    person = Person(segmentation((2.0, 4.0), made_from=made_from))
    return person.makes(Label(1.0, "insert “peg”"), Keep(3.0, False), Plan((9.0, 1.0, 9.0)))


@pytest.fixture
def written(labeled, tmp_path):
    path = tmp_path / "out" / "demo.segments.json"
    path.parent.mkdir()
    write_segment_file(labeled, path)
    return path


def rewrite(path, change):
    content = json.loads(path.read_bytes())
    change(content)
    path.write_text(json.dumps(content))
    return path


def test_the_schema_is_a_schema_and_the_file_keeps_to_it(written):
    jsonschema.Draft202012Validator.check_schema(schema())
    jsonschema.validate(json.loads(written.read_bytes()), schema())


def test_what_is_written_is_read_back(written, labeled):
    file = read_segment_file(written)
    assert file.demonstration.name == "demo"
    assert file.demonstration.path == "../demo.npz"
    assert file.demonstration.duration_s == 10.0
    assert file.demonstration.rate_hz == 100.0
    assert file.parameters == Parameters()
    assert [b.time_s for b in file.boundaries] == [2.0, 4.0]
    assert file.boundaries[0].interval_s == (1.95, 2.05)
    assert [s.id for s in file.segments] == [1, 2, 3]
    assert [s.label for s in file.segments] == labels(labeled)
    assert [s.kept for s in file.segments] == [True, False, True]
    end = file.segments[0].end_condition
    assert isinstance(end, ConfigurationEnd)
    assert end.rotation_tolerance_rad == pytest.approx(ConfigurationEnd().rotation_tolerance_rad)
    assert file.plan == (3, 1, 3)


def test_fields_are_the_published_ones_and_no_more(written):
    content = json.loads(written.read_bytes())
    assert list(content) == [
        "schema_version",
        "software_version",
        "demonstration",
        "parameters",
        "boundaries",
        "segments",
        "plan",
    ]
    assert list(content["boundaries"][0]) == [
        "time_s",
        "origin",
        "interval_s",
        "confidence",
        "contact_change",
    ]
    assert list(content["segments"][0]) == [
        "id",
        "start_s",
        "end_s",
        "label",
        "kept",
        "end_condition",
    ]


def test_a_contact_end_condition_is_read_back(tmp_path):
    made_from = demonstration(path=tmp_path / "demo.npz")
    person = Person(segmentation((2.0,), made_from=made_from))
    contact = ContactEnd((0.0, 0.6, 0.8), 1.25)

    def until_contact(start_s, end_s, contact_change):
        return Segment(start_s, end_s, "press", False, contact)

    person.makes(Contact(2.0, True))
    path = tmp_path / "demo.segments.json"
    write_segment_file(label(person.segmentation, person.document.edits, until_contact), path)
    assert json.loads(path.read_bytes())["segments"][0]["end_condition"] == {
        "kind": "contact",
        "direction": [0.0, 0.6, 0.8],
        "threshold_N": 1.25,
    }
    assert read_segment_file(path).segments[0].end_condition == contact


def test_a_boundary_of_every_origin_is_read_back(tmp_path):
    made_from = demonstration(path=tmp_path / "demo.npz")
    origins = get_args(Origin)
    found = segmentation(tuple(1.0 + k for k in range(len(origins))), made_from=made_from)
    boundaries = tuple(
        replace(one, origin=origin) for one, origin in zip(found.boundaries, origins, strict=True)
    )
    path = tmp_path / "demo.segments.json"
    write_segment_file(label(replace(found, boundaries=boundaries)), path)
    assert tuple(one.origin for one in read_segment_file(path).boundaries) == origins


def test_the_same_labeling_gives_the_same_bytes(labeled, written, tmp_path):
    again = tmp_path / "out" / "again.segments.json"
    write_segment_file(labeled, again)
    assert again.read_bytes() == written.read_bytes()


def test_numbers_have_nine_decimals_and_no_negative_zero(tmp_path):
    made_from = demonstration(path=tmp_path / "demo.npz")
    labeled = label(segmentation((1 / 3, 0.1 + 0.2 + 1), made_from=made_from), {}, described)
    content = segment_file_content(labeled, tmp_path / "x.segments.json")
    assert [b["time_s"] for b in content["boundaries"]] == [0.333333333, 1.3]
    assert "-0.0" not in json.dumps(content)


def test_parameters_are_written_as_they_are(tmp_path):
    made_from = demonstration(path=tmp_path / "demo.npz")
    parameters = Parameters(measurement_noise=1.23456789e-11, gaussians=4)
    found = segmentation((2.0,), made_from=made_from, parameters=parameters)
    write_segment_file(label(found), tmp_path / "demo.segments.json")
    assert read_segment_file(tmp_path / "demo.segments.json").parameters == parameters


def test_as_csv_each_segment_is_a_row(labeled, tmp_path):
    path = tmp_path / "demo.segments.csv"
    write_segment_file(labeled, path)
    with path.open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["id"] for row in rows] == ["1", "2", "3"]
    assert [row["kept"] for row in rows] == ["true", "false", "true"]
    assert [row["plan"] for row in rows] == ["2", "", "1 3"]
    assert rows[0]["label"] == "insert “peg”"
    assert (rows[1]["start_s"], rows[1]["end_s"]) == ("2.0", "4.0")
    assert rows[0]["end_condition"] == "configuration"
    assert rows[0]["position_tolerance_m"] == "0.005"


def test_a_demonstration_that_was_never_saved_has_no_segment_file(tmp_path):
    with pytest.raises(SegmentFileError, match="never saved"):
        write_segment_file(label(segmentation()), tmp_path / "x.segments.json")


def test_a_folder_that_takes_no_files_is_refused(labeled, tmp_path):
    with pytest.raises(SegmentFileError, match="cannot be written"):
        write_segment_file(labeled, tmp_path / "nowhere" / "x.segments.json")


def test_a_recording_with_a_strange_name_is_found_again(tmp_path):
    path = tmp_path / os.fsdecode(b"caf\xe9 #1 \xf0\x9f\xa4\x96.npz")
    found = segmentation((2.0,), made_from=demonstration(path=path, name=path.stem))
    write_segment_file(label(found), tmp_path / "x.segments.json")
    assert read_segment_file(tmp_path / "x.segments.json").recording == path


def test_a_path_through_a_link_leads_to_the_recording(labeled, tmp_path):
    (tmp_path / "far" / "away").mkdir(parents=True)
    (tmp_path / "link").symlink_to(tmp_path / "far" / "away")
    write_segment_file(labeled, tmp_path / "link" / "x.segments.json")
    assert read_segment_file(tmp_path / "link" / "x.segments.json").demonstration.path == (
        "../../demo.npz"
    )


def test_a_recording_that_has_changed_is_refused(written, tmp_path):
    (tmp_path / "demo.npz").write_bytes(b"another recording")
    with pytest.raises(SegmentFileError, match="has changed"):
        read_segment_file(written)
    assert read_segment_file(written, check_recording=False).plan == (3, 1, 3)


def test_a_recording_that_is_missing_is_refused(written, tmp_path):
    (tmp_path / "demo.npz").unlink()
    with pytest.raises(SegmentFileError, match="cannot be read"):
        read_segment_file(written)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda c: c.pop("plan"), "plan"),
        (lambda c: c.update(schema_version=2), "schema_version"),
        (lambda c: c.update(extra=1), "extra"),
        (lambda c: c["boundaries"][0].update(origin="magic"), "origin"),
        (lambda c: c["boundaries"][0].update(confidence=2), "confidence"),
        (lambda c: c["boundaries"][0].update(interval_s=[3.0, 1.0]), "ascending"),
        (lambda c: c["segments"][0]["end_condition"].update(kind="never"), "end_condition"),
        (lambda c: c["segments"][0].update(id=2), "ids must count"),
        (lambda c: c["segments"][1].update(start_s=2.5), "meet at the boundaries"),
        (lambda c: c["segments"][2].update(end_s=3.0), "ascend"),
        (lambda c: c.update(plan=[2]), "kept segments only"),
        (lambda c: c.update(plan=[9]), "kept segments only"),
        (lambda c: c["parameters"].update(force_ratio=-1), "force_ratio"),
        (lambda c: c["parameters"].update(speed=1), "speed"),
    ],
)
def test_a_malformed_file_is_refused_with_the_place(written, change, reason):
    with pytest.raises(SegmentFileError, match=reason):
        read_segment_file(rewrite(written, change))


@pytest.mark.parametrize("data", [b"", b"{", b"\xff\xfe", b"[" * 100_000, b'{"a": NaN}', b"[]"])
def test_what_is_no_json_object_is_refused(tmp_path, data):
    path = tmp_path / "x.segments.json"
    path.write_bytes(data)
    with pytest.raises(SegmentFileError):
        read_segment_file(path)


def test_a_segment_file_that_is_missing_is_refused(tmp_path):
    with pytest.raises(SegmentFileError, match="cannot be read"):
        read_segment_file(tmp_path / "nothing.segments.json")
