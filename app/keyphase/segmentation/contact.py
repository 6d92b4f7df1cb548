"""When the tool touches something, whatever constant the force sensor shows in free space."""

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.bins import bin_means, bin_starts
from keyphase.segmentation.free_force import free_force, least_contact
from keyphase.segmentation.paper.force import noise_variance

_NOISE_LEVELS = 6.0


def contact_force(demonstration: Demonstration) -> Array | None:
    """Binned force (n, 3) [N] above the level in free space; None where no force was recorded."""
    if demonstration.force_N is None:
        return None
    force = bin_means(demonstration.force_N, bin_starts(demonstration.time_s))
    return force - free_force(demonstration)


def in_contact(force_N: Array) -> np.ndarray:
    """In which bins (n,) a force above the free level is more than noise and handling."""
    size = np.linalg.norm(force_N, axis=1)
    noise = float(np.sqrt(noise_variance(force_N).sum()))
    return size > max(least_contact(size), _NOISE_LEVELS * noise)
