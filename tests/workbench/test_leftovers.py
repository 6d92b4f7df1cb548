"""What kills leave behind in a folder is cleared up at the next start, and nobody else's file."""

import os
import time
from pathlib import Path

import pytest

from keyphase.cli import main
from keyphase.workbench.leftovers import clear_up

HEX = "0123456789abcdef"


def _left(path: Path, age_s: float = 3600.0) -> Path:
    path.parent.mkdir(exist_ok=True)
    path.write_bytes(b"half")
    then = time.time() - age_s
    os.utime(path, (then, then))
    return path


def test_half_written_files_are_removed_beside_recordings_and_journals(tmp_path: Path) -> None:
    left = [
        _left(tmp_path / f".keyphase-{HEX}"),
        _left(tmp_path / ".upload-abc_1234"),
        _left(tmp_path / ".keyphase" / f".keyphase-{HEX}"),
        _left(tmp_path / ".keyphase" / ".probe-4711"),
    ]
    told = clear_up([tmp_path])
    assert not any(path.exists() for path in left)
    assert [line.partition("removed ")[2][:7] for line in told] == ["2 files", "2 files"]


@pytest.mark.parametrize("name", [".keyphase-notes", ".upload-list.txt", ".keyphase-abc"])
def test_what_somebody_called_almost_so_is_left(tmp_path: Path, name: str) -> None:
    path = _left(tmp_path / name)
    assert clear_up([tmp_path]) == ()
    assert path.exists()


def test_what_is_being_written_now_is_left(tmp_path: Path) -> None:
    path = _left(tmp_path / f".keyphase-{HEX}", age_s=1.0)
    assert clear_up([tmp_path]) == ()
    assert path.exists()


def test_what_is_called_a_take_and_is_none_costs_no_other(tmp_path: Path) -> None:
    (tmp_path / "a.npz.take").write_bytes(b"no take\n")
    (tmp_path / "b.npz.take").write_bytes(b"cut off in its first line")
    (told,) = clear_up([tmp_path])
    assert "a.npz.take must begin as a take" in told
    assert not (tmp_path / "b.npz.take").exists()


def test_the_command_tells_of_a_renamed_recording_and_takes_its_edits_over(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from two_pages import TalkingPage, workbench_on

    workbench = workbench_on(tmp_path, "a")
    page = TalkingPage(workbench, "page")
    edit = {"kind": "label", "time_s": 1.0, "label": "mine"}
    page.say("edit", page.document(), edit=edit)
    page.wait_for(lambda: page.told["document"]["edits"] == 1)
    workbench.close()
    (tmp_path / "a.npz").rename(tmp_path / "b.npz")

    for options, told in (
        ([], "b.npz: 1 edit were made as a.npz (--take-over takes them over)"),
        (["--take-over"], "b.npz: took over 1 edit made as a.npz"),
        ([], ""),
    ):
        with pytest.raises(SystemExit) as ended:
            main(["tidy", str(tmp_path), *options])
        assert ended.value.code == 0
        assert capsys.readouterr().out.strip().endswith(told)
