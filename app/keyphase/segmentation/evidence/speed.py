"""How fast the tool moves, smoothed so that tremor does not count."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.grid import MIN_CELLS, Grid
from keyphase.segmentation.evidence.rests import joined, rests
from keyphase.segmentation.evidence.windows import Windows
from keyphase.segmentation.filters import smoothed
from keyphase.segmentation.order_statistics import quantile

SMOOTHING_HZ = 3.0

QUICK_HZ = 7.0
"""Strokes of a third of a second run into one another below 3 Hz; tremor is slower than they."""

MIN_FAST_M_S = 5e-3
"""Where the fast moments are slower than this, nothing moves on purpose."""

_FAST_QUANTILE = 0.98


@dataclass(frozen=True, eq=False)
class Speed:
    """Of the pose on a grid of n cells.

    pose_m (n, 3 or 6)  smoothed, usually below 3 Hz
    speed_m_s (n,)      of it
    fast_m_s            98 % of the moments are slower; 0 where nothing moves on purpose
    """

    grid: Grid
    pose_m: Array
    speed_m_s: Array
    fast_m_s: float

    @cached_property
    def rests(self) -> Indices:
        """First and last cell (R, 2) of every stop, see `rests`."""
        return rests(self.grid, self.fast_m_s)

    @cached_property
    def stops(self) -> Indices:
        """The same (S, 2), those that are parted by a mere sway as one."""
        return joined(self.rests, self.grid, self.speed_m_s, self.fast_m_s)

    def beside(self, at: Indices) -> tuple[Array, Array]:
        """Mean speed (C,) 0.4 to 0.05 s before and after cells."""
        windows, rate = Windows(self.speed_m_s), self.grid.rate_hz
        far, near = max(1, round(0.4 * rate)), round(0.05 * rate)
        before = windows.mean(at - far, at - near)[:, 0]
        return np.maximum(before, 0.0), np.maximum(windows.mean(at + near, at + far)[:, 0], 0.0)


def speed_of(grid: Grid, smoothing_hz: float = SMOOTHING_HZ) -> Speed:
    """Smooth the pose below `smoothing_hz` and differentiate it."""
    pose = grid.pose_m
    if len(grid) <= MIN_CELLS:
        return Speed(grid, pose, np.zeros(len(grid)), 0.0)
    pose = smoothed(pose, min(smoothing_hz, 0.35 * grid.rate_hz), grid.rate_hz)
    velocity = np.gradient(pose, 1.0 / grid.rate_hz, axis=0)
    speed = np.linalg.norm(velocity, axis=1)
    fast = quantile(speed, _FAST_QUANTILE)
    return Speed(grid, pose, speed, fast if fast > MIN_FAST_M_S else 0.0)
