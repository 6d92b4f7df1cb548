"""Unit quaternions w x y z: product, exponential and logarithm over any leading shape.

The logarithm is the one on the sphere minus one point: q and -q are told apart, so that with
sign-continuous quaternions a rotation is followed past 180 degrees.

Everything is written by component (`keyphase.skills.components`), and what is done one after the
other on the way is joined at its end only.
"""

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.components import Components, components, functions, joined

IDENTITY = (1.0, 0.0, 0.0, 0.0)

_TINY = 1e-300
"""Added to divisors, so that a zero rotation gives zero."""


def product(left: Array, right: Array) -> Array:
    """Hamilton product (..., 4): first the rotation `right`, then `left`."""
    return joined(_product(components(left), components(right)))


def conjugate(wxyz: Array) -> Array:
    """The inverse rotation (..., 4)."""
    return joined(_conjugate(components(wxyz)))


def rotation_vector(wxyz: Array) -> Array:
    """Twice the logarithm: axis times angle (..., 3), the angle from 0 to 2 pi [rad].

    Continuous everywhere but at (-1, 0, 0, 0), a whole turn.
    """
    return joined(_rotation_vector(components(wxyz)))


def shortest_rotation_vector(wxyz: Array) -> Array:
    """Axis times angle (..., 3) of the same rotation by its shorter way, at most pi [rad]."""
    return joined(_shortest_rotation_vector(components(wxyz)))


def from_rotation_vector(vector: Array) -> Array:
    """Quaternion (..., 4) of the rotation by |vector| [rad] about its axis."""
    return joined(_from_rotation_vector(components(vector)))


def normalised(wxyz: Array) -> Array:
    """The same (..., 4) at unit length."""
    return joined(_normalised(components(wxyz)))


def difference(to: Array, origin: Array) -> Array:
    """Rotation vector (..., 3) that turns `origin` into `to`, in the base frame, sign-aware."""
    return joined(_rotation_vector(_turn(to, origin)))


def shortest_difference(to: Array, origin: Array) -> Array:
    """Like `difference` by the shorter way, at most pi, whatever the signs."""
    return joined(_shortest_rotation_vector(_turn(to, origin)))


def turned(wxyz: Array, vector: Array) -> Array:
    """The orientation (..., 4) turned by a rotation vector (..., 3), in the base frame."""
    turn = _from_rotation_vector(components(vector))
    return joined(_normalised(_product(turn, components(wxyz))))


def nearest_sign(wxyz: Array, to: Array) -> Array:
    """The same rotations with the signs that lie nearer to the quaternions `to`."""
    opposite = np.add.reduce(wxyz * to, axis=-1, keepdims=True) < 0.0
    return np.where(opposite, -wxyz, wxyz)


def _product(left: Components, right: Components) -> Components:
    a, b, c, d = left
    w, x, y, z = right
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def _conjugate(wxyz: Components) -> Components:
    w, x, y, z = wxyz
    return w, -x, -y, -z


def _turn(to: Array, origin: Array) -> Components:
    return _product(components(to), _conjugate(components(origin)))


def _rotation_vector(wxyz: Components) -> Components:
    w, x, y, z = wxyz
    m = functions(w)
    sine = m.sqrt(x * x + y * y + z * z)
    scale = 2.0 * m.atan2(sine, w) / (sine + _TINY)
    return scale * x, scale * y, scale * z


def _shortest_rotation_vector(wxyz: Components) -> Components:
    sign = functions(wxyz[0]).copysign(1.0, wxyz[0])
    return _rotation_vector([sign * part for part in wxyz])


def _from_rotation_vector(vector: Components) -> Components:
    x, y, z = vector
    m = functions(x)
    half = 0.5 * m.sqrt(x * x + y * y + z * z)
    scale = 0.5 * m.sin(half) / (half + _TINY)
    return m.cos(half), scale * x, scale * y, scale * z


def _normalised(wxyz: Components) -> Components:
    w, x, y, z = wxyz
    scale = 1.0 / functions(w).sqrt(w * w + x * x + y * y + z * z)
    return scale * w, scale * x, scale * y, scale * z
