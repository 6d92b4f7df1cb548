"""The choice among candidates, for which no line has to be known."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from keyphase.segmentation.evidence.choice import CROWDED_S, MIN_ODDS, spaced_scores

candidates = st.lists(
    st.tuples(st.floats(0.0, 10.0), st.floats(-6.0, 6.0)), min_size=1, max_size=30
).map(sorted)


@given(candidates, st.floats(0.0, 1.0))
def test_what_is_chosen_keeps_its_distance_whatever_the_line(found, distance):
    times, odds = np.array(found).T
    scores = spaced_scores(times, odds, distance)
    chosen = times[np.isfinite(scores)]
    assert (np.diff(chosen) >= distance).all()


@given(candidates, st.floats(0.05, 0.6))
def test_the_likeliest_candidate_is_always_chosen_with_all_its_odds(found, distance):
    times, odds = np.array(found).T
    scores = spaced_scores(times, odds, distance)
    if odds.max() >= MIN_ODDS:
        assert scores.max() == odds.max()
    assert (scores <= odds).all()


@given(candidates, st.floats(0.05, 0.6))
def test_leaving_out_what_scores_lowest_changes_nothing_above(found, distance):
    times, odds = np.array(found).T
    scores = spaced_scores(times, odds, distance)
    rest = np.arange(len(times)) != int(np.argmin(scores))
    above = scores > scores.min()
    np.testing.assert_array_equal(
        spaced_scores(times[rest], odds[rest], distance)[above[rest]], scores[above]
    )


def test_a_weaker_candidate_loses_the_nearer_a_likelier_one_is():
    def beside(gap: float) -> float:
        return spaced_scores(np.array([1.0, 1.0 + gap]), np.array([3.0, 2.0]), 0.1)[1]

    assert beside(0.2) < beside(0.4) < beside(CROWDED_S)
    assert beside(CROWDED_S) == pytest.approx(2.0)
    assert beside(0.05) == -np.inf


def test_what_is_seen_at_one_place_and_put_at_two_is_one_change():
    put, odds = np.array([1.0, 1.3]), np.array([3.0, 2.0])
    assert np.isfinite(spaced_scores(put, odds, 0.25)).all()
    assert spaced_scores(put, odds, 0.25, np.array([1.2, 1.3])).tolist() == [3.0, -np.inf]


def test_a_ramp_seen_over_half_a_second_is_part_of_a_likelier_step_in_it():
    times, odds = np.array([1.0, 1.35, 2.0]), np.array([2.0, 3.0, 1.0])
    scores = spaced_scores(times, odds, 0.25, None, np.array([2.0, 1.0, 2.0]))
    assert scores.tolist() == [-np.inf, 3.0, 1.0]
    assert np.isfinite(spaced_scores(times, odds, 0.25)).all()
