"""The list of recordings of one workbench, and who is at which."""

import threading
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from keyphase.errors import RequestError
from keyphase.workbench.proposals import Proposal
from keyphase.workbench.recordings import Recording, recording_at

if TYPE_CHECKING:
    from keyphase.workbench.view import View

PAGE_COLORS = 8
"""So many colours tell pages apart."""


@dataclass(frozen=True)
class Presence:
    """A page as others see it: a name, the number of its colour, the recording it is at."""

    page: str
    name: str
    color: int
    recording: str | None

    @staticmethod
    def of(view: "View") -> "Presence":
        """That of a page."""
        number = view.number
        return Presence(view.id, f"Page {number}", (number - 1) % PAGE_COLORS, view.recording)


def free_number(views: Iterable["View"]) -> int:
    """The smallest that no page has: who loads a page again and again is no ninth person."""
    taken = {view.number for view in views}
    return min(set(range(1, len(taken) + 2)) - taken)


@dataclass(frozen=True)
class Listing:
    """The list as it is now."""

    recordings: tuple[Recording, ...]
    presences: tuple[Presence, ...] = ()
    proposals: Mapping[str, Proposal] = field(default_factory=dict)


class RecordingList:
    """The lines of the list; `tell` is told of each change. For many threads.

    `counted` adds to a line what is known of it beside its own recording.
    """

    def __init__(
        self,
        paths: Sequence[Path],
        tell: Callable[[Listing], None],
        counted: Callable[[Recording], Recording] = lambda line: line,
    ) -> None:
        self._lock = threading.RLock()
        self._tell = tell
        self._counted = counted
        self._listing = Listing(tuple(counted(recording_at(path)) for path in dict.fromkeys(paths)))

    @property
    def listing(self) -> Listing:
        """The list as it is now."""
        return self._listing

    @property
    def recordings(self) -> tuple[Recording, ...]:
        """Its lines."""
        return self._listing.recordings

    def find(self, recording_id: str) -> Recording:
        """The line with that id. Raises RequestError where there is none."""
        for recording in self.recordings:
            if recording.id == recording_id:
                return recording
        raise RequestError("There is no such recording in this list; choose one that is.")

    def chosen(
        self, scope: Literal["picked", "done", "all"], picked: Collection[str]
    ) -> list[Recording]:
        """Those of a scope: with the ids `picked`, those that are done, or all."""
        lines = self.recordings
        if scope == "done":
            return [one for one in lines if one.state == "done"]
        return [one for one in lines if scope == "all" or one.id in picked]

    def first_to_do(self) -> Recording | None:
        """The first recording that is not done, so that work goes on where it was left."""
        open_ones = (recording for recording in self.recordings if recording.state != "done")
        return next(open_ones, next(iter(self.recordings), None))

    def add(self, path: Path) -> Recording:
        """A line more; the one there is where the file is listed already."""
        added = self._counted(recording_at(path))
        with self._lock:
            known = next((r for r in self.recordings if r.id == added.id), None)
            if known is None:
                self._change((*self.recordings, added))
        return known or added

    def remove(self, path: Path) -> tuple[Recording, Recording | None] | None:
        """A line less: that line and its neighbour; None where the file is not listed."""
        with self._lock:
            place = next((i for i, r in enumerate(self.recordings) if r.path == path), None)
            if place is None:
                return None
            removed = self.recordings[place]
            left = (*self.recordings[:place], *self.recordings[place + 1 :])
            self._change(left)
            return removed, left[min(place, len(left) - 1)] if left else None

    def update(self, changed: Recording) -> None:
        """Put a changed line into the list."""
        changed = self._counted(changed)
        with self._lock:
            if changed not in self.recordings:
                self._change(tuple(changed if r.id == changed.id else r for r in self.recordings))

    def show_pages(self, presences: Callable[[], Sequence[Presence]]) -> None:
        """Who is at which recording by now.

        They are asked for while nobody else can change the list, so that the newest are told last,
        and whoever asks must hold no lock that telling takes.
        """
        with self._lock:
            now = tuple(presences())
            if now != self._listing.presences:
                self._change(presences=now)

    def show_proposals(self, proposals: Mapping[str, Proposal]) -> None:
        """What is proposed for which recording by now, by their ids."""
        with self._lock:
            self._change(proposals=proposals)

    def _change(
        self,
        recordings: tuple[Recording, ...] | None = None,
        presences: tuple[Presence, ...] | None = None,
        proposals: Mapping[str, Proposal] | None = None,
    ) -> None:
        old = self._listing
        self._listing = Listing(
            old.recordings if recordings is None else recordings,
            old.presences if presences is None else presences,
            old.proposals if proposals is None else proposals,
        )
        self._tell(self._listing)
