"""Segment files made to take minutes, or to end the program that reads them."""

import json
import os
from dataclasses import replace

import pytest
from handmade import demonstration, segmentation

from keyphase.demonstration import Source
from keyphase.errors import SegmentFileError
from keyphase.labeling.label import label
from keyphase.labeling.segment_file import (
    read_segment_file,
    require_same_reading,
    write_segment_file,
)


@pytest.fixture
def file(tmp_path):
    """A sound segment file."""
    path = tmp_path / "demo.segments.json"
    found = segmentation(made_from=demonstration(path=tmp_path / "demo.npz"))
    write_segment_file(label(found), path)
    return path


def change(path, how):
    content = json.loads(path.read_bytes())
    how(content)
    path.write_text(json.dumps(content))


def nested(depth):
    """Lists in lists."""
    inner = []
    for _ in range(depth):
        inner = [inner]
    return inner


@pytest.mark.slow
@pytest.mark.parametrize(
    "how",
    [
        lambda c: c.update(plan=[1] * 1_000_000),
        lambda c: c.update(segments=c["segments"][:1] * 200_000),
        lambda c: c["parameters"].update(force_ratio=10**400),
        lambda c: c["segments"][1].update(end_s=10**400),
        lambda c: c["segments"][1].update(id=2**70),
        lambda c: c["segments"][1].update(label="a\ud800"),
        lambda c: c["segments"][1].update(label="x" * 10_000),
        lambda c: c["demonstration"].update(path="/dev/zero"),
        lambda c: c["demonstration"].update(path="a" * 5000),
        lambda c: c["demonstration"].update(path="a\0b"),
        lambda c: c["segments"][1].update(label=nested(900)),
        lambda c: c.update(plan=[[] for _ in range(600_000)]),
    ],
    ids=range(12),
)
def test_it_is_refused_in_a_sentence(file, how):
    change(file, how)
    with pytest.raises(SegmentFileError, match=file.name):
        read_segment_file(file)


@pytest.mark.parametrize("text", ["1e999", "[" * 100_000, "NaN", '{"plan": [1e400]}'])
def test_json_beyond_what_can_be_held_is_refused(file, text):
    file.write_text(text)
    with pytest.raises(SegmentFileError, match="cannot be parsed"):
        read_segment_file(file)


def test_a_pipe_is_refused_at_once(tmp_path):
    os.mkfifo(tmp_path / "pipe.segments.json")
    with pytest.raises(SegmentFileError, match="no regular file"):
        read_segment_file(tmp_path / "pipe.segments.json")


def test_parameters_from_before_there_were_variants_are_the_papers(file):
    change(file, lambda c: c.update(parameters={"variant": "keyphase", "force_ratio": 5.0}))
    parameters = read_segment_file(file).parameters
    assert parameters.variant == "paper"
    assert parameters.force_ratio == 5.0


def test_what_was_read_with_another_recipe_is_another_demonstration(tmp_path):
    plain = demonstration(path=tmp_path / "demo.csv")
    demo, other = (replace(plain, source=_by(plain.source, name)) for name in ("left", "right"))
    path = tmp_path / "demo.segments.json"
    write_segment_file(label(segmentation(made_from=demo)), path)
    file = read_segment_file(path)
    assert file.demonstration.recipe == "left"
    require_same_reading(file, demo)
    with pytest.raises(SegmentFileError, match=r"the recipe left, not with the recipe right"):
        require_same_reading(file, other)


def _by(source, name):
    return Source(source.path, source.sha256, name, name.encode().hex().ljust(64, "0"))


@pytest.mark.parametrize(
    ("name", "data", "way"),
    [
        ("run.csv", b"time_s,position_x_m\n0,1\n", "keyphase segment .*run.csv"),
        ("run.npz", b"PK\x03\x04", "keyphase segment .*run.npz"),
        ("run.segments.csv", b"id,start_s\n1,0\n", r"name run\.segments\.json"),
        ("run.segments.json", b'{"segments": [', "expected JSON.*write the file again"),
    ],
)
def test_whoever_names_something_else_is_told_the_way(tmp_path, name, data, way):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(SegmentFileError, match=way):
        read_segment_file(tmp_path / name)


def test_a_refusal_can_be_sent_whatever_the_file_holds(file):
    content = json.loads(file.read_text())
    content["demonstration"]["path"] = "\ud800"
    file.write_text(json.dumps(content))
    with pytest.raises(SegmentFileError) as refused:
        read_segment_file(file)
    assert "\\ud800" in str(refused.value).encode().decode()
