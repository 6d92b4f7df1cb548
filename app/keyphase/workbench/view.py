"""A view: what one page looks at. No other page moves it, unless it follows that page."""

import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from keyphase.errors import RequestError
from keyphase.workbench.desks.desk import Desk
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.leading.session import LeadThroughSession
from keyphase.workbench.playback import Playhead
from keyphase.workbench.recordings import Recording
from keyphase.workbench.replaying.session import ReplaySession
from keyphase.workbench.scene_choices import SceneChoices
from keyphase.workbench.selection import Selection
from keyphase.workbench.surroundings import Surroundings
from keyphase.workbench.telling import Level, Telling
from keyphase.workbench.watcher import Watcher
from keyphase.workbench.watchers import Watchers
from keyphase.workbench.worker import Worker


class View:
    """What one page looks at; for many threads.

    scene    what it chose of its 3D scene
    replay   its replay and trials
    lead     its recording by hand
    errands  what takes long and is asked by it alone

    Locks are taken in the order library, desk, view: nothing of a desk is called under ours.
    """

    def __init__(self, id: str, number: int, around: Surroundings) -> None:
        self.id, self.number = id, number
        self._watchers, self._selection = Watchers(), Selection()
        self.playhead = Playhead()
        self.scene = SceneChoices(around.arms, self.each)
        self.following: str | None = None
        self._around, self._lock = around, threading.RLock()
        self._desk: Desk | None = None
        self._coming: Desk | None = None
        self._state: DeskState | None = None
        self.telling = Telling(self.tell, around.tasks)
        self.errands = Worker(self.telling.report)
        self.replay = ReplaySession(self.current, self.add, self.telling, self.each)
        self.lead = LeadThroughSession(around.takes, self, self.telling, self.each)

    @property
    def state(self) -> DeskState | None:
        """What is looked at; None where nothing is."""
        return self._state

    @property
    def recording(self) -> str | None:
        """Id of the recording that is looked at."""
        return self._state.recording.id if self._state else None

    @property
    def selected(self) -> int | None:
        """Index of the segment that is selected."""
        return self._selection.segment

    def current(self) -> DeskState:
        """What is looked at. Raises RequestError where nothing is."""
        if self._state is None:
            raise RequestError("No recording is open yet; choose one from the list.")
        return self._state

    # -- watchers

    def watch(self, watcher: Watcher) -> None:
        """Tell `watcher` how all stands, then every change."""
        with self._lock:
            self.scene.greet(watcher)
            watcher.show_following(self.following)
            watcher.show_recordings(self._around.recordings.listing, self.recording)
            if self._state is not None:
                watcher.show_document(self._state)
                watcher.show_selection(self._selection)
                watcher.show_playhead(self.playhead)
            for task in self._around.tasks.under_way:
                watcher.show_task(task)
            self._watchers.add(watcher)
        self.lead.greet(watcher)
        self.replay.greet(watcher)
        self._around.selection_changed()

    @property
    def is_here(self) -> bool:
        """Whether somebody has the page before them."""
        return len(self._watchers) > 0

    def unwatch(self, watcher: Watcher) -> None:
        """Tell `watcher` no more."""
        with self._lock:
            self._watchers.remove(watcher)

    def each(self, show: Callable[[Watcher], None]) -> None:
        """Tell all watchers; what goes wrong in one is no other's business."""
        self._watchers.each(show)

    def tell(self, level: Level, text: str) -> None:
        """A line of text for this page alone."""
        self.each(lambda watcher: watcher.show_notice(level, text))

    def close(self) -> None:
        """The page has gone for good: end what it began, give back what it had on loan."""
        self.errands.stop()
        self.lead.close()
        self.replay.close()
        with self._lock:
            lent = self._desk, self._coming
            self._desk = self._coming = self._state = None
            self._watchers.clear()
        self._give_back(*lent)

    # -- which recording

    def open(self, recording_id: str) -> None:
        """Look at a recording; what is looked at now stays until that is open."""
        self._leave_other()
        self._open(recording_id)

    def _open(self, recording_id: str) -> None:
        recording = self._around.recordings.find(recording_id)
        with self._lock:
            shown = self._desk is not None and self._desk.recording.id == recording_id
            desk = None if shown else self._around.library.lend(recording)
            before, self._coming = self._coming, desk
        self._give_back(before)
        if desk is not None:
            desk.join(self)

    def add(self, path: Path) -> None:
        """A recording more in the list, which is looked at."""
        self.open(self._around.recordings.add(path).id)

    def remove(self, path: Path) -> None:
        """A recording less in the list."""
        self._around.remove(path)

    def recording_gone(self, removed: Recording, neighbour: Recording | None) -> None:
        """A recording was taken out of the list: look at its neighbour instead."""
        if self.recording == removed.id and neighbour is not None:
            self._open(neighbour.id)
        elif self.recording == removed.id:
            with self._lock:
                before, self._desk, self._state = self._desk, None, None
                self._selection = Selection()
                self.each(lambda watcher: watcher.show_nothing())
            self._give_back(before)
            self._around.view_changed(self)

    # -- what a desk tells

    def desk_opened(self, desk: Desk, state: DeskState) -> None:
        """The recording that was asked for is open: look at it."""
        with self._lock:
            if desk is not self._coming:
                return
            before, self._desk, self._coming = self._desk, desk, None
            self._state, self._selection = state, Selection(cut_at=state.revision)
            start_s, end_s = state.demonstration.start_s, state.demonstration.end_s
            self.playhead = Playhead(start_s, start_s, end_s)
            self._show_state(state)
            self.each(lambda watcher: watcher.show_playhead(self.playhead))
        self._turned(state, before)

    def desk_failed(self, desk: Desk, error: Exception) -> None:
        """The recording that was asked for cannot be opened."""
        with self._lock:
            if desk is not self._coming:
                return
            self._coming = None
        self._around.recordings.update(replace(desk.recording, error=str(error)))
        self.telling.report(error)
        self._around.library.give_back(desk)

    def desk_changed(self, desk: Desk, state: DeskState) -> None:
        """What is looked at has changed."""
        with self._lock:
            if desk is not self._desk:
                return
            before, self._state = self._state, state
            self._selection = self._selection.after(before, state)
            self._show_state(state)
        self._around.selection_changed()

    def _turned(self, state: DeskState, before: Desk | None) -> None:
        if before is not None:
            before.leave(self)
            self._around.library.give_back(before)
        self.replay.turn_to(state)
        self._around.view_changed(self)
        self.errands.submit(self.lead.turn_away)
        self.errands.submit(self._lead_on)

    def _show_state(self, state: DeskState) -> None:
        self.each(lambda watcher: watcher.show_document(state))
        self.each(lambda watcher: watcher.show_selection(self._selection))

    def _give_back(self, *desks: Desk | None) -> None:
        for desk in filter(None, desks):
            desk.leave(self)
            self._around.library.give_back(desk)

    # -- selection, playback, scene

    def select(
        self,
        segment: int | None,
        recording: str | None = None,
        revision: int | None = None,
        to: int | None = None,
    ) -> None:
        """Select a segment of what is looked at, or none; with `to` all from it to that one.

        `recording` and `revision` are those the page saw: segments of another one, or of what was
        cut anew since, are not meant. Raises RequestError where there is none of that number.
        """
        self._leave_other()
        with self._lock:
            if recording is not None and recording != self.recording:
                raise RequestError("Another recording is shown by now, so nothing was selected.")
            self._select(self._selection.of(segment, to, self._state, revision))
        self._around.selection_changed()
        self._lead_on()

    def select_at(self, time_s: float) -> None:
        """Select the segment around a time, as a click in the scene does."""
        state = self._state
        if state and (segment := state.labeling.segment_at(time_s)) is not None:
            self.select(segment)

    def move_playhead(self, change: Callable[[Playhead], Playhead]) -> None:
        """Seek, play or pause."""
        self._leave_other()
        self._move(change)
        self._around.wake_clock()
        self._lead_on()

    def step(self, elapsed_s: float) -> bool:
        """Let a running playhead run on; whether it still runs."""
        with self._lock:
            if not self.playhead.playing or self.following is not None:
                return False
            self._move(lambda playhead: playhead.advanced(elapsed_s))
            playing = self.playhead.playing
        self._lead_on()
        return playing

    def _select(self, selection: Selection) -> None:
        with self._lock:
            self._selection = selection
            self.each(lambda watcher: watcher.show_selection(selection))

    def _move(self, change: Callable[[Playhead], Playhead]) -> None:
        with self._lock:
            self.playhead = change(self.playhead)
            self.each(lambda watcher: watcher.show_playhead(self.playhead))

    # -- following another page

    def follow(self, page: str | None) -> None:
        """See what another page sees: its recording, selection and playhead; None: no more.

        Raises RequestError for a page that is not there, or that follows this one.
        """
        leader = None if page is None else self._around.find_view(page)
        if leader is self or (leader is not None and leader.following is not None):
            raise RequestError("That page follows another one itself; follow that one.")
        with self._lock:
            self.following = page
            self.each(lambda watcher: watcher.show_following(page))
        if leader is not None:
            self.mirror(leader)

    def mirror(self, leader: "View") -> None:
        """Take over what the page that is followed sees."""
        if (recording := leader.recording) != self.recording:
            if recording is not None:
                self._open(recording)
            return
        if (playhead := leader.playhead) != self.playhead:
            self._move(lambda _: playhead)
        if (selection := self._selection.like(leader._selection)) != self._selection:
            self._select(selection)
            self._around.selection_changed()

    def _leave_other(self) -> None:
        """Whoever acts for itself follows nobody any more."""
        if self.following is not None:
            self.follow(None)

    def _lead_on(self) -> None:
        for follower in self._around.followers(self.id):
            follower.mirror(self)
