"""Rotations by component: unit quaternions w x y z and rotation vectors as sequences of parts.

What `keyphase.rotations.quaternions` does to arrays, for formulae that are themselves written by
component (`keyphase.rotations.components`) and would take arrays apart again.
"""

from keyphase.rotations.components import Components, functions

_TINY = 1e-300
"""Added to divisors, so that a zero rotation gives zero."""


def product(left: Components, right: Components) -> Components:
    """Hamilton product (4): first the rotation `right`, then `left`."""
    a, b, c, d = left
    w, x, y, z = right
    return (
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    )


def conjugate(wxyz: Components) -> Components:
    """The inverse rotation (4)."""
    w, x, y, z = wxyz
    return w, -x, -y, -z


def difference(to: Components, origin: Components) -> Components:
    """Rotation vector (3) that turns `origin` into `to`, in the base frame, sign-aware [rad]."""
    return rotation_vector(product(to, conjugate(origin)))


def shortest_difference(to: Components, origin: Components) -> Components:
    """Like `difference` by the shorter way, at most pi, whatever the signs."""
    return shortest_rotation_vector(product(to, conjugate(origin)))


def turned(wxyz: Components, vector: Components) -> Components:
    """The orientation (4) turned by a rotation vector (3), in the base frame."""
    return normalised(product(from_rotation_vector(vector), wxyz))


def rotation_vector(wxyz: Components) -> Components:
    """Twice the logarithm: axis times angle (3), the angle from 0 to 2 pi [rad]."""
    w, x, y, z = wxyz
    m = functions(w)
    sine = m.sqrt(x * x + y * y + z * z)
    scale = 2.0 * m.atan2(sine, w) / (sine + _TINY)
    return scale * x, scale * y, scale * z


def shortest_rotation_vector(wxyz: Components) -> Components:
    """Axis times angle (3) of the same rotation by its shorter way, at most pi [rad]."""
    sign = functions(wxyz[0]).copysign(1.0, wxyz[0])
    return rotation_vector([sign * part for part in wxyz])


def from_rotation_vector(vector: Components) -> Components:
    """Quaternion (4) of the rotation by |vector| [rad] about its axis."""
    x, y, z = vector
    m = functions(x)
    half = 0.5 * m.sqrt(x * x + y * y + z * z)
    scale = 0.5 * m.sin(half) / (half + _TINY)
    return m.cos(half), scale * x, scale * y, scale * z


def normalised(wxyz: Components) -> Components:
    """The same (4) at unit length."""
    w, x, y, z = wxyz
    scale = 1.0 / functions(w).sqrt(w * w + x * x + y * y + z * z)
    return scale * w, scale * x, scale * y, scale * z
