"""The plan under a person's edits."""

import pytest
from handmade import Person, plan, segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.edits import Add, DropIdle, Keep, Merge, Move, Plan, Reset


def test_the_plan_is_the_kept_segments_in_the_order_of_time():
    assert plan(Person(segmentation(idle=(1, 3))).labeling) == [0, 2, 4]


def test_a_person_orders_repeats_and_leaves_out():
    seen = Person(segmentation(idle=(1, 3))).makes(Plan((9.0, 1.0, 9.0)))
    assert plan(seen) == [4, 0, 4]
    assert [entry.repeat for entry in seen.plan] == [0, 0, 1]
    assert [entry.time_s for entry in seen.plan] == [9.0, 1.0, 9.0]


def test_an_empty_plan_is_a_plan():
    assert plan(Person(segmentation()).makes(Plan(()))) == []


def test_a_dropped_segment_leaves_the_plan_and_returns_to_its_place():
    person = Person(segmentation())
    person.makes(Plan((9.0, 1.0, 3.0, 5.0, 7.0)))
    assert plan(person.makes(Keep(1.0, False))) == [4, 1, 2, 3]
    assert plan(person.makes(Keep(1.0, True))) == [4, 0, 1, 2, 3]


def test_a_segment_kept_later_follows_the_one_before_it_in_time():
    person = Person(segmentation(idle=(1,)))
    person.makes(DropIdle(), Plan((9.0, 1.0, 5.0, 7.0)))
    assert plan(person.makes(Keep(3.0, True))) == [4, 0, 1, 2, 3]


def test_a_segment_left_out_stays_out():
    person = Person(segmentation())
    person.makes(Plan((9.0, 1.0)))
    assert plan(person.makes(Move(4.0, 4.5))) == [4, 0]
    assert plan(person.sees(segmentation((2.1, 4.0, 6.1, 8.0)))) == [4, 0]


def test_the_parts_of_a_split_segment_stand_where_it_stood():
    person = Person(segmentation())
    person.makes(Plan((5.0, 1.0, 5.0)), Add(5.0))
    assert plan(person.labeling) == [2, 3, 0, 2, 3]


def test_merged_segments_stand_where_the_longest_stood():
    person = Person(segmentation((1.0, 4.0)))
    person.makes(Plan((8.0, 2.0, 0.5)), Merge(0.5, 2.0))
    assert plan(person.labeling) == [1, 0]


def test_the_last_plan_counts():
    assert plan(Person(segmentation()).makes(Plan((9.0,)), Plan((1.0, 3.0)))) == [0, 1]


def test_reset_takes_the_plan_back():
    assert plan(Person(segmentation()).makes(Plan((9.0,)), Reset())) == [0, 1, 2, 3, 4]


def test_a_plan_of_dropped_segments_is_refused():
    with pytest.raises(LabelingError, match="dropped"):
        Person(segmentation(idle=(1,))).makes(Plan((3.0,)))
