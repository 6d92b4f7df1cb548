"""The segments of a recording with their times and names, as a row of the grid shows them."""

from dataclasses import dataclass

from keyphase.labeling.frozen import Frozen
from keyphase.labeling.labeling import Labeling


@dataclass(frozen=True)
class Stretch:
    """A segment from one time to another [s]; `color` None: idle or dropped.

    proposed  nobody has given or accepted the name
    """

    start_s: float
    end_s: float
    label: str
    color: int | None
    proposed: bool = False


def stretches(labeling: Labeling) -> tuple[Stretch, ...]:
    """The segments as they stand."""
    return tuple(
        Stretch(s.start_s, s.end_s, s.label, s.color if s.kept else None, s.proposed)
        for s in labeling.segments
    )


def frozen_stretches(frozen: Frozen) -> tuple[Stretch, ...]:
    """The segments of a recording that is done, from its journal alone."""
    return tuple(
        Stretch(s.start_s, s.end_s, s.label, s.color if s.kept else None, s.proposed)
        for s in frozen.segments
    )
