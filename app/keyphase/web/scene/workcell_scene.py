"""A workcell led by hand, in the scene: robot, parts, the gizmo to drag, the force."""

import numpy as np
import viser

from keyphase.robot.arm import Arm
from keyphase.robot.pose import Placement
from keyphase.robot.yumi import yumi
from keyphase.simulation.demonstrating.lead_through import LeadThroughState
from keyphase.simulation.shapes import Shape
from keyphase.web.scene.force_arrow import ForceArrow
from keyphase.web.scene.part_figures import PartFigures
from keyphase.web.scene.robot_figure import RobotFigure
from keyphase.web.scene.robot_view import RobotView
from keyphase.web.scene.scene import Scene
from keyphase.workbench.leading.session import LeadThroughSession
from keyphase.workbench.leading.status import LeadThroughStatus

ROOT = "/workcell"
GIZMO = f"{ROOT}/gizmo"
GIZMO_M = 0.14

_SEEN_M = 0.42


class WorkcellScene:
    """Takes the scene over while a workcell is open; called by one thread at a time."""

    def __init__(
        self,
        server: viser.ViserServer,
        scene: Scene,
        robot: RobotView,
        session: LeadThroughSession,
    ) -> None:
        self._server, self._scene, self._robot, self._session = server, scene, robot, session
        self._arm = Arm(yumi())
        self._own_figure: RobotFigure | None = None
        self._figure: RobotFigure | None = None
        self._parts: PartFigures | None = None
        self._arrow: ForceArrow | None = None
        self._gizmo: viser.TransformControlsHandle | None = None

    def turn_to(self, session: LeadThroughSession) -> None:
        """Be led by another page."""
        self._session = session

    def show_workcell(self, status: LeadThroughStatus, shapes: tuple[Shape, ...]) -> None:
        """Clear the scene, then put the workcell into it."""
        state = status.running
        assert state is not None
        with self._server.atomic():
            self._server.scene.add_frame(ROOT, show_axes=False)
            self._parts = PartFigures(self._server, f"{ROOT}/parts", shapes)
            self._figure = self._lent_figure()
            self._figure.stand(Placement())
            self._figure.visible = True
            self._arrow = ForceArrow(self._server, ROOT)
            self._gizmo = self._add_gizmo(state)
            self._draw(state)
            self._scene.cover(state.parts["housing"][0] + [0.0, 0.0, 0.1], _SEEN_M)
        self._server.flush()

    def show_status(self, status: LeadThroughStatus) -> None:
        """Robot, parts and force as they are now."""
        if status.running is not None and self._gizmo is not None:
            with self._server.atomic():
                self._draw(status.running)

    def show_closed(self) -> None:
        """Give the scene back."""
        with self._server.atomic():
            self._gizmo = self._arrow = self._parts = None
            self._server.scene.remove_by_name(ROOT)
            if self._own_figure is not None:
                self._own_figure.visible = False
            self._robot.take_back()
            self._scene.uncover()
        self._server.flush()

    def _lent_figure(self) -> RobotFigure:
        """The YuMi that is in the scene already; one of our own where another robot is shown."""
        lent = self._robot.lend()
        if set(lent.links) <= set(self._arm.robot.links):
            return lent
        lent.visible = False
        if self._own_figure is None:
            self._own_figure = RobotFigure(self._server, self._arm.robot, "/yumi")
        return self._own_figure

    def _draw(self, state: LeadThroughState) -> None:
        assert self._figure is not None
        assert self._parts is not None
        assert self._arrow is not None
        sample = state.sample
        self._figure.pose(self._arm.robot, sample.joints_rad)
        self._parts.pose(state.parts)
        self._arrow.show(sample.position_m, sample.force_N)

    def _add_gizmo(self, state: LeadThroughState) -> viser.TransformControlsHandle:
        gizmo = self._server.scene.add_transform_controls(
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
                self._session.pull(position, wxyz)
            elif (held := self._session.hold(position, wxyz)) is not None:
                gizmo.position, gizmo.wxyz = held

        return gizmo
