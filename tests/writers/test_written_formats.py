"""What is written where, what is refused, and what is said to be lost before it is written."""

import csv
import json

import pytest
from segmented_recordings import EDGES_S, NAMES, item, saved

from keyphase.cli import main
from keyphase.errors import ExportError, FileInTheWayError
from keyphase.labeling.assessment import Assessment
from keyphase.labeling.segment_file import SUFFIX, read_segment_file, write_segment_file
from keyphase.labeling.segment_file_content import as_json
from keyphase.writers import WRITERS, Options, SegmentedRecording, planned_export


def export(items, to, output, **options):
    planned = planned_export(items, to, output, Options(**options))
    return [path for paths in planned.write() for path in paths]


def test_a_segment_file_that_is_exported_is_the_same_segment_file(tmp_path):
    labeling = saved(tmp_path / "in")
    original = tmp_path / "in" / f"run{SUFFIX}"
    write_segment_file(labeling, original)
    (again,) = export([SegmentedRecording.of_file(original)], "json", tmp_path / "out")
    assert again == tmp_path / "out" / f"run{SUFFIX}"
    assert read_segment_file(again).segments == read_segment_file(original).segments
    here = export([SegmentedRecording.of_file(original)], "json", original, if_there="replace")
    assert here == [original]
    write_segment_file(labeling, tmp_path / "in" / "fresh.segments.json")
    assert original.read_bytes() == (tmp_path / "in" / "fresh.segments.json").read_bytes()


def test_what_a_person_said_of_recording_and_segments_is_carried_or_said_to_be_lost(tmp_path):
    original = tmp_path / "in" / f"run{SUFFIX}"
    write_segment_file(saved(tmp_path / "in"), original)
    content = json.loads(original.read_text())
    content["assessment"] = {"quality": 4}
    content["segments"][1]["assessment"] = {"outcome": "failure", "note": "late"}
    original.write_bytes(as_json(content))
    marked = SegmentedRecording.of_file(original)
    (again,) = export([marked], "json", tmp_path / "out")
    file = read_segment_file(again, check_recording=False)
    assert file.assessment == Assessment(quality=4)
    assert file.segments[1].assessment == Assessment("failure", None, "late")
    lost = planned_export([marked], "csv", tmp_path / "out").not_carried
    assert "marks of success, quality and notes" in lost


def test_a_table_has_a_row_for_each_segment(tmp_path):
    (path,) = export([item(tmp_path)], "csv", tmp_path / "out")
    rows = list(csv.DictReader(path.open()))
    assert [(float(r["start_s"]), r["label"], r["kept"]) for r in rows] == [
        (EDGES_S[0], NAMES[0], "true"),
        (EDGES_S[1], NAMES[1], "true"),
        (EDGES_S[2], NAMES[2], "false"),
        (EDGES_S[3], NAMES[3], "true"),
    ]


def test_what_is_not_carried_names_only_what_is_there(tmp_path):
    in_time = planned_export([item(tmp_path / "a")], "csv", tmp_path / "out")
    assert "the recorded signals" in in_time.not_carried
    assert "the order and the repetitions of the plan" not in in_time.not_carried
    program = planned_export([item(tmp_path / "b")], "program", tmp_path / "out")
    assert "which segments are dropped" in program.not_carried


@pytest.mark.parametrize("writer", WRITERS, ids=lambda writer: writer.name)
def test_every_writer_holds_the_names_and_says_how_it_is_read(writer):
    assert "NAMES" in {one.name for one in writer.carries}
    assert writer.reads_back.count("\n") == 2
    compile(writer.reads_back, writer.name, "exec")


@pytest.mark.parametrize(
    "name", [w.name for w in WRITERS if w.one_for == "recording" and not w.extra]
)
def test_the_three_lines_read_what_was_written(name, tmp_path, capsys):
    planned = planned_export([item(tmp_path)], name, tmp_path / "out")
    ((path, *_),) = planned.write()
    exec(planned.writer.reads_back.replace("PATH", str(path)), {})
    assert "insert" in capsys.readouterr().out


def test_what_keyphase_wrote_is_written_again_and_nothing_else_is_replaced_unasked(tmp_path):
    (path,) = export([item(tmp_path)], "csv", tmp_path / "out")
    export([item(tmp_path)], "csv", tmp_path / "out")
    path.write_text("a person's notes")
    with pytest.raises(FileInTheWayError):
        export([item(tmp_path)], "csv", tmp_path / "out")
    assert path.read_text() == "a person's notes"
    export([item(tmp_path)], "csv", tmp_path / "out", if_there="replace")


def test_two_recordings_for_one_file_are_refused_before_any_work(tmp_path):
    both = [item(tmp_path / "a"), item(tmp_path / "b")]
    with pytest.raises(ExportError, match="would both be written"):
        planned_export(both, "csv", tmp_path / "out")


def test_a_format_that_holds_all_time_refuses_to_trim(tmp_path):
    with pytest.raises(ExportError, match="leave out trimming"):
        planned_export([item(tmp_path)], "csv", tmp_path, Options(trim_idle=True))


def test_the_command_says_what_is_lost_before_it_writes(tmp_path, capsys):
    write_segment_file(saved(tmp_path), tmp_path / f"run{SUFFIX}")
    arguments = ["export", str(tmp_path), "--to", "csv", "--output", str(tmp_path / "out")]
    with pytest.raises(SystemExit) as dry:
        main([*arguments, "--dry-run"])
    assert dry.value.code == 0
    said = capsys.readouterr().out
    assert "does not carry:\n  what each segment does" in said
    assert not (tmp_path / "out").exists()
    with pytest.raises(SystemExit) as done:
        main(arguments)
    assert done.value.code == 0
    assert capsys.readouterr().out.endswith(f"{tmp_path / 'out' / 'run.segments.csv'}\n")


def test_one_that_cannot_be_written_costs_no_other_its_file(tmp_path, capsys):
    for name in ("a", "b", "c"):
        write_segment_file(saved(tmp_path, name), tmp_path / f"{name}{SUFFIX}")
    (tmp_path / f"b{SUFFIX}").write_text("{")
    out = tmp_path / "out"
    out.mkdir()
    (out / "a.segments.csv").write_text("somebody's own")
    with pytest.raises(SystemExit) as done:
        main(["export", str(tmp_path), "--to", "csv", "--output", str(out)])
    assert done.value.code == 1
    told = capsys.readouterr().err
    assert told.startswith("2 refused:\n")
    assert f"b{SUFFIX}" in told
    assert "a.segments.csv" in told
    assert (out / "a.segments.csv").read_text() == "somebody's own"
    assert (out / "c.segments.csv").exists()


def test_without_a_folder_the_command_writes_beside_the_segment_files(tmp_path, monkeypatch):
    write_segment_file(saved(tmp_path), tmp_path / f"run{SUFFIX}")
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    monkeypatch.chdir(elsewhere)
    with pytest.raises(SystemExit):
        main(["export", str(tmp_path / f"run{SUFFIX}"), "--to", "csv"])
    assert (tmp_path / "run.segments.csv").exists()
    assert list(elsewhere.iterdir()) == []


def test_an_unknown_format_is_refused_with_those_there_are(tmp_path):
    with pytest.raises(ExportError, match="among json, csv"):
        planned_export([item(tmp_path)], "word", tmp_path)
