"""Orientations as tables write them, turned into unit quaternions w x y z."""

from collections.abc import Callable
from typing import Literal

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.demonstration import UNIT_TOLERANCE, Array
from keyphase.errors import DemonstrationError

QuaternionOrder = Literal["wxyz", "xyzw"]
MatrixLayout = Literal["row_major", "column_major"]
Where = Callable[[int], str]
"""Names a row as messages should: its file, line and columns."""


def from_quaternions(values: Array, order: QuaternionOrder, where: Where) -> Array:
    """(N, 4) in either order to w x y z; refuses a norm that is not one."""
    wxyz = values if order == "wxyz" else np.roll(values, 1, axis=1)
    refuse_not_unit(wxyz, where)
    return wxyz


def normalised(values: Array, where: Where) -> Array:
    """Quaternions (N, 4) scaled to norm one; refuses those that have none."""
    norms = np.linalg.norm(values, axis=1, keepdims=True)
    bad = ~((norms > 0) & np.isfinite(norms)).ravel()
    if bad.any():
        row = int(np.argmax(bad))
        raise DemonstrationError(
            f"{where(row)}: expected a quaternion that can be normalised, but its norm is "
            f"{norms[row, 0]:.3g}; check the columns."
        )
    return values / norms


def refuse_not_unit(quaternions: Array, where: Where) -> None:
    """Refuse the first quaternion (of either order) whose norm is not one within 1e-3."""
    norms = np.linalg.norm(quaternions, axis=1)
    off = ~(np.abs(norms - 1.0) <= UNIT_TOLERANCE)
    if off.any():
        row = int(np.argmax(off))
        raise DemonstrationError(
            f"{where(row)}: expected a unit quaternion, but its norm is {norms[row]:.6g}; check "
            "the columns, or let a recipe normalise it."
        )


def from_euler(angles_rad: Array, sequence: str) -> Array:
    """Three angles (N, 3) about the axes of `sequence`, in SciPy's notation.

    Lower case turns about the fixed axes, upper case about the turned ones: roll, pitch and yaw
    are "xyz".
    """
    return _wxyz(Rotation.from_euler(sequence, angles_rad))


def from_rotation_vectors(vectors_rad: Array) -> Array:
    """Axis times angle (N, 3)."""
    return _wxyz(Rotation.from_rotvec(vectors_rad))


def from_matrices(matrices: Array, where: Where) -> Array:
    """Rotation matrices (N, 3, 3); refuses what is no rotation within 1e-3."""
    gram = np.einsum("nij,nik->njk", matrices, matrices)
    error = np.max(np.abs(gram - np.eye(3)), axis=(1, 2))
    off = ~((error <= UNIT_TOLERANCE) & (np.linalg.det(matrices) > 0))
    if off.any():
        raise DemonstrationError(
            f"{where(int(np.argmax(off)))}: expected a rotation matrix (orthogonal within "
            f"{UNIT_TOLERANCE:g}, right-handed), but it is none; check the columns and the layout."
        )
    return _wxyz(Rotation.from_matrix(matrices))


def from_six_numbers(values: Array, where: Where) -> Array:
    """First two columns of the rotation matrix (N, 6), made orthonormal (Zhou et al., rot6d).

    Refuses columns that are parallel or not of unit length within 0.1.
    """
    first, second = values[:, :3], values[:, 3:]
    norms = np.linalg.norm(first, axis=1)
    x = first / np.where(norms > 0, norms, 1.0)[:, None]
    aside = second - np.sum(x * second, axis=1, keepdims=True) * x
    lengths = np.linalg.norm(aside, axis=1)
    off = (np.abs(norms - 1.0) > 0.1) | (np.abs(lengths - 1.0) > 0.1)
    if off.any():
        raise DemonstrationError(
            f"{where(int(np.argmax(off)))}: expected six numbers that are two columns of a "
            "rotation matrix, but they are none; check the columns and their order."
        )
    y = aside / lengths[:, None]
    return _wxyz(Rotation.from_matrix(np.stack([x, y, np.cross(x, y)], axis=2)))


def square_matrices(values: Array, layout: MatrixLayout) -> Array:
    """Flat matrices (N, D*D) as (N, D, D)."""
    side = int(np.sqrt(values.shape[1]))
    matrices = values.reshape(-1, side, side)
    return matrices if layout == "row_major" else np.swapaxes(matrices, 1, 2)


def with_last_row(values: Array, layout: MatrixLayout) -> Array:
    """The first three rows of 4x4 matrices (N, 12), flat by rows or columns, as (N, 16)."""
    rows = values.reshape(-1, 3, 4)
    if layout == "column_major":
        rows = values.reshape(-1, 4, 3).swapaxes(1, 2)
    last = np.tile([0.0, 0.0, 0.0, 1.0], (len(rows), 1, 1))
    whole = np.concatenate([rows, last], axis=1)
    return (whole if layout == "row_major" else whole.swapaxes(1, 2)).reshape(-1, 16)


def refuse_not_homogeneous(matrices: Array, where: Where) -> None:
    """Refuse the first 4x4 matrix (N, 4, 4) whose last row is not 0 0 0 1."""
    error = np.max(np.abs(matrices[:, 3] - [0, 0, 0, 1]), axis=1)
    if (error > UNIT_TOLERANCE).any():
        row = int(np.argmax(error > UNIT_TOLERANCE))
        last = ", ".join(f"{value:g}" for value in matrices[row, 3])
        raise DemonstrationError(
            f"{where(row)}: expected a 4x4 matrix whose last row is 0, 0, 0, 1, but it is {last}; "
            "check the columns and whether the layout is row_major or column_major."
        )


def _wxyz(rotation: Rotation) -> Array:
    return rotation.as_quat(scalar_first=True)
