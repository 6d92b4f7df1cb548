"""Where the motion may change: a hand that stands for a minute, and one in a hurry."""

import numpy as np

import synthetic
from keyphase.demonstration import Array, Demonstration
from keyphase.making.draws import low_noise
from keyphase.segmentation.evidence.grid import grid_of
from keyphase.segmentation.evidence.motion_terms import (
    MOTION_TERMS,
    MotionCandidates,
    motion_candidates,
)
from keyphase.segmentation.evidence.speed import speed_of
from keyphase.segmentation.motion import motion_of


def candidates_s(time_s: Array, position_m: Array) -> tuple[Array, MotionCandidates]:
    recorded = Demonstration("moved", time_s, position_m)
    grid = grid_of(recorded, motion_of(recorded))
    found = motion_candidates(grid, speed_of(grid))
    return np.interp(found.cell, np.arange(len(grid)), grid.time_s), found


def strokes(time_s: Array, *each: tuple[float, float, tuple[float, float, float]]) -> Array:
    position = np.zeros((len(time_s), 3))
    for begin, end, way in each:
        part = synthetic.minimum_jerk(np.clip((time_s - begin) / (end - begin), 0.0, 1.0))
        position += part[:, None] * np.array(way)
    return position


def test_a_hand_that_sways_for_a_minute_does_not_move():
    time = np.arange(0.0, 70.0, 0.01)
    moved = strokes(time, (1.0, 2.0, (0.3, 0.0, 0.0)), (65.0, 66.0, (-0.3, 0.1, 0.0)))
    sway = low_noise(np.random.default_rng(5), len(time), 100.0, 1.0, 6e-4)
    at, _ = candidates_s(time, moved + sway)
    assert not ((at > 3.0) & (at < 64.0)).any()


def test_a_corner_between_two_hasty_strokes_is_deep():
    time = np.arange(0.0, 3.0, 0.01)
    moved = strokes(time, (1.0, 1.3, (0.2, 0.0, 0.0)), (1.3, 1.6, (0.0, 0.2, 0.0)))
    at, found = candidates_s(time, moved)
    corner = int(np.argmin(np.abs(at - 1.3)))
    assert abs(at[corner] - 1.3) < 0.05
    assert found.terms[corner, 0] > np.log(5.0)


def test_the_slow_ends_of_an_oval_are_told_from_turns_at_places_of_their_own():
    time = np.arange(0.0, 10.0, 0.01)
    angle = 2.0 * np.pi * np.clip(time - 1.0, 0.0, 8.0) / 2.0
    oval = np.column_stack([0.2 * np.cos(angle), 0.08 * np.sin(angle), 0.0 * time])
    ahead = np.column_stack([0.2 * np.cos(angle) + 0.3 * angle, 0.08 * np.sin(angle), 0.0 * time])
    column = list(MOTION_TERMS).index("rounds")
    at, found = candidates_s(time, oval)
    rounds = found.terms[(at > 2.0) & (at < 8.0), column]
    assert len(rounds)
    assert rounds.min() > 0.5
    at, found = candidates_s(time, ahead)
    onwards = found.terms[(at > 2.0) & (at < 8.0), column]
    assert len(onwards)
    assert onwards.max() < 0.2


def test_a_short_stop_at_both_ends_of_a_recording_has_its_inner_edge():
    time = np.arange(0.0, 4.0, 0.01)
    at, _ = candidates_s(time, strokes(time, (0.36, 3.64, (0.3, 0.0, 0.0))))
    assert len(at) == 2
    assert np.allclose(at, (0.6, 3.4), atol=0.15)


def test_the_hand_that_starts_and_stops_the_recording_is_no_stop():
    time = np.arange(0.0, 2.0, 0.01)
    assert not len(candidates_s(time, strokes(time, (0.1, 1.9, (0.3, 0.0, 0.0))))[0])
