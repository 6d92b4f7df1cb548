"""The document: parameters and edits in one history."""

import pytest
from handmade import Person, segmentation, times

from keyphase.errors import LabelingError
from keyphase.labeling.document import Document
from keyphase.labeling.edits import (
    Accept,
    AcceptLabels,
    Add,
    Contact,
    DropIdle,
    Keep,
    Label,
    Merge,
    Move,
    Plan,
    Remove,
    Reset,
)
from keyphase.segmentation.parameters import Parameters


def test_a_change_leaves_the_document_it_came_from_alone():
    person = Person(segmentation())
    before = person.document
    person.makes(Add(3.0))
    assert before.edits == {}
    assert list(person.document.edits.values()) == [Add(3.0, False)]


def test_undo_and_redo_walk_through_edits_and_parameters_alike():
    person = Person(segmentation())
    person.makes(Add(3.0))
    changed = person.document.set_parameters(Parameters(force_ratio=5.0))
    back = changed.undo().undo()
    assert (back.edits, back.parameters) == ({}, Parameters())
    again = back.redo().redo()
    assert (again.edits, again.parameters) == (changed.edits, changed.parameters)
    assert times(Person(segmentation()).labeling) == [2.0, 4.0, 6.0, 8.0]


def test_a_new_step_replaces_what_was_taken_back():
    person = Person(segmentation())
    person.makes(Add(3.0), Add(5.0))
    person.document = person.document.undo()
    assert times(person.makes(Add(7.0))) == [2.0, 3.0, 4.0, 6.0, 7.0, 8.0]
    with pytest.raises(LabelingError, match="nothing to redo"):
        person.document.redo()


def test_there_is_an_end_to_undo():
    document = Document(segmentation().demonstration)
    with pytest.raises(LabelingError, match="nothing to undo"):
        document.undo()
    assert (document.undo_name, document.redo_name) == (None, None)


@pytest.mark.parametrize(
    ("edit", "name"),
    [
        (Add(3.0), "Add boundary at 3.00 s"),
        (Remove(4.0), "Remove boundary 2"),
        (Move(4.0, 4.5), "Move boundary 2"),
        (Contact(4.0, True), "Boundary 2 is a contact change"),
        (Contact(4.0, False), "Boundary 2 is no contact change"),
        (Accept(8.0), "Accept boundary 4"),
        (Label(5.0, "insert"), "Label segment 3 “insert”"),
        (Label(5.0, "a label that goes on and on"), "Label segment 3 “a label that goes on an…”"),
        (Label(5.0, ""), "Give segment 3 its proposed label"),
        (Label(3.0, "", to_s=5.0), "Give segments 2 to 3 their proposed labels"),
        (Keep(5.0, False), "Drop segment 3"),
        (Keep(3.0, True), "Keep segment 2"),
        (Merge(5.0, 9.0), "Merge segments 3 to 5"),
        (Plan((1.0,)), "Change the plan"),
        (DropIdle(), "Drop 1 idle segment"),
        (AcceptLabels(), "Accept 4 labels"),
        (Reset(), "Reset to automatic"),
    ],
)
def test_undo_is_named_after_what_it_takes_back(edit, name):
    person = Person(segmentation(idle=(1,)))
    person.makes(edit)
    assert person.document.undo_name == name
    assert person.document.undo().redo_name == name


@pytest.mark.parametrize(
    ("parameters", "name"),
    [
        (Parameters(force_threshold=23.94), "Threshold 23.94"),
        (Parameters(gaussians=5), "Gaussians 5"),
        (Parameters(variant="paper"), "Method as published"),
        (Parameters(mixture="scikit-learn"), "Mixture scikit-learn"),
        (Parameters(force_ratio=1.0, persistence=1.0), "Change 2 parameters"),
    ],
)
def test_a_change_of_parameters_is_named_after_them(parameters, name):
    document = Document(segmentation().demonstration).set_parameters(parameters)
    assert document.undo_name == name
    assert document.parameters == parameters


def test_one_change_of_parameters_leaves_the_one_before_in_force():
    document = Document(segmentation().demonstration)
    document = document.set_parameters(Parameters(gaussians=5))
    document = document.set_parameters(Parameters(gaussians=5, force_ratio=3.0))
    assert document.parameters == Parameters(gaussians=5, force_ratio=3.0)
    assert document.undo().parameters == Parameters(gaussians=5)


def test_a_parameter_back_to_automatic_is_named_so():
    document = Document(segmentation().demonstration, Parameters(gaussians=4))
    document = document.set_parameters(Parameters())
    assert document.undo_name == "Gaussians automatic"
    assert document.parameters == Parameters()


def test_parameters_that_do_not_differ_are_no_step():
    document = Document(segmentation().demonstration)
    assert document.set_parameters(Parameters()) is document
    assert document.reset_parameters() is document


def test_a_recording_departs_from_its_folder_only_in_what_was_changed_on_it():
    document = Document(segmentation().demonstration, Parameters(persistence=2.0))
    document = document.set_parameters(Parameters(persistence=2.0, force_ratio=5.0))
    assert document.own_parameters == {"force_ratio": 5.0}
    elsewhere = document.with_shared(Parameters(persistence=3.0))
    assert elsewhere.parameters == Parameters(persistence=3.0, force_ratio=5.0)
    assert elsewhere.reset_parameters().parameters == Parameters(persistence=3.0)
    assert elsewhere.reset_parameters().undo().parameters == elsewhere.parameters
