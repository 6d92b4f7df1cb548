"""A person marks a recording, or a segment, as a success or a failure, with quality and note."""

import pytest
from handmade import Person, demonstration, segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.assessment import Assessment
from keyphase.labeling.edits import Add, Assess, AssessSegment, Done, Reset, edit_from_json
from keyphase.labeling.segment_file import read_segment_file, write_segment_file
from keyphase.labeling.storage.journal import Journal
from keyphase.labeling.storage.summary import summarize


@pytest.fixture
def person():
    return Person(segmentation())


def test_what_is_said_last_counts_and_each_step_is_undone_by_itself(person):
    person.makes(Assess("success"), Assess("success", 4), Assess("success", 4, "gripper slipped"))
    assert person.labeling.assessment == Assessment("success", 4, "gripper slipped")
    assert person.document.undo_name == "Note on the recording"
    person.document = person.document.undo()
    assert person.document.undo_name == "Quality 4"
    assert person.labeling.assessment == Assessment("success", 4)


def test_a_recording_that_is_done_can_be_marked_and_stays_done(person):
    person.makes(Done(), Assess("failure"))
    assert person.labeling.done
    assert not person.labeling.changed_since_done
    assert person.labeling.assessment.outcome == "failure"


def test_taking_back_all_edits_takes_it_back(person):
    assert person.makes(Assess("failure"), Reset()).assessment == Assessment()


def test_saying_it_again_is_no_step(person):
    person.makes(Assess("failure"))
    with pytest.raises(LabelingError, match="marked so already"):
        person.makes(Assess("failure"))


@pytest.mark.parametrize(
    "wrong", [{"quality": 0}, {"quality": 6}, {"outcome": "fine"}, {"note": "x" * 1001}]
)
def test_what_is_on_no_scale_is_refused(wrong):
    with pytest.raises(LabelingError):
        edit_from_json({"kind": "assess", **wrong})


def test_it_stands_in_the_journal_the_list_and_the_segment_file(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    path = tmp_path / "demo.npz"
    demo = demonstration(path=path)
    said = Assessment("failure", 2, "late")
    with Journal(demo) as journal:
        person = Person(segmentation(made_from=demo))
        person.document = journal.document
        person.makes(Assess("failure", 2, " late "))
        journal.save(person.document)
    assert summarize(path).assessment == said
    write_segment_file(person.labeling, tmp_path / "demo.segments.json")
    file = read_segment_file(tmp_path / "demo.segments.json", check_recording=False)
    assert file.assessment == said


def test_a_single_segment_is_marked_and_its_parts_keep_the_mark(person):
    person.makes(AssessSegment(1.0, "failure", note=" slipped "))
    assert person.document.undo_name == "Mark segment 1 as failure"
    person.makes(Add(1.0, contact_change=False))
    said = [segment.assessment for segment in person.labeling.segments]
    assert said[:3] == [Assessment("failure", None, "slipped")] * 2 + [Assessment()]


def test_a_mark_of_a_segment_outlasts_being_done(person):
    person.makes(AssessSegment(1.0, quality=2), Done())
    assert person.labeling.segments[0].assessment == Assessment(None, 2)
    assert not person.labeling.changed_since_done


def test_saying_it_again_of_a_segment_is_no_step(person):
    person.makes(AssessSegment(1.0, "failure"))
    with pytest.raises(LabelingError, match="Marked so already: segment 1"):
        person.makes(AssessSegment(1.0, "failure"))
    assert not person.makes(AssessSegment(1.0)).segments[0].assessment


def test_marks_of_segments_stand_in_the_journal_the_list_and_the_segment_file(
    tmp_path, monkeypatch
):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    path = tmp_path / "demo.npz"
    demo = demonstration(path=path)
    with Journal(demo) as journal:
        person = Person(segmentation(made_from=demo))
        person.document = journal.document
        person.makes(AssessSegment(1.0, "failure"), AssessSegment(1.0, "success", 4))
        journal.save(person.document)
    assert summarize(path).marked == (Assessment("success", 4),)
    write_segment_file(person.labeling, tmp_path / "demo.segments.json")
    file = read_segment_file(tmp_path / "demo.segments.json", check_recording=False)
    assert file.segments[0].assessment == Assessment("success", 4)
    assert not file.segments[1].assessment
