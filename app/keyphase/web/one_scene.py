"""One 3D scene for one page at a time: it shows the view of the page that came last."""

from collections.abc import Callable, Sequence

import viser

from keyphase.robot.description import RobotDescription
from keyphase.simulation.shapes import Shape
from keyphase.web.scene.ground_shadow import shadow_of
from keyphase.web.scene.parts_view import PartsView
from keyphase.web.scene.replay_scene import ReplayScene
from keyphase.web.scene.robot_view import RobotView
from keyphase.web.scene.scene import Scene
from keyphase.web.scene.workcell_scene import WorkcellScene
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.leading.status import LeadThroughStatus
from keyphase.workbench.placing.robot_choice import RobotChoice
from keyphase.workbench.playback import Playhead
from keyphase.workbench.replaying.run import Tick
from keyphase.workbench.replaying.running import Running
from keyphase.workbench.telling import in_words
from keyphase.workbench.view import View
from keyphase.workbench.watcher import Watcher
from keyphase.workbench.worker import Worker


class OneScene(Watcher):
    """Hands what a view tells to a painter's thread, which skips what is no longer true."""

    def __init__(
        self, server: viser.ViserServer, view: View, arms: Sequence[RobotDescription]
    ) -> None:
        self.view = view
        self._painter = Worker(in_words)
        self.robot = RobotView(server, view.telling, arms)
        self.scene = Scene(server, view.select_at, lambda: self.robot.base, shadow_of(arms[0]))
        self.parts = PartsView(server, view.telling)
        self.robot.on_stand = self.scene.stand_anew
        self.replay = ReplayScene(server, self.scene, self.robot, view)
        self.workcell = WorkcellScene(server, self.scene, self.robot, view.lead)
        self._arms = tuple(arm.robot.tool_frame for arm in self.robot.arms)
        self._choice = view.scene.robot
        view.watch(self)

    def close(self) -> None:
        """Draw no more."""
        self.view.unwatch(self)
        self._painter.stop()
        self._painter.join()
        self.replay.close()
        self.robot.close()
        self.parts.close()

    def turn_to(self, view: View) -> None:
        """Show the view of another page."""
        if view is self.view:
            return
        self.view.unwatch(self)
        self.view = view
        self.replay.view = view
        self.workcell.turn_to(view.lead)
        view.watch(self)

    def wait_until_shown(self, timeout_s: float) -> bool:
        """Whether everything that was told is drawn within `timeout_s`."""
        return self._painter.wait_until_idle(timeout_s)

    def _paint(self, kind: str, *acts: Callable[[], None]) -> None:
        for number, act in enumerate(acts):
            self._painter.submit(act, f"{kind} in {number}")

    def show_document(self, state: DeskState) -> None:
        """The robot first: where it stands decides how the scene is seen."""
        self._paint(
            "document",
            lambda: self.robot.show_document(state),
            lambda: self.scene.show_document(state),
            lambda: self.parts.show_document(state),
        )

    def show_playhead(self, playhead: Playhead) -> None:
        """Robot, tool and parts as they were then."""
        self._paint(
            "playhead",
            lambda: self.robot.show_playhead(playhead),
            lambda: self.scene.show_playhead(playhead),
            lambda: self.parts.show_playhead(playhead),
        )

    def show_selection(self, segment: int | None) -> None:
        """The selected segment is drawn thicker."""
        self._paint("selection", lambda: self.scene.show_selection(segment))

    def show_parts(self, hidden: frozenset[str]) -> None:
        """What is shown and hidden."""
        self._paint(
            "parts",
            lambda: self.robot.show_parts(hidden),
            lambda: self.scene.show_parts(hidden),
        )

    def show_theme(self, dark: bool) -> None:
        """Light or dark."""
        self._paint("theme", lambda: self.scene.show_theme(dark))

    def show_robot(self, choice: RobotChoice) -> None:
        """The arm that follows, and the gizmo of its base."""
        before, self._choice = self._choice, choice
        if choice.arm != before.arm:
            self._paint("arm", lambda: self.robot.use_arm(self._arms.index(choice.arm)))
        if choice.moving != before.moving:
            self._paint("gizmo", lambda: self.robot.offer_moving(choice.moving))

    def place_robot(self) -> None:
        """Where it reaches most."""
        self._paint("place", self.robot.place_automatically)

    def show_begun(self, running: Running) -> None:
        """The scene is the replay's now."""
        self.replay.show_begun(running)

    def show_tick(self, running: Running, tick: Tick) -> None:
        """It has come to here."""
        self.replay.show_tick(running, tick)

    def show_status(self, running: Running) -> None:
        """It stands still, or goes on."""
        self.replay.show_status(running)

    def show_replay_closed(self) -> None:
        """The scene is the recording's again."""
        self.replay.show_closed()

    def show_push(self, offered: bool) -> None:
        """The gizmo that pushes."""
        self.replay.offer_push(offered)

    def write_replay(self, running: Running) -> None:
        """As a page of its own."""
        self.replay.share(running)

    def show_workcell(self, status: LeadThroughStatus, shapes: tuple[Shape, ...]) -> None:
        """The scene is the workcell's now."""
        self.workcell.show_workcell(status, shapes)

    def show_workcell_status(self, status: LeadThroughStatus) -> None:
        """It is like this now."""
        self.workcell.show_status(status)

    def show_workcell_closed(self) -> None:
        """The scene is the recording's again."""
        self.workcell.show_closed()
