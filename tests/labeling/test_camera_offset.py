"""A person lays a video on the recording's clock; that is an edit like any other."""

import pytest
from handmade import Person, demonstration, segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.edits import CameraOffset, Done, Label, Reset, edit_from_json
from keyphase.labeling.edits.beside.camera_offset import camera_offsets
from keyphase.labeling.storage.journal import Journal


@pytest.fixture
def person():
    return Person(segmentation())


def test_the_latest_offset_of_each_camera_counts_and_is_undone_by_itself(person):
    person.makes(CameraOffset("wrist", 0.25))
    person.makes(CameraOffset("scene", -1.0))
    person.makes(CameraOffset("wrist", 0.5))
    assert camera_offsets(person.document.edits) == {"wrist": 0.5, "scene": -1.0}
    assert person.document.undo_name == "Offset of camera wrist: +500 ms"
    person.document = person.document.undo()
    assert camera_offsets(person.document.edits) == {"wrist": 0.25, "scene": -1.0}


def test_taking_back_all_edits_takes_back_offsets(person):
    person.makes(CameraOffset("wrist", 0.25))
    person.makes(Reset())
    assert camera_offsets(person.document.edits) == {}


def test_an_offset_changes_no_segment_and_a_recording_that_is_done_stays_as_it_was(person):
    person.makes(Label(1.0, "reach"))
    person.makes(Done())
    before = person.labeling
    person.makes(CameraOffset("wrist", 0.25))
    assert person.labeling.segments == before.segments
    assert not person.labeling.changed_since_done
    assert camera_offsets(person.document.edits) == {"wrist": 0.25}


def test_an_offset_is_kept_in_the_journal(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    demo = demonstration(path=tmp_path / "demo.npz")
    journal = Journal(demo)
    person = Person(segmentation(made_from=demo))
    person.document = journal.document
    person.makes(CameraOffset("wrist", -0.04))
    journal.save(person.document)
    journal.close()
    again = Journal(demo)
    assert camera_offsets(again.document.edits) == {"wrist": -0.04}
    again.close()


@pytest.mark.parametrize("wrong", [1e7, float("nan"), "soon"])
def test_an_offset_longer_than_a_recording_is_refused(wrong):
    with pytest.raises(LabelingError):
        edit_from_json({"kind": "camera_offset", "camera": "wrist", "offset_s": wrong})
