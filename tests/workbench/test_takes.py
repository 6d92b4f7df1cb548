"""Takes: their names, and taking the last one back without losing it."""

from pathlib import Path

import pytest

from keyphase.errors import SimulationError
from keyphase.workbench.leading.takes import Takes


def made(takes: Takes, content: str) -> Path:
    path = takes.next_path("setup1")
    path.write_text(content)
    takes.add(path)
    return path


def test_takes_are_numbered(tmp_path: Path) -> None:
    takes = Takes(tmp_path)
    assert [made(takes, text).name for text in "ab"] == ["setup1_01.npz", "setup1_02.npz"]


def test_an_undone_take_leaves_the_folder_and_comes_back_as_it_was(tmp_path: Path) -> None:
    takes = Takes(tmp_path)
    path = made(takes, "first")
    takes.undo()
    assert not path.exists()
    assert takes.redo() == path
    assert path.read_text() == "first"


def test_a_new_take_never_gets_the_name_of_an_undone_one(tmp_path: Path) -> None:
    takes = Takes(tmp_path)
    undone = made(takes, "first")
    takes.undo()
    assert made(takes, "second") != undone


def test_another_server_can_bring_back_what_was_undone(tmp_path: Path) -> None:
    takes = Takes(tmp_path)
    path = made(takes, "first")
    takes.undo()
    later = Takes(tmp_path)
    assert later.can_redo
    assert later.redo() == path


def test_recordings_that_were_there_before_cannot_be_undone(tmp_path: Path) -> None:
    (tmp_path / "setup1_01.npz").write_text("someone's")
    takes = Takes(tmp_path)
    assert not takes.can_undo
    with pytest.raises(SimulationError, match="none to undo"):
        takes.undo()


def test_bringing_back_never_overwrites(tmp_path: Path) -> None:
    takes = Takes(tmp_path)
    path = made(takes, "first")
    takes.undo()
    path.write_text("someone's")
    with pytest.raises(SimulationError, match="must not exist"):
        takes.redo()
    assert path.read_text() == "someone's"
