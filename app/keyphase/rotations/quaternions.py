"""Unit quaternions w x y z: product, exponential and logarithm over any leading shape.

The logarithm is the one on the sphere minus one point: q and -q are told apart, so that with
sign-continuous quaternions a rotation is followed past 180 degrees.
"""

import numpy as np

from keyphase.arrays import Array
from keyphase.rotations import turns
from keyphase.rotations.components import components, joined

IDENTITY = (1.0, 0.0, 0.0, 0.0)


def product(left: Array, right: Array) -> Array:
    """Hamilton product (..., 4): first the rotation `right`, then `left`."""
    return joined(turns.product(components(left), components(right)))


def conjugate(wxyz: Array) -> Array:
    """The inverse rotation (..., 4)."""
    return joined(turns.conjugate(components(wxyz)))


def rotation_vector(wxyz: Array) -> Array:
    """Twice the logarithm: axis times angle (..., 3), the angle from 0 to 2 pi [rad].

    Continuous everywhere but at (-1, 0, 0, 0), a whole turn.
    """
    return joined(turns.rotation_vector(components(wxyz)))


def shortest_rotation_vector(wxyz: Array) -> Array:
    """Axis times angle (..., 3) of the same rotation by its shorter way, at most pi [rad]."""
    return joined(turns.shortest_rotation_vector(components(wxyz)))


def from_rotation_vector(vector: Array) -> Array:
    """Quaternion (..., 4) of the rotation by |vector| [rad] about its axis."""
    return joined(turns.from_rotation_vector(components(vector)))


def normalised(wxyz: Array) -> Array:
    """The same (..., 4) at unit length."""
    return joined(turns.normalised(components(wxyz)))


def difference(to: Array, origin: Array) -> Array:
    """Rotation vector (..., 3) that turns `origin` into `to`, in the base frame, sign-aware."""
    return joined(turns.difference(components(to), components(origin)))


def shortest_difference(to: Array, origin: Array) -> Array:
    """Like `difference` by the shorter way, at most pi, whatever the signs."""
    return joined(turns.shortest_difference(components(to), components(origin)))


def turned(wxyz: Array, vector: Array) -> Array:
    """The orientation (..., 4) turned by a rotation vector (..., 3), in the base frame."""
    return joined(turns.turned(components(wxyz), components(vector)))


def nearest_sign(wxyz: Array, to: Array) -> Array:
    """The same rotations with the signs that lie nearer to the quaternions `to`."""
    opposite = np.add.reduce(wxyz * to, axis=-1, keepdims=True) < 0.0
    return np.where(opposite, -wxyz, wxyz)
