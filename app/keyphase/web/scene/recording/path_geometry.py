"""Shapes of the scene as plain arrays: the path in pieces, ellipsoids, arrows.

Everything here is numbers; the parts of the scene hand it to viser.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.segmentation import Gaussian

MAX_PIECES = 1000
"""So many pieces draw any path: where it passes again and again, its first pass is drawn."""

MAX_ELLIPSOIDS = 60
"""So many Gaussians are drawn, those with the most weight; more hide each other, and every one of
them is filled pixel by pixel where 3D is drawn in software."""

MAX_ARROWS = 100
"""So many force arrows are drawn, the longest ones."""

METRES_PER_NEWTON = 0.01
"""Length of the force arrow of a workcell."""

MAX_ARROW = 1.0 / 3.0
"""The longest force arrow of a recording, as a share of its path's size."""

CHEVRONS = 24
"""So many chevrons along a path, and one at least."""

MIN_SIZE_M = 0.02
"""A path that hardly moves is seen as if it were so large."""

_MAX_SAMPLES = 200_000
_SIDES = 12
_SAME_PASS = 8
"""Pieces that are no more than so many apart belong to one pass."""


@dataclass(frozen=True, eq=False)
class Path:
    """A path as M straight pieces, each from one kept sample to the next.

    position_m (M + 1, 3) the kept samples
    time_s     (M,)   when the piece was passed: a rest before it belongs to what is before
    wxyz       (M, 4) turns z along it
    length_m   (M,)
    drawn      (D,)   indices of the pieces that show the whole path; the others lie where it had
               been before
    low_m, high_m     (3,) the box around the whole path
    least_m    how large what is seen is at least, of which the path may be a small part
    """

    position_m: Array
    time_s: Array
    wxyz: Array
    length_m: Array
    drawn: NDArray[np.intp]
    low_m: Array
    high_m: Array
    least_m: float = MIN_SIZE_M

    @property
    def size_m(self) -> float:
        """The diagonal of the box, or the least size."""
        return _size_m(self.low_m, self.high_m, self.least_m)

    @property
    def radius_m(self) -> float:
        """How thick the path is drawn: to be seen beside the whole."""
        return radius_of(self.size_m)

    @property
    def middle_m(self) -> Array:
        """(M, 3) the middle of each piece."""
        return 0.5 * (self.position_m[1:] + self.position_m[:-1])


