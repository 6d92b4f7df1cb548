"""Journals that other programs replace, cut or delete while they are open, or that lie twice."""

import os
import shutil

import pytest
from handmade import Person, demonstration, segmentation

from keyphase.errors import JournalError
from keyphase.labeling.edits import Add, Label
from keyphase.labeling.storage import state_folder
from keyphase.labeling.storage.journal import Journal
from keyphase.labeling.storage.readings import read_journal
from keyphase.labeling.storage.records import MAX_LINES, encode
from keyphase.labeling.storage.state_folder import journal_path
from keyphase.labeling.storage.summary import summarize


@pytest.fixture
def demo(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    return demonstration(path=tmp_path / "demo.npz")


class Editor(Person):
    """A person whose edits are journaled."""

    def __init__(self, demo):
        super().__init__(segmentation(made_from=demo))
        self.journal = Journal(demo)
        self.document = self.journal.document

    def makes(self, *edits):
        for edit in edits:
            super().makes(edit)
            self.journal.save(self.document)


def edits_of(demo):
    with Journal(demo) as journal:
        return list(journal.document.edits.values())


def replace_by_a_copy(path):
    copy = path.with_name("copy")
    shutil.copy(path, copy)
    copy.replace(path)


def delete(path):
    path.unlink()


def delete_the_folder(path):
    shutil.rmtree(path.parent)


def cut(path):
    path.write_bytes(path.read_bytes()[:-20])


def empty(path):
    path.write_bytes(b"")


def append(path):
    with path.open("ab") as file:
        file.write(encode({"op": "at", "number": None}))


def change_in_place(path):
    with path.open("r+b") as file:
        file.seek(-5, os.SEEK_END)
        file.write(b"xyz")


def put_a_pipe_there(path):
    path.unlink()
    os.mkfifo(path)


TOUCHES = [
    replace_by_a_copy,
    delete,
    delete_the_folder,
    cut,
    empty,
    append,
    change_in_place,
    put_a_pipe_there,
]


@pytest.mark.parametrize("touch", TOUCHES, ids=lambda touch: touch.__name__)
def test_a_journal_that_another_program_touched_is_written_again_with_all_edits(demo, touch):
    editor = Editor(demo)
    editor.makes(Add(1.0), Add(3.0))
    touch(editor.journal.path)
    editor.makes(Label(5.0, "insert"))
    editor.makes(Add(7.0))
    told = [notice for notice in editor.journal.notices if "Another program" in notice]
    assert len(told) == 1
    editor.journal.close()
    assert edits_of(demo) == list(editor.document.edits.values())


@pytest.mark.parametrize("touch", [replace_by_a_copy, cut, empty, append, change_in_place])
def test_what_the_other_program_left_there_is_kept(demo, touch):
    editor = Editor(demo)
    editor.makes(Add(1.0), Add(3.0))
    touch(editor.journal.path)
    left = editor.journal.path.read_bytes()
    editor.makes(Add(7.0))
    old = editor.journal.path.with_suffix(".old-1")
    assert old.read_bytes() == left
    assert any(old.name in notice for notice in editor.journal.notices)


def test_a_journal_somebody_else_began_meanwhile_is_kept_beside(demo):
    editor = Editor(demo)
    editor.journal.path.parent.mkdir(exist_ok=True)
    editor.journal.path.write_bytes(b"of another")
    editor.makes(Add(1.0))
    assert editor.journal.path.with_suffix(".old-1").read_bytes() == b"of another"
    editor.journal.close()
    assert edits_of(demo) == [Add(1.0, False)]


def test_a_folder_that_went_takes_its_lock_with_it_so_another_may_be_first(demo):
    first = Editor(demo)
    first.makes(Add(1.0))
    shutil.rmtree(first.journal.path.parent)
    second = Editor(demo)
    second.makes(Add(3.0))
    first_before = first.journal.document
    with pytest.raises(JournalError, match="is editing"):
        first.makes(Add(5.0))
    assert first.journal.document is first_before
    assert any("looking only" in notice for notice in first.journal.notices)


def test_a_closed_journal_refuses_to_write(demo):
    editor = Editor(demo)
    editor.makes(Add(1.0))
    editor.journal.close()
    before = editor.journal.path.read_bytes()
    with pytest.raises(JournalError, match="closed"):
        editor.makes(Add(3.0))
    assert editor.journal.path.read_bytes() == before


def in_the_other_place(demo, monkeypatch, *edits):
    """Edits made while nothing could be written beside the recording."""
    usable = state_folder._usable
    with monkeypatch.context() as patch:
        patch.setattr(
            state_folder, "_usable", lambda folder: folder.name != ".keyphase" and usable(folder)
        )
        editor = Editor(demo)
        editor.makes(*edits)
        editor.journal.close()
        return editor.journal.path


def test_of_two_places_the_longer_history_wins_and_the_other_is_told(demo, monkeypatch):
    other = in_the_other_place(demo, monkeypatch, Add(1.0), Add(3.0), Add(5.0))
    aside = other.with_name("aside")
    other.rename(aside)
    shorter = Editor(demo)
    shorter.makes(Label(5.0, "insert"))
    shorter.journal.close()
    aside.rename(other)
    os.utime(other, (0, 0))
    with Journal(demo) as journal:
        assert len(journal.document.edits) == 3
        told = next(notice for notice in journal.notices if "two places" in notice)
        assert str(other) in told
        assert journal.path.with_suffix(".old-1").exists()
    assert summarize(demo.source.path).touched


def test_a_record_with_numbers_beyond_floats_costs_only_itself(demo):
    editor = Editor(demo)
    editor.makes(Add(1.0))
    editor.journal.close()
    strange = [
        {"op": "recording", "format": 2, "sha256": "0", "next": 10**400},
        {"op": "at", "number": -1},
        {"op": "step", "number": 2**60, "after": 0, "name": "x", "edit": {"kind": "reset"}},
        {"op": "step", "number": 1, "after": [0], "name": "x", "edit": {"kind": "reset"}},
        {"op": "step", "number": 1, "after": 0, "name": "x", "parameters": {"seed": 10**400}},
    ]
    with editor.journal.path.open("ab") as file:
        file.writelines(map(encode, strange))
        file.write(b"%08x %s\n" % (0, b'{"op": "at", "number": 1e999}'))
    with Journal(demo) as journal:
        assert list(journal.document.edits.values()) == [Add(1.0, False)]
        told = " ".join(journal.notices)
    assert "3 records" in told
    assert "left out: 3, 7, 8." in told


def test_a_recipe_whose_name_is_no_text_cannot_reach_the_page(demo):
    editor = Editor(demo)
    editor.makes(Add(1.0))
    editor.journal.close()
    opening = {"op": "recording", "format": 2, "sha256": "0"}
    with editor.journal.path.open("ab") as file:
        file.write(encode({**opening, "recipe": {"name": "a\ud800", "sha256": "1"}}))
    with Journal(demo) as journal:
        assert any("as read with a recipe" in notice for notice in journal.notices)
        assert all(notice.isprintable() for notice in journal.notices)


def test_millions_of_empty_lines_take_no_room(demo):
    path = journal_path(demo.source.path, state_folder.state_folder(demo.source.path.parent).path)
    path.write_bytes(b"\n" * 3_000_000)
    with Journal(demo, read_only=True) as journal:
        assert len(read_journal(path).read.damaged) == MAX_LINES + 1
        assert journal.document.history.steps == ()


def test_a_name_that_is_no_text_cannot_reach_the_page(demo):
    editor = Editor(demo)
    editor.makes(Add(1.0))
    editor.journal.close()
    step = {
        "op": "step",
        "number": 5,
        "after": 0,
        "name": "a\ud800\u202eb" * 999,
        "edit": {"kind": "reset"},
    }
    with editor.journal.path.open("ab") as file:
        file.write(encode(step))
    with Journal(demo) as journal:
        name = journal.document.undo_name or ""
    assert name.isprintable()
    assert len(name) <= 300


@pytest.mark.parametrize("length", [200, 247, 255])
def test_a_recording_with_a_name_as_long_as_file_systems_take_is_labeled_like_any(
    tmp_path, monkeypatch, length
):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    name = f"{'ä' * 90}.npz"
    demo = demonstration(path=tmp_path / name.rjust(length - 90, "x"))
    assert len(os.fsencode(demo.source.path.name)) == length
    assert not summarize(demo.source.path).touched
    editor = Editor(demo)
    editor.makes(Add(1.0))
    editor.journal.close()
    assert edits_of(demo) == [Add(1.0, False)]
    assert summarize(demo.source.path).touched


def test_a_pipe_in_the_place_of_a_journal_is_refused_at_once(demo):
    path = journal_path(demo.source.path, demo.source.path.parent / ".keyphase")
    path.parent.mkdir()
    os.mkfifo(path)
    with pytest.raises(JournalError, match="no regular file"):
        Journal(demo)
    assert not summarize(demo.source.path).touched
