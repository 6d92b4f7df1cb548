"""Labels, dropping and colours of segments under a person's edits."""

import pytest
from handmade import Person, kept, labels, segmentation

from keyphase.errors import LabelingError
from keyphase.labeling.colors import SEGMENT_COLORS
from keyphase.labeling.edits import (
    AcceptLabels,
    Add,
    BringBack,
    DropIdle,
    Keep,
    Label,
    Merge,
    Move,
    Remove,
    Reset,
)


def test_a_label_is_the_persons_and_no_proposal():
    seen = Person(segmentation()).makes(Label(4.1, "insert"))
    assert labels(seen) == ["part 1", "part 2", "insert", "part 4", "part 5"]
    assert [s.proposed for s in seen.segments] == [True, True, False, True, True]


def test_several_in_a_row_are_named_and_dropped_as_one_step():
    person = Person(segmentation())
    person.makes(Label(7.1, "insert", to_s=3.0))
    assert labels(person.labeling) == ["part 1", "insert", "insert", "insert", "part 5"]
    person.makes(Keep(1.0, False, to_s=5.0))
    assert kept(person.labeling) == [3, 4]


def test_what_was_decided_about_several_stays_with_them_when_their_sides_move():
    person = Person(segmentation())
    person.makes(Label(3.0, "insert", to_s=5.0), Move(2.0, 3.5), Move(6.0, 6.4))
    assert labels(person.labeling)[1:3] == ["insert", "insert"]
    assert "insert" not in (labels(person.labeling)[0], labels(person.labeling)[3])


def test_an_empty_label_gives_back_the_proposed_one():
    seen = Person(segmentation()).makes(Label(5.0, "insert"), Label(5.0, ""))
    assert labels(seen)[2] == "part 3"
    assert seen.segments[2].proposed


def test_accepted_labels_stay_as_they_were_accepted():
    person = Person(segmentation(idle=(1,)))
    person.makes(Label(5.0, "insert"), AcceptLabels(), Move(8.0, 8.5))
    assert labels(person.labeling) == ["part 1", "idle", "insert", "part 4", "part 5"]
    assert [s.proposed for s in person.labeling.segments] == [False, True, False, False, False]


def test_there_is_nothing_to_accept_twice():
    with pytest.raises(LabelingError, match="none to accept"):
        Person(segmentation()).makes(AcceptLabels(), AcceptLabels())


def test_a_label_stays_with_its_segment_when_a_boundary_moves_past_its_middle():
    person = Person(segmentation())
    person.makes(Label(5.0, "insert"), Move(4.0, 5.7))
    assert labels(person.labeling)[1:3] == ["new", "insert"]
    person.makes(Move(6.0, 7.9))
    assert labels(person.labeling)[2:4] == ["insert", "new"]


def test_a_label_stays_with_its_segment_when_the_program_moves_its_boundaries():
    person = Person(segmentation())
    person.makes(Label(5.0, "insert"))
    assert labels(person.sees(segmentation((2.0, 4.3, 6.4)))) == [
        "part 1",
        "part 2",
        "insert",
        "part 4",
    ]


def test_both_parts_of_a_split_segment_keep_label_and_fate():
    person = Person(segmentation())
    person.makes(Label(5.0, "insert"), Keep(5.0, False), Add(4.5))
    assert labels(person.labeling)[2:4] == ["insert", "insert"]
    assert kept(person.labeling) == [0, 1, 4, 5]
    person.makes(Label(4.2, "reach"))
    assert labels(person.labeling)[2:4] == ["reach", "insert"]


def test_parts_of_a_segment_that_the_program_splits_keep_its_label():
    person = Person(segmentation())
    person.makes(Label(5.0, "insert"))
    assert labels(person.sees(segmentation((2.0, 4.0, 5.0, 6.0))))[2:4] == ["insert", "insert"]


def test_of_merged_segments_the_longest_gives_the_label():
    person = Person(segmentation((1.0, 4.0)))
    person.makes(Label(0.5, "short"), Label(2.0, "long"), Merge(0.5, 2.0))
    assert labels(person.labeling) == ["long", "part 3"]
    assert not person.labeling.inapplicable


