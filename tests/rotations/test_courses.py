"""Orientations over time are followed as they were turned, past half a turn and past many."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose

from keyphase.rotations import quaternions
from keyphase.rotations.courses import angular_velocity, continued, from_first

AXIS = np.array([0.0, 0.6, 0.8])
TIME_S = np.linspace(0.0, 10.0, 501)


def turning(angles_rad: np.ndarray, first_wxyz: np.ndarray | None = None) -> np.ndarray:
    """Orientations (N, 4) turned about one axis of the base frame."""
    wxyz = quaternions.from_rotation_vector(np.asarray(angles_rad)[:, None] * AXIS)
    return wxyz if first_wxyz is None else quaternions.product(wxyz, first_wxyz)


@pytest.mark.parametrize("turns", [0.4, 0.5, 0.6, 1.0, 1.2, 2.0, 2.7, -0.6, -3.1])
def test_any_number_of_turns_about_one_axis_is_followed(turns: float) -> None:
    angles = 2.0 * np.pi * turns * TIME_S / TIME_S[-1]
    first = quaternions.from_rotation_vector(np.array([0.3, -1.0, 2.0]))
    assert_allclose(
        from_first(continued(turning(angles, first))), angles[:, None] * AXIS, atol=1e-9
    )


def test_a_turn_there_and_back_ends_where_it_began() -> None:
    angles = 2.5 * 2.0 * np.pi * np.sin(np.pi * TIME_S / TIME_S[-1])
    assert_allclose(from_first(continued(turning(angles)))[-1], 0.0, atol=1e-9)


@given(st.integers(0, 2**32 - 1))
def test_a_wandering_orientation_jumps_nowhere_below_a_whole_turn(seed: int) -> None:
    steps = 0.05 * np.random.default_rng(seed).normal(size=(200, 3))
    wxyz = [np.array(quaternions.IDENTITY)]
    for step in steps:
        wxyz.append(quaternions.turned(wxyz[-1], step))
    vectors = from_first(continued(np.array(wxyz)))
    before_whole = int(np.argmax(np.linalg.norm(vectors, axis=1) > 5.0)) or len(vectors)
    jumps = np.linalg.norm(np.diff(vectors[:before_whole], axis=0), axis=1)
    assert np.all(jumps < 1.5)


@given(st.lists(st.booleans(), min_size=2, max_size=50))
def test_signs_of_quaternions_do_not_matter_once_continued(flips: list[bool]) -> None:
    wxyz = turning(np.linspace(0.0, 3.0, len(flips)))
    signs = np.where(flips, -1.0, 1.0)[:, None]
    assert_allclose(from_first(continued(signs * wxyz)), from_first(wxyz), atol=1e-12)


def test_angular_velocity_is_that_of_an_even_turn() -> None:
    assert_allclose(
        angular_velocity(TIME_S, turning(0.7 * TIME_S)), np.tile(0.7 * AXIS, (501, 1)), atol=1e-9
    )
