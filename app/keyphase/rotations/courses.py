"""Orientations over time: quaternions continuous in sign, and how far they have turned."""

import numpy as np

from keyphase.arrays import Array
from keyphase.rotations.quaternions import difference

_NO_AXIS = 1e-6
"""Sine of half an angle below which a rotation shows no axis."""


def continued(wxyz: Array) -> Array:
    """The same rotations (N, 4), each with the sign that lies nearer to the one before it."""
    flips = np.sum(wxyz[1:] * wxyz[:-1], axis=1) < 0
    signs = np.where(np.concatenate([[False], np.cumsum(flips) % 2 == 1]), -1.0, 1.0)
    return wxyz * signs[:, None]


def from_first(wxyz: Array) -> Array:
    """Rotation vectors (N, 3) from the first orientation, base frame [rad].

    `wxyz` (N, 4) is continuous in sign. The vectors are continuous as the orientation is: nothing
    jumps where it has turned by half a turn, and about one axis nothing where it has turned by a
    whole one or by many.
    """
    turned = difference(wxyz, wxyz[0])
    angle = np.linalg.norm(turned, axis=1)
    # A jump happens at a whole turn only, where the logarithm meets itself from the other side.
    near = angle > 1.5 * np.pi
    return _past_whole_turns(turned, angle) if near.any() else turned


def _past_whole_turns(turned: Array, angle: Array) -> Array:
    shows_axis = np.sin(0.5 * angle) > _NO_AXIS
    last = np.maximum.accumulate(np.where(shows_axis, np.arange(len(angle)), 0))
    axis = (turned / np.where(shows_axis, angle, 1.0)[:, None])[last]
    turns_over = np.sum(axis[1:] * axis[:-1], axis=1) < 0
    sign = np.where(np.concatenate([[False], np.cumsum(turns_over) % 2 == 1]), -1.0, 1.0)
    # A quaternion comes back to itself after two turns.
    about = np.unwrap(sign * angle, period=4.0 * np.pi)
    return (sign * about)[:, None] * axis


def angular_velocity(time_s: Array, wxyz: Array) -> Array:
    """Angular velocity (N, 3) in the base frame, by central differences [rad/s].

    time_s (N,) increasing, wxyz (N, 4) continuous in sign.
    """
    after = np.minimum(np.arange(len(time_s)) + 1, len(time_s) - 1)
    before = np.maximum(np.arange(len(time_s)) - 1, 0)
    turn = difference(wxyz[after], wxyz[before])
    return turn / (time_s[after] - time_s[before])[:, None]
