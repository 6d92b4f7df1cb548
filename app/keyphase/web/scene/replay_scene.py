"""A replay in the scene: robot and parts, the demonstrated path as ghost, the path that was run.

It is drawn in a thread of its own that skips poses which are no longer true, so that the replay
never waits for the scene.
"""

import time
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.simulation.replay.result import Frame, ReplayResult, ReplayState
from keyphase.simulation.replay.shared_page import with_summary
from keyphase.skills.execution.executor import STEP_S
from keyphase.web.scene.force_arrow import ForceArrow
from keyphase.web.scene.lent_yumi import LentYumi
from keyphase.web.scene.part_figures import PartFigures
from keyphase.web.scene.replay_paths import ReplayPaths
from keyphase.web.scene.replay_push import PushGizmo
from keyphase.web.scene.robot_view import RobotView
from keyphase.web.scene.scene import Scene
from keyphase.workbench.replaying.exports import write_page
from keyphase.workbench.replaying.plan_paths import middle_of_skill, path_of_skill
from keyphase.workbench.replaying.run import Tick
from keyphase.workbench.replaying.running import Running
from keyphase.workbench.view import View
from keyphase.workbench.worker import Worker

PartPoses = Mapping[str, tuple[Array, Array]]

ROOT = "/replay"

FRAME_S = 0.04
"""Between two frames of a result."""

DRAWN_EVERY_S = 0.048
"""The scene is told new poses no more often than this."""

_SEEN_M = 0.36


@dataclass
class _Shown:
    """What stands in the scene for one replay."""

    running: Running
    parts: PartFigures
    paths: ReplayPaths
    arrow: ForceArrow
    name: viser.LabelHandle
    skill: int | None = None
    named: bool = False

    def label(self, wanted: bool) -> None:
        """Whether skill and force are labels of the scene: the page lays its own over it."""
        self.named = wanted
        self.name.visible = wanted and self.skill is not None
        self.arrow.label(wanted)


