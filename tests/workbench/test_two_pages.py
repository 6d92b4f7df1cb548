"""Two pages at work: what is asked of a recording lands on it or is refused, and nowhere else."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from two_pages import TalkingPage, run_pages, workbench_on

from keyphase.workbench import workbench as workbench_module
from keyphase.workbench.workbench import Workbench


@pytest.fixture
def workbench(tmp_path: Path) -> Iterator[Workbench]:
    workbench = workbench_on(tmp_path, "ab")
    yield workbench
    workbench.close()


def _journal(folder: Path, name: str) -> str:
    path = folder / ".keyphase" / f"{name}.npz.journal"
    return path.read_text() if path.exists() else ""


@pytest.mark.parametrize(
    ("kind", "fields", "trace"),
    [
        ("edit", {"edit": {"kind": "add", "time_s": 0.4}}, "Add boundary"),
        ("set", {"parameter": "min_distance_s", "value": 0.7}, "0.7"),
        ("done", {"done": True}, "done"),
    ],
)
def test_what_is_asked_of_one_while_another_is_opened_lands_on_the_one(
    workbench: Workbench, tmp_path: Path, kind: str, fields: dict[str, object], trace: str
) -> None:
    page = TalkingPage(workbench, "one")
    first = page.document()
    page.say("open", id=page.id_of("b"))
    page.say(kind, first, **fields)
    page.wait_for(lambda: page.told["document"]["name"] == "b")
    page.open("a")
    page.wait_for(lambda: trace in _journal(tmp_path, "a"))

    assert trace in _journal(tmp_path, "a")
    assert not _journal(tmp_path, "b")


def test_an_export_of_one_while_another_is_opened_is_of_the_one(
    workbench: Workbench, tmp_path: Path
) -> None:
    page = TalkingPage(workbench, "one")
    first = page.document()
    page.say("open", id=page.id_of("b"))
    page.say("export", first, kind="json")
    page.wait_for(lambda: "saved" in page.told)

    assert [path.name for path in tmp_path.glob("*.segments.json")] == ["a.segments.json"]


def test_undo_of_another_pages_step_is_told_to_both(workbench: Workbench) -> None:
    one, two = TalkingPage(workbench, "one"), TalkingPage(workbench, "two")
    one.document()
    two.say("edit", two.document(), edit={"kind": "add", "time_s": 0.4})
    one.wait_for(lambda: one.told["document"]["edits"] == 1)
    one.say("undo", one.document(), event=9)
    for page in (one, two):
        page.wait_for(lambda page=page: "notice" in page.told)

    again = "; Ctrl Shift Z makes it again."
    assert one.told["notice"]["text"] == f"Took back “Add boundary at 0.40 s” of page 2{again}"
    assert two.told["notice"]["text"] == f"Page 1 took back your “Add boundary at 0.40 s”{again}"

    two.wait_for(lambda: two.told["document"]["edits"] == 0)
    two.say("redo", two.document())
    two.wait_for(lambda: two.told["document"]["edits"] == 1)
    del two.told["notice"]
    two.say("undo", two.document())
    two.wait_for(lambda: two.told["document"]["edits"] == 0)
    assert "notice" not in two.told


def test_undo_after_a_page_was_loaded_again_names_no_page_that_is_there(
    workbench: Workbench,
) -> None:
    before = TalkingPage(workbench, "before")
    before.say("edit", before.document(), edit={"kind": "add", "time_s": 0.4})
    before.wait_for(lambda: before.told["document"]["edits"] == 1)
    before.conversation.end()
    page = TalkingPage(workbench, "after")
    page.say("undo", page.document())
    page.wait_for(lambda: "notice" in page.told)
    assert "of a page that was closed or loaded again" in page.told["notice"]["text"]


def test_undo_takes_back_nothing_that_was_not_seen(workbench: Workbench) -> None:
    one, two = TalkingPage(workbench, "one"), TalkingPage(workbench, "two")
    seen = one.document()
    two.say("edit", two.document(), edit={"kind": "add", "time_s": 0.4})
    one.wait_for(lambda: one.told["document"]["edits"] == 1)
    one.say("undo", seen, event=9)
    one.wait_for(lambda: bool(one.refused))

    assert one.refused[0]["event"] == 9
    assert not two.refused
    assert one.told["document"]["edits"] == 1


def test_an_edit_about_what_another_page_has_changed_is_refused(
    workbench: Workbench,
) -> None:
    one, two = TalkingPage(workbench, "one"), TalkingPage(workbench, "two")
    seen = one.document()
    first = seen["boundaries"][0]["time_s"]
    two.say("edit", two.document(), edit={"kind": "remove", "time_s": first})
    one.wait_for(lambda: one.told["document"]["edits"] == 1)
    mine = {"kind": "label", "time_s": 0.5 * first, "label": "approach"}
    one.say("edit", seen, edit=mine, event=7)
    one.wait_for(lambda: bool(one.refused))

    assert one.refused[0]["event"] == 7


def test_edits_of_two_pages_about_different_things_both_land(workbench: Workbench) -> None:
    one, two = TalkingPage(workbench, "one"), TalkingPage(workbench, "two")
    seen, last = one.document(), two.document()["segments"][-1]
    two.say(
        "edit",
        two.document(),
        edit={"kind": "label", "time_s": last["end_s"] - 0.01, "label": "retreat"},
    )
    one.wait_for(lambda: one.told["document"]["edits"] == 1)
    one.say("edit", seen, edit={"kind": "label", "time_s": 0.05, "label": "approach"})
    one.wait_for(lambda: one.told["document"]["edits"] == 2)

    assert not one.refused


def test_neither_page_moves_what_the_other_looks_at(workbench: Workbench) -> None:
    one, two = TalkingPage(workbench, "one"), TalkingPage(workbench, "two")
    one.document()
    two.document()
    two.open("b")
    two.say("seek", time_s=1.0)
    two.wait_for(lambda: two.told["playhead"]["time_s"] == 1.0)

    assert one.told["document"]["name"] == "a"
    assert one.told["playhead"]["time_s"] == one.told["document"]["start_s"]
    assert one.told["recordings"]["items"][1]["pages"][0]["id"] == "two"

    two.conversation.end()
    one.wait_for(lambda: not one.told["recordings"]["items"][1]["pages"])


def test_a_page_that_follows_sees_what_the_other_opens(workbench: Workbench) -> None:
    one, two = TalkingPage(workbench, "one"), TalkingPage(workbench, "two")
    one.document()
    two.document()
    two.say("follow", page="one")
    one.open("b")
    two.wait_for(lambda: two.told["document"]["name"] == "b")
    two.open("a")

    assert two.told["following"]["page"] is None
    assert one.told["document"]["name"] == "b"


@pytest.mark.slow
def test_random_actions_of_two_pages_equal_a_replay_of_the_journals(tmp_path: Path) -> None:
    assert run_pages(tmp_path, actions=40, seed=1, slow=0.02, names="abc") >= 80


def test_a_page_that_is_loaded_again_is_no_further_person(
    workbench: Workbench, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(workbench_module, "KEPT_S", 0.0)
    stays = TalkingPage(workbench, "stays")
    for load in ("first load", "second load"):
        assert workbench.enter(load).number == 2
        workbench.leave(load)
        stays.wait_for(lambda: len(workbench.views) == 1)
