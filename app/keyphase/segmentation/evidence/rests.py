"""Stops: stretches in which the tool stays within a millimetre and a degree."""

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.motion import METRES_PER_RADIAN

MIN_DURATION_S = 0.5
PLACE_M = 1e-3
SLOW_SHARE = 0.03
"""And slower than this share of the fast moments: the turn of a slow stroke is no stop."""

MIN_PLACE_M = 1e-4
TURN_M = METRES_PER_RADIAN * float(np.radians(1.0))


def rests(grid: Grid, fast_m_s: float) -> Indices:
    """First and last cell (R, 2) of every stop of at least half a second, in time order.

    A stop is a run of half seconds each of which stays in its place; a slow drift over many of
    them is one stop. `fast_m_s` is how fast the tool moves elsewhere.
    """
    from scipy.ndimage import maximum_filter1d, minimum_filter1d

    width = int(np.ceil(MIN_DURATION_S * grid.rate_hz - 1e-3)) + 1
    if len(grid) < width:
        return np.zeros((0, 2), dtype=np.intp)
    slow = max(SLOW_SHARE * fast_m_s * MIN_DURATION_S, MIN_PLACE_M) if fast_m_s > 0.0 else PLACE_M
    still = np.ones(len(grid) - width + 1, dtype=bool)
    limits = min(PLACE_M, slow), TURN_M
    for columns, most in zip((grid.pose_m[:, :3], grid.pose_m[:, 3:]), limits, strict=True):
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


SWAY_M = 5e-3
SWAY_SHARE = 0.08
"""Between two stops the tool went nowhere if it stayed within this place and was never faster than
this share of the fast moments: a hand sways, and creeps while it presses."""


def joined(stops: Indices, grid: Grid, speed_m_s: Array, fast_m_s: float) -> Indices:
    """The stops (R, 2) without the gaps in which the tool went nowhere."""
    if len(stops) < 2:
        return stops
    ends = np.ones(len(stops), dtype=bool)
    for index, (last, first) in enumerate(zip(stops[:-1, 1], stops[1:, 0], strict=True)):
        gap = slice(int(last), int(first) + 1)
        extent = float(np.linalg.norm(np.ptp(grid.pose_m[gap], axis=0)))
        fastest = float(speed_m_s[gap].max(initial=0.0))
        ends[index] = extent >= SWAY_M or fastest >= SWAY_SHARE * fast_m_s
    begins = np.concatenate([[True], ends[:-1]])
    return np.column_stack([stops[begins, 0], stops[ends, 1]])


SETS_OFF = 0.07
"""A stop lasts until the stroke after it is faster than this part of its largest speed: a slow one
leaves the stop's place before it begins."""


def up_to_strokes(stops: Indices, strokes: Indices, speed_m_s: Array) -> Indices:
    """The stops (R, 2), each from where the stroke before it has ended to where the next begins.

    strokes (V,) are the cells at which the speed of each stroke is largest.
    """
    found = stops.copy()
    after = np.searchsorted(strokes, stops[:, 1], side="right")
    before = np.searchsorted(strokes, stops[:, 0]) - 1
    for row, (early, late) in enumerate(stops.tolist()):
        if before[row] >= 0:
            peak = int(strokes[before[row]])
            slow = speed_m_s[peak : early + 1] < SETS_OFF * speed_m_s[peak]
            found[row, 0] = peak + int(np.argmax(slow)) if slow.any() else early
        if after[row] < len(strokes):
            peak = int(strokes[after[row]])
            slow = speed_m_s[late : peak + 1] < SETS_OFF * speed_m_s[peak]
            found[row, 1] = peak - int(np.argmax(slow[::-1])) if slow.any() else late
    return found
