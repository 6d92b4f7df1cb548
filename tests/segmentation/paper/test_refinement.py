"""Moving cuts to where all stretches together cost least."""

import itertools

import numpy as np
import pytest

from keyphase.segmentation.paper.contiguous import Moments
from keyphase.segmentation.paper.refinement import refine_cuts

FLOOR = np.array([0.01, 2e-4, 2e-4])
LEAST = 6


def strokes(seed: int, lengths: tuple[int, ...]) -> Moments:
    """Straight strokes of so many samples in random directions: [time, x, y]."""
    rng = np.random.default_rng(seed)
    velocity = np.repeat(rng.normal(size=(len(lengths), 2)) * 0.3, lengths, axis=0)
    position = np.cumsum(velocity, axis=0) * 0.02 + rng.normal(size=velocity.shape) * 1e-4
    samples = np.column_stack([np.arange(len(position)) * 0.02, position])
    return Moments.of(samples.astype(np.float64), FLOOR)


def total(moments: Moments, cuts: tuple[int, ...]) -> float:
    edges = np.array([0, *cuts, len(moments)])
    return float(np.diag(moments.costs(edges[:-1], edges[1:], LEAST)).sum())


@pytest.mark.parametrize("stride", [1, 4])
def test_cuts_move_onto_the_corners(stride):
    refined = refine_cuts(strokes(5, (50, 40, 30)), np.array([32, 109]), 25, LEAST, stride)
    assert np.abs(refined - [50, 90]).max() <= 1


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(8))
def test_strides_first_find_the_cheapest_cuts_of_all_moves(seed):
    moments, cuts = strokes(seed, (20, 15, 25)), np.array([25, 32])
    moves = itertools.product(*(range(cut - 12, cut + 13) for cut in cuts))
    cheapest = min(moves, key=lambda moved: total(moments, moved))
    assert refine_cuts(moments, cuts, 12, LEAST, stride=3).tolist() == list(cheapest)


def test_cuts_go_less_than_a_stride_further_than_they_reach():
    (refined,) = refine_cuts(strokes(5, (50, 40)), np.array([30]), 8, LEAST, stride=4)
    assert 38 <= refined < 42


@pytest.mark.parametrize("stride", [1, 4])
def test_cuts_without_room_for_stretches_stay(stride):
    assert refine_cuts(strokes(1, (10,)), np.array([5]), 4, LEAST, stride).tolist() == [5]


def test_without_cuts_there_is_nothing_to_move():
    assert refine_cuts(strokes(1, (20,)), np.zeros(0, np.intp), 5, LEAST, 3).tolist() == []
