"""Another person's segmentation is taken over as one edit, and undone as one."""

import json
from dataclasses import replace

import pytest
from handmade import Person, demonstration, labels, segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.comparing.comparison import Outline, compare
from keyphase.labeling.comparing.taking_over import taking_over
from keyphase.labeling.edits import (
    Accept,
    Add,
    Done,
    Keep,
    Label,
    Move,
    Plan,
    Remove,
    TakeOver,
    edit_as_json,
    edit_from_json,
)
from keyphase.labeling.segment_file import read_segment_file, write_segment_file
from keyphase.workbench.showing.doubts import unsure_count
from keyphase.workbench.showing.reasons import Meeting, sentences


@pytest.fixture
def found(tmp_path):
    """What the program found in a recording that both people label."""
    return segmentation((2.0, 4.0, 7.0), made_from=demonstration(path=tmp_path / "demo.npz"))


@pytest.fixture
def annas(found, tmp_path):
    """Anna's segment file: a boundary moved, one removed, one added; names, a drop, an order."""
    anna = Person(found)
    labeled = anna.makes(
        Move(2.0, 2.5),
        Remove(7.0),
        Add(8.0, True),
        Label(1.0, "reach"),
        Keep(3.0, False),
        Plan((9.0, 1.0, 9.0, 6.0)),
    )
    path = tmp_path / "anna.segments.json"
    write_segment_file(labeled, path)
    return read_segment_file(path, check_recording=False)


def test_what_was_taken_over_is_what_the_file_says(found, annas):
    person = Person(found)
    taken = person.makes(Add(5.0), Label(1.0, "mine"), taking_over(annas, found))

    assert [b.time_s for b in taken.boundaries] == [2.5, 4.0, 8.0]
    assert labels(taken) == [segment.label for segment in annas.segments]
    assert [s.kept for s in taken.segments] == [s.kept for s in annas.segments]
    assert [entry.segment + 1 for entry in taken.plan] == list(annas.plan)
    assert taken.boundaries[2].contact_change
    assert taken.inapplicable == ()
    assert compare(Outline.of_labeling(taken), Outline.of_file(annas)).same_label == 1.0


def test_boundaries_both_have_keep_the_evidence_of_the_program(found, annas):
    taken = Person(found).makes(taking_over(annas, found))

    assert [b.automatic is not None for b in taken.boundaries] == [False, True, False]


def test_it_is_one_step_that_undo_takes_back(found, annas):
    person = Person(found)
    person.makes(Add(5.0), taking_over(annas, found))
    assert person.document.undo_name == "Take over “anna.segments.json”"

    person.document = person.document.undo()
    assert [b.time_s for b in person.labeling.boundaries] == [2.0, 4.0, 5.0, 7.0]


def test_edits_go_on_after_it(found, annas):
    taken = Person(found).makes(taking_over(annas, found), Label(1.0, "approach"))

    assert labels(taken)[0] == "approach"


def test_it_goes_through_the_journals_json_unchanged(found, annas):
    edit = taking_over(annas, found)

    assert edit_from_json(json.loads(json.dumps(edit_as_json(edit)))) == edit


def test_a_file_of_any_name_can_be_taken_over_and_journaled(found, annas, tmp_path):
    strange = replace(annas, path=tmp_path / "an\nna\u202e.segments.json")
    edit = taking_over(strange, found)

    assert edit_from_json(edit_as_json(edit)) == edit
    assert edit.source == "an?na?.segments.json"


@pytest.mark.parametrize("label", ["a\nb", "\x11", "\u202ereversed", "x" * 500])
def test_labels_that_are_no_names_are_taken_over_as_plain_text(found, annas, label):
    first, *others = annas.segments
    edit = taking_over(replace(annas, segments=(replace(first, label=label), *others)), found)

    assert edit_from_json(edit_as_json(edit)) == edit


@pytest.mark.parametrize(
    "edit",
    [
        TakeOver("proposed", (Label(1.0, "a\nb"),)),
        TakeOver("a\nb", ()),
        TakeOver("proposed", (Add(1.0),) * 200_001),
    ],
)
def test_what_a_journal_could_not_read_back_is_refused_before_it_is_confirmed(found, edit):
    with pytest.raises(LabelingError):
        Person(found).makes(edit)


@pytest.mark.parametrize(
    "content",
    [
        {"source": "x", "edits": [{"kind": "take_over", "source": "y", "edits": []}]},
        {"source": "x", "edits": [{"kind": "reset"}]},
        {"source": "x", "edits": ["add"]},
        {"source": "x", "edits": [{"kind": "add", "time_s": 1e300}]},
        {"source": "a\nb", "edits": []},
        {"source": "x"},
        {"source": "x", "edits": [], "more": 1},
    ],
)
def test_what_is_no_taking_over_is_refused(content):
    with pytest.raises(LabelingError):
        edit_from_json({"kind": "take_over", **content})


def test_a_file_about_another_stretch_of_time_is_refused(annas, tmp_path):
    shorter = segmentation(
        (2.0,), made_from=demonstration(duration_s=5.0, path=tmp_path / "demo.npz")
    )
    with pytest.raises(LabelingError, match="choose a segment file of this recording"):
        taking_over(annas, shorter)


def test_what_a_proposal_was_not_sure_of_is_in_doubt_until_it_is_accepted_or_moved(found):
    doubtful = TakeOver("proposed", (Add(5.0), Add(9.0)), ((2.0, 0.9), (5.0, 0.3), (9.0, 0.4)))
    person = Person(found)

    taken = person.makes(doubtful)
    assert [b.confidence for b in taken.boundaries if b.time_s in (2.0, 5.0, 9.0)] == [
        0.9,
        0.3,
        0.4,
    ]
    assert unsure_count(taken) == 2
    assert unsure_count(person.makes(Accept(5.0))) == 1
    assert unsure_count(person.makes(Move(9.0, 8.9))) == 0


def test_a_boundary_that_was_taken_over_says_so_until_it_is_moved(found, annas):
    person = Person(found)

    def said(labeled):
        added = (one for one in labeled.boundaries if one.origin == "user")
        return [sentences(one, None, Meeting(())) for one in added]

    taken = ["Taken over: anna.segments.json."]
    assert said(person.makes(taking_over(annas, found))) == [taken, taken]
    assert said(person.makes(Done())) == [taken, taken]
    assert said(person.makes(Move(2.5, 2.7))) == [["Placed by you."], taken]
