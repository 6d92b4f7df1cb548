"""What a method finds in a demonstration, before segments are made of it."""

from dataclasses import dataclass

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
    """Boundaries in time order and the evidence they rest on; see `Segmentation`."""

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
