"""The workbench: the list of recordings, the desks they lie on, the pages that look at them."""

import itertools
import threading
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from keyphase.errors import FileInTheWayError, RequestError
from keyphase.readers.finding import begins_native, folder_recipe
from keyphase.workbench.desks.desk import Desk
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.desks.library import Library
from keyphase.workbench.exporting.all_recordings import export_all
from keyphase.workbench.exporting.beside import InTheWay, require_own_names
from keyphase.workbench.exporting.formats import write_in
from keyphase.workbench.footage import FootageShelf
from keyphase.workbench.grid.for_all import ForAll
from keyphase.workbench.grid.second_person import SecondPerson
from keyphase.workbench.leading.takes import Takes
from keyphase.workbench.looking import Looking
from keyphase.workbench.playback import Clock
from keyphase.workbench.proposals import Proposals
from keyphase.workbench.recording_list import Listing, Presence, RecordingList, free_number
from keyphase.workbench.recordings import Recording
from keyphase.workbench.selection import selected_by_others
from keyphase.workbench.sharing import Sharing
from keyphase.workbench.spread import Spread, Trial, beside, look_into
from keyphase.workbench.tasks import Tasks, TaskState
from keyphase.workbench.uploads import DEFAULT_LIMIT_BYTES, Upload
from keyphase.workbench.view import View
from keyphase.writers import Options, SegmentedRecording, writer_named

KEPT_S = 30.0
"""A page that comes back within this time finds its view as it left it."""


@dataclass(frozen=True)
class Settings:
    """How a workbench is set up.

    recipe       how to read tables that are not in keyphase's own form
    read_only    nothing may be changed by anybody
    folder       where takes are put
    arms         names of the tools a robot beside a recording could follow with
    beside       a folder of another person's segment files of the same recordings
    """

    recipe: Path | None = None
    read_only: bool = False
    folder: Path = Path()
    arms: tuple[str, ...] = ()
    upload_limit_bytes: int = DEFAULT_LIMIT_BYTES
    beside: Path | None = None


