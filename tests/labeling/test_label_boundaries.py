"""Boundaries under a person's edits, before and after the program changes its mind."""

import pytest
from handmade import Person, boundary, labels, peak, segmentation, times

from keyphase.errors import LabelingError
from keyphase.labeling.edits import (
    Accept,
    Add,
    BringBack,
    Contact,
    Forget,
    Merge,
    Move,
    Remove,
    Reset,
)
from keyphase.labeling.label import label


def test_without_edits_it_is_what_the_program_found():
    found = segmentation()
    seen = label(found)
    assert times(seen) == [2.0, 4.0, 6.0, 8.0]
    assert [b.origin for b in seen.boundaries] == ["position"] * 4
    assert [b.automatic for b in seen.boundaries] == list(found.boundaries)
    assert labels(seen) == [s.label for s in found.segments]
    assert all(s.proposed and s.kept for s in seen.segments)


def test_an_added_boundary_is_the_persons_and_certain():
    seen = Person(segmentation()).makes(Add(3.0))
    assert times(seen) == [2.0, 3.0, 4.0, 6.0, 8.0]
    added = seen.boundaries[1]
    assert (added.origin, added.confidence, added.interval_s) == ("user", 1.0, (3.0, 3.0))
    assert added.automatic is None
    assert labels(seen) == ["part 1", "new", "new", "part 3", "part 4", "part 5"]


def test_an_added_boundary_is_a_contact_change_where_the_force_stays_changed():
    found = segmentation(peaks=(peak(3.05, rejection="too close"), peak(5.0, persistence=1.0)))
    seen = Person(found).makes(Add(3.0), Add(5.0), Add(7.0, contact_change=True))
    assert [b.time_s for b in seen.boundaries if b.contact_change] == [3.0, 7.0]
    assert seen.segments[1].label == "new until contact"


def test_a_moved_boundary_remembers_where_it_was_and_why_it_was_there():
    seen = Person(segmentation()).makes(Move(4.0, 4.6))
    moved = seen.boundaries[1]
    assert (moved.time_s, moved.was_s, moved.origin) == (4.6, 4.0, "user")
    assert moved.automatic is not None
    assert moved.automatic.time_s == 4.0
    assert moved.interval_s == (3.95, 4.6)
    assert labels(seen)[1:3] == ["new", "new"]


def test_a_boundary_moved_twice_remembers_where_the_program_had_it():
    seen = Person(segmentation()).makes(Move(4.0, 4.6), Move(4.6, 4.8))
    assert (seen.boundaries[1].time_s, seen.boundaries[1].was_s) == (4.8, 4.0)


def test_an_edit_means_the_boundary_nearest_to_the_time_given():
    assert times(Person(segmentation()).makes(Move(4.1, 4.6))) == [2.0, 4.6, 6.0, 8.0]


def test_merging_removes_what_lies_between():
    assert times(Person(segmentation()).makes(Merge(3.0, 7.0))) == [2.0, 8.0]
    assert times(Person(segmentation()).makes(Merge(2.0, 8.0))) == [2.0, 8.0]


def test_a_merge_leaves_its_outer_boundaries_alone_when_they_wander():
    person = Person(segmentation())
    person.makes(Merge(2.0, 8.0))
    assert times(person.sees(segmentation((2.1, 4.0, 5.0, 7.9)))) == [2.1, 7.9]


def test_accepting_and_judging_contact_leave_the_boundary_where_it_is():
    seen = Person(segmentation()).makes(Accept(4.0), Contact(6.0, True))
    assert [b.accepted for b in seen.boundaries] == [False, True, False, False]
    assert [b.contact_change for b in seen.boundaries] == [False, False, True, False]
    assert seen.boundaries[2].origin == "position"
    assert labels(seen)[2] == "new until contact"


def test_a_removed_boundary_stays_removed_when_the_program_finds_it_elsewhere():
    person = Person(segmentation())
    person.makes(Remove(4.0))
    assert times(person.sees(segmentation((2.0, 4.1, 6.0)))) == [2.0, 6.0]
    assert times(person.sees(segmentation((2.0, 6.0)))) == [2.0, 6.0]
    assert not person.labeling.inapplicable
    assert times(person.sees(segmentation((2.0, 3.95, 6.0)))) == [2.0, 6.0]


def test_removing_one_boundary_spares_its_neighbours():
    person = Person(segmentation())
    person.makes(Remove(4.0))
    assert times(person.sees(segmentation((2.0, 4.4, 6.0)))) == [2.0, 4.4, 6.0]


