"""What is proposed for the others once a recording is done: shown, taken over, taken back."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from two_pages import TalkingPage, workbench_on

from keyphase.files.shipped import shipped
from keyphase.readers import read, save_npz
from keyphase.workbench.workbench import Workbench


@pytest.fixture
def workbench(tmp_path: Path) -> Iterator[Workbench]:
    """Three recordings of one task, and one of another."""
    workbench = workbench_on(tmp_path, "abc")
    yield workbench
    workbench.close()


def line(page: TalkingPage, name: str) -> dict:
    return next(i for i in page.told["recordings"]["items"] if i["name"] == name)


def taught(page: TalkingPage) -> None:
    """Recording a is named by a person and done."""
    document = page.open("a")
    for number in range(len(document["segments"])):
        document = page.told["document"]
        middle = sum(document["segments"][number][key] for key in ("start_s", "end_s")) / 2
        edit = {"kind": "label", "time_s": middle, "label": f"Phase {number}"}
        before = document["edits"]
        page.say("edit", document, edit=edit)
        page.wait_for(lambda before=before: page.told["document"]["edits"] > before)
    page.say("done", page.told["document"], done=True)
    page.wait_for(lambda: line(page, "b")["proposed_from"] != [])


def test_a_finished_recording_is_proposed_for_the_others(workbench: Workbench) -> None:
    page = TalkingPage(workbench, "one")
    page.document()
    assert line(page, "b")["proposed_from"] == []

    taught(page)

    assert line(page, "b")["proposed_from"] == ["a"]
    assert 0 < line(page, "b")["proposed_confidence"] <= 1
    assert line(page, "a")["proposed_from"] == []


def test_what_is_proposed_changes_nothing_before_it_is_taken_over(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "one")
    taught(page)

    document = page.open("b")

    assert not (tmp_path / ".keyphase" / "b.npz.journal").exists()
    assert document["edits"] == 0
    assert all("Phase" not in segment["label"] for segment in document["segments"])


def test_what_is_proposed_is_taken_over_in_one_step_and_back_in_one(workbench: Workbench) -> None:
    page = TalkingPage(workbench, "one")
    taught(page)
    before = page.open("b")
    page.say("compare", before, **{"with": "proposed"})
    page.wait_for(lambda: page.told.get("comparison", {}).get("with") == "proposed")
    page.say("take_over", before, **{"from": "proposed"})
    page.wait_for(lambda: page.told["document"]["edits"] == 1)
    names = [segment["label"] for segment in page.told["document"]["segments"]]
    page.say("undo", page.told["document"])
    page.wait_for(lambda: page.told["document"]["edits"] == 0)

    assert page.told["comparison"]["labels"] == names
    assert names == [f"Phase {number}" for number in range(len(names))]
    after = page.told["document"]["segments"]
    assert [s["label"] for s in after] == [s["label"] for s in before["segments"]]


def test_nothing_is_proposed_any_more_once_nothing_is_done(workbench: Workbench) -> None:
    page = TalkingPage(workbench, "one")
    taught(page)

    page.say("done", page.told["document"], done=False)
    page.wait_for(lambda: line(page, "b")["proposed_from"] == [])

    assert workbench.proposals.of(page.id_of("b")) is None


def test_a_recording_of_another_kind_gets_no_proposal(tmp_path: Path) -> None:
    shutil.copy(shipped("data") / "setup1.npz", tmp_path / "a.npz")
    shutil.copy(shipped("data") / "setup1.npz", tmp_path / "b.npz")
    other = read(shipped("data") / "setup2.npz")
    save_npz(other, tmp_path / "c.npz")
    assert not np.array_equal(other.position_m, read(tmp_path / "a.npz").position_m)
    workbench = Workbench([tmp_path / f"{name}.npz" for name in "abc"])
    page = TalkingPage(workbench, "one")
    taught(page)
    page.wait_for(lambda: line(page, "c")["outlier"])

    assert line(page, "c")["proposed_from"] == []
    assert line(page, "b")["proposed_from"] == ["a"]
    workbench.close()
