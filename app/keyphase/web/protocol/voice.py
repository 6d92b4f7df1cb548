"""What a page is told: a watcher of its view that puts everything into messages."""

import threading
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Protocol

import msgspec

from keyphase.labeling.tasks.task import plain_or
from keyphase.simulation.part_shapes import Shape
from keyphase.web.protocol import control_messages as controls
from keyphase.web.protocol import document_messages as documents
from keyphase.web.protocol import export_messages as exports
from keyphase.web.protocol import list_messages as lists
from keyphase.web.protocol.document_content import document_message, ghosts
from keyphase.web.protocol.messages import Message
from keyphase.web.protocol.replay_messages import ReplayClosed, Streamed, replay_message
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.desks.folder import FIRST_TASK
from keyphase.workbench.exporting.beside import InTheWay
from keyphase.workbench.grid.rows import GridRow, grid_rows
from keyphase.workbench.leading.status import LeadThroughStatus
from keyphase.workbench.placing.robot_choice import RobotChoice
from keyphase.workbench.playback import Playhead
from keyphase.workbench.recording_list import Listing
from keyphase.workbench.recordings import printable
from keyphase.workbench.replaying.margin import MarginRun
from keyphase.workbench.replaying.run import Tick
from keyphase.workbench.replaying.running import Running
from keyphase.workbench.replaying.settings import ReplaySettings
from keyphase.workbench.replaying.trials import TrialsRun
from keyphase.workbench.scene_choices import PARTS
from keyphase.workbench.selection import OtherSelection, Selection
from keyphase.workbench.spread import Spread
from keyphase.workbench.tasks import TaskState
from keyphase.workbench.telling import Level
from keyphase.workbench.view import View
from keyphase.workbench.watcher import Watcher
from keyphase.workbench.workbench import Workbench

TOLD_EVERY_S = 0.1
"""Numbers of a recording by hand are told so often."""


class Send(Protocol):
    """Sends a message to one page, from any thread; `may_drop` where a newer one will follow."""

    def __call__(self, message: Message | bytes, may_drop: bool = False) -> None:
        """Send it."""
        ...


class GridVoice:
    """Tells one page of all recordings of the folder it looks at, while it shows the grid.

    What it knows already is not told again: of two hundred recordings one changes at a time.
    """

    def __init__(self, send: Send, workbench: Workbench, view: View) -> None:
        self._send, self._workbench, self._view = send, workbench, view
        self._lock = threading.Lock()
        self._shown = False
        self._rows: dict[str, GridRow] = {}
        self._told: lists.GridMessage | None = None

    def show(self, shown: bool) -> None:
        """The page shows the grid, or does no more."""
        with self._lock:
            self._shown, self._rows, self._told = shown, {}, None
        self.tell()

    def tell(self) -> None:
        """What has changed."""
        with self._lock:
            if self._shown:
                self._tell()

    def _tell(self) -> None:
        listing, state = self._workbench.recordings.listing, self._view.state
        line = state.recording if state else next(iter(listing.recordings), None)
        if line is None:
            return
        folder = line.path.parent
        rows = {row.recording.id: row for row in grid_rows(listing, folder)}
        changed = [row for id, row in rows.items() if row != self._rows.get(id)]
        settings, made = (
            self._workbench.library.settings_of(folder),
            self._workbench.for_all.last(folder),
        )
        task = next(iter(settings.tasks), None)
        message = lists.GridMessage(
            printable(folder.name),
            tuple(rows),
            tuple(map(lists.grid_line, changed)),
            task.name if task else plain_or(folder.name, FIRST_TASK),
            task.phases if task else (),
            made.name if made else None,
        )
        if changed or self._told != msgspec.structs.replace(message, rows=()):
            self._send(message)
        self._rows, self._told = rows, msgspec.structs.replace(message, rows=())


