"""Two arms of one table: each with segments, journal and segment file, and none for the other's."""

import json
from pathlib import Path

import numpy as np
import pytest

from keyphase.batch.segmenting import segment_all
from keyphase.cli import main
from keyphase.labeling.edits import Label
from keyphase.labeling.label import label
from keyphase.labeling.storage.journal import Journal
from keyphase.readers import arms_beside, read
from keyphase.segmentation import segment
from keyphase.segmentation.parameters import Parameters
from two_arms import RECIPE


@pytest.fixture
def table(tmp_path: Path) -> Path:
    """The left arm stops twice, the right one once."""
    time = np.arange(400) / 50
    left = np.interp(time, [0, 2, 3, 5, 6, 8], [0, 0.3, 0.3, 0.5, 0.5, 0.7])
    right = np.interp(time, [0, 4, 5, 8], [0.2, 0.6, 0.6, 0.3])
    rows = [f"{t},{a:.5f},0,0.3,0.4,{b:.5f},0.3" for t, a, b in zip(time, left, right, strict=True)]
    path = tmp_path / "data" / "run.csv"
    path.parent.mkdir()
    path.write_text("\n".join(["t,lx,ly,lz,rx,ry,rz", *rows, ""]))
    (path.parent / "recipe.toml").write_text(RECIPE)
    return path


def test_each_arm_has_a_segment_file_and_neither_replaces_the_other(table: Path) -> None:
    report = segment_all([table.parent], table.parent, jobs=1)
    files = [written.segment_file for written in report.written]
    assert [file.name for file in files] == ["run#left.segments.json", "run#right.segments.json"]
    left, right = (json.loads(file.read_text()) for file in files)
    assert len(left["segments"]) > len(right["segments"])
    assert left["demonstration"]["sha256"] != right["demonstration"]["sha256"]


def test_each_arm_has_a_journal_and_neither_sees_the_others_edits(table: Path) -> None:
    for arm in ("left", "right"):
        demonstration = read(f"{table}#{arm}")
        with Journal(demonstration, Parameters()) as journal:
            labeling = label(segment(demonstration))
            journal.save(journal.document.apply(Label(1.0, f"{arm} goes"), labeling))
    for arm in ("left", "right"):
        with Journal(read(f"{table}#{arm}"), Parameters()) as journal:
            assert [edit.label for edit in journal.document.edits.values()] == [f"{arm} goes"]
            assert not journal.notices


def test_replay_with_the_wrong_arm_is_refused(
    table: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    segment_all([table.parent], table.parent, jobs=1)
    segments = table.parent / "run#left.segments.json"
    with pytest.raises(SystemExit) as ended:
        main(["replay", str(segments), "--demonstration", f"{table}#right"])
    assert ended.value.code
    assert "run.csv#right has changed since" in capsys.readouterr().err


def test_the_arms_of_a_table_know_each_other(table: Path) -> None:
    assert arms_beside(Path(f"{table}#left")) == (Path(f"{table}#right"),)
    assert arms_beside(table) == ()
