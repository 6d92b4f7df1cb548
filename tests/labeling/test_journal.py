"""The journal: what was saved is there again, whatever happened in between."""

import json
import os
import stat
import subprocess
import sys
import zlib

import pytest
from handmade import Person, demonstration, labels, segmentation, times

from keyphase.errors import JournalError
from keyphase.labeling.edits import Add, BringBack, Done, Label, Move, Remove
from keyphase.labeling.label import label
from keyphase.labeling.storage import state_folder
from keyphase.labeling.storage.journal import Journal
from keyphase.labeling.storage.records import encode
from keyphase.labeling.storage.state_folder import journal_path
from keyphase.labeling.storage.summary import summarize
from keyphase.segmentation.parameters import Parameters


@pytest.fixture
def demo(tmp_path):
    return demonstration(path=tmp_path / "demo.npz")


@pytest.fixture(autouse=True)
def own_state(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))


class Editor(Person):
    """A person whose edits are journaled."""

    def __init__(self, demo, **options):
        super().__init__(segmentation(made_from=demo))
        self.journal = Journal(demo, **options)
        self.document = self.journal.document

    def makes(self, *edits):
        for edit in edits:
            super().makes(edit)
            self.journal.save(self.document)
        return self.labeling

    def turns(self, document):
        self.document = document
        self.journal.save(document)


def reopened(demo, **options):
    with Journal(demo, **options) as journal:
        return journal


def lines(journal):
    return journal.path.read_bytes().splitlines(keepends=True)


def test_what_was_saved_is_there_again_with_undo_and_redo(demo):
    editor = Editor(demo)
    editor.makes(Add(3.0), Move(4.0, 4.5), Label(5.0, "insert “peg”"))
    editor.turns(editor.document.set_parameters(Parameters(force_ratio=5.0)))
    editor.turns(editor.document.undo().undo())
    editor.journal.close()
    again = reopened(demo).document
    assert again.history == editor.document.history
    assert again.undo_name == "Move boundary 3"
    assert again.redo().redo().parameters == Parameters(force_ratio=5.0)
    assert again.undo().undo().edits == {}


def test_a_step_that_replaced_others_replaces_them_after_a_restart_too(demo):
    editor = Editor(demo)
    editor.makes(Add(3.0), Add(5.0), Add(7.0))
    editor.turns(editor.document.undo().undo())
    editor.makes(Add(1.0))
    editor.journal.close()
    again = reopened(demo).document
    assert times(label(editor.segmentation, again.edits)) == [1.0, 2.0, 3.0, 4.0, 6.0, 8.0]
    assert again.redo_name is None
    assert again.next_number == 4


def test_an_opened_recording_that_nobody_edits_has_no_journal(demo):
    assert not reopened(demo).path.exists()
    assert not summarize(demo.source.path).touched


def test_a_list_of_recordings_knows_which_are_touched_and_done(demo):
    editor = Editor(demo)
    editor.makes(Add(3.0))
    assert summarize(demo.source.path).touched
    editor.turns(editor.document.undo())
    assert not summarize(demo.source.path).touched
    editor.makes(Done())
    assert summarize(demo.source.path).done
    editor.journal.close()
    assert reopened(demo).document.done


def test_the_recording_itself_is_never_written(demo):
    before = demo.source.path.read_bytes(), os.stat(demo.source.path).st_mtime_ns
    Editor(demo).makes(Add(3.0))
    assert (demo.source.path.read_bytes(), os.stat(demo.source.path).st_mtime_ns) == before


def test_a_demonstration_that_was_never_saved_has_no_journal():
    with pytest.raises(JournalError, match="never saved"):
        Journal(demonstration())


def test_a_second_writer_may_only_look_and_is_told_why(demo):
    editor = Editor(demo)
    editor.makes(Add(3.0))
    second = Journal(demo)
    assert second.read_only is not None
    assert str(os.getpid()) in second.read_only
    assert any("looking only" in notice for notice in second.notices)
    assert second.document.history == editor.document.history
    with pytest.raises(JournalError, match="Nothing can be changed"):
        second.save(second.document.undo())
    second.close()
    editor.makes(Add(5.0))


def test_whoever_comes_after_the_writer_may_write(demo):
    Editor(demo).journal.close()
    assert reopened(demo).read_only is None


