"""The shapes of the scene as numbers: they are where the recording was."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration
from keyphase.segmentation.segmentation import Gaussian
from keyphase.web.path_geometry import MOST_PIECES, arrow, ellipsoids, path_of, tube, turns_of_z
from keyphase.web.viewpoint import FIELD_OF_VIEW_RAD, placed, viewpoint_of

POINTS = arrays(np.float64, (12, 3), elements=st.floats(-2, 2))


def _demonstration(position_m: np.ndarray) -> Demonstration:
    return Demonstration("d", np.arange(len(position_m)) * 0.01, position_m)


@pytest.fixture(scope="module")
def corner() -> Demonstration:
    """10 cm along x, a rest of one second, 10 cm along y."""
    way = np.linspace(0.0, 0.1, 100)
    along = np.stack([way, 0 * way, 0 * way], axis=1)
    rest = np.tile([0.1, 0.0, 0.0], (100, 1))
    across = np.stack([0 * way + 0.1, way, 0 * way], axis=1)
    return _demonstration(np.concatenate([along, rest, across]))


def test_pieces_join_from_start_to_end(corner: Demonstration) -> None:
    path = path_of(corner)
    z = Rotation.from_quat(path.wxyz, scalar_first=True).apply([0.0, 0.0, 1.0])
    ends = path.middle_m + 0.5 * path.length_m[:, None] * z
    starts = path.middle_m - 0.5 * path.length_m[:, None] * z

    np.testing.assert_allclose(ends[:-1], starts[1:], atol=1e-9)
    np.testing.assert_allclose(starts[0], [0, 0, 0], atol=path.radius_m)
    np.testing.assert_allclose(ends[-1], [0.1, 0.1, 0], atol=path.radius_m)


def test_a_rest_belongs_to_no_piece_after_it(corner: Demonstration) -> None:
    path = path_of(corner)
    moving = (path.time_s < 1.01) | (path.time_s > 1.99)

    assert moving.all()


def test_a_path_however_long_has_a_bounded_number_of_pieces() -> None:
    walk = np.cumsum(np.random.default_rng(0).normal(size=(200_000, 3)), axis=0)

    assert len(path_of(_demonstration(0.01 * walk)).time_s) <= MOST_PIECES


@pytest.mark.parametrize("rows", [2, 3, 4, 7])
def test_the_shortest_and_the_resting_recordings_have_a_path(rows: int) -> None:
    path = path_of(_demonstration(np.zeros((rows, 3))))

    assert np.isfinite(path.wxyz).all()
    assert path.size_m > 0


@given(POINTS)
def test_z_is_turned_along_any_direction(directions: np.ndarray) -> None:
    wxyz = turns_of_z(directions)
    norms = np.linalg.norm(directions, axis=1, keepdims=True)
    turned = Rotation.from_quat(wxyz, scalar_first=True).apply([0.0, 0.0, 1.0])
    long = norms[:, 0] > 1e-6

    np.testing.assert_allclose(np.linalg.norm(wxyz, axis=1), 1.0, atol=1e-12)
    np.testing.assert_allclose(
        turned[long], (directions / np.maximum(norms, 1e-9))[long], atol=1e-4
    )


def test_the_tube_faces_outwards() -> None:
    vertices, faces = tube()
    corners = vertices[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])

    assert (np.sum(normals * corners.mean(axis=1) * [1, 1, 0], axis=1) > 0).all()


@given(POINTS)
def test_an_ellipsoid_is_one_standard_deviation_of_its_gaussian(points: np.ndarray) -> None:
    covariance = np.cov(points.T) + 1e-4 * np.eye(3)
    gaussian = Gaussian(1.0, 0.0, 1.0, points.mean(axis=0), covariance)

    (position,), (turn,), (half_axes,) = ellipsoids([gaussian], 1e-9)

    axes = Rotation.from_quat(turn, scalar_first=True).as_matrix()
    np.testing.assert_allclose(axes * half_axes**2 @ axes.T, covariance, atol=1e-9)
    np.testing.assert_array_equal(position, points.mean(axis=0))


def test_a_force_of_five_newtons_is_five_centimetres_long() -> None:
    at_m = np.array([1.0, 0.0, 0.0])
    drawn = arrow(at_m, (0.0, 3.0, 4.0), 0.01, 1.0)

    assert drawn is not None
    np.testing.assert_allclose(drawn[1] - drawn[0], [0.0, 0.03, 0.04])
    assert arrow(at_m, (0.0, 0.0, 0.0), 0.01, 1.0) is None


@given(POINTS)
def test_the_whole_path_is_in_view(points: np.ndarray) -> None:
    path = path_of(_demonstration(points))
    view = viewpoint_of(path)
    seen = points - view.position_m
    ahead = view.look_at_m - view.position_m
    depth = seen @ (ahead / np.linalg.norm(ahead))

    assert (depth > 0).all()
    assert (np.abs(seen @ view.up) <= 1.05 * np.tan(0.5 * FIELD_OF_VIEW_RAD) * depth).all()


@given(st.lists(arrays(np.float64, 3, elements=st.floats(-0.1, 0.1)), max_size=12))
def test_names_on_one_side_never_cover_each_other(anchors: list[np.ndarray]) -> None:
    path = path_of(_demonstration(np.array([[0, 0, 0], [0.1, 0.1, 0.1]], float)))
    view = viewpoint_of(path)
    names = placed([(str(i), anchor) for i, anchor in enumerate(anchors)], view)

    assert sorted(name.text for name in names) == sorted(map(str, range(len(anchors))))
    for side in ("left", "right"):
        heights = sorted(float(n.at_m @ view.up) for n in names if n.side == side)
        assert all(np.diff(heights) > 0.05 * view.height_m)
