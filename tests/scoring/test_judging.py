"""What a reference can judge, and that judging is never kinder than that."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from keyphase.scoring import Claim, Judged, ReferenceEvent, Truth, judge, tally

times = st.lists(st.floats(0, 20), max_size=12, unique=True).map(sorted)
NARROW = (0.2, 0.2)


def event(time_s, window_s=NARROW, kind=None):
    return ReferenceEvent(time_s, "x", window_s, kind)


def contact(time_s, confidence=0.8):
    return Claim(time_s, contact_change=True, confidence=confidence, motion=False)


def motion(time_s, confidence=0.8):
    return Claim(time_s, contact_change=False, confidence=confidence)


def counts(verdict):
    tally = verdict.tally
    return tally.found, tally.missed, tally.false, tally.ignored


def test_where_only_contact_is_labelled_motion_is_neither_right_nor_wrong():
    judged = Judged("contact", (event(1.0), event(5.0)))
    assert counts(judge(judged, [contact(1.1), motion(3.0), motion(5.0)])) == (1, 1, 0, 2)


@given(times, times, times)
def test_more_boundaries_of_motion_never_help_where_only_contact_is_labelled(events, found, more):
    judged = Judged("contact", tuple(event(time) for time in events))
    bare = judge(judged, [contact(time) for time in found])
    many = judge(judged, [contact(time) for time in found] + [motion(time) for time in more])
    assert counts(many)[:3] == counts(bare)[:3]
    assert many.outcomes == bare.outcomes


def test_where_everything_is_labelled_every_boundary_counts():
    judged = Judged("all", (event(1.0),))
    assert counts(judge(judged, [contact(1.1), motion(3.0)])) == (1, 0, 1, 0)


def test_a_window_may_reach_farther_before_an_event_than_after():
    judged = Judged("all", (event(5.0, (0.8, 0.2)),))
    assert counts(judge(judged, [motion(4.3)])) == (1, 0, 0, 0)
    assert counts(judge(judged, [motion(5.3)])) == (0, 1, 1, 0)


def test_two_boundaries_of_one_event_are_one_hit_and_one_false():
    judged = Judged("all", (event(5.0),), ignore_s=((4.0, 6.0),))
    assert counts(judge(judged, [contact(4.9), contact(5.1)])) == (1, 0, 1, 0)


def test_a_boundary_in_a_stretch_to_ignore_counts_neither_way():
    judged = Judged("all", (event(5.0),), ignore_s=((0.0, 1.0),))
    assert counts(judge(judged, [contact(0.5), motion(0.7), motion(5.0)])) == (1, 0, 0, 2)


def test_a_stretch_to_ignore_motion_excuses_no_claim_of_a_contact_change():
    judged = Judged("all", (event(5.0),), ignore_motion_s=((0.0, 1.0),))
    assert counts(judge(judged, [contact(0.5), motion(0.7), motion(5.0)])) == (1, 0, 1, 1)


@given(times, times)
def test_without_windows_kinds_and_stretches_judging_is_the_strict_count(events, found):
    apart = [t for i, t in enumerate(events) if i == 0 or t - events[i - 1] > 0.1]
    truth = Truth(tuple(apart), (), 0.25)
    strict, judged = tally(truth, found), judge(truth.judged, [motion(time) for time in found])
    assert counts(judged)[:3] == (strict.found, strict.missed, strict.false)


def test_labels_nearer_than_a_tenth_of_a_second_are_one_event():
    truth = Truth((1.0, 1.05, 3.0), (), 0.25)
    assert [each.time_s for each in truth.judged.events] == [1.0, 3.0]


def test_confidences_are_kept_of_what_counts_only():
    judged = Judged("contact", (event(1.0),), ignore_s=((8.0, 9.0),))
    claims = [contact(1.1, 0.9), contact(4.0, 0.3), motion(5.0, 0.7), contact(8.5, 0.6)]
    assert judge(judged, claims).outcomes == ((0.9, True), (0.3, False))


def test_kinds_are_counted_apart_where_the_reference_tells_them():
    judged = Judged("all", (event(1.0, kind="contact"), event(5.0, kind="motion")))
    kinds = judge(judged, [motion(1.0), motion(5.1), contact(7.0)]).kinds
    assert (kinds["contact"].found, kinds["contact"].missed, kinds["contact"].false) == (0, 1, 1)
    assert (kinds["motion"].found, kinds["motion"].missed, kinds["motion"].false) == (1, 0, 0)


def test_kinds_are_not_counted_where_the_reference_does_not_tell_them():
    assert judge(Judged("all", (event(1.0),)), [motion(1.0)]).kinds == {}


@pytest.mark.parametrize("claims", [[], [motion(1.0)]])
def test_a_recording_without_events_has_no_recall(claims):
    verdict = judge(Judged("all", ()), claims)
    assert verdict.tally.recall is None
    assert verdict.tally.false == len(claims)