def test_a_label_whose_segment_is_gone_is_listed_and_can_be_brought_back():
    person = Person(segmentation((1.0, 4.0)))
    person.makes(Label(0.5, "short"), Label(2.0, "long"))
    seen = person.sees(segmentation((4.0,)))
    assert labels(seen) == ["long", "part 2"]
    assert [lost.edit for lost in seen.inapplicable] == [0]
    assert "short" in seen.inapplicable[0].text
    seen = person.makes(BringBack(0))
    assert labels(seen) == ["short", "long", "part 2"]
    assert not seen.inapplicable


def test_a_dropped_segment_that_is_gone_is_listed():
    person = Person(segmentation((1.0, 4.0)))
    person.makes(Keep(0.5, False))
    assert "Dropped" in person.sees(segmentation((4.0,))).inapplicable[0].text


def test_a_label_that_was_replaced_is_not_listed():
    person = Person(segmentation())
    person.makes(Label(5.0, "insert"), Move(4.0, 4.8), Label(5.0, "press"))
    assert labels(person.labeling)[2] == "press"
    assert not person.labeling.inapplicable


def test_of_labels_that_replaced_one_another_only_the_last_is_listed_when_the_segment_is_gone():
    person = Person(segmentation((1.0, 4.0)))
    person.makes(Label(0.5, "first"), Label(0.5, "second"), Label(0.5, "third"))
    assert [lost.edit for lost in person.sees(segmentation((4.0,))).inapplicable] == [2]


def test_a_label_whose_segment_a_person_merged_away_is_not_listed():
    person = Person(segmentation((1.0, 4.0)))
    person.makes(Label(0.5, "short"), Remove(1.0))
    assert not person.labeling.inapplicable


def test_idle_segments_are_proposed_as_dropped():
    seen = Person(segmentation(idle=(1, 3))).labeling
    assert kept(seen) == [0, 2, 4]
    assert seen.proposed_drops == (1, 3)


def test_dropping_the_idle_ones_decides_about_all_of_them():
    person = Person(segmentation(idle=(1, 3)))
    seen = person.makes(Keep(3.0, True), DropIdle())
    assert kept(seen) == [0, 2, 4]
    assert seen.proposed_drops == ()
    assert kept(person.sees(segmentation((2.0, 5.0), idle=(2,)))) == [0, 1]


def test_an_idle_segment_can_be_kept_after_all():
    seen = Person(segmentation(idle=(1, 3))).makes(DropIdle(), Keep(3.0, True))
    assert kept(seen) == [0, 1, 2, 4]


def test_a_segment_dropped_by_hand_is_no_proposal():
    seen = Person(segmentation(idle=(1, 3))).makes(Keep(3.0, False), Keep(9.0, False))
    assert kept(seen) == [0, 2]
    assert seen.proposed_drops == (3,)


def test_there_are_no_idle_segments_to_drop_twice():
    with pytest.raises(LabelingError, match="No idle"):
        Person(segmentation(idle=(1,))).makes(DropIdle(), DropIdle())


def test_reset_takes_back_labels_and_drops():
    person = Person(segmentation(idle=(1,)))
    person.makes(Label(5.0, "insert"), Keep(5.0, False), DropIdle(), Reset())
    assert labels(person.labeling)[2] == "part 3"
    assert kept(person.labeling) == [0, 2, 3, 4]
    assert person.labeling.proposed_drops == (1,)


def test_edits_leave_the_colours_of_other_segments_alone():
    person = Person(segmentation(idle=(1,)))
    before = [s.color for s in person.labeling.segments]
    assert before == [0, 4, 1, 2, 3]
    after = [s.color for s in person.makes(Add(5.0)).segments]
    assert after[:3] + after[4:] == before
    assert len(set(after)) == 6
    assert after[3] % len(SEGMENT_COLORS) != after[2] % len(SEGMENT_COLORS)


@pytest.mark.parametrize(
    "label", ["line\nbreak", "bell\x07", "turned\u202eround", "\ud800", "x" * 201]
)
def test_a_label_that_is_not_plain_text_is_refused(label):
    with pytest.raises(LabelingError, match=r"[Ll]abel"):
        Person(segmentation()).makes(Label(5.0, label))
