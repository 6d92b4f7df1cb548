"""Colours and plain axes that all pictures share; told apart by people who see fewer colours."""

from typing import Any

from keyphase.labeling.colors import SEGMENT_COLORS
from keyphase.labeling.labeling import LabeledSegment

AXES = ("#2f6fb3", "#c2571a", "#3c8f5a")
"""x, y and z."""

INK, GRID, IDLE, CONTACT, MOTION = "#26323f", "#e3e8ee", "#c3cad3", "#c2571a", "#2f6fb3"


def color_of(segment: LabeledSegment) -> str:
    """Its colour on the page; grey where it is dropped."""
    return SEGMENT_COLORS[segment.color % len(SEGMENT_COLORS)] if segment.kept else IDLE


def plain(axes: Any) -> None:
    """Without a frame, and with a grid that stays behind."""
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(color=GRID, lw=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=8)


def shortened(text: str, width: int) -> str:
    """At most so many characters, with a sign where some are missing."""
    return text if len(text) <= width else f"{text[: max(width - 1, 1)]}…"
