"""Unit quaternions w x y z: product, exponential and logarithm over any leading shape.

The logarithm is the one on the sphere minus one point: q and -q are told apart, so that with
sign-continuous quaternions a rotation is followed past 180 degrees.

Everything is written by component, so that the same lines serve one quaternion in plain numbers
and a batch in arrays: control steps one at a time, and numpy is slow at single numbers.
"""

import math
from typing import Any

import numpy as np

from keyphase.demonstration import Array

IDENTITY = (1.0, 0.0, 0.0, 0.0)

_TINY = 1e-300
"""Added to divisors, so that a zero rotation gives zero."""


def product(left: Array, right: Array) -> Array:
    """Hamilton product (..., 4): first the rotation `right`, then `left`."""
    a, b, c, d = _components(left)
    w, x, y, z = _components(right)
    return _joined(
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def conjugate(wxyz: Array) -> Array:
    """The inverse rotation (..., 4)."""
    w, x, y, z = _components(wxyz)
    return _joined(w, -x, -y, -z)


def rotation_vector(wxyz: Array) -> Array:
    """Twice the logarithm: axis times angle (..., 3), the angle from 0 to 2 pi [rad].

    Continuous everywhere but at (-1, 0, 0, 0), a whole turn.
    """
    w, x, y, z = _components(wxyz)
    m = _trigonometry(wxyz)
    sine = m.sqrt(x * x + y * y + z * z)
    scale = 2.0 * m.atan2(sine, w) / (sine + _TINY)
    return _joined(scale * x, scale * y, scale * z)


def shortest_rotation_vector(wxyz: Array) -> Array:
    """Axis times angle (..., 3) of the same rotation by its shorter way, at most pi [rad]."""
    if wxyz.ndim == 1:
        return rotation_vector(-wxyz if wxyz[0] < 0.0 else wxyz)
    return rotation_vector(np.where(wxyz[..., :1] < 0.0, -wxyz, wxyz))


def from_rotation_vector(vector: Array) -> Array:
    """Quaternion (..., 4) of the rotation by |vector| [rad] about its axis."""
    x, y, z = _components(vector)
    m = _trigonometry(vector)
    half = 0.5 * m.sqrt(x * x + y * y + z * z)
    scale = 0.5 * m.sin(half) / (half + _TINY)
    return _joined(m.cos(half), scale * x, scale * y, scale * z)


def normalised(wxyz: Array) -> Array:
    """The same (..., 4) at unit length."""
    w, x, y, z = _components(wxyz)
    scale = 1.0 / _trigonometry(wxyz).sqrt(w * w + x * x + y * y + z * z)
    return _joined(scale * w, scale * x, scale * y, scale * z)


def difference(to: Array, origin: Array) -> Array:
    """Rotation vector (..., 3) that turns `origin` into `to`, in the base frame, sign-aware."""
    return rotation_vector(product(to, conjugate(origin)))


def nearest_sign(wxyz: Array, to: Array) -> Array:
    """The same rotations with the signs that lie nearer to the quaternions `to`."""
    opposite = np.add.reduce(wxyz * to, axis=-1, keepdims=True) < 0.0
    return np.where(opposite, -wxyz, wxyz)


def _components(array: Array) -> Any:
    return array.tolist() if array.ndim == 1 else np.moveaxis(array, -1, 0)


def _joined(*components: Any) -> Array:
    if isinstance(components[0], float):
        return np.array(components)
    return np.stack(np.broadcast_arrays(*components), axis=-1)


def _trigonometry(array: Array) -> Any:
    return math if array.ndim == 1 else np
