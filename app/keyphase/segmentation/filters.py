"""Butterworth filters of second order, designed once for each cut-off and rate.

The numbers are those of scipy's `sosfiltfilt`, which works its starting state out anew in every
call: on ten seconds that takes longer than filtering.
"""

from functools import lru_cache
from typing import Literal

import numpy as np

from keyphase.demonstration import Array

_KEPT = 64

_PADDED = 9
"""So many values are mirrored at both ends, as scipy's `sosfiltfilt` does for one section."""

Kind = Literal["lowpass", "highpass"]


def smoothed(values: Array, below_hz: float, rate_hz: float) -> Array:
    """`values` (n,) or (n, D) below a frequency, without delay: run forward and backward."""
    return _both_ways(values, below_hz, rate_hz, "lowpass")


def fast_part(values: Array, above_hz: float, rate_hz: float) -> Array:
    """`values` (n,) or (n, D) above a frequency, without delay."""
    return _both_ways(values, above_hz, rate_hz, "highpass")


def _both_ways(values: Array, hz: float, rate_hz: float, kind: Kind) -> Array:
    # Along rows that lie in one piece it is several times faster.
    rows = np.ascontiguousarray(np.atleast_2d(values.T))
    if rows.shape[1] <= _PADDED:
        raise ValueError(f"expected more than {_PADDED} values to filter, got {rows.shape[1]}")
    ends = [
        2.0 * rows[:, :1] - rows[:, _PADDED:0:-1],
        2.0 * rows[:, -1:] - rows[:, -2 : -_PADDED - 2 : -1],
    ]
    there = _one_way(np.hstack([ends[0], rows, ends[1]]), hz, rate_hz, kind)
    back = _one_way(there[:, ::-1], hz, rate_hz, kind)[:, ::-1]
    return np.ascontiguousarray(back[:, _PADDED:-_PADDED].T.reshape(values.shape))


def _one_way(rows: Array, hz: float, rate_hz: float, kind: Kind) -> Array:
    """Rows (D, n) filtered from a state that is settled on their first values."""
    from scipy.signal import sosfilt

    sections, settled = _design(hz, rate_hz, kind)
    return np.asarray(sosfilt(sections, rows, zi=settled[:, None] * rows[None, :, :1])[0])


@lru_cache(maxsize=_KEPT)
def _design(hz: float, rate_hz: float, kind: Kind) -> tuple[Array, Array]:
    """The section (1, 6), and its settled state (1, 2) for a constant of one."""
    from scipy.signal import butter, sosfilt_zi

    sections = np.asarray(butter(2, hz, kind, fs=rate_hz, output="sos"), dtype=np.float64)
    return sections, np.asarray(sosfilt_zi(sections))
