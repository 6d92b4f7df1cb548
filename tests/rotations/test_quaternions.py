"""Quaternion algebra against scipy, and the logarithm past half a turn."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from keyphase.rotations import quaternions

vectors = st.tuples(*[st.floats(-3.0, 3.0, allow_nan=False)] * 3).map(np.array)


def as_wxyz(rotation):
    return rotation.as_quat(scalar_first=True)


@given(vectors, vectors)
def test_the_product_turns_right_factor_first(one, other):
    expected = Rotation.from_rotvec(one) * Rotation.from_rotvec(other)
    ours = quaternions.product(
        quaternions.from_rotation_vector(one), quaternions.from_rotation_vector(other)
    )
    assert_allclose(
        quaternions.nearest_sign(ours, as_wxyz(expected)), as_wxyz(expected), atol=1e-12
    )


@given(vectors)
def test_logarithm_undoes_exponential_up_to_a_whole_turn(vector):
    assert_allclose(
        quaternions.rotation_vector(quaternions.from_rotation_vector(vector)), vector, atol=1e-9
    )


@given(vectors)
def test_the_shortest_way_is_scipys(vector):
    wxyz = quaternions.from_rotation_vector(vector)
    shortest = quaternions.shortest_rotation_vector(wxyz)
    assert np.linalg.norm(shortest) <= np.pi + 1e-12
    assert (Rotation.from_rotvec(shortest).inv() * Rotation.from_rotvec(vector)).magnitude() < 1e-9


@pytest.mark.parametrize("degrees", [0.0, 90.0, 179.0, 181.0, 220.0, 350.0])
def test_the_logarithm_keeps_growing_past_half_a_turn(degrees):
    wxyz = quaternions.from_rotation_vector(np.radians(degrees) * np.array([0.0, 0.6, 0.8]))
    angle = np.linalg.norm(quaternions.rotation_vector(wxyz))
    assert np.degrees(angle) == pytest.approx(degrees, abs=1e-9)


def test_one_and_many_give_the_same():
    rng = np.random.default_rng(3)
    left, right = quaternions.normalised(rng.normal(size=(2, 7, 4)))
    many = (
        quaternions.product(left, right),
        quaternions.difference(left, right),
        quaternions.from_rotation_vector(left[:, 1:]),
    )
    for k in range(7):
        assert_allclose(many[0][k], quaternions.product(left[k], right[k]), atol=1e-15)
        assert_allclose(many[1][k], quaternions.difference(left[k], right[k]), atol=1e-14)
        assert_allclose(many[2][k], quaternions.from_rotation_vector(left[k, 1:]), atol=1e-15)
