"""Poses as 4x4 matrices and as position with quaternion, and where a recording is placed."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array

TOOL_DOWN_WXYZ = (0.0, 1.0, 0.0, 0.0)
"""The tool's z axis points down and its x axis forward: for recordings without orientation."""

NO_TURN_WXYZ = (1.0, 0.0, 0.0, 0.0)


def matrices(position_m: ArrayLike, orientation_wxyz: ArrayLike) -> Array:
    """Homogeneous matrices (N, 4, 4) of positions (N, 3) and unit quaternions (N, 4)."""
    position = np.asarray(position_m, dtype=np.float64)
    poses = np.tile(np.eye(4), (len(position), 1, 1))
    poses[:, :3, :3] = _rotation(orientation_wxyz).as_matrix()
    poses[:, :3, 3] = position
    return poses


def matrix(position_m: ArrayLike, orientation_wxyz: ArrayLike) -> Array:
    """Homogeneous matrix (4, 4) of one position (3,) and unit quaternion (4,)."""
    return matrices(np.reshape(position_m, (1, 3)), np.reshape(orientation_wxyz, (1, 4)))[0]


def position_and_wxyz(pose: ArrayLike) -> tuple[Array, Array]:
    """Position (3,) [m] and unit quaternion (4,), w first and not negative, of a pose (4, 4)."""
    pose = np.asarray(pose, dtype=np.float64)
    wxyz = Rotation.from_matrix(pose[:3, :3]).as_quat(canonical=True, scalar_first=True)
    return pose[:3, 3].copy(), wxyz


@dataclass(frozen=True)
class Placement:
    """Where a recording's frame lies in the robot's base frame [m, w x y z].

    By default it is that frame. Recordings made elsewhere in space are moved within reach by it.
    """

    position_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    orientation_wxyz: tuple[float, float, float, float] = NO_TURN_WXYZ

    def apply(self, poses: Array) -> Array:
        """Poses (N, 4, 4) of the recording in the robot's base frame."""
        return matrix(self.position_m, self.orientation_wxyz) @ poses

    def inverse(self) -> "Placement":
        """Where the robot's base lies in the recording's frame."""
        turn = _rotation(self.orientation_wxyz).inv()
        x, y, z = (-turn.apply(self.position_m) + 0.0).tolist()
        a, b, c, d = turn.as_quat(scalar_first=True).tolist()
        return Placement((x, y, z), (a, b, c, d))


def _rotation(wxyz: ArrayLike) -> Rotation:
    return Rotation.from_quat(np.asarray(wxyz, dtype=np.float64), scalar_first=True)
