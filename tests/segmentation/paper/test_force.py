"""The Kalman filter's normalized error: against filterpy, its scales, its noise."""

from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2

import synthetic
from keyphase.demonstration import Demonstration
from keyphase.segmentation.bins import bin_means, bin_starts
from keyphase.segmentation.paper.force import (
    chi_square_level,
    error_curve,
    noise_variance,
    normalized_error,
    paper_scales,
    settled_gain,
    wrench_of,
)
from keyphase.segmentation.parameters import Parameters

DATA = Path(__file__).parents[3] / "data"
BUNDLED = sorted(path.name for path in DATA.glob("*.npz"))


def bundled_wrench(name: str) -> np.ndarray:
    with np.load(DATA / name) as file:
        return np.hstack([file["force_N"], file["torque_Nm"]])


def correlated(channels: int, seed: int = 0) -> np.ndarray:
    root = np.random.default_rng(seed).normal(size=(channels, channels))
    return root @ root.T * 0.01 + np.eye(channels) * 1e-3


def assert_engines_agree(measured: np.ndarray, noise: np.ndarray, ratio: float) -> None:
    fast = normalized_error(measured, noise, ratio)
    reference = normalized_error(measured, noise, ratio, "filterpy")
    # Relative to the value, down to what rounding leaves where a held sample makes it vanish.
    np.testing.assert_allclose(fast, reference, rtol=1e-9, atol=1e-12 * reference.max())


@pytest.mark.slow
@pytest.mark.parametrize("name", BUNDLED)
@pytest.mark.parametrize("ratio", [0.01, 1.0, 30.0])
def test_it_agrees_with_filterpy_on_every_bundled_signal(name, ratio):
    wrench = bundled_wrench(name)
    for channels in (3, 6):
        assert_engines_agree(wrench[:, :channels], noise_variance(wrench[:, :channels]), ratio)


@pytest.mark.slow
@pytest.mark.parametrize("name", BUNDLED)
def test_it_agrees_with_filterpy_where_noise_is_correlated(name):
    wrench = bundled_wrench(name)
    assert_engines_agree(wrench, correlated(6), 1.0)
    assert_engines_agree(wrench[:, :3], correlated(3), 0.3)


def test_it_agrees_with_filterpy_on_the_published_curve_taken_as_a_force():
    curve = np.loadtxt(DATA / "published_normalized_error.csv", delimiter=",", skiprows=1)
    assert_engines_agree(np.tile(curve[:, 1:], 3), correlated(3, 1), 1.0)


@pytest.mark.parametrize("length", [1, 2, 3, 10])
def test_it_agrees_with_filterpy_before_the_gain_has_settled(length):
    measured = np.random.default_rng(0).normal(size=(length, 3))
    assert_engines_agree(measured, np.full(3, 0.02), 1e-3)


def test_the_filter_starts_at_the_first_measurement_with_its_noise():
    measured = np.array([[2.0], [3.0]])
    # P(0|-1) = R2 gives P(0|0) = R2 / 2, P(1|0) = 1.5 R2 and S = 2.5 R2.
    np.testing.assert_allclose(normalized_error(measured, np.array([0.1])), [0.0, 1.0 / 0.25])


def test_while_nothing_changes_the_error_is_chi_square_distributed():
    rng = np.random.default_rng(0)
    truth = np.cumsum(rng.normal(size=(40_000, 3)) * 0.2, axis=0)
    error = normalized_error(truth + rng.normal(size=truth.shape) * 0.2, np.full(3, 0.04))
    assert error.mean() == pytest.approx(3.0, rel=0.03)
    assert (error > chi2.isf(0.05, 3)).mean() == pytest.approx(0.05, rel=0.1)


def test_the_readings_of_the_papers_scale():
    assert paper_scales(1.0) == pytest.approx((0.618, 0.236), abs=5e-4)
    assert settled_gain(1.0) == pytest.approx(0.618, abs=5e-4)


def test_the_papers_scales_are_those_of_its_residuals():
    rng = np.random.default_rng(3)
    measured = rng.normal(size=(60, 1))
    ratio, p, estimate = 2.0, 1.0, measured[0, 0]
    for sample in measured[:, 0]:
        predicted = p
        gain = p / (p + 1.0)
        estimate, p = estimate + gain * (sample - estimate), p * (1.0 - gain)
        residual, updated = sample - estimate, p
        p += ratio
    error = normalized_error(measured, np.ones(1), ratio)[-1]
    literal, predicted_scale = paper_scales(ratio)
    assert residual**2 / updated == pytest.approx(literal * error)
    assert residual**2 / predicted == pytest.approx(predicted_scale * error)


def test_noise_is_estimated_whatever_steps_and_ramps_are_in_the_force():
    rng = np.random.default_rng(1)
    force = np.linspace(0, 5, 4000)[:, None] + np.where(np.arange(4000) > 2000, 8.0, 0.0)[:, None]
    force = force + rng.normal(size=(4000, 3)) * [0.1, 0.2, 0.3]
    np.testing.assert_allclose(np.sqrt(noise_variance(force)), [0.1, 0.2, 0.3], rtol=0.07)


def test_noise_of_a_sensor_that_holds_its_samples_is_not_zero():
    rng = np.random.default_rng(1)
    held = np.repeat(rng.normal(size=(1000, 3)) * 0.2, 3, axis=0)
    np.testing.assert_allclose(np.sqrt(noise_variance(held)), 0.2, rtol=0.1)


def test_noise_is_never_below_a_millinewton_and_a_tenth_of_a_millinewtonmetre():
    np.testing.assert_allclose(np.sqrt(noise_variance(np.zeros((50, 6)))), [1e-3] * 3 + [1e-4] * 3)


def test_the_automatic_threshold_allows_one_false_alarm_in_a_hundred_demonstrations():
    assert 350 * chi2.sf(chi_square_level(350, 3), 3) == pytest.approx(0.01)


def test_irregular_samples_are_binned_by_time_not_by_count():
    rng = np.random.default_rng(0)
    time = np.sort(rng.uniform(0.0, 4.0, 3000))
    means = bin_means(time, bin_starts(time))
    assert len(means) == pytest.approx(200, abs=2)
    assert np.diff(means) == pytest.approx(0.02, abs=0.012)


def test_the_curve_peaks_where_contact_is_made():
    made = synthetic.bundled_setup1()
    curve = error_curve(made, Parameters())
    assert curve is not None
    strongest = curve.time_s[curve.error.argmax()]
    assert strongest == pytest.approx(4.2, abs=0.04)
    assert curve.channels == 6


def test_a_given_noise_replaces_the_estimate():
    made = synthetic.bundled_setup1()
    given = error_curve(made, Parameters(measurement_noise=0.01))
    assert given is not None
    wrench = wrench_of(made)
    assert wrench is not None
    binned = bin_means(wrench, bin_starts(made.time_s))
    expected = normalized_error(binned, np.array([0.01] * 3 + [1e-4] * 3))
    np.testing.assert_allclose(given.error, expected)


def test_without_force_there_is_no_curve():
    still = Demonstration("still", np.arange(5) / 100, np.zeros((5, 3)))
    assert error_curve(still, Parameters()) is None
