"""A stretch of time becomes one named segment, as when a key is held while the recording plays."""

import pytest
from handmade import Person, segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.edits import NameStretch


@pytest.fixture
def person():
    return Person(segmentation())


def spans(labeling):
    return [(segment.start_s, segment.end_s) for segment in labeling.segments]


def test_boundaries_come_at_its_sides_and_those_between_go(person):
    first, second = (boundary.time_s for boundary in person.labeling.boundaries[:2])
    before, after = first - 0.5, second + 0.3
    labeling = person.makes(NameStretch(before, after, " insert "))
    named = next(s for s in labeling.segments if s.label == "insert")
    assert (named.start_s, named.end_s) == (before, after)
    assert not named.proposed
    assert person.document.undo_name == f"“insert” from {before:.2f} to {after:.2f} s"
    person.document = person.document.undo()
    assert first in {boundary.time_s for boundary in person.labeling.boundaries}


def test_boundaries_that_are_there_are_its_sides(person):
    before = spans(person.labeling)
    start, end = before[1]
    labeling = person.makes(NameStretch(end - 0.02, start + 0.03, "insert"))
    assert spans(labeling) == before
    assert labeling.segments[1].label == "insert"


def test_the_ends_of_the_recording_are_sides_too(person):
    labeling = person.makes(NameStretch(-5.0, 50.0, "all"))
    assert [segment.label for segment in labeling.segments] == ["all"]


def test_one_that_is_too_short_is_refused(person):
    with pytest.raises(LabelingError, match="hold the key longer"):
        person.makes(NameStretch(1.0, 1.01, "insert"))


def test_one_without_a_name_is_refused(person):
    with pytest.raises(LabelingError, match="it is empty"):
        person.makes(NameStretch(1.0, 2.0, " "))
