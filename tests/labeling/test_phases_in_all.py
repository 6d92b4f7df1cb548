"""A phase renamed or dropped in one of the recordings in which that is done together."""

import pytest
from handmade import Person, segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.edits import (
    DropPhase,
    Label,
    Move,
    RenamePhase,
    edit_as_json,
    edit_from_json,
)


@pytest.fixture
def person():
    """Who has named two segments alike."""
    person = Person(segmentation())
    person.makes(Label(1.0, "reach"), Label(5.0, "reach"))
    return person


def names(person):
    return [segment.label for segment in person.labeling.segments]


def test_every_segment_of_the_name_is_called_otherwise(person):
    before = names(person)
    person.makes(RenamePhase("reach", "approach", "s1"))
    assert names(person) == [name.replace("reach", "approach") for name in before]
    assert names(person).count("approach") == 2


def test_a_rename_holds_where_its_boundary_is_moved_later(person):
    person.makes(RenamePhase("reach", "approach", "s1"))
    time_s = person.labeling.boundaries[0].time_s
    person.makes(Move(time_s, time_s + 0.3))
    assert names(person)[0] == "approach"


def test_every_kept_segment_of_the_name_is_dropped(person):
    person.makes(DropPhase("reach", "s1"))
    assert [s.kept for s in person.labeling.segments if s.label == "reach"] == [False, False]
    with pytest.raises(LabelingError, match="No segment here"):
        person.makes(DropPhase("reach", "s2"))


@pytest.mark.parametrize(
    ("wrong", "why"),
    [
        (RenamePhase("gone", "x", "s"), "No segment here is called “gone”"),
        (RenamePhase("reach", "reach ", "s"), "called so already"),
        (RenamePhase("reach", " ", "s"), "empty"),
        (RenamePhase("reach", "a\nb", "s"), "plain text"),
    ],
)
def test_what_changes_nothing_or_is_no_name_is_refused(person, wrong, why):
    with pytest.raises(LabelingError, match=why):
        person.makes(wrong)


def test_a_journal_gives_it_back_as_it_was(person):
    edit = RenamePhase("reach", "approach", "s1").anchored(person.labeling)
    assert edit_from_json(edit_as_json(edit)) == edit
