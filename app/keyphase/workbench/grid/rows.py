"""The rows of the grid: every recording of a folder with its segments, and how it stands."""

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from keyphase.labeling.comparing.comparison import Outline
from keyphase.labeling.edits import Keep
from keyphase.transfer.phase_order import Difference
from keyphase.workbench.grid.stretches import Stretch
from keyphase.workbench.proposals import Proposal
from keyphase.workbench.recording_list import Listing
from keyphase.workbench.recordings import Recording
from keyphase.workbench.showing.doubts import UNSURE_BELOW

Standing = Literal[
    "outlier",
    "differs",
    "unsure",
    "proposed",
    "done",
    "touched",
    "automatic",
    "waiting",
    "broken",
]
"""How a recording stands; `differs`: its phases seem to be others, `waiting`: nobody has looked at
it yet, `broken`: it cannot be read."""


@dataclass(frozen=True)
class GridRow:
    """One recording.

    stretches  its segments; of one for which something is proposed, those that are proposed
    teachers   names of the recordings these are proposed from
    differs    how its phases differ from those of the finished ones
    """

    recording: Recording
    standing: Standing
    stretches: tuple[Stretch, ...]
    teachers: tuple[str, ...] = ()
    differs: Difference | None = None


def grid_rows(listing: Listing, folder: Path) -> tuple[GridRow, ...]:
    """The rows of the recordings of a folder, in the order of the list."""
    return tuple(
        grid_row(line, listing.proposals.get(line.id))
        for line in listing.recordings
        if line.path.parent == folder
    )


def grid_row(line: Recording, proposal: Proposal | None) -> GridRow:
    """The row of one recording; what is proposed counts where nobody has touched it."""
    if line.error is not None:
        return GridRow(line, "broken", ())
    if line.state == "automatic" and proposal is not None:
        if proposal.outline is None:
            return GridRow(line, "outlier", line.stretches)
        sure = proposal.confidence >= UNSURE_BELOW
        shown = _proposed(proposal, proposal.outline)
        if proposal.differs is not None:
            return GridRow(line, "differs", shown, proposal.teachers, proposal.differs)
        return GridRow(line, "proposed" if sure else "unsure", shown, proposal.teachers)
    if not line.stretches:
        return GridRow(line, "waiting", ())
    unsure = line.state != "done" and line.unsure > 0
    return GridRow(line, "unsure" if unsure else line.state, line.stretches)


def _proposed(proposal: Proposal, outline: Outline) -> tuple[Stretch, ...]:
    start, end = outline.span_s
    times = (start, *outline.boundaries_s, end)
    parts = proposal.edit.edits if proposal.edit else ()
    dropped = [part.span_s for part in parts if isinstance(part, Keep) and not part.kept]
    return tuple(
        Stretch(a, b, name, None if (a, b) in dropped else number, True)
        for number, (a, b, name) in enumerate(
            zip(times[:-1], times[1:], outline.labels, strict=True)
        )
    )
