"""Which segment a page has selected, and what others at the same recording have, as values."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from keyphase.errors import RequestError
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.recording_list import Presence

if TYPE_CHECKING:
    from keyphase.workbench.view import View


@dataclass(frozen=True)
class Selection:
    """A segment of a document by its index, or none.

    `cut_at` is the revision since which the segments lie as they do: what was meant on an older
    one may have been another segment.
    """

    segment: int | None = None
    cut_at: int = 0

    def of(self, segment: int | None, state: DeskState | None, revision: int | None) -> "Selection":
        """Another segment, meant on a revision. Raises RequestError where there is none such."""
        if segment is not None:
            if state is not None and revision is not None and revision < self.cut_at:
                raise RequestError("The segments were changed meanwhile; select again.")
            count = len(state.labeling.segments) if state else 0
            if segment >= count:
                raise RequestError(f"There are {count} segments, so none has the index {segment}.")
        return replace(self, segment=segment)

    def after(self, before: DeskState | None, state: DeskState) -> "Selection":
        """What is still selected once the document has changed."""
        cut_anew = before is None or _cuts(before) != _cuts(state)
        is_there = self.segment is not None and self.segment < len(state.labeling.segments)
        return Selection(
            self.segment if is_there else None, state.revision if cut_anew else self.cut_at
        )


@dataclass(frozen=True)
class OtherSelection:
    """The segment that another page at the same recording has selected."""

    page: str
    name: str
    color: int
    segment: int


def selected_by_others(view: "View", views: Iterable["View"]) -> tuple[OtherSelection, ...]:
    """What the other pages at the recording of `view` have selected."""
    return tuple(
        OtherSelection(there.page, there.name, there.color, one.selected)
        for one in views
        if one is not view and one.recording == view.recording and one.selected is not None
        for there in (Presence.of(one),)
    )


def _cuts(state: DeskState) -> list[float]:
    return [segment.start_s for segment in state.labeling.segments]
