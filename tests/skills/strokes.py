"""Paths the skill tests share: a curved stroke, a turn, a tool that meets the table."""

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ConfigurationEnd
from keyphase.skills.connecting import minimum_jerk
from keyphase.skills.library import Cut

H = 0.004
DURATION_S = 1.5
TIME_S = H * np.arange(376, dtype=np.float64)
AXIS = np.array([1.0, 2.0, -1.0]) / np.sqrt(6.0)


def stroke():
    """1.5 s along a curve of 0.36 m (376, 3)."""
    way = minimum_jerk(TIME_S / DURATION_S)
    return np.c_[0.3 * way, 0.08 * np.sin(np.pi * way), -0.2 * way]


def turn(degrees, wobble_rad=0.0):
    """The same time spent turning about a skew axis, from a skew start (376, 4)."""
    start = quaternions.from_rotation_vector(np.array([0.4, -0.8, 0.2]))
    way = minimum_jerk(TIME_S / DURATION_S)[:, None]
    across = np.sin(np.pi * TIME_S / DURATION_S)[:, None] ** 2 * np.array([0.0, 1.0, 1.0])
    vector = np.radians(degrees) * way * AXIS + wobble_rad * across
    return quaternions.product(quaternions.from_rotation_vector(vector), start)


def degrees_between(wxyz, other):
    apart = quaternions.product(wxyz, quaternions.conjugate(other))
    return np.degrees(np.linalg.norm(quaternions.shortest_rotation_vector(apart), axis=-1))


def millimetres_between(position_m, other_m):
    return 1e3 * np.linalg.norm(position_m - other_m, axis=-1)


def lowered(depth_m=0.1, contact_s=1.2, step_N=6.0, cut=0.8, rate_hz=250.0, noise_m=0.0):
    """A tool that comes down, meets the table while still moving, and presses on it."""
    time = np.arange(int((contact_s + 1.0) * rate_hz)) / rate_hz
    way = minimum_jerk(np.minimum(time / contact_s, 1.0) * cut) / minimum_jerk(np.array([cut]))
    position = np.c_[np.zeros_like(way), np.zeros_like(way), 0.3 - depth_m * way]
    position += noise_m * np.random.default_rng(0).normal(size=position.shape)
    force = np.where(time[:, None] >= contact_s, (0.0, 0.0, step_N), 0.0)
    wxyz = np.tile(quaternions.IDENTITY, (len(time), 1))
    return Demonstration("lowered", time, position, wxyz, force)


def segment(start_s, end_s, end_condition=None, label="move"):
    end = ConfigurationEnd() if end_condition is None else end_condition
    return Cut(start_s, end_s, label, end)
