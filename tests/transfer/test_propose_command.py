"""`keyphase propose`: from a finished recording to the others of a folder."""

import json
from pathlib import Path

import pytest

from keyphase.cli import main
from keyphase.demonstration import Demonstration
from keyphase.readers import read, save_npz
from keyphase.simulation import record


def keyphase(*arguments: object) -> int:
    with pytest.raises(SystemExit) as ended:
        main([str(argument) for argument in arguments])
    return int(ended.value.code or 0)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("task")
    for name, cell, seed in (("a", "setup1", 1), ("b", "setup1", 2), ("other", "setup2", 1)):
        save_npz(record(cell, seed=seed), folder / f"{name}.npz")
    return folder


def test_the_others_of_the_task_get_names_and_outliers_get_nothing(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert keyphase("segment", folder / "a.npz", "--output", tmp_path) == 0
    file = tmp_path / "a.segments.json"
    content = json.loads(file.read_text())
    for number, segment in enumerate(content["segments"]):
        segment["label"] = f"phase {'abcdefgh'[number]}"
    file.write_text(json.dumps(content))
    out, report = tmp_path / "out", tmp_path / "report.json"
    assert keyphase("propose", folder, "--from", file, "--output", out, "--report", report) == 1
    assert [path.name for path in out.glob("*.json")] == ["b.segments.json"]
    labels = [s["label"] for s in json.loads((out / "b.segments.json").read_text())["segments"]]
    assert labels == [s["label"] for s in content["segments"]]
    first, second = json.loads(report.read_text())
    assert [first["outlier"], second["outlier"]] == [False, True]
    least = min(part["confidence"] for part in (*first["boundaries"], *first["phases"]))
    assert f"least confidence {least:.2f}" in capsys.readouterr().out
    (out / "b.segments.json").write_text("corrected by hand")
    assert keyphase("propose", folder / "b.npz", "--from", file, "--output", out) == 1
    assert (out / "b.segments.json").read_text() == "corrected by hand"


def test_two_processes_propose_the_same_bytes_as_one(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert keyphase("segment", folder / "a.npz", "--output", tmp_path) == 0
    monkeypatch.setattr("keyphase.transfer.folder.WORTH_PROCESSES", 1)
    written = []
    for jobs in (1, 2):
        out, report = tmp_path / "out", tmp_path / f"{jobs}.json"
        given = ("--from", tmp_path / "a.segments.json", "--output", out, "--report", report)
        keyphase("propose", folder, *given, "--jobs", jobs)
        written.append(((out / "b.segments.json").read_bytes(), report.read_bytes()))
        (out / "b.segments.json").unlink()
    assert written[0] == written[1]


def test_a_phase_that_the_task_of_its_folder_calls_optional_may_be_missing(
    folder: Path, tmp_path: Path
) -> None:
    file, cut = tmp_path / "a.segments.json", tmp_path / "cut"
    cut.mkdir()
    assert keyphase("segment", folder / "a.npz", "--output", tmp_path) == 0
    content = json.loads(file.read_text())
    for segment, name in zip(content["segments"], "abcdefgh", strict=False):
        segment["label"] = name
    file.write_text(json.dumps(content))
    last = content["segments"][-1]
    whole = read(folder / "a.npz")
    kept = whole.time_s < last["start_s"]
    channels = ("time_s", "position_m", "orientation_wxyz", "force_N", "torque_Nm")
    save_npz(Demonstration("c", *(getattr(whole, each)[kept] for each in channels)), cut / "c.npz")
    differs = []
    for optional in ("", ":optional"):
        assert keyphase("phases", cut, "--write", f"{last['label']}{optional}") == 0
        out, report = tmp_path / f"out{optional[1:]}", tmp_path / f"report{optional[1:]}.json"
        keyphase("propose", cut, "--from", file, "--output", out, "--report", report)
        differs += [one["differs"] for one in json.loads(report.read_text())]
    assert differs[0]["told"] == f"'{last['label']}' is missing"
    assert differs[1] is None


def test_a_folder_without_a_finished_recording_says_what_to_do(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert keyphase("propose", folder, "--output", tmp_path / "out") == 1
    assert "mark one as done in the page, or name its segment file" in capsys.readouterr().err


def test_no_processes_at_all_are_refused(
    folder: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert keyphase("segment", folder / "a.npz", "--output", tmp_path) == 0
    given = ("--from", tmp_path / "a.segments.json", "--output", tmp_path / "out")
    assert keyphase("propose", folder, *given, "--jobs", 0) == 1
    assert "-1 for all cores" in capsys.readouterr().err
