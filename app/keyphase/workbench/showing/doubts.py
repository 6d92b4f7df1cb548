"""How sure a segmentation is, and the segments in small: what the list of recordings shows."""

from dataclasses import dataclass

from keyphase.labeling.labeling import LabeledBoundary, Labeling

UNSURE_BELOW = 0.75
"""A boundary nobody has decided about counts as unsure below this confidence, wherever shown."""


@dataclass(frozen=True)
class Piece:
    """One segment in a strip: its share of the duration, its colour; None: idle or dropped."""

    share: float
    color: int | None


def is_unsure(boundary: LabeledBoundary) -> bool:
    """Whether a person should look at it."""
    return _is_open(boundary) and boundary.confidence < UNSURE_BELOW


def least_confidence(labeling: Labeling) -> float | None:
    """Confidence of the least certain boundary nobody has decided about; None without any."""
    return min((b.confidence for b in labeling.boundaries if _is_open(b)), default=None)


def unsure_count(labeling: Labeling) -> int:
    """How many boundaries a person should look at."""
    return sum(map(is_unsure, labeling.boundaries))


def strip(labeling: Labeling) -> tuple[Piece, ...]:
    """The segments in small."""
    duration = labeling.segmentation.demonstration.duration_s
    return tuple(
        Piece((s.end_s - s.start_s) / duration, s.color if s.kept else None)
        for s in labeling.segments
    )


def _is_open(boundary: LabeledBoundary) -> bool:
    """What a person placed is decided; what was taken over from others is as sure as they were."""
    by_hand = boundary.origin == "user" and boundary.confidence == 1.0
    return not boundary.accepted and not by_hand