def test_a_boundary_placed_by_hand_stays_when_the_program_changes_its_mind():
    person = Person(segmentation())
    person.makes(Add(3.0), Move(6.0, 6.5))
    assert times(person.sees(segmentation((2.1, 6.1)))) == [2.1, 3.0, 6.5]


def test_an_edit_of_a_boundary_placed_by_hand_never_reaches_another():
    person = Person(segmentation())
    person.makes(Add(3.9), Remove(4.0))
    assert times(person.sees(segmentation((2.0, 6.0)))) == [2.0, 3.9, 6.0]


def test_what_the_program_finds_beside_one_placed_by_hand_is_the_same():
    person = Person(segmentation())
    person.makes(Add(3.0))
    seen = person.sees(segmentation((2.0, 3.03, 4.0)))
    assert times(seen) == [2.0, 3.0, 4.0]
    assert seen.boundaries[1].automatic is not None


def test_a_move_whose_boundary_is_gone_is_listed_and_applies_again_when_it_returns():
    person = Person(segmentation())
    person.makes(Move(4.0, 4.6))
    seen = person.sees(segmentation((2.0, 6.0)))
    assert times(seen) == [2.0, 6.0]
    assert [lost.edit for lost in seen.inapplicable] == [0]
    assert "4.000" in seen.inapplicable[0].text
    assert times(person.sees(segmentation())) == [2.0, 4.6, 6.0, 8.0]


@pytest.mark.parametrize("edit", [Move(4.0, 4.6), Accept(4.0), Contact(4.0, True)])
def test_an_edit_whose_boundary_is_gone_can_be_brought_back(edit):
    person = Person(segmentation())
    person.makes(edit)
    person.sees(segmentation((2.0, 6.0)))
    seen = person.makes(BringBack(0))
    wanted = 4.6 if isinstance(edit, Move) else 4.0
    assert times(seen) == [2.0, wanted, 6.0]
    assert not seen.inapplicable
    assert seen.boundaries[1].accepted == isinstance(edit, Accept)
    assert seen.boundaries[1].contact_change == isinstance(edit, Contact)


def test_of_edits_that_follow_one_another_the_last_is_listed():
    person = Person(segmentation())
    person.makes(Move(4.0, 4.6), Move(4.6, 4.8), Accept(4.8))
    seen = person.sees(segmentation((2.0, 6.0)))
    assert [lost.edit for lost in seen.inapplicable] == [2]
    assert times(person.makes(BringBack(2))) == [2.0, 4.8, 6.0]


def test_a_lost_edit_that_was_taken_away_later_anyway_is_not_listed():
    person = Person(segmentation())
    person.makes(Move(4.0, 4.6), Remove(4.6))
    assert not person.sees(segmentation((2.0, 6.0))).inapplicable


def test_a_forgotten_edit_stays_away_when_its_place_returns():
    person = Person(segmentation())
    person.makes(Move(4.0, 4.6))
    person.sees(segmentation((2.0, 6.0)))
    assert not person.makes(Forget(0)).inapplicable
    assert times(person.sees(segmentation())) == [2.0, 4.0, 6.0, 8.0]


def test_reset_is_what_the_program_found():
    person = Person(segmentation())
    person.makes(Add(3.0), Remove(8.0), Accept(4.0), Reset())
    assert times(person.labeling) == [2.0, 4.0, 6.0, 8.0]
    assert not any(b.accepted for b in person.labeling.boundaries)
    assert times(person.makes(Add(1.0))) == [1.0, 2.0, 4.0, 6.0, 8.0]


@pytest.mark.parametrize(
    ("edit", "reason"),
    [
        (Add(0.0), "inside the recording"),
        (Add(11.0), "inside the recording"),
        (Add(4.02), "already"),
        (Move(4.0, 6.02), "neighbours"),
        (Move(4.0, 5.98), "already"),
        (Move(3.0, 3.5), "none within"),
        (Remove(5.0), "none within"),
        (Merge(4.1, 5.9), "none"),
        (BringBack(7), "not lost"),
    ],
)
def test_an_edit_that_makes_no_sense_is_refused_with_the_reason(edit, reason):
    with pytest.raises(LabelingError, match=reason):
        Person(segmentation()).makes(edit)


def test_a_recording_without_boundaries_can_be_edited():
    person = Person(segmentation(()))
    assert labels(person.labeling) == ["part 1"]
    assert times(person.makes(Add(5.0))) == [5.0]


def test_a_boundary_of_the_program_keeps_its_confidence_and_interval():
    found = segmentation()
    seen = Person(found).makes(Add(3.0))
    assert seen.boundaries[0].confidence == boundary(2.0).confidence
    assert seen.boundaries[0].interval_s == boundary(2.0).interval_s
