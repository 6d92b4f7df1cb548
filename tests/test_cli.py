"""The command line: what it answers, and how it ends."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from keyphase.cli import main
from keyphase.files.shipped import shipped


def keyphase(*arguments: object) -> int:
    """The exit status of the command."""
    with pytest.raises(SystemExit) as ended:
        main([str(argument) for argument in arguments])
    return int(ended.value.code or 0)


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    return Path(shutil.copy(shipped("data") / "setup1.npz", tmp_path / "one.npz"))


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys; from keyphase.cli import main\n"
        "try: main(['--help'])\n"
        "except SystemExit: pass\n"
        "print(*(m for m in ('scipy','sklearn','viser','mujoco','pinocchio') "
        "if m in sys.modules), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr.strip() == ""


@pytest.mark.slow
def test_segment_writes_one_segment_file_for_each_recording(
    recording: Path, tmp_path: Path
) -> None:
    assert keyphase("segment", recording, "--output", tmp_path / "out") == 0
    content = json.loads((tmp_path / "out" / "one.segments.json").read_text())
    assert [segment["id"] for segment in content["segments"]] == [1, 2, 3, 4, 5]


def test_segment_goes_on_past_a_file_it_must_refuse_and_says_which(
    recording: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    broken = tmp_path / "broken.npz"
    broken.write_bytes(b"not an archive")
    assert keyphase("segment", broken, recording, "--output", tmp_path / "out") == 1
    assert (tmp_path / "out" / "one.segments.json").is_file()
    assert "broken.npz" in capsys.readouterr().err


def test_segment_twice_gives_the_same_bytes(recording: Path, tmp_path: Path) -> None:
    for _ in range(2):
        assert keyphase("segment", recording, "--output", tmp_path / "out") == 0
        shutil.copy(tmp_path / "out" / "one.segments.json", tmp_path / f"{_}.json")
    assert (tmp_path / "0.json").read_bytes() == (tmp_path / "1.json").read_bytes()


@pytest.mark.slow
def test_score_prints_figures_for_machines(
    recording: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    keyphase("segment", recording, "--output", tmp_path / "out")
    truth = tmp_path / "truth.json"
    truth.write_text(json.dumps({"one": {"events": [[0.5, "any"]], "tolerance_s": 60.0}}))
    capsys.readouterr()
    assert keyphase("score", truth, tmp_path / "out", "--json") == 0
    assert "f1" in capsys.readouterr().out.lower()


def test_an_error_a_user_can_mend_is_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert keyphase("score", tmp_path / "none.json", tmp_path) == 1
    message = capsys.readouterr().err.strip()
    assert message.startswith("keyphase: ")
    assert "\n" not in message


def test_a_parameter_out_of_its_range_is_one_line(
    recording: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert keyphase("segment", recording, "--output", tmp_path / "out", "--force-ratio", "-3") == 1
    message = capsys.readouterr().err.strip()
    assert message.startswith("keyphase: force_ratio must be")
    assert "\n" not in message


def test_what_is_printed_may_be_read_only_in_part() -> None:
    read, write = os.pipe()
    os.close(read)
    code = "from keyphase.cli import main; main(['--help'])"
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, stdout=write, stderr=subprocess.PIPE, check=False)
    os.close(write)
    assert (done.returncode, done.stderr) == (1, b"")
