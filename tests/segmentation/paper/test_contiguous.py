"""The cut into contiguous Gaussians against exhaustive search."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from keyphase.segmentation.paper.contiguous import (
    Moments,
    best_cut,
    best_cut_into,
    parameters_per_gaussian,
)

FLOOR = np.array([0.01, 1e-3, 1e-3])


def strokes(seed: int, count: int, length: int = 12) -> np.ndarray:
    """Straight strokes in random directions: samples of [time, x, y]."""
    rng = np.random.default_rng(seed)
    velocity = np.repeat(rng.normal(size=(count, 2)) * 0.3, length, axis=0)
    position = np.cumsum(velocity, axis=0) * 0.02 + rng.normal(size=velocity.shape) * 1e-4
    return np.column_stack([np.arange(len(position)) * 0.02, position])


def negative_log_likelihood(stretch: np.ndarray, total: int) -> float:
    count, d = stretch.shape
    covariance = np.cov(stretch.T, bias=True)
    floored = covariance + np.diag(FLOOR**2)
    fit = np.linalg.slogdet(floored)[1] + np.trace(np.linalg.solve(floored, covariance))
    return 0.5 * count * (fit + d * np.log(2 * np.pi)) - count * np.log(count / total)


def exhaustive(samples: np.ndarray, grid: np.ndarray, least: int, effective: float) -> list[int]:
    """Cuts of least BIC among all combinations of grid points."""
    n, d = samples.shape
    best, found = np.inf, []
    for count in range(len(grid) - 1):
        for cuts in itertools.combinations(grid[1:-1].tolist(), count):
            edges = [0, *cuts, n]
            if min(np.diff(edges)) < least:
                continue
            cost = sum(
                negative_log_likelihood(samples[i:j], n) for i, j in itertools.pairwise(edges)
            )
            penalty = (count + 1) * parameters_per_gaussian(d) * np.log(effective)
            bic = 2.0 * effective / n * cost + penalty
            if bic < best:
                best, found = bic, list(cuts)
    return found


def test_the_cost_of_a_stretch_is_its_negative_log_likelihood():
    samples = strokes(1, 3)
    begin, end = np.array([0, 5]), np.array([20, 36])
    expected = [[negative_log_likelihood(samples[i:j], 36) for j in end] for i in begin]
    np.testing.assert_allclose(Moments.of(samples, FLOOR).costs(begin, end), expected, rtol=1e-9)


def test_a_stretch_shorter_than_allowed_costs_infinitely_much():
    costs = Moments.of(strokes(1, 2), FLOOR).costs(np.array([0]), np.array([3, 4, 5]), least=5)
    assert np.isfinite(costs).tolist() == [[False, False, True]]


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("effective", [8.0, 25.0])
def test_the_cut_is_the_one_of_least_bic_among_all(seed, effective):
    samples = strokes(seed, 3)
    grid = np.arange(0, len(samples) + 1, 4)
    found = best_cut(Moments.of(samples, FLOOR), grid, 6, effective)
    assert found.tolist() == exhaustive(samples, grid, 6, effective)


@pytest.mark.slow
@settings(max_examples=15)
@given(seed=st.integers(0, 10_000), effective=st.floats(20.0, 400.0))
def test_leaving_out_hopeless_starts_changes_nothing_on_long_motions(seed, effective):
    samples = strokes(seed, 14, length=25)
    grid = np.arange(0, len(samples) + 1, 2)
    moments = Moments.of(samples, FLOOR)
    cuts = best_cut(moments, grid, 6, effective)
    same_number = best_cut_into(moments, grid, 6, len(cuts) + 1)
    np.testing.assert_allclose(total(moments, cuts), total(moments, same_number), rtol=1e-12)


def total(moments: Moments, cuts: np.ndarray) -> float:
    edges = np.concatenate([[0], cuts, [len(moments)]]).astype(np.intp)
    return float(np.diag(moments.costs(edges[:-1], edges[1:])).sum())


def test_a_given_number_of_stretches_is_kept():
    samples = strokes(3, 4)
    for count in (1, 2, 5, 7):
        cuts = best_cut_into(Moments.of(samples, FLOOR), np.arange(49), 6, count)
        assert len(cuts) == count - 1


def test_more_stretches_than_fit_give_as_many_as_fit():
    cuts = best_cut_into(Moments.of(strokes(3, 1), FLOOR), np.arange(13), 6, 5)
    assert len(cuts) == 1
