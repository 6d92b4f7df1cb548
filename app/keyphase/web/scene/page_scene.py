"""The 3D scene of one page, drawn through viser's handle of its client in a thread of its own.

A frame that connects again is a new client with an empty scene: it gets a new `PageScene`, which is
told how all stands and draws it. Whoever tells it things never waits for the drawing, and of things
that are overtaken (a playhead, a pose of a replay) only the last is drawn.
"""

import time
from collections.abc import Callable

import viser

from keyphase.errors import FileInTheWayError
from keyphase.labeling.storage.written_files import IfThere
from keyphase.robot.pose import Placement
from keyphase.simulation.part_shapes import Shape
from keyphase.web.scene.camera import Camera, LastCamera
from keyphase.web.scene.page_parts import PageParts
from keyphase.web.scene.page_robot import PageRobot
from keyphase.web.scene.page_spread import PageSpread
from keyphase.web.scene.replaying.film import film_of
from keyphase.web.scene.replaying.replay_scene import ReplayScene
from keyphase.web.scene.replaying.workcell_scene import WorkcellScene
from keyphase.web.scene.shared import Shared
from keyphase.web.scene.stage import Stage
from keyphase.web.scene.standing_mark import StandingMark
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.exporting.beside import InTheWay
from keyphase.workbench.leading.status import LeadThroughStatus
from keyphase.workbench.placing.robot_choice import RobotChoice
from keyphase.workbench.playback import Playhead
from keyphase.workbench.replaying.exports import write_page
from keyphase.workbench.replaying.run import Tick
from keyphase.workbench.replaying.running import Running
from keyphase.workbench.selection import Selection
from keyphase.workbench.view import View
from keyphase.workbench.watcher import Watcher
from keyphase.workbench.worker import Worker