@pytest.mark.slow
def test_the_lock_of_a_killed_writer_does_not_stay(demo):
    program = (
        "import os, sys; sys.path.insert(0, sys.argv[2]); from pathlib import Path;"
        "from handmade import demonstration; from keyphase.labeling.storage.journal import Journal;"
        "journal = Journal(demonstration(path=Path(sys.argv[1])));"
        "print(journal.read_only, flush=True); sys.stdin.read()"
    )
    arguments = [sys.executable, "-c", program, str(demo.source.path), os.path.dirname(__file__)]
    with subprocess.Popen(
        arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == "None\n"
        assert str(holder.pid) in (reopened(demo).read_only or "")
        holder.kill()
        holder.wait()
    assert reopened(demo).read_only is None


def test_looking_only_writes_and_locks_nothing(demo, tmp_path):
    before = sorted(tmp_path.rglob("*"))
    journal = reopened(demo, read_only=True)
    assert journal.read_only == "opened for looking only"
    assert sorted(tmp_path.rglob("*")) == before


def test_cut_anywhere_in_its_last_line_only_that_line_is_lost(demo):
    editor = Editor(demo)
    editor.makes(Add(3.0), Label(5.0, "insert “peg”"), Add(7.0))
    editor.journal.close()
    *kept, last = lines(editor.journal)
    for cut in (*range(0, len(last) - 1, 5), len(last) - 1):
        editor.journal.path.write_bytes(b"".join(kept) + last[:cut])
        with Journal(demo) as journal:
            whole = cut == len(last) - 1
            assert len(journal.document.edits) == (3 if whole else 2)
            assert bool(journal.notices) == (0 < cut < len(last) - 1)
            journal.save(journal.document.undo())
        assert len(reopened(demo).document.edits) == (2 if whole else 1)
        assert not reopened(demo).notices


def test_a_damaged_line_costs_no_other_and_the_file_as_it_was_is_kept(demo):
    editor = Editor(demo)
    editor.makes(Add(1.0), Add(3.0), Add(5.0), Add(7.0))
    editor.turns(editor.document.undo())
    editor.journal.close()
    damaged = lines(editor.journal)
    damaged[2] = damaged[2].replace(b"3.0", b"3.5")
    editor.journal.path.write_bytes(b"".join(damaged))
    journal = reopened(demo)
    seen = label(editor.segmentation, journal.document.edits)
    assert times(seen) == [1.0, 2.0, 4.0, 5.0, 6.0, 8.0]
    assert journal.document.redo_name == "Add boundary at 7.00 s"
    assert any("left out: 3" in notice for notice in journal.notices)
    assert journal.path.with_suffix(".old-1").read_bytes() == b"".join(damaged)
    assert not reopened(demo).notices


@pytest.mark.parametrize("lost", range(8))
def test_whichever_line_is_damaged_the_rest_is_kept(demo, lost):
    editor = Editor(demo)
    editor.makes(Add(1.0), Add(3.0))
    editor.turns(editor.document.undo())
    editor.turns(editor.document.redo())
    editor.makes(Add(5.0), Remove(3.0), Add(7.0))
    editor.journal.close()
    damaged = lines(editor.journal)
    assert len(damaged) == 8
    added = {1: 1.0, 2: 3.0, 5: 5.0, 7: 7.0}
    damaged[lost] = b"\x00" * 20 + b"\n"
    editor.journal.path.write_bytes(b"".join(damaged))
    found = times(label(editor.segmentation, reopened(demo).document.edits))
    assert {time for line, time in added.items() if line not in (lost, 2)} <= set(found)
    assert (3.0 in found) == (lost == 6)


def test_where_the_undo_was_lost_the_edit_after_it_still_follows_what_it_followed(demo):
    editor = Editor(demo)
    editor.makes(Add(1.0), Add(3.0))
    editor.turns(editor.document.undo())
    editor.makes(Add(5.0))
    editor.journal.close()
    damaged = lines(editor.journal)
    assert b'"at"' in damaged[3]
    damaged[3] = b"broken\n"
    editor.journal.path.write_bytes(b"".join(damaged))
    found = times(label(editor.segmentation, reopened(demo).document.edits))
    assert found == [1.0, 2.0, 4.0, 5.0, 6.0, 8.0]


def test_after_a_damaged_line_an_edit_still_refers_to_the_same_one(demo):
    editor = Editor(demo)
    editor.makes(Add(1.0), Move(4.0, 4.5))
    editor.sees(segmentation((2.0, 6.0), made_from=demo))
    editor.makes(BringBack(1))
    editor.journal.close()
    damaged = lines(editor.journal)
    damaged[1] = b"broken\n"
    editor.journal.path.write_bytes(b"".join(damaged))
    assert times(label(editor.segmentation, reopened(demo).document.edits)) == [2.0, 4.5, 6.0]


def test_records_that_are_not_understood_are_left_out_and_kept_beside(demo):
    editor = Editor(demo)
    editor.makes(Add(3.0))
    editor.journal.close()
    strange = [
        {"op": "dance"},
        {"no": "op"},
        {"op": "step", "number": 9, "after": 0, "name": "x", "edit": {"kind": "dance"}},
        {"op": "step", "number": 9, "after": 0, "name": "x", "parameters": {"force_ratio": -1}},
        {"op": "step", "number": 9, "after": 0, "name": "x", "parameters": {"dance": 1}},
        {"op": "step", "number": "x", "after": 0, "name": "x", "edit": {"kind": "reset"}},
    ]
    with editor.journal.path.open("ab") as file:
        file.writelines(map(encode, strange))
    journal = reopened(demo)
    assert len(journal.document.edits) == 1
    assert any(notice.startswith("6 records") for notice in journal.notices)


def test_a_journal_of_a_later_version_is_refused_and_left_alone(demo):
    editor = Editor(demo)
    editor.makes(Add(3.0))
    editor.journal.close()
    later = encode({"op": "recording", "format": 9, "software": "keyphase 9", "sha256": "0" * 64})
    editor.journal.path.write_bytes(later)
    with pytest.raises(JournalError, match="update keyphase"):
        Journal(demo)
    assert editor.journal.path.read_bytes() == later


@pytest.mark.slow
def test_a_long_journal_is_rewritten_and_leads_to_the_same(demo):
    editor = Editor(demo)
    editor.makes(Add(3.0), Add(5.0))
    for _ in range(150):
        editor.turns(editor.document.undo())
        editor.turns(editor.document.redo())
    editor.turns(editor.document.undo())
    editor.makes(Done())
    editor.journal.close()
    long = len(lines(editor.journal))
    journal = reopened(demo)
    assert len(lines(journal)) < 10 < long
    assert journal.document.history == editor.document.history
    assert journal.document.done
    again = reopened(demo)
    assert (again.document.history, again.document.next_number) == (editor.document.history, 3)


def test_a_changed_recording_keeps_its_labels_and_asks(demo):
    editor = Editor(demo)
    editor.makes(Label(5.0, "insert"))
    assert not editor.journal.changed
    editor.journal.close()
    demo.source.path.write_bytes(b"recorded again")
    now = demonstration(path=demo.source.path)
    with Journal(now) as journal:
        assert journal.changed
        assert labels(label(editor.segmentation, journal.document.edits))[2] == "insert"
        journal.keep_labels()
        assert not journal.changed
    assert not reopened(now).changed


def test_other_parameters_of_the_folder_are_no_step_of_the_recording(demo):
    editor = Editor(demo)
    editor.makes(Add(3.0))
    before = lines(editor.journal)
    editor.turns(editor.document.with_shared(Parameters(force_ratio=5.0)))
    assert editor.journal.document.parameters == Parameters(force_ratio=5.0)
    assert lines(editor.journal) == before
    editor.journal.close()
    assert reopened(demo, shared=Parameters(persistence=1.0)).document.parameters == Parameters(
        persistence=1.0
    )


def test_where_nothing_can_be_written_edits_are_kept_with_the_user(demo, tmp_path):
    (tmp_path / ".keyphase").write_text("in the way")
    editor = Editor(demo)
    editor.makes(Add(3.0))
    assert editor.journal.path.is_relative_to(tmp_path / "state")
    assert any("edits are kept in" in notice for notice in editor.journal.notices)
    editor.journal.close()
    assert len(reopened(demo).document.edits) == 1


def test_edits_follow_when_the_folder_becomes_read_only_and_when_it_is_writable_again(
    demo, monkeypatch, tmp_path
):
    usable = state_folder._usable
    first = Editor(demo)
    first.makes(Add(3.0))
    first.journal.close()
    with monkeypatch.context() as patch:
        patch.setattr(
            state_folder, "_usable", lambda folder: folder.name != ".keyphase" and usable(folder)
        )
        moved = Editor(demo)
        moved.makes(Add(5.0))
        moved.journal.close()
        assert moved.journal.path.is_relative_to(tmp_path / "state")
        assert len(reopened(demo).document.edits) == 2
    assert summarize(demo.source.path).touched
    back = Editor(demo)
    back.makes(Add(7.0))
    back.journal.close()
    assert back.journal.path.is_relative_to(tmp_path / ".keyphase")
    assert len(reopened(demo).document.edits) == 3


def test_where_nothing_can_be_written_at_all_it_is_open_for_looking(demo, tmp_path):
    (tmp_path / ".keyphase").write_text("in the way")
    (tmp_path / "state").write_text("in the way")
    with Journal(demo) as journal:
        assert "neither" in (journal.read_only or "")
        with pytest.raises(JournalError, match="neither"):
            journal.keep_labels()


def test_each_line_is_synced_before_it_is_confirmed(demo, monkeypatch):
    synced = []
    real = os.fsync

    def sync(descriptor):
        if stat.S_ISREG(os.fstat(descriptor).st_mode):
            synced.append(os.fstat(descriptor).st_size)
        real(descriptor)

    editor = Editor(demo)
    monkeypatch.setattr(os, "fsync", sync)
    editor.makes(Add(3.0), Add(5.0))
    assert synced[-1] == editor.journal.path.stat().st_size
    assert len(synced) == 2


def test_a_line_is_a_checksum_and_json(demo):
    editor = Editor(demo)
    editor.makes(Label(5.0, "insert “peg”"))
    assert editor.journal.path == journal_path(
        demo.source.path, demo.source.path.parent / ".keyphase"
    )
    for line in lines(editor.journal):
        checksum, _, content = line.rstrip(b"\n").partition(b" ")
        assert int(checksum, 16) == zlib.crc32(content)
        json.loads(content)
