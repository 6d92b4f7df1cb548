"""A replay in the scene of a page: robot, parts, the demonstrated path as ghost, what was run."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.simulation.replay.result import ReplayState
from keyphase.simulation.simulation import Simulation
from keyphase.web.scene.figures.force_arrow import ForceArrow
from keyphase.web.scene.figures.part_figures import PartFigures
from keyphase.web.scene.page_robot import PageRobot
from keyphase.web.scene.replaying.lent_yumi import LentYumi
from keyphase.web.scene.replaying.replay_paths import ReplayPaths
from keyphase.web.scene.replaying.replay_push import PushGizmo
from keyphase.web.scene.replaying.seen_replay import arrow_scale, seen_replay
from keyphase.web.scene.stage import Stage
from keyphase.workbench.replaying.plan_paths import middle_of_skill
from keyphase.workbench.replaying.run import Tick
from keyphase.workbench.replaying.running import Running

PartPoses = Mapping[str, tuple[Array, Array]]

ROOT = "/replay"


@dataclass
class Drawn:
    """What stands in the scene for one replay.

    named  whether skill and force are labels of the scene: a page lays its own over it
    """

    running: Running
    parts: PartFigures
    paths: ReplayPaths
    arrow: ForceArrow
    name: viser.LabelHandle
    skill: int | None = None
    named: bool = False

    def label(self) -> None:
        """Let skill and force be labels of the scene, for where no page lays its own over it."""
        self.named = True
        self.arrow.label(True)

    def draw(self, state: ReplayState, parts: PartPoses) -> None:
        """Parts, force and path as they are in `state`."""
        sample = state.sample
        self.parts.pose(parts)
        self.arrow.show(sample.position_m, sample.force_N)
        self._draw_skill(state.skill)
        self.paths.follow(sample.position_m, state.skill)

    def _draw_skill(self, skill: int | None) -> None:
        """The skill that runs is drawn thicker, and named where it is to be."""
        before, self.skill = self.skill, skill
        if before == skill:
            return
        planned = self.running.plan.planned
        self.paths.highlight(before, skill)
        self.name.visible = self.named and skill is not None
        if skill is not None:
            self.name.text = planned[skill].name
            self.name.position = middle_of_skill(self.running.plan, planned[skill].skill)


class ReplayScene:
    """Takes the scene over while a replay is shown; runs in the thread that draws it."""

    def __init__(
        self,
        client: viser.ClientHandle,
        stage: Stage,
        robot: PageRobot,
        push: Callable[[Array], None],
    ) -> None:
        self._client, self._stage, self._push = client, stage, push
        self._yumi = LentYumi(client, robot)
        self._shown: Drawn | None = None
        self._gizmo: PushGizmo | None = None
        self._tool_m = np.zeros(3)
        self._offered = False

    def offer_push(self, offered: bool) -> None:
        """Show or hide the gizmo that pushes the tool."""
        self._offered = offered
        self._show_gizmo()

    def begin(self, running: Running) -> None:
        """Clear the scene, then put the workcell and the plan into it."""
        with self._client.atomic():
            self._remove_drawn()
            simulation = running.run.replay.simulation
            self._yumi.take(runs=isinstance(simulation, Simulation))
            self._shown = put_up(self._client, running)
            if isinstance(simulation, Simulation):
                self._yumi.pose(simulation.posture_rad)
            seen = seen_replay(running)
            self._stage.cover(seen.view, seen.ground_m, seen.size_m, seen.base, running)
            self._tool_m = simulation.here().position_m
            self._show_gizmo()
        self._client.flush()

    def draw(self, running: Running, tick: Tick) -> None:
        """Everything as it is now."""
        shown = self._shown
        if shown is None or shown.running.number != running.number:
            return
        with self._client.atomic():
            self._yumi.pose(tick.state.sample.joints_rad)
            shown.draw(tick.state, tick.parts)
            self._tool_m = tick.state.sample.position_m
            if self._gizmo is not None:
                self._gizmo.follow(self._tool_m)

    def end(self) -> None:
        """Give the scene back."""
        if self._shown is None:
            return
        with self._client.atomic():
            self._remove_drawn()
            self._yumi.give_back()
            self._stage.uncover()
        self._client.flush()

    def _remove_drawn(self) -> None:
        self._shown = None
        if self._gizmo is not None:
            self._gizmo.remove()
            self._gizmo = None
        self._client.scene.remove_by_name(ROOT)

    def _show_gizmo(self) -> None:
        wanted = self._offered and self._shown is not None
        if wanted and self._gizmo is None:
            self._gizmo = PushGizmo(self._client, f"{ROOT}/push", self._tool_m, self._push)
        elif not wanted and self._gizmo is not None:
            self._gizmo.remove()
            self._gizmo = None


def put_up(client: viser.ClientHandle, running: Running) -> Drawn:
    """Draw parts, paths and force of a replay, as they are at its start; the robot is apart."""
    scene, seen = client.scene, seen_replay(running)
    scene.add_frame(ROOT, show_axes=False)
    drawn = Drawn(
        running,
        PartFigures(client, f"{ROOT}/parts", running.shapes),
        ReplayPaths(client, ROOT, running.plan, seen.thickness),
        ForceArrow(client, ROOT, arrow_scale(running)),
        scene.add_label(f"{ROOT}/name", "", visible=False, anchor="center-right"),
    )
    drawn.parts.pose(running.run.replay.simulation.start_parts)
    return drawn
