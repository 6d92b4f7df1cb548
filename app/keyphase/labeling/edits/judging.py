"""Finding the boundary that a person said something about."""

from keyphase.labeling.boundary_line import Mark
from keyphase.labeling.walk import Walk


def judged(number: int, time_s: float, walk: Walk, insisted: bool) -> Mark | None:
    """The boundary at `time_s`, made there where a person insists; None where it is missed."""
    walk.forget_holds()
    mark = walk.line.find(time_s)
    if mark is None and insisted and walk.line.obstacle(time_s) is None:
        mark = Mark(time_s, contact_change=False)
        walk.line.place(mark, time_s)
    if mark is None:
        text = f"Boundary at {time_s:.3f} s: it is no longer found."
        walk.miss(number, time_s, time_s, text)
    return mark
