"""The shapes of the scene as numbers: they are where the recording was."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration
from keyphase.segmentation.segmentation import Gaussian
from keyphase.web.scene.recording.path_geometry import (
    CHEVRONS,
    MAX_ELLIPSOIDS,
    MAX_PIECES,
    arrow,
    bent,
    chevron,
    ellipsoids,
    heaviest,
    path_of,
    spaced,
    tube,
    turns_of_z,
)
from keyphase.web.scene.recording.viewpoint import FIELD_OF_VIEW_RAD, viewpoint_of

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


def test_a_path_however_long_is_drawn_with_a_bounded_number_of_pieces() -> None:
    walk = np.cumsum(np.random.default_rng(0).normal(size=(200_000, 3)), axis=0)

    assert len(path_of(_demonstration(0.01 * walk)).drawn) <= MAX_PIECES


def test_going_round_again_and_again_is_drawn_about_once() -> None:
    angle = np.linspace(0.0, 2 * np.pi, 500, endpoint=False)
    once = 0.1 * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    noise = np.random.default_rng(0).normal(0.0, 2e-4, (100_000, 3))
    path = path_of(_demonstration(np.tile(once, (200, 1)) + noise))
    seen = path.middle_m[path.drawn]

    assert len(seen) < 0.1 * len(path.time_s)
    for point in once:
        assert np.linalg.norm(seen - point, axis=1).min() < 2 * path.radius_m


def test_only_bends_that_can_be_seen_are_joined() -> None:
    directions = np.array([[1.0, 0.0, 0.0], [2.0, 0.01, 0.0], [0.0, 1.0, 0.0]])

    np.testing.assert_array_equal(bent(directions), [False, True])


def test_of_very_many_gaussians_the_heaviest_are_drawn() -> None:
    gaussians = [Gaussian(float(k), 0.0, 1.0, np.zeros(3), np.eye(3)) for k in range(200)]
    drawn = heaviest(gaussians)

    assert len(drawn) == MAX_ELLIPSOIDS
    assert min(one.weight for one in drawn) == 200 - MAX_ELLIPSOIDS


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


def test_a_force_is_as_long_as_the_scale_says_and_none_is_too_short_to_be_seen() -> None:
    at_m = np.array([1.0, 0.0, 0.0])
    drawn = arrow(at_m, (0.0, 3.0, 4.0), 0.01, 0.02)
    small = arrow(at_m, (0.0, 0.0, 0.5), 0.01, 0.02)

    assert drawn is not None
    assert small is not None
    np.testing.assert_allclose(drawn[1] - drawn[0], [0.0, 0.03, 0.04])
    np.testing.assert_allclose(small[1] - small[0], [0.0, 0.0, 0.02])
    assert arrow(at_m, (0.0, 0.0, 0.0), 0.01, 0.02) is None


def test_chevrons_are_evenly_spaced_and_few() -> None:
    path = path_of(_demonstration(np.linspace([0.0, 0.0, 0.0], [1.0, 0.0, 0.0], 2000)))
    at = path.middle_m[spaced(path, np.arange(len(path.time_s)))][:, 0]

    assert 5 < len(at) <= CHEVRONS
    assert np.ptp(np.diff(at)) < 0.02
    assert len(spaced(path, np.arange(0))) == 0


def test_a_chevron_points_along_z() -> None:
    points, faces = chevron()

    assert points[:, 2].max() == 0.5
    assert (points[points[:, 2] == 0.5][:, :2] == 0.0).all()
    assert faces.max() < len(points)


@given(POINTS)
def test_the_whole_path_is_in_view(points: np.ndarray) -> None:
    path = path_of(_demonstration(points))
    view = viewpoint_of(path)
    seen = points - view.position_m
    ahead = view.look_at_m - view.position_m
    depth = seen @ (ahead / np.linalg.norm(ahead))

    assert (depth > 0).all()
    assert (np.abs(seen @ view.up) <= 1.05 * np.tan(0.5 * FIELD_OF_VIEW_RAD) * depth).all()
