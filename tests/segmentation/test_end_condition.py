"""The end condition of a segment is read off the force around its end."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from keyphase.demonstration import Demonstration
from keyphase.errors import ParameterError
from keyphase.segmentation.end_condition import (
    ConfigurationEnd,
    ContactEnd,
    end_condition_at,
    ends_in_contact,
)


def pressed_at(contact_s, step_N, noise_N=0.0, duration_s=4.0, rate_hz=250.0, seed=0):
    time = np.arange(int(duration_s * rate_hz)) / rate_hz
    force = np.random.default_rng(seed).normal(size=(len(time), 3)) * noise_N
    force[time >= contact_s] += step_N
    return Demonstration("pressed", time, np.zeros((len(time), 3)), force_N=force)


def test_a_contact_change_is_over_at_half_the_demonstrated_step_along_its_direction():
    end = end_condition_at(pressed_at(2.0, (0.0, 3.0, 4.0)), 1.0, 2.0, contact_change=True)
    assert isinstance(end, ContactEnd)
    assert_allclose(end.direction, (0.0, 0.6, 0.8))
    assert end.threshold_N == pytest.approx(2.5)


def test_a_lost_contact_points_away_from_the_force_that_ends():
    released = pressed_at(2.0, (0.0, 0.0, -5.0))
    end = end_condition_at(released, 1.0, 2.0, contact_change=True)
    assert isinstance(end, ContactEnd)
    assert_allclose(end.direction, (0.0, 0.0, -1.0))


def test_the_threshold_stays_above_the_noise_of_the_force_before():
    end = end_condition_at(pressed_at(2.0, (0, 0, 2.0), noise_N=0.5), 1.0, 2.0, True)
    assert isinstance(end, ContactEnd)
    assert 1.8 < end.threshold_N < 3.5


def test_without_a_contact_change_the_configuration_decides():
    demonstration = pressed_at(2.0, (0.0, 0.0, 5.0))
    assert end_condition_at(demonstration, 1.0, 2.0, contact_change=False) == ConfigurationEnd()


def test_without_recorded_force_the_configuration_decides():
    time = np.arange(100) / 50
    free = Demonstration("free", time, np.zeros((100, 3)))
    assert end_condition_at(free, 0.0, 1.0, contact_change=True) == ConfigurationEnd()


def test_where_the_force_does_not_change_the_configuration_decides():
    still = pressed_at(2.0, (0.0, 0.0, 0.0))
    assert end_condition_at(still, 1.0, 2.0, contact_change=True) == ConfigurationEnd()


@pytest.mark.parametrize("step_N", [1e-200, 1e-12])
def test_a_force_too_small_to_feel_leaves_it_to_the_configuration(step_N):
    end = end_condition_at(pressed_at(2.0, (0.0, 0.0, step_N)), 1.0, 2.0, True)
    assert end == ConfigurationEnd()


def test_a_recording_that_breaks_off_in_a_contact_ends_in_it():
    """The wall is met 90 ms before the recording stops: too late for any boundary."""
    pressed = pressed_at(3.91, (0.0, -4.0, 0.0), noise_N=0.1)
    assert ends_in_contact(pressed, 2.0)
    end = end_condition_at(pressed, 2.0, pressed.end_s, contact_change=True)
    assert isinstance(end, ContactEnd)
    assert_allclose(end.direction, (0.0, -1.0, 0.0), atol=0.05)
    assert end.threshold_N == pytest.approx(2.0, rel=0.1)


def test_a_recording_that_ends_under_a_steady_force_does_not_end_in_a_contact():
    assert not ends_in_contact(pressed_at(2.0, (0.0, 0.0, 5.0), noise_N=0.1), 2.0)


def test_a_contact_that_the_last_segment_starts_with_is_not_its_end():
    pressed = pressed_at(3.7, (0.0, 0.0, 5.0), noise_N=0.1)
    assert not ends_in_contact(pressed, 3.72)


def test_a_recording_without_force_does_not_end_in_a_contact():
    time = np.arange(100) / 50
    assert not ends_in_contact(Demonstration("free", time, np.zeros((100, 3))), 0.0)


def test_the_force_of_the_segment_before_does_not_count():
    """The segment is 0.1 s long; the 50 N before it belong to another one."""
    demonstration = pressed_at(2.0, (0.0, 0.0, 5.0))
    assert demonstration.force_N is not None
    force = demonstration.force_N.copy()
    force[demonstration.time_s < 1.9] = 50.0
    short = Demonstration("short", demonstration.time_s, demonstration.position_m, force_N=force)
    end = end_condition_at(short, 1.9, 2.0, contact_change=True)
    assert isinstance(end, ContactEnd)
    assert_allclose(end.direction, (0.0, 0.0, 1.0))
    assert end.threshold_N == pytest.approx(2.5)


def test_windows_without_a_sample_use_the_nearest_one():
    sparse = pressed_at(2.0, (0.0, 0.0, 5.0), rate_hz=2.0)
    end = end_condition_at(sparse, 0.0, 2.0, contact_change=True)
    assert isinstance(end, ContactEnd)
    assert end.threshold_N == pytest.approx(2.5)


@pytest.mark.parametrize("direction", [(0.0, 0.0, 0.0), (0.0, 0.0, 2.0), (float("nan"), 0.0, 1.0)])
def test_a_direction_that_is_no_unit_vector_is_refused(direction):
    with pytest.raises(ParameterError, match="unit vector"):
        ContactEnd(direction, 1.0)


@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), float("inf")])
def test_thresholds_and_tolerances_are_positive(value):
    with pytest.raises(ParameterError, match="threshold_N"):
        ContactEnd((0.0, 0.0, 1.0), value)
    with pytest.raises(ParameterError, match="position_tolerance_m"):
        ConfigurationEnd(position_tolerance_m=value)
    with pytest.raises(ParameterError, match="rotation_tolerance_rad"):
        ConfigurationEnd(rotation_tolerance_rad=value)
