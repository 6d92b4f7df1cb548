"""What the force sensor shows in free space: a constant that is no contact."""

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.bins import bins_of
from keyphase.segmentation.order_statistics import column_medians, quantile

MIN_FORCE_N = 0.5
"""No force below this above the free level counts as contact."""

_SHARE_OF_STRONGEST = 0.08
_REST_S = 0.5


def free_force(demonstration: Demonstration) -> Array:
    """The force (3,) that the sensor shows in free space [N]; zero where none was recorded.

    A recording with moments of next to no force has no offset. In others the tool's weight was
    not taken out, and the level at their beginning is what free space shows.
    """
    bins = bins_of(demonstration)
    force, time = bins.force, bins.time_s
    if force is None:
        return np.zeros(3)
    size = np.linalg.norm(force, axis=1)
    if quantile(size, 0.05) <= least_contact(size):
        return np.zeros(3)
    return column_medians(force[time <= time[0] + _REST_S])


def least_contact(size_N: Array) -> float:
    """The least force that counts as contact beside the sizes (n,) that were recorded [N]."""
    return max(MIN_FORCE_N, _SHARE_OF_STRONGEST * quantile(size_N, 0.95))