class PageScene(Watcher):
    """Shows one page what it looks at; told from any thread."""

    def __init__(
        self,
        server: viser.ViserServer,
        client: viser.ClientHandle,
        shared: Shared,
        view: View,
        last: LastCamera,
    ) -> None:
        self.client = client
        self._server, self._shared, self._view = server, shared, view
        self._painter = Worker(view.telling.report)
        self._closed = False
        self._built = False
        self._drawn_at = 0.0
        self._camera = Camera(client, last)
        self._painter.submit(self._build)

    def close(self) -> None:
        """Draw no more: the client has gone."""
        self._closed = True
        self._view.unwatch(self)
        self._painter.stop()
        self._painter.join()
        if self._built:
            self.robot.close()

    def wait_until_drawn(self, timeout_s: float) -> bool:
        """Whether everything it was told is drawn within `timeout_s`."""
        return self._painter.wait_until_idle(timeout_s)

    # -- what the page looks at

    def show_nothing(self) -> None:
        """No recording is looked at any more, or another one is on its way."""
        self._later(self._clear)

    def show_document(self, state: DeskState) -> None:
        """The document has changed, or another recording is looked at."""
        self._later(lambda: self._show_document(state), "document")

    def show_playhead(self, playhead: Playhead) -> None:
        """The playhead has moved; while it runs it is drawn as often as all pages' may be."""
        now = time.perf_counter()
        if playhead.playing and now - self._drawn_at < self._shared.pace_s:
            return
        self._drawn_at = now
        self._later(lambda: self._show_playhead(playhead), "playhead")

    def show_range(self, recording: str, from_s: float, to_s: float) -> None:
        """So much of the recording is in view."""
        self._later(lambda: self.stage.show_range(recording, from_s, to_s), "range")

    def show_selection(self, selection: Selection) -> None:
        """Other segments are selected."""
        self._later(lambda: self.stage.show_selection(selection.stretch), "selection")

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Parts of the scene are shown or hidden."""
        self._later(lambda: self._show_parts(hidden), "parts")

    def show_theme(self, dark: bool) -> None:
        """The page has become light or dark."""
        self._later(lambda: self.stage.show_theme(dark), "theme")

    # -- the robot

    def show_robot(self, choice: RobotChoice) -> None:
        """Another arm was chosen, or the robot may be moved."""
        self._later(lambda: self._show_robot(choice), "robot")

    def place_robot(self) -> None:
        """Forget where a person put the robot."""
        self._later(lambda: self.robot.place_automatically())

    def put_robot(self, base: Placement) -> None:
        """Put the robot's base there, in the recording's frame, and keep that."""
        self._later(lambda: self.robot.place(base))

    # -- a replay

    def show_push(self, offered: bool) -> None:
        """Show or hide the gizmo that pushes the tool."""
        self._later(lambda: self.replay.offer_push(offered), "push")

    def show_begun(self, running: Running) -> None:
        """A replay begins."""
        self._later(lambda: self.replay.begin(running))

    def show_tick(self, running: Running, tick: Tick) -> None:
        """It has come to here."""
        if self._replay_is_due():
            self._later(lambda: self.replay.draw(running, tick), "tick")

    def show_status(self, running: Running) -> None:
        """Where it stands still all is drawn as it is then."""
        replay = running.run.replay
        if running.phase != "running" and replay.states:
            tick = Tick(replay.state, replay.simulation.part_poses())
            self._later(lambda: self.replay.draw(running, tick), "tick")

    def show_replay_closed(self) -> None:
        """Give the scene back."""
        self._later(lambda: self.replay.end())

    def write_replay(self, running: Running, if_there: IfThere) -> None:
        """The replay that is over is to be written as a page of its own."""
        self._view.errands.submit(lambda: self._write(running, if_there))

    def _replay_is_due(self) -> bool:
        """Whether the next pose of a replay is to be drawn, however fast it runs."""
        now = time.perf_counter()
        if now - self._drawn_at < max(REPLAY_DRAWN_EVERY_S, self._shared.pace_s):
            return False
        self._drawn_at = now
        return True

    # -- a workcell that is led by hand

    def show_workcell(self, status: LeadThroughStatus, shapes: tuple[Shape, ...]) -> None:
        """A workcell was opened."""
        self._later(lambda: self.workcell.open(status, shapes))

    def show_workcell_status(self, status: LeadThroughStatus) -> None:
        """How it stands now."""
        self._later(lambda: self.workcell.draw(status), "workcell")

    def show_workcell_closed(self) -> None:
        """Give the scene back."""
        self._later(lambda: self.workcell.close())

    # -- in the painter's thread

    def _later(self, job: Callable[[], None], kind: str | None = None) -> None:
        self._painter.submit(lambda: None if self._closed else job(), kind)

    def _build(self) -> None:
        client, shared, view = self.client, self._shared, self._view
        with client.atomic():
            self._mark = StandingMark(client)
            self.robot = PageRobot(
                client, shared, view, self._later, self._stand_anew, self._settle
            )
            self.stage = Stage(
                client, self._camera, view.select_at, lambda: self.robot.base, shared.shadow
            )
            self.parts = PageParts(client, shared, self._later)
            self.spread = PageSpread(client, shared, view, self._later)
            self.replay = ReplayScene(client, self.stage, self.robot, view.replay.push)
            self.workcell = WorkcellScene(client, self.stage, self.robot, view.lead)
        self._built = True

    def _stand_anew(self) -> None:
        self.stage.stand_anew()

    def _clear(self) -> None:
        with self.client.atomic():
            self._mark.clear()
            self.robot.clear()
            self.parts.clear()
            self.spread.clear()
        self.stage.clear()

    def _show_document(self, shown: DeskState) -> None:
        """The path first: it is there at once, the robot when its joints are known."""
        self._mark.begin(shown.recording.id)
        try:
            self.stage.show_document(shown)
            self.robot.show_document(shown)
            self.parts.show_document(shown)
            self.spread.show_document(shown)
        finally:
            self._settle()

    def _settle(self) -> None:
        """Tell the page that all is drawn, or that no more of it can be."""
        if not self.robot.is_awaited:
            self._mark.put()

    def _show_robot(self, choice: RobotChoice) -> None:
        self.robot.use_arm(choice.arm)
        self.robot.offer_moving(choice.moving)

    def _write(self, running: Running, if_there: IfThere) -> None:
        """Runs in a thread of the view's."""
        html = film_of(self._server, running, self._shared.shadow)
        recording = running.opened.recording
        try:
            path = write_page(html, recording.path, if_there)
        except FileInTheWayError as error:
            files = (InTheWay.of(error),)
            self._view.each(lambda one: one.show_in_the_way(recording.id, "page", files))
        else:
            self._view.each(lambda watcher: watcher.show_saved(path, "page"))

    def _show_playhead(self, playhead: Playhead) -> None:
        with self.client.atomic():
            self.stage.show_playhead(playhead)
            self.robot.show_playhead(playhead)
            self.parts.show_playhead(playhead)

    def _show_parts(self, hidden: frozenset[str]) -> None:
        self.robot.show_parts(hidden)
        self.stage.show_parts(hidden)
        self.spread.show_parts(hidden)
        self._settle()


REPLAY_DRAWN_EVERY_S = 0.048
"""Poses of a replay are drawn no more often than this."""
