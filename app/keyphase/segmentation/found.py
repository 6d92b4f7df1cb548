"""What a method finds in a demonstration, before segments are made of it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.segmentation.segmentation import (
    Boundary,
    Candidate,
    ErrorCurve,
    EvidenceTrack,
    Gaussian,
    HeldBack,
    LineCounts,
    Peak,
)


@dataclass(frozen=True, eq=False)
class Found:
    """Boundaries in time order and the evidence they rest on; see `Segmentation`.

    `times_s` (B,) and `contact_change` (B,) are those of the boundaries, where the method has them
    in arrays: asking thousands of boundaries one by one takes longer than all else.
    """

    boundaries: tuple[Boundary, ...]
    gaussians: tuple[Gaussian, ...]
    curve: ErrorCurve | None
    peaks: tuple[Peak, ...]
    threshold: float | None
    motion_threshold: float | None = None
    candidates: tuple[Candidate, ...] = ()
    track: EvidenceTrack | None = None
    unlike: float = 0.0
    automatic_least_step_N: float | None = None
    line_counts: tuple[LineCounts, ...] = ()
    held_back: tuple[HeldBack, ...] = ()
    times_s: Array | None = None
    contact_change: NDArray[np.bool_] | None = None
