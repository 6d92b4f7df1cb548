"""When the tool touches something, whatever constant the force sensor shows in free space."""

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.bins import bin_means, bin_starts
from keyphase.segmentation.force import noise_variance

LEAST_N = 0.5
"""No force below this above the free level counts as contact."""

_NOISE_LEVELS = 6.0
_SHARE_OF_STRONGEST = 0.08
_REST_S = 0.5


def contact_force(demonstration: Demonstration) -> Array | None:
    """Binned force (n, 3) [N] above the level in free space; None where no force was recorded.

    A recording with moments of next to no force has no offset. In others the tool's weight was
    not taken out, and the level at their beginning is what free space shows.
    """
    if demonstration.force_N is None:
        return None
    starts = bin_starts(demonstration.time_s)
    force = bin_means(demonstration.force_N, starts)
    size = np.linalg.norm(force, axis=1)
    if np.quantile(size, 0.05) <= _least(size):
        return force
    time = bin_means(demonstration.time_s, starts)
    return force - np.median(force[time <= time[0] + _REST_S], axis=0)


def _least(size: Array) -> float:
    return max(LEAST_N, _SHARE_OF_STRONGEST * float(np.quantile(size, 0.95)))


def in_contact(force_N: Array) -> np.ndarray:
    """In which bins (n,) a force above the free level is more than noise and handling."""
    size = np.linalg.norm(force_N, axis=1)
    noise = float(np.sqrt(noise_variance(force_N).sum()))
    return size > max(_least(size), _NOISE_LEVELS * noise)
