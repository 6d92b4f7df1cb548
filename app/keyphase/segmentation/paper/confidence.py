"""How sure a boundary is, from 0 to 1; it grows with the evidence and not with the sliders."""

import itertools

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.motion import Motion
from keyphase.segmentation.paper.peaks import Candidates
from keyphase.segmentation.paper.strokes import idle_speed, mean_velocity
from keyphase.segmentation.parameters import Parameters

_DEFAULT = Parameters()


def force_confidence(candidates: Candidates, automatic_threshold: float) -> Array:
    """Of each candidate (C,): a² / (1 + a²), a how many times it passes its weakest criterion.

    The criteria are the default ones: the automatic threshold and the ratio (both of a square,
    so their roots count), and persistence. On the criterion it is 0.5, at twice it 0.8.
    """
    square = np.minimum.reduce(
        [
            candidates.height / automatic_threshold,
            candidates.ratio / _DEFAULT.force_ratio,
            (candidates.persistence / _DEFAULT.persistence) ** 2,
        ]
    )
    return square / (1.0 + square)


def position_confidence(motion: Motion, times_s: Array, intervals_s: Array) -> Array:
    """Of each position boundary (B,): how much the motion changes, and how sharply it is placed.

    Change is |v1 - v2| / (|v1| + |v2|) of the mean velocities on both sides: 1 between idle and
    moving or for a reversal, 0.7 for a right angle. Sharpness is what remains of the shorter
    neighbour beside the boundary's interval.
    """
    edges = np.searchsorted(motion.time_s, times_s)
    edges = np.concatenate([[0], edges, [len(motion.time_s)]]).astype(np.intp)
    velocity = _mean_velocities(motion, edges)
    speed = np.linalg.norm(velocity, axis=1)
    total = np.maximum(speed[:-1] + speed[1:], idle_speed(motion))
    change = np.linalg.norm(np.diff(velocity, axis=0), axis=1) / total
    ends = np.concatenate([[motion.time_s[0]], times_s, [motion.time_s[-1]]])
    duration = np.diff(ends)
    around = np.maximum(duration[:-1] + duration[1:], 1e-9)
    sharpness = 1.0 - np.diff(intervals_s, axis=1)[:, 0] / around
    return np.clip(change, 0.0, 1.0) ** 0.5 * np.clip(sharpness, 0.0, 1.0) ** 0.5


def _mean_velocities(motion: Motion, edges: Indices) -> Array:
    pairs = itertools.pairwise(edges.tolist())
    return np.array([mean_velocity(motion, i, max(j, i + 1)) for i, j in pairs])


def joint_confidence(force: float, position: float) -> float:
    """Of a boundary that both put there: wrong only where both are."""
    return 1.0 - (1.0 - force) * (1.0 - position)
