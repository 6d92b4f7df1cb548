"""A workcell led by hand, in the scene of a page: robot, parts, the gizmo to drag, the force."""

import numpy as np
import viser

from keyphase.robot.pose import Placement
from keyphase.simulation.demonstrating.lead_through import LeadThroughState
from keyphase.simulation.part_shapes import Shape
from keyphase.web.scene.figures.force_arrow import ForceArrow
from keyphase.web.scene.figures.part_figures import PartFigures
from keyphase.web.scene.page_robot import PageRobot
from keyphase.web.scene.recording.viewpoint import viewpoint_with_robot
from keyphase.web.scene.replaying.lent_yumi import LentYumi
from keyphase.web.scene.stage import Stage
from keyphase.workbench.leading.session import LeadThroughSession
from keyphase.workbench.leading.status import LeadThroughStatus

ROOT = "/workcell"
GIZMO = f"{ROOT}/gizmo"
GIZMO_M = 0.14

_SEEN_M = 0.42


class WorkcellScene:
    """Takes the scene over while a workcell is open; runs in the thread that draws it."""

    def __init__(
        self, client: viser.ClientHandle, stage: Stage, robot: PageRobot, lead: LeadThroughSession
    ) -> None:
        self._client, self._stage, self._lead = client, stage, lead
        self._yumi = LentYumi(client, robot)
        self._parts: PartFigures | None = None
        self._arrow: ForceArrow | None = None
        self._gizmo: viser.TransformControlsHandle | None = None

    def open(self, status: LeadThroughStatus, shapes: tuple[Shape, ...]) -> None:
        """Clear the scene, then put the workcell into it."""
        state = status.running
        if state is None:
            return
        with self._client.atomic():
            self._client.scene.remove_by_name(ROOT)
            self._client.scene.add_frame(ROOT, show_axes=False)
            self._parts = PartFigures(self._client, f"{ROOT}/parts", shapes)
            self._yumi.take()
            self._arrow = ForceArrow(self._client, ROOT)
            self._gizmo = self._add_gizmo(state)
            self._draw(state)
            middle = state.parts["housing"][0] + [0.0, 0.0, 0.1]
            base, ground = Placement(), np.array([*middle[:2], 0.0])
            view = viewpoint_with_robot(middle, _SEEN_M, base)
            self._stage.cover(view, ground, _SEEN_M, base, status.workcell)
        self._client.flush()

    def draw(self, status: LeadThroughStatus) -> None:
        """Robot, parts and force as they are now."""
        if status.running is not None and self._gizmo is not None:
            with self._client.atomic():
                self._draw(status.running)

    def close(self) -> None:
        """Give the scene back."""
        if self._gizmo is None:
            return
        with self._client.atomic():
            self._gizmo = self._arrow = self._parts = None
            self._client.scene.remove_by_name(ROOT)
            self._yumi.give_back()
            self._stage.uncover()
        self._client.flush()

    def _draw(self, state: LeadThroughState) -> None:
        assert self._parts is not None
        assert self._arrow is not None
        sample = state.sample
        self._yumi.pose(sample.joints_rad)
        self._parts.pose(state.parts)
        self._arrow.show(sample.position_m, sample.force_N)

    def _add_gizmo(self, state: LeadThroughState) -> viser.TransformControlsHandle:
        gizmo = self._client.scene.add_transform_controls(
            GIZMO,
            scale=GIZMO_M,
            depth_test=False,
            position=state.sample.position_m,
            wxyz=state.sample.orientation_wxyz,
        )

        @gizmo.on_update
        async def _(event: viser.TransformControlsEvent) -> None:
            position, wxyz = np.array(event.target.position), np.array(event.target.wxyz)
            if event.phase != "end":
                self._lead.pull(position, wxyz)
            elif (held := self._lead.hold(position, wxyz)) is not None:
                gizmo.position, gizmo.wxyz = held

        return gizmo
