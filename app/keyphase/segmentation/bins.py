"""Block means over short bins in time, which make irregular and different rates alike."""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.order_statistics import median

BIN_S = 0.02
"""Width of a bin: 50 Hz is enough for a hand's motion and for finding a contact."""

_EARLY = 0.45

Indices = NDArray[np.intp]


def bin_starts(time_s: Array, width_s: float = BIN_S) -> Indices:
    """Index of the first sample of every bin that holds one, from `time_s` (N,) [s].

    Bins are counted in time, not in samples, because rates are irregular. They begin nearly half a
    sample early, so that jitter does not move samples of a regular recording between bins. (With
    just half a one every fifth sample at 125 Hz lay on the edge of two.)
    """
    early_s = _EARLY * median(np.diff(time_s)) if len(time_s) > 1 else 0.0
    bins = np.floor((time_s - time_s[0] + early_s) / width_s)
    return np.flatnonzero(np.diff(bins, prepend=-1.0))


def bin_means(values: Array, starts: Indices) -> Array:
    """Mean of `values` (N,) or (N, D) in each of the bins that begin at `starts` (M,)."""
    counts = np.diff(starts, append=len(values))
    sums = np.add.reduceat(values, starts, axis=0)
    return sums / (counts[:, None] if values.ndim == 2 else counts)


@dataclass(frozen=True, eq=False)
class Bins:
    """A demonstration in bins of `BIN_S`, each channel when it is first asked for.

    starts (M,)  index of the first sample of each
    """

    demonstration: Demonstration
    starts: Indices

    @cached_property
    def time_s(self) -> Array:
        """Mean time (M,)."""
        return bin_means(self.demonstration.time_s, self.starts)

    @cached_property
    def force(self) -> Array | None:
        """Mean force (M, 3) [N]."""
        force = self.demonstration.force_N
        return None if force is None else bin_means(force, self.starts)

    @cached_property
    def torque(self) -> Array | None:
        """Mean torque (M, 3) [N m]."""
        torque = self.demonstration.torque_Nm
        return None if torque is None else bin_means(torque, self.starts)


@lru_cache(maxsize=1)
def bins_of(demonstration: Demonstration) -> Bins:
    """The bins of a demonstration; kept for the last one, because many ask in turn."""
    return Bins(demonstration, bin_starts(demonstration.time_s))


def typical_step_s(time_s: Array) -> float:
    """Median distance between neighbouring times (N at least 2); BIN_S for a single one."""
    return median(np.diff(time_s)) if len(time_s) > 1 else BIN_S


def count_in(duration_s: float, step_s: float, least: int, most: int) -> int:
    """How many steps a duration is, rounded and kept from `least` to `most`."""
    return int(min(max(round(min(duration_s / step_s, 1e9)), least), most))


def whole_in(duration_s: float, rate_hz: float) -> int:
    """How many whole cells a duration is, at least one; a clock that is slightly off, or times
    that were rounded, do not decide over one more."""
    return max(1, int(duration_s * rate_hz + 1e-3))
