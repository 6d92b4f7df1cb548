"""A recording that was renamed or moved finds its journal by its hash: offered, never assumed."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest
from handmade import Person, demonstration, segmentation

from keyphase.demonstration import Demonstration
from keyphase.errors import JournalError
from keyphase.labeling.edits import Add, Done
from keyphase.labeling.storage.journal import Journal
from keyphase.labeling.storage.records import encode
from keyphase.readers import fingerprint


@pytest.fixture(autouse=True)
def own_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


@pytest.fixture
def labeled(tmp_path: Path) -> Path:
    """A recording with two edits."""
    (tmp_path / "monday").mkdir()
    path = tmp_path / "monday" / "run.npz"
    demo = demonstration(path=path)
    person = Person(segmentation(made_from=demo))
    with Journal(demo) as journal:
        person.document = journal.document
        person.makes(Add(3.0), Done())
        journal.save(person.document)
    return path


def moved(path: Path, to: Path) -> Demonstration:
    to.parent.mkdir(exist_ok=True)
    path.rename(to)
    return demonstration(path=to)


@pytest.mark.parametrize("to", ["monday/other.npz", "tuesday/run.npz", "../far/run.npz"])
def test_its_journal_is_offered_wherever_it_went(labeled: Path, tmp_path: Path, to: str) -> None:
    with Journal(moved(labeled, tmp_path / to)) as journal:
        assert journal.elsewhere is not None
        assert (journal.elsewhere.name, journal.elsewhere.steps) == ("run.npz", 2)
        assert journal.elsewhere.done
        assert not journal.document.history.steps


def test_taking_it_over_gives_every_step_with_undo_and_leaves_the_other(
    labeled: Path, tmp_path: Path
) -> None:
    other = labeled.parent / ".keyphase" / "run.npz.journal"
    before = other.read_bytes()
    demo = moved(labeled, tmp_path / "tuesday" / "run.npz")
    with Journal(demo) as journal:
        assert journal.elsewhere is not None
        journal.take_over(journal.elsewhere)
        assert journal.elsewhere is None
    with Journal(demo) as journal:
        assert journal.document.done
        assert journal.document.undo().undo_name == "Add boundary at 3.00 s"
        assert not journal.changed
    assert other.read_bytes() == before


def test_nothing_is_offered_where_something_was_done_already(labeled: Path) -> None:
    with Journal(demonstration(path=labeled)) as journal:
        assert journal.elsewhere is None


def test_nothing_is_taken_over_what_was_done_meanwhile(labeled: Path, tmp_path: Path) -> None:
    demo = moved(labeled, tmp_path / "monday" / "other.npz")
    person = Person(segmentation(made_from=demo))
    with Journal(demo) as journal:
        assert journal.elsewhere is not None
        person.document = journal.document
        person.makes(Add(5.0))
        journal.save(person.document)
        with pytest.raises(JournalError, match="only where none were made"):
            journal.take_over(journal.elsewhere)


def test_a_copy_is_offered_nothing_while_the_labeled_one_is_there(labeled: Path) -> None:
    copy = labeled.with_name("copy.npz")
    shutil.copy(labeled, copy)
    with Journal(demonstration(path=copy)) as journal:
        assert journal.elsewhere is None


def test_another_recording_of_that_name_is_not_meant(labeled: Path, tmp_path: Path) -> None:
    other = tmp_path / "monday" / "other.npz"
    other.write_bytes(b"other bytes")
    with Journal(demonstration(path=other)) as journal:
        assert journal.elsewhere is None


def test_a_damaged_journal_beside_is_passed_over(labeled: Path, tmp_path: Path) -> None:
    beside = labeled.parent / ".keyphase"
    shutil.copy(beside / "run.npz.journal", beside / "aaa.npz.journal")
    (beside / "bbb.npz.journal").write_bytes(b"\xff" * 100)
    nameless = {"op": "recording", "format": 2, "sha256": fingerprint(labeled)}
    step = {"op": "step", "number": 0, "after": None, "name": "x", "edit": {"kind": "reset"}}
    (beside / "ccc.npz.journal").write_bytes(encode(nameless) + encode(step))
    with Journal(moved(labeled, labeled.with_name("other.npz"))) as journal:
        assert journal.elsewhere is not None


def test_a_recording_that_is_read_with_another_recipe_is_called_changed(labeled: Path) -> None:
    demo = demonstration(path=labeled)
    assert demo.source is not None
    source = replace(demo.source, recipe="arm.toml", recipe_sha256="0" * 64)
    with Journal(replace(demo, source=source)) as journal:
        assert journal.changed
        assert any("no recipe, and is read with the recipe arm.toml" in n for n in journal.notices)
        journal.keep_labels()
        assert not journal.changed
    with Journal(demo) as journal:
        assert journal.changed
