"""Whether the default parameters give a simulated recording the paper's segments."""

import numpy as np

from keyphase.segmentation import segment
from keyphase.simulation import record

PHASES = {
    "setup1": ["forward", "idle", "down until contact", "idle", "sideways until contact"],
    "setup2": ["rotate", "down until contact", "sideways until contact", "on with contact kept"],
}
TOLERANCE_S = 0.060
FOUND_CHANGES = {"setup1": ["snap"], "setup2": ["contact", "others"]}
"""Contact changes between two segments; setup1 ends as the wall is reached."""


def segmented_right(name: str, seed: int) -> bool:
    """Whether number of segments and every contact boundary are right for this seed."""
    demonstration = record(name, seed=seed)
    result = segment(demonstration)
    onsets = demonstration.metadata["ground_truth"]["contact_onsets_s"]
    expected = [onsets[change] for change in FOUND_CHANGES[name]]
    found = [boundary.time_s for boundary in result.boundaries if boundary.contact_change]
    return (
        len(result.segments) == len(PHASES[name])
        and len(found) == len(expected)
        and np.allclose(found, expected, atol=TOLERANCE_S)
    )
