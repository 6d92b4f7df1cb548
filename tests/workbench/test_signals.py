"""The curves of the timeline: right values, extremes kept, a million samples as cheap as few."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration
from keyphase.workbench.showing.signals import (
    Series,
    SignalTracks,
    rotation_from_start_deg,
    speed_mm_s,
)

TIMES = np.arange(0.0, 10.0, 0.001)


def _noise(seed: int = 0) -> Series:
    return Series("x", TIMES, np.random.default_rng(seed).normal(size=len(TIMES)))


@given(start=st.floats(-2, 11), length=st.floats(0.001, 12), points=st.integers(10, 4000))
def test_a_range_keeps_its_extremes_and_one_sample_beyond_either_end(
    start: float, length: float, points: int
) -> None:
    series = _noise()
    time, values = series.decimated(start, start + length, points)
    inside = (start <= TIMES) & (start + length >= TIMES)

    assert len(time) == len(values) <= points + 4
    assert np.all(np.diff(time) > 0)
    if inside.any():
        assert time[0] <= max(start, TIMES[0]) + 1e-9
        assert time[-1] >= min(start + length, TIMES[-1]) - 1e-9
        assert values.max() >= series.values[inside].max()
        assert values.min() <= series.values[inside].min()


def test_few_samples_are_sent_as_they_are() -> None:
    series = _noise()

    time, values = series.decimated(2.0, 2.05, 1000)

    first = int(np.searchsorted(TIMES, 2.0)) - 1
    np.testing.assert_array_equal(values, series.values[first : first + len(values)])
    assert time[0] < 2.0
    assert time[-1] > 2.05


def test_a_single_spike_in_a_million_samples_is_seen() -> None:
    time = np.arange(1_000_000) / 1000.0
    values = np.zeros(len(time))
    values[654_321] = 1.0

    shown = Series("x", time, values).decimated(0.0, 1000.0, 2000)

    assert len(shown[0]) <= 2002
    assert shown[1].max() == 1.0


@pytest.fixture(scope="module")
def turning() -> Demonstration:
    """Along x at 0.1 m/s while turning about z at 90 deg/s."""
    time = np.arange(0.0, 2.0, 0.004)
    position = np.outer(time, [0.1, 0.0, 0.0]) + np.array([1.0, 2.0, 3.0])
    turn = Rotation.from_rotvec(np.outer(np.deg2rad(90.0 * time), [0.0, 0.0, 1.0]))
    wxyz = turn.as_quat(scalar_first=True)
    return Demonstration("turning", time, position, wxyz)


def test_position_is_relative_to_the_start_in_millimetres(turning: Demonstration) -> None:
    x, y, _ = SignalTracks(turning, None).track("position")

    np.testing.assert_allclose(x.values, 100.0 * turning.time_s, atol=1e-9)
    assert y.scale == (0.0, 0.0)


def test_speed_is_in_millimetres_per_second(turning: Demonstration) -> None:
    np.testing.assert_allclose(speed_mm_s(turning), 100.0, rtol=1e-9)


def test_orientation_is_the_rotation_since_the_start_in_degrees(turning: Demonstration) -> None:
    turned = rotation_from_start_deg(turning)

    np.testing.assert_allclose(turned[:, 2], 90.0 * turning.time_s, atol=1e-9)


def test_a_track_that_was_not_recorded_has_no_curves(turning: Demonstration) -> None:
    tracks = SignalTracks(turning, None)

    assert tracks.names == ("position", "speed", "orientation")
    assert tracks.track("force") == ()
    assert tracks.track("nonsense") == ()


def test_the_rotation_is_followed_past_half_a_turn_and_past_a_whole_one() -> None:
    time_s = np.linspace(0.0, 6.0, 301)
    degrees = 120.0 * time_s
    wxyz = np.column_stack(
        [np.cos(np.radians(degrees / 2)), 0 * time_s, 0 * time_s, np.sin(np.radians(degrees / 2))]
    )
    turning = Demonstration("spun", time_s, np.zeros((301, 3)), -wxyz)
    assert rotation_from_start_deg(turning)[:, 2] == pytest.approx(degrees, abs=1e-6)
