"""Long rests, which say nothing about a task: how long one waits is a matter of chance."""

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter1d, minimum_filter1d

from keyphase.demonstration import Array

LONGEST_S = 1.0
"""Of a longer rest the middle is left out."""

STILL = 0.06
"""Signals, each in its own size, that move less than this within WITHIN_S are still."""

WITHIN_S = 0.4


def awake(time_s: Array, values: Array) -> NDArray[np.bool_]:
    """Which samples (M,) of signals (M, D) on an even grid (M,) are not the middle of a rest."""
    step_s = (time_s[-1] - time_s[0]) / (len(time_s) - 1)
    width = max(round(WITHIN_S / step_s) | 1, 3)
    moved = maximum_filter1d(values, width, axis=0) - minimum_filter1d(values, width, axis=0)
    still = np.all(moved < STILL, axis=1).astype(int)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], still, [0]])))
    half = max(round(0.5 * LONGEST_S / step_s), 1)
    kept = np.ones(len(time_s), bool)
    for start, end in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        kept[start + half : max(end - half, start + half)] = False
    return kept
