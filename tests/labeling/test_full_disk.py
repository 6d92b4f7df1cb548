"""A disk without room, or one that becomes read-only, loses nothing that was confirmed."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from handmade import Person, demonstration, segmentation
from small_disk import SmallDisk, small_disk

from keyphase.demonstration import Demonstration
from keyphase.errors import JournalError, KeyphaseError
from keyphase.labeling.edits import Label
from keyphase.labeling.storage.folder_settings import change_folder_settings, read_folder_settings
from keyphase.labeling.storage.journal import Journal
from keyphase.labeling.storage.written_files import write_unasked
from keyphase.labeling.vocabulary import Vocabulary


@pytest.fixture
def disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[SmallDisk]:
    with small_disk(tmp_path / "disk") as disk:
        # What cannot be kept beside the recordings cannot be kept elsewhere either.
        monkeypatch.setenv("XDG_STATE_HOME", str(disk.path / "state"))
        yield disk


@pytest.fixture
def demo(disk: SmallDisk) -> Demonstration:
    return demonstration(path=disk.path / "demo.npz")


def _saves(journal: Journal, label: str) -> bool:
    """Whether one edit more is confirmed."""
    person = Person(segmentation(made_from=journal.document.demonstration))
    person.document = journal.document
    person.makes(Label(3.0, label))
    try:
        journal.save(person.document)
    except JournalError:
        return False
    return True


def _edits(demo: Demonstration) -> int:
    with Journal(demo, read_only=True) as journal:
        return len(journal.document.edits)


def test_an_edit_that_does_not_fit_was_not_made_and_the_next_one_that_fits_is(
    disk: SmallDisk, demo: Demonstration
) -> None:
    with Journal(demo) as journal:
        confirmed = int(_saves(journal, "first"))
        with disk.full():
            # What is left of the last block may still take some.
            while _saves(journal, f"{confirmed:0200d}"):
                confirmed += 1
            assert len(journal.document.edits) == confirmed
        assert _edits(demo) == confirmed
        assert _saves(journal, "last")
    assert _edits(demo) == confirmed + 1


def test_a_torn_journal_opens_for_looking_and_is_mended_once_there_is_room(
    disk: SmallDisk, demo: Demonstration
) -> None:
    with Journal(demo) as journal:
        assert _saves(journal, "first")
        assert _saves(journal, "second")
    torn = journal.path.read_bytes()[:-10]
    journal.path.write_bytes(torn)
    with disk.full(), Journal(demo) as journal:
        assert len(journal.document.edits) == 1
        assert journal.read_only is not None
    assert journal.path.read_bytes() == torn
    with Journal(demo) as journal:
        assert journal.read_only is None
        assert len(journal.document.edits) == 1


def test_settings_and_exports_that_do_not_fit_stay_as_they_were(disk: SmallDisk) -> None:
    settings = change_folder_settings(
        disk.path, lambda each: replace(each, vocabulary=Vocabulary().with_label("push"))
    )
    file = write_unasked(disk.path / "a.segments.json", b"first", "a.npz")
    many = Vocabulary()
    for number in range(200):
        many = many.with_label(f"label {number}")
    with disk.full():
        with pytest.raises(JournalError):
            change_folder_settings(disk.path, lambda each: replace(each, vocabulary=many))
        with pytest.raises(KeyphaseError, match="cannot be written"):
            write_unasked(file, b"second" * 5000, "a.npz")
    assert read_folder_settings(disk.path).vocabulary == settings.vocabulary
    assert file.read_bytes() == b"first"
    assert not list(disk.path.rglob(".keyphase-*"))


def test_a_folder_that_becomes_read_only_while_open_loses_nothing_confirmed(
    disk: SmallDisk, demo: Demonstration
) -> None:
    other = demonstration(path=disk.path / "other.npz")
    with Journal(demo) as begun, Journal(other) as new:
        confirmed = [int(_saves(begun, "first")), 0]
        with disk.read_only() as refuses:
            confirmed[0] += _saves(begun, "second")
            confirmed[1] += _saves(new, "first")
            # A file that is open already may take lines; one more cannot be made.
            assert confirmed[1] == (not refuses)
        assert [_edits(demo), _edits(other)] == confirmed
        assert _saves(new, "last")
    assert _edits(other) == confirmed[1] + 1