class ReplayScene:
    """Takes the scene over while a replay is shown."""

    def __init__(
        self,
        server: viser.ViserServer,
        scene: Scene,
        robot: RobotView,
        view: View,
    ) -> None:
        self._server, self._scene, self.view = server, scene, view
        self._yumi = LentYumi(server, robot)
        self._painter = Worker(view.telling.report)
        self._shown: _Shown | None = None
        self._gizmo: PushGizmo | None = None
        self._tool_m = np.zeros(3)
        self._shown_s = 0.0
        self._offered = False

    def close(self) -> None:
        """Draw no more."""
        self._painter.stop()
        self._painter.join()

    def offer_push(self, offered: bool) -> None:
        """Show or hide the gizmo that pushes the tool."""
        self._offered = offered
        self._painter.submit(self._show_gizmo, "gizmo")

    def share(self, running: Running) -> None:
        """Write the replay that is over as one page that opens without a server."""
        self._painter.submit(lambda: self._share(running))

    # -- what the session says

    def show_begun(self, running: Running) -> None:
        """Clear the scene, then put the workcell and the plan into it."""
        self._painter.submit(lambda: self._build(running))

    def show_tick(self, running: Running, tick: Tick) -> None:
        """Everything as it is now, unless it was drawn just before."""
        now = time.perf_counter()
        if now - self._shown_s >= DRAWN_EVERY_S:
            self._shown_s = now
            self._painter.submit(lambda: self._draw(running, tick), "tick")

    def show_status(self, running: Running) -> None:
        """Where it stands still all is drawn as it is then."""
        replay = running.run.replay
        if running.phase != "running" and replay.states:
            tick = Tick(replay.state, replay.simulation.part_poses())
            self._painter.submit(lambda: self._draw(running, tick), "tick")

    def show_closed(self) -> None:
        """Give the scene back."""
        self._painter.submit(self._remove)

    # -- drawing, in the painter's thread

    def _build(self, running: Running) -> None:
        scene = self._server.scene
        with self._server.atomic():
            scene.add_frame(ROOT, show_axes=False)
            self._yumi.take()
            self._shown = _Shown(
                running,
                PartFigures(self._server, f"{ROOT}/parts", running.shapes),
                ReplayPaths(self._server, ROOT, running.plan),
                ForceArrow(self._server, ROOT),
                scene.add_label(f"{ROOT}/name", "", visible=False, anchor="center-right"),
            )
            path = np.concatenate(
                [path_of_skill(running.plan, one.skill) for one in running.plan.planned]
            )
            middle = 0.5 * (path.min(axis=0) + path.max(axis=0))
            simulation = running.run.replay.simulation
            self._yumi.pose(np.array(simulation.posture_rad))
            self._shown.parts.pose(simulation.start_parts)
            self._scene.cover(middle, _SEEN_M)
            self._tool_m = simulation.here().position_m
            self._show_gizmo()
        self._server.flush()

    def _draw(self, running: Running, tick: Tick) -> None:
        shown = self._shown
        if shown is None or shown.running.number != running.number:
            return
        with self._server.atomic():
            self._draw_state(shown, tick.state, tick.parts)
            self._tool_m = tick.state.sample.position_m
            if self._gizmo is not None:
                self._gizmo.follow(self._tool_m)

    def _draw_state(self, shown: _Shown, state: ReplayState, parts: PartPoses) -> None:
        sample = state.sample
        self._yumi.pose(sample.joints_rad)
        shown.parts.pose(parts)
        shown.arrow.show(sample.position_m, sample.force_N)
        self._draw_skill(shown, state.skill)
        shown.paths.follow(sample.position_m, state.skill)

    def _draw_skill(self, shown: _Shown, skill: int | None) -> None:
        """The skill that runs is drawn thicker, and named where it is to be."""
        before, shown.skill = shown.skill, skill
        if before == skill:
            return
        planned = shown.running.plan.planned
        shown.paths.highlight(before, skill)
        shown.name.visible = shown.named and skill is not None
        if skill is not None:
            shown.name.text = planned[skill].name
            shown.name.position = middle_of_skill(shown.running.plan, planned[skill].skill)

    def _remove(self) -> None:
        if self._shown is None:
            return
        with self._server.atomic():
            self._shown = None
            if self._gizmo is not None:
                self._gizmo.remove()
                self._gizmo = None
            self._server.scene.remove_by_name(ROOT)
            self._yumi.give_back()
            self._scene.uncover()
        self._server.flush()

    def _share(self, running: Running) -> None:
        """Show the replay once more, all within one message, to whoever writes messages down."""
        shown, result = self._shown, running.result
        if shown is None or result is None:
            return
        with self._server.atomic():
            shown.paths.forget_run()
            shown.label(True)
            film = self._server.get_scene_serializer()
            for frame in result.frames:
                self._draw_state(shown, state_at(result, frame.time_s), parts_in(result, frame))
                film.insert_sleep(FRAME_S)
        page = film.as_html(dark_mode=False)
        shown.label(False)
        page = with_summary(page, result, running.plan.demonstration)
        path = write_page(page, running.opened.recording.path)
        self.view.each(lambda watcher: watcher.show_saved(path, "page"))

    def _show_gizmo(self) -> None:
        wanted = self._offered and self._shown is not None
        if wanted and self._gizmo is None:
            push = self.view.replay.push
            self._gizmo = PushGizmo(self._server, f"{ROOT}/push", self._tool_m, push)
        elif not wanted and self._gizmo is not None:
            self._gizmo.remove()
            self._gizmo = None


def state_at(result: ReplayResult, time_s: float) -> ReplayState:
    """The tick nearest to a time."""
    return result.states[min(round(time_s / STEP_S), len(result.states) - 1)]


def parts_in(result: ReplayResult, frame: Frame) -> PartPoses:
    """Where everything that is no link of the robot was."""
    poses = zip(result.bodies, frame.position_m, frame.orientation_wxyz, strict=True)
    return {name: (position, wxyz) for name, position, wxyz in poses}
