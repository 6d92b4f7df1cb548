"""Which peaks of the normalized error are contact changes."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.signal import find_peaks

from keyphase.demonstration import Demonstration
from keyphase.segmentation.bins import BIN_S
from keyphase.segmentation.paper.peaks import REJECTIONS, local_maxima, peaks_of_curve, spaced
from keyphase.segmentation.paper.stages import ForceStage
from keyphase.segmentation.parameters import Parameters

PUBLISHED = Path(__file__).parents[3] / "data" / "published_normalized_error.csv"

REGION = [
    (distance, threshold)
    for distance, low in ((0.0, 7.6), (0.3, 2.3), (0.8, 0.8))
    for threshold in np.geomspace(low, 20.0, 40)
]
"""Thresholds and distances over which the paper's two points must come out."""


@pytest.mark.parametrize(("distance", "threshold"), REGION)
def test_the_published_curve_gives_the_papers_two_points(distance, threshold):
    time, error = np.loadtxt(PUBLISHED, delimiter=",", skiprows=1).T
    found = peaks_of_curve(time, error, threshold, distance)
    np.testing.assert_allclose(found, [4.16, 5.02], atol=1e-9)


@given(
    st.lists(st.floats(0.0, 100.0), min_size=3, max_size=80, unique=True),
    st.integers(2, 40),
)
def test_spacing_is_that_of_scipy_on_the_whole_curve(heights, bins_apart):
    curve = np.array(heights)
    maxima = local_maxima(curve)
    expected, _ = find_peaks(np.concatenate([[-1.0], curve, [-1.0]]), distance=bins_apart)
    kept = spaced(maxima * BIN_S, curve[maxima], bins_apart * BIN_S)
    assert maxima[kept].tolist() == (expected - 1).tolist()


def with_force(along_z, rate_hz: float = 250.0, noise: float = 0.1) -> ForceStage:
    """Eight seconds of white noise with `along_z(t)` in its z."""
    time = np.arange(round(8 * rate_hz)) / rate_hz
    force = np.random.default_rng(0).normal(size=(len(time), 3)) * noise
    force[:, 2] += along_z(time)
    still = Demonstration("force", time, np.zeros_like(force), force_N=force)
    stage = ForceStage.of(still, Parameters())
    assert stage is not None
    return stage


def used(stage: ForceStage, **changes) -> np.ndarray:
    codes = stage.codes(Parameters(**changes))
    return stage.candidates.time_s[codes == 0]


def reasons(stage: ForceStage, around_s: float, **changes) -> set[str]:
    codes = stage.codes(Parameters(**changes))
    near = np.abs(stage.candidates.time_s - around_s) < 0.1
    return {REJECTIONS[code] for code in codes[near]}


def step(at_s: float, size_N: float = 4.0):
    return lambda t: size_N * (t >= at_s)


def pulse(at_s: float, size_N: float = 4.0):
    return lambda t: size_N * np.exp(-0.5 * ((t - at_s) / 0.02) ** 2)


@pytest.mark.parametrize("rate_hz", [60.0, 100.0, 250.0, 1000.0])
def test_a_step_is_found_to_within_a_few_milliseconds(rate_hz):
    found = used(with_force(step(3.0), rate_hz))
    np.testing.assert_allclose(found, [3.0], atol=max(0.008, 1.01 / rate_hz))


def test_the_interval_of_a_peak_contains_its_time_and_the_truth():
    stage = with_force(step(3.0, 1.0))
    (index,) = np.flatnonzero(stage.codes(Parameters()) == 0)
    low, high = stage.interval_s(index)
    assert low <= stage.candidates.time_s[index] <= high
    assert low - 0.004 <= 3.0 <= high + 0.004


def test_a_bump_does_not_stay():
    stage = with_force(pulse(3.0))
    assert used(stage).tolist() == []
    assert "does not stay" in reasons(stage, 3.0)
    assert len(used(stage, persistence=0.0)) == 1


def test_stick_slip_is_no_contact_though_it_passes_the_threshold():
    stage = with_force(lambda t: 0.8 * np.mod(6.0 * t, 1.0))
    assert used(stage).tolist() == []
    assert len(used(stage, force_ratio=0.0, persistence=0.0)) > 5


def test_the_lower_of_two_close_steps_gives_way():
    stage = with_force(lambda t: step(3.0, 6.0)(t) - step(3.2, 3.0)(t))
    np.testing.assert_allclose(used(stage), [3.0], atol=0.01)
    assert "too close" in reasons(stage, 3.2)
    np.testing.assert_allclose(used(stage, min_distance_s=0.1), [3.0, 3.2], atol=0.01)


def test_a_step_at_an_end_of_the_recording_is_left_out():
    stage = with_force(step(0.06))
    assert used(stage).tolist() == []
    assert "at an end" in reasons(stage, 0.06)


def test_raising_the_threshold_only_takes_peaks_away():
    stage = with_force(lambda t: step(2.0, 1.0)(t) + step(4.0, 2.0)(t) + step(6.0, 8.0)(t))
    counts = [len(used(stage, force_threshold=h)) for h in np.geomspace(5.0, 1e6, 40)]
    assert counts[0] == 3
    assert counts[-1] == 0
    assert counts == sorted(counts, reverse=True)


def test_a_peak_says_by_how_much_the_force_changed():
    stage = with_force(step(3.0, 4.0))
    (index,) = np.flatnonzero(stage.codes(Parameters()) == 0)
    peak = stage.peak(int(index))
    np.testing.assert_allclose(peak.force_step_N, (0.0, 0.0, 4.0), atol=0.1)
    assert peak.torque_step_Nm is None


def test_near_misses_are_reported_but_not_the_flanks_of_used_peaks():
    stage = with_force(lambda t: step(3.0, 6.0)(t) + pulse(6.0)(t))
    reported = stage.reported(stage.codes(Parameters()), Parameters())
    taken = [peak for peak in reported if not peak.rejection]
    missed = [peak for peak in reported if peak.rejection]
    assert [round(peak.time_s) for peak in taken] == [3]
    assert {round(peak.time_s) for peak in missed} == {6}
