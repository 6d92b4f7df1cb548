"""Shapes of the scene as plain arrays: the path in pieces, ellipsoids, arrows, where to look from.

Everything here is numbers; `scene` hands it to viser.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.segmentation import Gaussian

MOST_PIECES = 1500
"""So many pieces draw any path; a longer recording has longer ones."""

METRES_PER_NEWTON = 0.01
"""Length of a force arrow."""

_SIDES = 10
_TIME_SHARE = 0.2


@dataclass(frozen=True, eq=False)
class Path:
    """A path as straight pieces between M + 1 of its samples.

    time_s    (M,)   middle of each piece
    middle_m  (M, 3) where its middle is
    wxyz      (M, 4) turns z along it
    length_m  (M,)
    size_m           the longest side of the box around the whole path
    """

    time_s: Array
    middle_m: Array
    wxyz: Array
    length_m: Array
    size_m: float

    @property
    def radius_m(self) -> float:
        """How thick it is drawn: to be seen beside the whole."""
        return float(np.clip(0.011 * self.size_m, 0.001, 0.012))


def path_of(demonstration: Demonstration) -> Path:
    """The path of the tool, in at most MOST_PIECES pieces."""
    kept = _spread_samples(demonstration)
    time, position = demonstration.time_s[kept], demonstration.position_m[kept]
    steps = np.diff(position, axis=0)
    length = np.linalg.norm(steps, axis=1)
    box = np.ptp(demonstration.position_m, axis=0)
    return Path(
        time_s=0.5 * (time[1:] + time[:-1]),
        middle_m=0.5 * (position[1:] + position[:-1]),
        wxyz=turns_of_z(steps),
        length_m=length,
        size_m=max(float(box.max()), 0.02),
    )


def _spread_samples(demonstration: Demonstration) -> NDArray[np.intp]:
    """Samples evenly spread over the way and, less so, over time, so that rests keep a few."""
    way = np.concatenate([[0.0], np.cumsum(_step_lengths(demonstration.position_m))])
    elapsed = demonstration.time_s - demonstration.start_s
    progress = (1 - _TIME_SHARE) * way / max(way[-1], 1e-9) + _TIME_SHARE * elapsed / elapsed[-1]
    count = min(len(demonstration), MOST_PIECES + 1)
    found = np.searchsorted(progress, np.linspace(0.0, progress[-1], count))
    return np.unique(np.concatenate([[0], found.clip(0, len(demonstration) - 1)]))


def _step_lengths(position_m: Array) -> Array:
    return np.linalg.norm(np.diff(position_m, axis=0), axis=1)


def turns_of_z(directions: Array) -> Array:
    """(M, 4) quaternions w x y z that turn the z axis along (M, 3) directions of any length.

    The shortest turn: half way between z and the direction, (1 + cos, z × d) made unit.
    """
    norms = np.linalg.norm(directions, axis=1, keepdims=True)
    unit = np.where(norms > 0, directions / np.maximum(norms, 1e-300), [0.0, 0.0, 1.0])
    wxyz = np.stack([1 + unit[:, 2], -unit[:, 1], unit[:, 0], np.zeros(len(unit))], axis=1)
    opposite = unit[:, 2] < -1 + 1e-9
    wxyz[opposite] = [0.0, 1.0, 0.0, 0.0]
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


def piece_scales(path: Path, segment_of_piece: NDArray[np.intp], selected: int | None) -> Array:
    """(M, 3) scale of each piece; the selected segment is thicker, and pieces overlap a little."""
    radius = np.full(len(path.length_m), path.radius_m)
    if selected is not None:
        radius[segment_of_piece == selected] *= 1.6
    return np.stack([radius, radius, path.length_m + 0.5 * radius], axis=1)


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
    position_m: Array, force_N: Sequence[float], shortest_m: float, longest_m: float
) -> tuple[Array, Array] | None:
    """Start and end of an arrow for a force at the contact, 1 cm per N within bounds."""
    force = np.asarray(force_N, dtype=np.float64)
    size = float(np.linalg.norm(force))
    if size <= 0.0:
        return None
    length = float(np.clip(METRES_PER_NEWTON * size, shortest_m, longest_m))
    return position_m, position_m + force / size * length


def view_of(position_m: Array) -> tuple[Array, Array]:
    """Where to look from and at, so that the whole path is in view, from the front and above."""
    low, high = position_m.min(axis=0), position_m.max(axis=0)
    middle = 0.5 * (low + high)
    distance = max(1.5 * float(np.linalg.norm(high - low)), 0.08)
    direction = np.array([0.75, 0.55, 0.45])
    return middle + direction / np.linalg.norm(direction) * distance, middle
