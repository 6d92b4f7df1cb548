"""How much, and in which direction, the force of a demonstration changed at some moment."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.windows import AFTER_S, BEFORE_LAST_S, BEFORE_S, LAST_S

EVENT_WITHIN_S = 0.3
"""A contact change is looked for this far on both sides of the boundary."""

SHARP_S = 0.06
"""It lies where the means over so long before and after differ most."""

_GRID_S = 0.01


@dataclass(frozen=True, eq=False)
class ForceStep:
    """The mean force before and after a moment, (3,) each [N].

    before_N, after_N  mean forces
    noise_N            (3, 3) covariance of the force before
    """

    before_N: Array
    after_N: Array
    noise_N: Array

    @property
    def change(self) -> Array:
        """(3,) after minus before [N]."""
        return self.after_N - self.before_N

    def noise_along(self, direction: Array) -> float:
        """Standard deviation of the force before, along a unit vector (3,) [N]."""
        return float(np.sqrt(max(direction @ self.noise_N @ direction, 0.0)))


def force_step(demonstration: Demonstration, start_s: float, moment_s: float) -> ForceStep:
    """The step of the force at `moment_s`; what lies before `start_s` does not count.

    The demonstration must have force.
    """
    before, after = _forces_around(demonstration, start_s, moment_s)
    # Sums over few rows: numpy's mean and cov take several times as long.
    level = before.sum(axis=0) / len(before)
    away = before - level
    return ForceStep(level, after.sum(axis=0) / len(after), away.T @ away / len(before))


def contact_event_s(demonstration: Demonstration, start_s: float, boundary_s: float) -> float:
    """When the force changed for good, within 0.3 s of a boundary [s].

    A boundary is where to cut, a contact is when the force changed; a person may drag the one,
    the other stays. The largest difference of the means over 60 ms before and after, as far as it
    lies in the direction of a change that lasts and is no larger than it.
    """
    first = max(start_s, demonstration.start_s) + SHARP_S
    last = demonstration.end_s + LAST_S[0]
    if last <= first:
        return boundary_s
    count = round(2.0 * EVENT_WITHIN_S / _GRID_S)
    offsets = np.linspace(-EVENT_WITHIN_S, EVENT_WITHIN_S, count + 1)
    # Candidates lie on a grid of the recording's own, whichever boundary asks.
    moments = np.unique(np.round((boundary_s + offsets) / _GRID_S) * _GRID_S)
    moments = moments[(moments >= first) & (moments <= last)]
    if not len(moments):
        return boundary_s
    mean = _means(demonstration, float(moments[0]) - 0.25, float(moments[-1]) + 0.25)
    sharp = mean(moments, moments + SHARP_S) - mean(moments - SHARP_S, moments)
    earliest = np.maximum(moments + BEFORE_S[0], start_s)
    lasting = mean(np.minimum(moments + AFTER_S[0], last), moments + AFTER_S[1])
    lasting = lasting - mean(earliest, np.maximum(moments + BEFORE_S[1], earliest + 0.02))
    size = np.sqrt((lasting * lasting).sum(axis=1))
    along = (sharp * lasting).sum(axis=1) / np.maximum(size, 1e-300)
    return float(moments[int(np.argmax(np.minimum(along, size)))])


def _means(demonstration: Demonstration, from_s: float, to_s: float):
    """Function giving the mean force (M, 3) between times (M,), by running sums."""
    assert demonstration.force_N is not None
    low, high = np.searchsorted(demonstration.time_s, (from_s, to_s)).tolist()
    low = min(low, len(demonstration) - 1)
    high = max(high, low + 1)
    time = demonstration.time_s[low:high]
    sums = np.zeros((high - low + 1, 3))
    np.cumsum(demonstration.force_N[low:high], axis=0, out=sums[1:])

    def mean(begin_s: Array, end_s: Array) -> Array:
        first = np.minimum(np.searchsorted(time, begin_s), len(time) - 1)
        last = np.maximum(np.searchsorted(time, end_s), first + 1)
        return (sums[last] - sums[first]) / (last - first)[:, None]

    return mean


def _forces_around(
    demonstration: Demonstration, start_s: float, moment_s: float
) -> tuple[Array, Array]:
    """Forces of the windows before and after; of one sample where a window holds none."""
    assert demonstration.force_N is not None
    # What follows a contact in the last moments is seen for the last 40 ms only.
    last_s = demonstration.end_s + LAST_S[0]
    before = BEFORE_LAST_S if moment_s > last_s else BEFORE_S
    edges = (
        max(start_s, moment_s + before[0]),
        moment_s + before[1],
        moment_s,
        min(moment_s + AFTER_S[0], last_s),
        moment_s + AFTER_S[1],
    )
    first, last, end, later, latest = np.searchsorted(demonstration.time_s, edges).tolist()
    if last <= first:
        first = max(min(first, end - 1), 0)
        last = first + 1
    if latest <= later:
        later = min(later, len(demonstration) - 1)
        latest = later + 1
    return demonstration.force_N[first:last], demonstration.force_N[later:latest]