def path_of(demonstration: Demonstration, least_m: float = MIN_SIZE_M) -> Path:
    """The path of the tool in pieces about as long as it is thick, at most MAX_PIECES drawn."""
    stride = -(-len(demonstration) // _MAX_SAMPLES)
    time, position = demonstration.time_s[::stride], demonstration.position_m[::stride]
    low, high = position.min(axis=0), position.max(axis=0)
    spacing = radius_of(_size_m(low, high, least_m))
    kept = _apart(position, spacing)
    drawn = _first_passes(position[kept], spacing)
    while len(drawn) > MAX_PIECES:
        spacing *= 1.5
        kept = kept[_apart(position[kept], spacing)]
        drawn = _first_passes(position[kept], spacing)
    points = _smoothed(position[kept])
    steps = np.diff(points, axis=0)
    return Path(
        position_m=points,
        time_s=time[kept[1:]],
        wxyz=turns_of_z(steps),
        length_m=np.linalg.norm(steps, axis=1),
        drawn=drawn,
        low_m=low,
        high_m=high,
        least_m=least_m,
    )


def _first_passes(points_m: Array, cell_m: float) -> NDArray[np.intp]:
    """Indices of the pieces between points (M + 1, 3) that lie in a cell none had passed before.

    A path of few pieces is drawn whole.
    """
    pieces = len(points_m) - 1
    if pieces <= MAX_PIECES:
        return np.arange(pieces)
    middles = 0.5 * (points_m[1:] + points_m[:-1])
    cells = np.floor((middles - middles.min(axis=0)) / cell_m)
    _, first, cell = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    return np.flatnonzero(np.arange(pieces) - first[cell.reshape(-1)] <= _SAME_PASS)


def bent(directions: Array, least_rad: float = 0.1) -> NDArray[np.bool_]:
    """(M - 1,) whether the path turns enough from one of M directions to the next to be seen."""
    norms = np.linalg.norm(directions, axis=1)
    along = np.sum(directions[1:] * directions[:-1], axis=1)
    return along < np.cos(least_rad) * norms[1:] * norms[:-1]


def _smoothed(points: Array) -> Array:
    """Without the zigzag of measurement noise, which is as wide as the path is thick."""
    if len(points) < 5:
        return points
    padded = np.pad(points, ((2, 2), (0, 0)), mode="edge")
    weights = np.array([1.0, 4.0, 6.0, 4.0, 1.0]) / 16.0
    return np.sum([w * padded[i : i + len(points)] for i, w in enumerate(weights)], axis=0)


def _size_m(low_m: Array, high_m: Array, least_m: float) -> float:
    return max(float(np.linalg.norm(high_m - low_m)), least_m)


def radius_of(size_m: float) -> float:
    """How thick a path of that size is drawn [m]."""
    return float(np.clip(0.009 * size_m, 0.0008, 0.012))


def _apart(position_m: Array, spacing_m: float) -> NDArray[np.intp]:
    """Indices of samples of which each is `spacing_m` from the one before; the last one always."""
    kept = [0]
    points = position_m.tolist()
    x, y, z = points[0]
    limit = spacing_m**2
    for index, (u, v, w) in enumerate(points):
        if (u - x) ** 2 + (v - y) ** 2 + (w - z) ** 2 >= limit:
            kept.append(index)
            x, y, z = u, v, w
    if len(kept) == 1 or kept[-1] != len(points) - 1:
        kept.append(len(points) - 1)
    return np.array(kept)


def turns_of_z(directions: Array) -> Array:
    """(M, 4) quaternions w x y z that turn the z axis along (M, 3) directions of any length.

    The shortest turn: half way between z and the direction, (1 + cos, z × d) made unit.
    """
    norms = np.linalg.norm(directions, axis=1, keepdims=True)
    unit = np.where(norms > 0, directions / np.maximum(norms, 1e-300), [0.0, 0.0, 1.0])
    wxyz = np.stack([1 + unit[:, 2], -unit[:, 1], unit[:, 0], np.zeros(len(unit))], axis=1)
    wxyz[unit[:, 2] < -1 + 1e-9] = [0.0, 1.0, 0.0, 0.0]
    return wxyz / np.linalg.norm(wxyz, axis=1, keepdims=True)


def tube() -> tuple[Array, NDArray[np.uint32]]:
    """Vertices and faces of an open cylinder of radius and length one along z, about its middle."""
    angle = np.linspace(0.0, 2 * np.pi, _SIDES, endpoint=False)
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    low = np.column_stack([ring, np.full(_SIDES, -0.5)])
    high = np.column_stack([ring, np.full(_SIDES, 0.5)])
    i = np.arange(_SIDES)
    j = (i + 1) % _SIDES
    faces = np.concatenate(
        [np.stack([i, j, j + _SIDES], axis=1), np.stack([i, j + _SIDES, i + _SIDES], axis=1)]
    )
    return np.concatenate([low, high]), faces.astype(np.uint32)


def heaviest(gaussians: Sequence[Gaussian]) -> Sequence[Gaussian]:
    """The MAX_ELLIPSOIDS Gaussians with the most weight; all where there are no more."""
    if len(gaussians) <= MAX_ELLIPSOIDS:
        return gaussians
    return sorted(gaussians, key=lambda gaussian: -gaussian.weight)[:MAX_ELLIPSOIDS]


def ellipsoids(gaussians: Sequence[Gaussian], least_m: float) -> tuple[Array, Array, Array]:
    """Positions (K, 3), turns w x y z (K, 4) and half axes (K, 3) of one standard deviation.

    No half axis is drawn shorter than `least_m`, so that a rest can still be seen.
    """
    covariances = np.array([gaussian.covariance_m2 for gaussian in gaussians])
    variances, axes = np.linalg.eigh(covariances)
    axes[:, :, 0] *= np.linalg.det(axes)[:, None]
    turns = Rotation.from_matrix(axes).as_quat(scalar_first=True)
    positions = np.array([gaussian.mean_position_m for gaussian in gaussians])
    return positions, turns, np.sqrt(np.maximum(variances, least_m**2))


def arrow(
    position_m: Array, force_N: Sequence[float], metres_per_newton: float, shortest_m: float
) -> tuple[Array, Array] | None:
    """Start and end of an arrow for a force at the contact; none where there is no force."""
    force = np.asarray(force_N, dtype=np.float64)
    size = float(np.linalg.norm(force))
    if size <= 0.0:
        return None
    length = max(metres_per_newton * size, shortest_m)
    return position_m, position_m + force / size * length


def chevron() -> tuple[Array, NDArray[np.uint32]]:
    """Vertices and faces of a cone of radius and length one along z, its middle at zero."""
    angle = np.linspace(0.0, 2 * np.pi, _SIDES, endpoint=False)
    ring = np.column_stack([np.cos(angle), np.sin(angle), np.full(_SIDES, -0.5)])
    i = np.arange(_SIDES)
    j = (i + 1) % _SIDES
    tip, base = np.full(_SIDES, _SIDES), np.full(_SIDES, _SIDES + 1)
    faces = np.concatenate([np.stack([i, j, tip], axis=1), np.stack([j, i, base], axis=1)])
    points = np.concatenate([ring, [[0.0, 0.0, 0.5], [0.0, 0.0, -0.5]]])
    return points, faces.astype(np.uint32)


def spaced(path: Path, pieces: NDArray[np.intp]) -> NDArray[np.intp]:
    """Of these pieces those at even distances along the path, CHEVRONS of them at most.

    Where the path hardly moves it has no direction and gets none.
    """
    if len(pieces) == 0:
        return pieces
    along = np.cumsum(path.length_m[pieces])
    count = min(CHEVRONS, int(along[-1] / (8.0 * path.radius_m)))
    at = (np.arange(count) + 0.5) / max(count, 1) * along[-1]
    return np.unique(pieces[np.searchsorted(along, at).clip(0, len(pieces) - 1)])
