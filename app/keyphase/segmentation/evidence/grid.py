"""A demonstration on one uniform grid, in the units in which evidence is weighed."""

from dataclasses import dataclass, replace

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.bins import (
    BIN_S,
    bin_means,
    bin_starts,
    bins_of,
    typical_step_s,
)
from keyphase.segmentation.filters import fast_part
from keyphase.segmentation.motion import METRES_PER_RADIAN, Motion
from keyphase.segmentation.order_statistics import column_medians, quantile

LEVER_M = METRES_PER_RADIAN
"""A torque counts as the force that gives it on this lever."""

MAX_GAP_S = 0.5
"""A longer stretch without data is shortened to this on the grid."""

MIN_CELLS = 20
"""In shorter recordings nothing is looked for."""

_SIZE_QUANTILE = 0.98
_VIBRATION_HZ = 10.0
_VIBRATION_STEP_S = 0.004
_MIN_FOR_VIBRATION_HZ = 60.0


@dataclass(frozen=True, eq=False)
class Grid:
    """A recording at up to 50 Hz.

    time_s     (n,)         of the recording at each cell
    rate_hz                 cells per second
    pose_m     (n, 3 or 6)  position, and rotation vector times 0.2 m/rad
    wrench     (n, 3 or 6)  force, and torque over 0.2 m, over `size_N`; None without force
    size_N                  98 % of the wrench is nearer to its median than this
    vibration  (n,)         force above 10 Hz squared [N^2]; None where too slow a rate shows none
    """

    time_s: Array
    rate_hz: float
    pose_m: Array
    wrench: Array | None
    size_N: float
    vibration: Array | None

    def __len__(self) -> int:
        return len(self.time_s)

    def cells(self, duration_s: float) -> int:
        """How many cells a duration is, at least one."""
        return max(1, round(duration_s * self.rate_hz))

    def with_wrench(self, wrench: Array) -> "Grid":
        """The grid with another wrench (n, 3 or 6) [N], in units of its own size."""
        scaled, size = _in_sizes(wrench)
        return replace(self, wrench=scaled, size_N=size)


def grid_of(demonstration: Demonstration, motion: Motion) -> Grid:
    """Put a demonstration on its grid; `motion` is its own."""
    even, cells, step = _even_times(motion)
    time = np.interp(cells, even, motion.time_s)
    pose = _at(cells, even, motion.pose_m)
    wrench, size = _wrench(demonstration, cells, even)
    vibration = None if wrench is None else _vibration(demonstration, time)
    return Grid(time, 1.0 / step, pose, wrench, size, vibration)


_RATE_DIGITS, _HAIR = 2, 1e-5
"""Times since 1970 are rounded to 0.2 us and clocks are off by parts in a hundred thousand: neither
may decide over a cell more or less. With cells a hair shorter than the step, those that are just a
duration apart are beyond it in no recording."""


def _even_times(motion: Motion) -> tuple[Array, Array, float]:
    """Times of the bins with gaps shortened, the uniform cells over them, and their step."""
    rate_hz = round(1.0 / motion.step_s, _RATE_DIGITS)
    step = (1.0 - _HAIR) * max(BIN_S, 1.0 / rate_hz)
    steps = np.minimum(np.diff(motion.time_s), max(MAX_GAP_S, 3.0 * step))
    even = np.concatenate([[0.0], np.cumsum(steps)])
    return even, step * np.arange(int(even[-1] / step + 1e-6) + 1, dtype=np.float64), step


def _at(cells: Array, times: Array, values: Array) -> Array:
    return np.column_stack([np.interp(cells, times, column) for column in values.T])


def _wrench(demonstration: Demonstration, cells: Array, even: Array) -> tuple[Array | None, float]:
    """The wrench over its size, and the size; None where none was recorded or none changes."""
    bins = bins_of(demonstration)
    force, torque = bins.force, bins.torque
    if force is None:
        return None, 0.0
    wrench = _at(cells, even, force)
    if torque is not None and np.ptp(torque) > 0.0:
        wrench = np.hstack([wrench, _at(cells, even, torque) / LEVER_M])
    return _in_sizes(wrench)


def _in_sizes(wrench: Array) -> tuple[Array | None, float]:
    wrench = wrench - column_medians(wrench)
    size = quantile(np.linalg.norm(wrench, axis=1), _SIZE_QUANTILE)
    return (wrench / size, size) if size > 1e-9 else (None, 0.0)


def _vibration(demonstration: Demonstration, time_s: Array) -> Array | None:
    """Mean square of the force above 10 Hz around each cell."""
    step = typical_step_s(demonstration.time_s)
    if step * _MIN_FOR_VIBRATION_HZ > 1.0 or demonstration.force_N is None:
        return None
    time, force = demonstration.time_s, demonstration.force_N
    if step < 0.75 * _VIBRATION_STEP_S:
        starts = bin_starts(time, _VIBRATION_STEP_S)
        time, force, step = bin_means(time, starts), bin_means(force, starts), _VIBRATION_STEP_S
    if len(time) < 2 * MIN_CELLS:
        return None
    energy = np.square(fast_part(force, _VIBRATION_HZ, 1.0 / step)).sum(axis=1)
    sums = np.concatenate([[0.0], np.cumsum(energy)])
    edges = np.searchsorted(time, np.append(time_s - 0.5 * BIN_S, time_s[-1] + 0.5 * BIN_S))
    first = np.minimum(edges[:-1], len(energy) - 1)
    last = np.maximum(edges[1:], first + 1)
    return (sums[last] - sums[first]) / (last - first)
