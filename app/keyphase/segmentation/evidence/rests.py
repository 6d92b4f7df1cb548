"""Stops: stretches in which the tool stays within a millimetre and a degree."""

import numpy as np

from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.motion import METRES_PER_RADIAN

MIN_DURATION_S = 0.5
PLACE_M = 1e-3
TURN_M = METRES_PER_RADIAN * float(np.radians(1.0))


def rests(grid: Grid) -> Indices:
    """First and last cell (R, 2) of every stop of at least half a second, in time order.

    A stop is a run of half seconds each of which stays in its place; a slow drift over many of
    them is one stop.
    """
    from scipy.ndimage import maximum_filter1d, minimum_filter1d

    width = int(np.ceil(MIN_DURATION_S * grid.rate_hz)) + 1
    if len(grid) < width:
        return np.zeros((0, 2), dtype=np.intp)
    still = np.ones(len(grid) - width + 1, dtype=bool)
    for columns, most in ((grid.pose_m[:, :3], PLACE_M), (grid.pose_m[:, 3:], TURN_M)):
        if not columns.shape[1]:
            continue
        extent = np.zeros(len(still))
        for column in columns.T:
            high = maximum_filter1d(column, width, origin=-(width // 2))
            low = minimum_filter1d(column, width, origin=-(width // 2))
            extent += (high - low)[: len(still)] ** 2
        still &= extent < most**2
    edges = np.flatnonzero(np.diff(np.concatenate([[False], still, [False]]).astype(np.int8)))
    first, last = edges[::2], edges[1::2] - 1 + width - 1
    apart = np.concatenate([[True], first[1:] > last[:-1]])
    starts = np.flatnonzero(apart)
    ends = np.append(starts[1:], len(first)) - 1
    return np.column_stack([first[starts], last[ends]]) if len(first) else np.zeros((0, 2), int)
