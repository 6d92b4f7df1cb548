"""Channels held at a lower rate than the rows they stand in, as merged logs of several rates have.

A held channel repeats its last value until a new one arrives. A robot at rest repeats, too, but in
few long runs; a channel counts as held where many of its runs are longer than one row.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.notices import Caution

_SHARE_OF_LONG_RUNS = 0.25
_MIN_RUNS = 10


@dataclass(frozen=True)
class Hold:
    """How a held channel came: the rows at which it changed, and how often that was."""

    fresh_rows: NDArray[np.intp]
    rate_hz: float


def find_hold(time_s: Array, values: Array) -> Hold | None:
    """How a channel (N, D) is held, or None where it is not."""
    changed = np.any(values[1:] != values[:-1], axis=1)
    fresh = np.flatnonzero(np.concatenate([[True], changed]))
    runs = np.diff(fresh)
    if len(runs) < _MIN_RUNS or np.mean(runs > 1) < _SHARE_OF_LONG_RUNS:
        return None
    return Hold(fresh, float(len(runs) / (time_s[fresh[-1]] - time_s[fresh[0]])))


def held_notices(channels: Mapping[str, Array]) -> tuple[str, ...]:
    """One sentence for each channel that is held and was left so."""
    time = channels["time_s"]
    notices = []
    for channel, values in channels.items():
        if values.ndim != 2 or len(values) != len(time):
            continue
        if hold := find_hold(time, values):
            told = (
                f"{channel} changes in only {len(hold.fresh_rows)} of {len(time)} rows "
                f"(about {hold.rate_hz:.3g} Hz) and repeats its last value in between; "
                "left as it came."
            )
            notices.append(Caution(told))
    return tuple(notices)
