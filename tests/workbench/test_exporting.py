"""What the page exports lies beside the recordings, and replaces nobody's file unasked."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from two_pages import TalkingPage, workbench_on

from keyphase.workbench.workbench import Workbench


@pytest.fixture
def workbench(tmp_path: Path) -> Iterator[Workbench]:
    made = workbench_on(tmp_path, "ab")
    yield made
    made.close()


def _export(page: TalkingPage, kind: str, answer: str, **how: str) -> dict[str, object]:
    page.told.pop(answer, None)
    page.say("export", page.document(), kind=kind, **how)
    page.wait_for(lambda: answer in page.told)
    return page.told[answer]


def test_a_strangers_file_is_asked_about_and_replaced_only_then(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "page")
    file = tmp_path / "a.segments.json"
    file.write_text("{}")
    told = _export(page, "json", "in_the_way")
    assert told["files"] == [{"name": file.name, "whose": "keyphase did not write it"}]
    assert file.read_text() == "{}"
    assert str(_export(page, "json", "saved", if_there="keep both")["path"]).endswith(
        "a_2.segments.json"
    )
    _export(page, "json", "saved", if_there="replace")
    assert file.stat().st_size > 100
    _export(page, "json", "saved")


def test_a_behaviour_tree_is_written_beside_a_hand_written_robot_description(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "page")
    (tmp_path / "a.xml").write_text("<robot/>")
    told = _export(page, "behavior tree", "saved")
    assert str(told["path"]).endswith("a.tree.xml")
    assert (tmp_path / "a.xml").read_text() == "<robot/>"


def test_two_recordings_of_one_name_are_refused_alone_and_among_all(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "page")
    page.document()
    table = tmp_path / "a.csv"
    shutil.copy(tmp_path / "b.npz", table)
    workbench.recordings.add(table)
    told = _export(page, "json", "refused")
    assert "a.npz and a.csv would both be written" in str(told["text"])
    told = _export(page, "all", "notice")
    assert sorted(file.name for file in tmp_path.glob("*.segments.json")) == ["b.segments.json"]


def test_exporting_all_writes_what_is_free_and_asks_about_the_rest(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "page")
    (tmp_path / "b.segments.json").write_text("{}")
    told = _export(page, "all", "in_the_way")
    assert [file["name"] for file in told["files"]] == ["b.segments.json"]  # type: ignore[attr-defined]
    assert (tmp_path / "a.segments.json").is_file()