class Workbench:
    """Everything one server knows. Methods may be called from any thread."""

    def __init__(self, paths: Sequence[Path], settings: Settings | None = None) -> None:
        self.settings = settings or Settings()
        self.tasks = Tasks(self._tell_task)
        self.library = Library(self.tasks, self.settings.recipe, read_only=self.settings.read_only)
        self._lock = threading.RLock()
        self._views: dict[str, View] = {}
        self._held: dict[str, int] = {}
        self._leaving: dict[str, threading.Timer] = {}
        self._looks = itertools.count(1)
        self._spreads: dict[str, int] = {}
        self.second = SecondPerson(self.settings.beside) if self.settings.beside else None
        counted = self.second.counted if self.second else (lambda line: line)
        self.recordings = RecordingList(paths, self._tell_list, counted)
        self.proposals = Proposals(
            lambda: self.recordings.recordings,
            self.library,
            self.tasks,
            self.recordings.show_proposals,
        )
        self.library.on_change = lambda state: self._line_changed(state.line)
        self.footage = FootageShelf(self.tasks)
        self.takes = Takes(self.settings.folder)
        self.arms = self.settings.arms
        self.looking = Looking(self.recordings, self.library)
        self.library.on_parameters = self.looking.begin
        self.for_all = ForAll(self.library, self.recordings)
        self.for_all.taught = self.proposals.begin
        self.sharing = Sharing(self.library, self.recordings, self.for_all)
        self._clock = Clock(self._step)

    def close(self) -> None:
        """End all threads and let go of the recordings."""
        with self._lock:
            views = tuple(self._views.values())
            self._views = {}
            for timer in self._leaving.values():
                timer.cancel()
        self._clock.stop()
        self.looking.stop()
        self.footage.stop()
        self.proposals.stop()
        for view in views:
            view.close()
        self.library.close()

    # -- pages

    @property
    def views(self) -> tuple[View, ...]:
        """The views of all pages, the oldest first."""
        with self._lock:
            return tuple(self._views.values())

    @property
    def _present(self) -> tuple[View, ...]:
        """The views that somebody has before them."""
        with self._lock:
            return tuple(view for page, view in self._views.items() if self._held.get(page))

    def enter(self, page: str) -> View:
        """The view of a page, made where there is none; each entering needs a leaving.

        A new view looks at the first recording that is not done.
        """
        with self._lock:
            if (timer := self._leaving.pop(page, None)) is not None:
                timer.cancel()
            has_come = not self._held.get(page)
            self._held[page] = self._held.get(page, 0) + 1
            is_new = page not in self._views
            if is_new:
                self._views[page] = View(page, free_number(self._views.values()), self)
            view = self._views[page]
        if has_come:
            self.view_changed(view)
        if is_new:
            if (first := self.recordings.first_to_do()) is not None:
                view.open(first.id)
            if len(self.views) == 1:
                self.looking.begin()
                self.proposals.begin()
        return view

    def leave(self, page: str) -> None:
        """One of those who entered has gone; after the last the view is kept KEPT_S, unseen."""
        with self._lock:
            view = self._views.get(page)
            if view is None:
                return
            self._held[page] -= 1
            if self._held[page]:
                return
            timer = threading.Timer(KEPT_S, self._forget, (page,))
            timer.daemon = True
            self._leaving[page] = timer
            timer.start()
        self.view_changed(view)

    def find_view(self, page: str) -> View:
        """The view of a page. Raises RequestError where there is none."""
        with self._lock:
            if page not in self._views:
                raise RequestError("That page is no longer there.")
            return self._views[page]

    def followers(self, page: str) -> tuple[View, ...]:
        """The views that follow a page."""
        return tuple(view for view in self.views if view.following == page)

    def view_changed(self, view: View) -> None:
        """A view looks at another recording, or its page has come or gone."""
        self.recordings.show_pages(lambda: [Presence.of(one) for one in self._present])
        view.each(lambda watcher: watcher.show_recordings(self.recordings.listing, view.recording))
        self.selection_changed()

    def selection_changed(self) -> None:
        """A view has selected another segment: whoever is at the same recording is told."""
        for one in self.views:
            others = selected_by_others(one, self._present)
            one.each(lambda watcher, others=others: watcher.show_others(others))

    def wake_clock(self) -> None:
        """A playhead has begun to run."""
        self._clock.wake()

    def _forget(self, page: str) -> None:
        with self._lock:
            if self._held.get(page):
                return
            view = self._views.pop(page, None)
            self._held.pop(page, None)
            self._leaving.pop(page, None)
        if view is not None:
            for follower in self.followers(page):
                follower.follow(None)
            view.close()

    def _step(self, elapsed_s: float) -> bool:
        still_running = [view.step(elapsed_s) for view in self.views]
        return any(still_running)

    # -- the list

    def remove(self, path: Path) -> None:
        """A recording less; whoever looks at it turns to its neighbour."""
        removed = self.recordings.remove(path)
        if removed is not None:
            for view in self.views:
                view.recording_gone(*removed)

    def take_in(self, upload: Upload, beside_sha256: str | None) -> Path:
        """A file that was sent, read and named; where it now is.

        `beside_sha256` is the hash of the recording a segment file is to be about. Raises
        RequestError with the reason where it cannot be used; it is there still.
        """
        with self.tasks.begin(f"{upload.name}: reading"):
            return self.library.take_in(upload, beside_sha256)

    def is_undescribed(self, upload: Upload) -> bool:
        """Whether a file that was sent is a table for which there is no recipe."""
        given = self.settings.recipe is not None or folder_recipe(upload.part) is not None
        return not (given or upload.is_segment_file or begins_native(upload.part))

    def export_one(self, view: View, state: DeskState, kind: str, options: Options) -> None:
        """Write a recording in a format, and tell a page what became of it."""
        title = writer_named(kind).title
        item = SegmentedRecording.of_labeling(state.kept_labeling)
        with self.tasks.begin(f"{state.recording.name}: writing {title}"):
            try:
                for path in write_in(kind, (item,), options):
                    view.each(lambda watcher, at=path: watcher.show_saved(at, kind))
            except FileInTheWayError as error:
                files, at = (InTheWay.of(error),), state.recording.id
                view.each(lambda watcher: watcher.show_in_the_way(at, kind, files))

    def export_all(
        self, view: View, chosen: Sequence[Recording], kind: str, options: Options
    ) -> None:
        """Write these recordings, and tell a page what became of it."""
        exported = export_all(chosen, self.library, self.tasks, kind, options)
        if len(exported.paths) == 1:
            view.each(lambda watcher: watcher.show_saved(exported.paths[0], kind))
        for reason in exported.refused:
            view.tell("warning", reason)
        title = writer_named(kind).title
        view.tell("info", f"{exported.written} of {len(chosen)} recordings were written: {title}.")
        files = exported.in_the_way
        if files:
            at = view.recording or ""
            view.each(lambda watcher: watcher.show_in_the_way(at, kind, files))

    def require_own_names(self, recording: Recording) -> None:
        """Raise RequestError where another of the list would be written to the same files."""
        require_own_names(recording.path, [one.path for one in self.recordings.recordings])

    # -- parameters for a whole folder

    def look_into_spread(self, desk: Desk, view: View, *, include_done: bool = False) -> None:
        """Tell a page what the parameters of a recording would do to all of its folder.

        What is done is left alone unless `include_done`.
        """
        state = desk.state
        if state is None:
            raise RequestError("This recording is not open yet; wait until it is shown.")
        number = next(self._looks)
        self._spreads[view.id] = number
        spread = Spread(number, beside(desk.recording, self.recordings.recordings))
        view.errands.submit(
            lambda: look_into(
                spread,
                Trial(state.parameters, include_done),
                self.library,
                self.tasks,
                lambda known: view.each(lambda watcher: watcher.show_spread(known)),
                lambda: self._spreads.get(view.id) == number,
            )
        )

    def leave_spread(self, view: View) -> None:
        """Look no further into what would change."""
        self._spreads.pop(view.id, None)

    def _line_changed(self, line: Recording) -> None:
        """A recording stands otherwise in the list; what it teaches the others may be new."""
        before = next((one for one in self.recordings.recordings if one.id == line.id), None)
        self.recordings.update(line)
        if before and (before.state == "done") != (line.state == "done"):
            self.proposals.begin()

    # -- telling

    def _tell_list(self, listing: Listing) -> None:
        for view in self.views:
            recording = view.recording
            view.each(lambda watcher, at=recording: watcher.show_recordings(listing, at))

    def _tell_task(self, task: TaskState) -> None:
        for view in self.views:
            view.each(lambda watcher: watcher.show_task(task))
