"""Whether a request still fits: who changed a recording since the page that asks saw it."""

from collections import OrderedDict
from dataclasses import dataclass, replace

from keyphase.errors import KeyphaseError, RequestError
from keyphase.labeling.edits import Edit
from keyphase.labeling.labeling import Labeling
from keyphase.workbench.desks.asked import Asked
from keyphase.workbench.desks.desk_state import DeskState

REMEMBERED = 64
"""So many revisions back an edit can still be compared with what its page saw; each holds a
whole labeling."""


@dataclass(frozen=True)
class _Revision:
    page: str | None
    labeling: Labeling
    only_colors: bool


class Revisions:
    """The last revisions of one desk, and which page made each. Used under the desk's lock."""

    def __init__(self) -> None:
        self._known: OrderedDict[int, _Revision] = OrderedDict()

    def add(self, state: DeskState, page: str | None) -> None:
        """A new revision, made by a page, or by none."""
        last = next(reversed(self._known.values()), None)
        same = last is not None and _uncolored(last.labeling) == _uncolored(state.labeling)
        self._known[state.revision] = _Revision(page, state.labeling, page is None and same)
        while len(self._known) > REMEMBERED:
            self._known.popitem(last=False)

    def check_unchanged(self, asked: Asked) -> None:
        """Raise RequestError where anybody but the page that asks has changed it since."""
        if self._others_since(asked):
            raise RequestError(
                "This recording was changed meanwhile, not by this page; look at it as it is now "
                "and ask again."
            )

    def check_edit(self, asked: Asked, edit: Edit, now: Labeling) -> None:
        """Raise RequestError where the edit would be about something else than its page saw."""
        if not self._others_since(asked):
            return
        try:
            same = edit.anchored(self._known[asked.revision].labeling) == edit.anchored(now)
        except KeyphaseError:
            same = False
        if not same:
            raise RequestError(
                "What this edit was about was changed meanwhile, not by this page, so it was not "
                "made; look and make it again."
            )

    def _others_since(self, asked: Asked) -> bool:
        if asked.revision not in self._known:
            raise RequestError(
                "This was asked of the recording as it no longer is; look at it as it is now and "
                "ask again."
            )
        return any(
            made.page != asked.page and not made.only_colors
            for revision, made in self._known.items()
            if revision > asked.revision
        )


def _uncolored(labeling: Labeling) -> tuple[object, ...]:
    """What a labeling says, whatever the folder's vocabulary makes its colours."""
    segments = [replace(segment, color=0) for segment in labeling.segments]
    return labeling.boundaries, segments, labeling.plan, labeling.parameters, labeling.done
