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
MAY_CHANGE = {"setup1": [4], "setup2": []}
"""Boundaries, counted from 1, at which the force may change as well: as the tool of setup1 sets off
sideways, pressed on, friction turns."""


def segmented_right(name: str, seed: int) -> bool:
    """Whether number of segments and every contact boundary are right for this seed."""
    demonstration = record(name, seed=seed)
    result = segment(demonstration)
    onsets = demonstration.metadata["ground_truth"]["contact_onsets_s"]
    expected = [onsets[change] for change in FOUND_CHANGES[name]]
    allowed = MAY_CHANGE[name]
    found = [
        boundary.time_s
        for number, boundary in enumerate(result.boundaries, start=1)
        if boundary.contact_change and not (number in allowed and boundary.origin == "both")
    ]
    return (
        len(result.segments) == len(PHASES[name])
        and len(found) == len(expected)
        and np.allclose(found, expected, atol=TOLERANCE_S)
    )