class Voice(Watcher):
    """Tells one page of its view; `selected` is what that has selected."""

    def __init__(
        self, send: Send, page: str, selected: Callable[[], int | None], grid: GridVoice
    ) -> None:
        self._send, self._page, self._selected, self._grid = send, page, selected, grid
        self._lock = threading.Lock()
        self._ghosts: tuple[documents.Ghost, ...] = ()
        self._others: tuple[documents.OtherSelected, ...] = ()
        self._streamed: Streamed | None = None
        self._record_told_at = 0.0
        self._record_told: tuple[object, ...] = ()

    # -- what the page looks at

    def show_document(self, state: DeskState) -> None:
        """The document, and what a change under way would bring and take."""
        message = document_message(state)
        self._send(msgspec.structs.replace(message, selected=self._selected()))
        coming = ghosts(state.kept_labeling, state.labeling)
        if coming != self._ghosts:
            self._ghosts = coming
            self._send(documents.GhostMessage(coming))
        self._grid.tell()

    def show_nothing(self) -> None:
        """No recording is left to look at."""
        self._send(documents.NothingMessage())

    def show_playhead(self, playhead: Playhead) -> None:
        """Where the playhead is; of one that runs not every step must arrive."""
        told = (
            playhead.time_s,
            playhead.playing,
            playhead.speed,
            playhead.loop,
            playhead.between_s,
        )
        self._send(documents.PlayheadMessage(*told), playhead.playing)

    def show_selection(self, selection: Selection) -> None:
        """Which segment is selected; how far more are with it the page knows itself."""
        self._send(documents.SelectionMessage(selection.segment))

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Which parts the scene shows."""
        self._send(documents.ShownMessage({part: part not in hidden for part in PARTS}))

    def show_following(self, page: str | None) -> None:
        """Which page is followed."""
        self._send(lists.Following(page))

    # -- controls

    def show_robot(self, choice: RobotChoice) -> None:
        """The arm that follows, and whether the robot may be moved."""
        self._send(controls.RobotMessage(choice.arms, choice.arm, choice.moving))

    def show_settings(self, settings: ReplaySettings) -> None:
        """The world of the next replay."""
        self._send(controls.replay_settings_message(settings))

    def show_push(self, offered: bool) -> None:
        """Whether the gizmo that pushes is offered."""
        self._send(controls.PushMessage(offered))

    def show_trials(self, trials: TrialsRun) -> None:
        """Trials on the way, or over."""
        self._send(controls.trials_message(trials))

    def show_margin(self, margin: MarginRun) -> None:
        """A margin on the way, or over."""
        self._send(controls.margin_message(margin))

    # -- a replay

    def show_begun(self, running: Running) -> None:
        """A replay begins, or runs already where the page has come late."""
        self._streamed = Streamed(running)
        self._send(replay_message(running))
        self._tell_samples()

    def show_tick(self, running: Running, tick: Tick) -> None:  # noqa: ARG002
        """What was measured since."""
        self._tell_samples()

    def show_status(self, running: Running) -> None:
        """A skill has ended, or the phase is another."""
        self._tell_samples()
        self._send(replay_message(running))

    def show_replay_closed(self) -> None:
        """It is shown no more."""
        self._streamed = None
        self._send(ReplayClosed())

    def _tell_samples(self) -> None:
        streamed = self._streamed
        message = streamed.more() if streamed else None
        if message is not None:
            self._send(message)

    # -- recording by hand

    def show_workcell(self, status: LeadThroughStatus, shapes: tuple[Shape, ...]) -> None:  # noqa: ARG002
        """A workcell was opened."""
        self.show_workcell_status(status)

    def show_workcell_status(self, status: LeadThroughStatus) -> None:
        """What can be done at once, numbers ten times a second."""
        stands = (status.workcell, status.recording, status.can_undo, status.can_redo)
        with self._lock:
            now = time.monotonic()
            soon = now - self._record_told_at < TOLD_EVERY_S or status.running is None
            if stands == self._record_told and soon:
                return
            self._record_told, self._record_told_at = stands, now
        self._send(controls.record_message(status))

    # -- what is told beside that

    def show_recordings(self, listing: Listing, current: str | None) -> None:
        """The list, with who else is at which recording."""
        self._send(lists.recordings_message(listing, current, self._page))
        self._grid.tell()

    def show_others(self, others: Sequence[OtherSelection]) -> None:
        """What others have selected here."""
        told = tuple(documents.OtherSelected(one.name, one.color, one.segment) for one in others)
        if told != self._others:
            self._others = told
            self._send(documents.OthersMessage(told))

    def show_grid(self) -> None:
        """What is known of the folder."""
        self._grid.tell()

    def show_spread(self, spread: Spread) -> None:
        """What is known of a look at the folder."""
        self._send(lists.spread_message(spread))

    def show_saved(self, path: Path, kind: str) -> None:
        """A file was written."""
        self._send(exports.saved_message(path, kind))

    def show_in_the_way(self, recording: str, kind: str, files: Sequence[InTheWay]) -> None:
        """Files that were not replaced."""
        self._send(exports.InTheWayMessage(recording, kind, tuple(files)))

    def show_task(self, task: TaskState) -> None:
        """How far something is."""
        self._send(lists.TaskMessage(task.id, task.name, task.fraction, task.done))

    def show_notice(self, level: Level, text: str) -> None:
        """A line of text."""
        self._send(lists.Notice(level, text))
