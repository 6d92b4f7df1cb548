"""A boundary moved with all later ones: what comes after keeps its lengths."""

import numpy as np
import pytest
from handmade import Person, segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.edits import Label, Move, Ripple


@pytest.fixture
def person():
    return Person(segmentation())


def times(labeling):
    return [boundary.time_s for boundary in labeling.boundaries]


@pytest.mark.parametrize("by_s", [-0.2, 0.2])
def test_all_later_boundaries_go_with_it_in_one_step(person, by_s):
    before = times(person.labeling)
    person.makes(Label(before[1] + 0.1, "insert"))
    moved = person.makes(Ripple(before[1], by_s))

    assert len(before) > 2
    assert times(moved)[0] == before[0]
    np.testing.assert_allclose(times(moved)[1:], np.array(before[1:]) + by_s)
    assert moved.segments[2].label == "insert"
    assert [boundary.was_s for boundary in moved.boundaries] == [None, *before[1:]]
    assert person.document.undo_name == "Move boundary 2 and all later ones"
    person.document = person.document.undo()
    assert times(person.labeling) == before


def test_it_stops_before_the_boundary_in_front_and_the_end(person):
    before = times(person.labeling)
    for by_s in (before[0] - before[1], 100.0):
        with pytest.raises(LabelingError, match="Boundary 2 and those after it can be moved by"):
            person.makes(Ripple(before[1], by_s))
    assert times(person.labeling) == before


def test_what_was_moved_since_moves_from_where_it_is(person):
    before = times(person.labeling)
    person.makes(Move(before[2], before[2] + 0.1))
    person.makes(Ripple(before[1], 0.2))
    np.testing.assert_allclose(times(person.labeling)[1:3], [before[1] + 0.2, before[2] + 0.3])
