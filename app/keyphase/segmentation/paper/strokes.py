"""Join neighbouring stretches of a motion that a person would call one stroke, or one idle."""

import itertools
from collections.abc import Iterable

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.motion import Motion
from keyphase.segmentation.order_statistics import quantile

IDLE_M_S = 5e-3
"""Slower than this, or than IDLE_FRACTION of the fast moments, the tool is idle."""

IDLE_FRACTION = 0.02

_SAME_DIRECTION_RAD = np.radians(40.0)
_DIP = 0.25
_DIP_REACH_S = 0.15


def idle_speed(motion: Motion) -> float:
    """Speed below which the tool counts as idle in this recording [m/s]."""
    return max(IDLE_M_S, IDLE_FRACTION * quantile(motion.speed, 0.98))


def mean_velocity(motion: Motion, begin: int, end: int) -> Array:
    """Slope of the pose over the bins [begin, end), by least squares [m/s]."""
    time = motion.time_s[begin:end]
    time = time - time.mean()
    spread = float(time @ time)
    if spread <= 0.0:
        return np.zeros(motion.pose_m.shape[1])
    return time @ motion.pose_m[begin:end] / spread


def merge_strokes(motion: Motion, cuts: Indices) -> Indices:
    """The cuts that remain after joining, most alike first, neighbours that are one stroke.

    Two stretches are one when both are idle, or when both move within 40° of each other and the
    speed around the cut between them does not dip below a quarter of the slower one's.
    """
    edges = [0, *cuts.tolist(), len(motion.time_s)]
    velocities = [mean_velocity(motion, i, j) for i, j in itertools.pairwise(edges)]
    idle = idle_speed(motion)

    def unlikeness(cut: int) -> float:
        before, after = velocities[cut - 1], velocities[cut]
        return _unlikeness(before, after, idle, _lowest_speed(motion, edges[cut]))

    scores = [unlikeness(cut) for cut in range(1, len(edges) - 1)]
    while scores and (least := min(scores)) < np.inf:
        gone = scores.index(least) + 1
        del edges[gone], velocities[gone], scores[gone - 1]
        velocities[gone - 1] = mean_velocity(motion, edges[gone - 1], edges[gone])
        for cut in _inside((gone - 1, gone), len(scores)):
            scores[cut - 1] = unlikeness(cut)
    return np.array(edges[1:-1], dtype=np.intp)


def _inside(cuts: Iterable[int], count: int) -> list[int]:
    return [cut for cut in cuts if 1 <= cut <= count]


def _unlikeness(before: Array, after: Array, idle: float, dip: float) -> float:
    slow, fast = sorted((float(np.linalg.norm(before)), float(np.linalg.norm(after))))
    if fast < idle:
        return 0.0
    if slow < idle or dip < _DIP * slow:
        return np.inf
    angle = float(np.arccos(np.clip(before @ after / (slow * fast), -1.0, 1.0)))
    return 1.0 + angle if angle <= _SAME_DIRECTION_RAD else np.inf


def _lowest_speed(motion: Motion, cut: int) -> float:
    around = motion.time_s[cut] + np.array([-_DIP_REACH_S, _DIP_REACH_S])
    low, high = np.searchsorted(motion.time_s, around)
    return float(motion.speed[low : max(high, low + 1)].min())
