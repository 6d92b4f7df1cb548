"""Segmentation of a demonstration by position and contact force.

`segment` and `Segmenter` are loaded on first use, so that importing the types stays cheap.
"""

from typing import TYPE_CHECKING, Any

from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import (
    Boundary,
    ErrorCurve,
    Gaussian,
    Peak,
    Segment,
    Segmentation,
)

if TYPE_CHECKING:
    from keyphase.segmentation.segmenter import Segmenter, segment

__all__ = [
    "Boundary",
    "ErrorCurve",
    "Gaussian",
    "Parameters",
    "Peak",
    "Segment",
    "Segmentation",
    "Segmenter",
    "segment",
]


def __getattr__(name: str) -> Any:
    if name in ("Segmenter", "segment"):
        from keyphase.segmentation.segmenter import Segmenter, segment

        return {"Segmenter": Segmenter, "segment": segment}[name]
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
