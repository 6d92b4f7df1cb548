"""Which segments a page has selected, and what others at the same recording have, as values."""

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
    """A segment of a document by its index, or none, and so far more are selected with it (`to`).

    `cut_at` is the revision since which the segments lie as they do: what was meant on an older
    one may have been another segment.
    """

    segment: int | None = None
    to: int | None = None
    cut_at: int = 0

    @property
    def stretch(self) -> tuple[int, int] | None:
        """The first and the last segment that are selected, or None."""
        if self.segment is None:
            return None
        other = self.segment if self.to is None else self.to
        return min(self.segment, other), max(self.segment, other)

    def of(
        self, segment: int | None, to: int | None, state: DeskState | None, revision: int | None
    ) -> "Selection":
        """Other segments, meant on a revision. Raises RequestError where there are none such."""
        for index in (segment, to):
            if index is None:
                continue
            if state is not None and revision is not None and revision < self.cut_at:
                raise RequestError("The segments were changed meanwhile; select again.")
            count = len(state.labeling.segments) if state else 0
            if index >= count:
                raise RequestError(f"There are {count} segments, so none has the index {index}.")
        return replace(self, segment=segment, to=to)

    def like(self, other: "Selection") -> "Selection":
        """The segments another page has selected."""
        return replace(self, segment=other.segment, to=other.to)

    def after(self, before: DeskState | None, state: DeskState) -> "Selection":
        """What is still selected once the document has changed."""
        cut_anew = before is None or _cuts(before) != _cuts(state)
        count = len(state.labeling.segments)
        is_there = self.segment is not None and self.segment < count
        is_whole = before is not None and len(before.labeling.segments) == count
        return Selection(
            self.segment if is_there else None,
            self.to if is_whole else None,
            state.revision if cut_anew else self.cut_at,
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
