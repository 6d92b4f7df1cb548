"""Two segmentations of one recording beside each other."""

import pytest
from handmade import Person, segmentation
from hypothesis import given
from hypothesis import strategies as st

from keyphase.errors import LabelingError
from keyphase.labeling.comparing.comparison import Outline, compare
from keyphase.labeling.edits import Label, Move, Remove
from keyphase.labeling.label import label

boundaries = st.lists(st.floats(0.1, 9.9), max_size=8, unique=True).map(sorted)


def outline(times, labels=None):
    return Outline(tuple(times), tuple(labels or "x" * (len(times) + 1)), (0.0, 10.0))


def test_it_says_what_is_shared_and_what_only_one_has():
    found = segmentation()
    person = Person(found)
    person.makes(Move(4.0, 4.2), Remove(8.0))
    seen = compare(Outline.of_labeling(label(found)), Outline.of_labeling(person.labeling))
    assert [pair.first_s for pair in seen.shared] == [2.0, 4.0, 6.0]
    assert [round(pair.distance_s, 6) for pair in seen.shared] == [0.0, 0.2, 0.0]
    assert (seen.only_first_s, seen.only_second_s) == ((8.0,), ())
    assert seen.f1 == pytest.approx(6 / 7)


def test_the_part_of_the_time_with_the_same_label_counts():
    found = segmentation()
    person = Person(found)
    person.makes(Label(5.0, "insert"))
    seen = compare(Outline.of_labeling(label(found)), Outline.of_labeling(person.labeling))
    assert seen.same_label == pytest.approx(0.8)
    assert (seen.f1, seen.covering) == (1.0, pytest.approx(1.0))


def test_two_that_found_nothing_agree():
    assert compare(outline([]), outline([])).f1 == 1.0


@given(boundaries, boundaries)
def test_swapping_the_two_changes_only_the_names(a, b):
    forth, back = compare(outline(a), outline(b)), compare(outline(b), outline(a))
    assert (forth.f1, forth.covering, forth.same_label) == pytest.approx(
        (back.f1, back.covering, back.same_label)
    )
    assert len(forth.only_first_s) == len(back.only_second_s)
    assert len(forth.shared) + len(forth.only_first_s) == len(a)


@given(boundaries)
def test_a_segmentation_agrees_with_itself(a):
    seen = compare(outline(a), outline(a))
    assert (seen.f1, seen.covering, seen.same_label) == pytest.approx((1.0, 1.0, 1.0))


def test_segmentations_of_different_recordings_are_refused():
    with pytest.raises(LabelingError, match="one recording"):
        compare(outline([1.0]), Outline((), ("x",), (0.0, 12.0)))
