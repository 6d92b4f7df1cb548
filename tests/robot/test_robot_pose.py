"""Poses and placements."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from keyphase.robot.pose import Placement, matrices, matrix, position_and_wxyz

numbers = st.floats(-2, 2)


@given(
    position=st.tuples(numbers, numbers, numbers),
    wxyz=st.tuples(numbers, numbers, numbers, numbers).filter(lambda q: np.linalg.norm(q) > 0.1),
)
def test_a_pose_survives_the_way_to_a_matrix_and_back(position, wxyz):
    unit = np.array(wxyz) / np.linalg.norm(wxyz)
    at, turned = position_and_wxyz(matrix(position, unit))

    assert at == pytest.approx(position)
    assert abs(turned @ unit) == pytest.approx(1)


def test_a_quarter_turn_about_z_takes_x_to_y():
    half = np.sqrt(0.5)
    pose = matrix((1, 2, 3), (half, 0, 0, half))

    assert pose @ [1, 0, 0, 1] == pytest.approx([1, 3, 3, 1])


def test_a_placement_moves_the_whole_recording():
    poses = matrices([[0.0, 0, 0], [1.0, 0, 0]], [[1.0, 0, 0, 0]] * 2)
    placed = Placement((0.4, 0.0, 0.1), (0.0, 0.0, 0.0, 1.0)).apply(poses)

    assert placed[:, :3, 3] == pytest.approx(np.array([[0.4, 0, 0.1], [-0.6, 0, 0.1]]))
    assert Placement().apply(poses) == pytest.approx(poses)
