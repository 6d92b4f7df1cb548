"""The robot in the scene: it follows the playhead of whatever recording is open.

How its joints must move is worked out once for each recording, in a thread of its own. Where the
recording lies elsewhere in space the robot is put to where it reaches it, and a person can move it.
"""

import threading
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.errors import KeyphaseError
from keyphase.robot.arm import Arm
from keyphase.robot.description import RobotDescription
from keyphase.robot.follow import JointPath, posture_at
from keyphase.robot.placing import suggested_placement, within_reach
from keyphase.robot.pose import Placement
from keyphase.web.scene.robot_figure import RobotFigure
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.placing.joint_paths import JointPaths, OvertakenError, Task
from keyphase.workbench.placing.placements import forget_placement, save_placement, saved_placement
from keyphase.workbench.playback import Playhead
from keyphase.workbench.telling import Telling
from keyphase.workbench.worker import Worker

ROOT = "/robot"

_GIZMO_M = 0.35


class RobotView:
    """The robot of one server; `arms` are descriptions of the same robot with different tools.

    `on_stand` is called when the robot stands elsewhere than before, or has appeared or gone.
    """

    def __init__(
        self, server: viser.ViserServer, telling: Telling, arms: Sequence[RobotDescription]
    ) -> None:
        self.arms = tuple(Arm(robot) for robot in arms)
        self.figure = RobotFigure(server, arms[0], ROOT)
        self.figure.visible = False
        self.on_stand: Callable[[], None] = lambda: None
        self.paths = JointPaths(telling)
        self._server = server
        self._telling = telling
        self._lock = threading.RLock()
        self._worker = Worker(telling.report)
        self._task: Task | None = None
        self._path: JointPath | None = None
        self._arm = self.arms[0]
        self._playhead = Playhead()
        self._wanted = True
        self._lent = False
        self._gizmo: viser.TransformControlsHandle | None = None

    def close(self) -> None:
        """Stop working things out."""
        with self._lock:
            self._task = None
        self._worker.stop()
        self._worker.join()

    @property
    def base(self) -> Placement | None:
        """Where the robot stands in the scene, that is in the recording's frame, if it is shown."""
        with self._lock:
            task = self._task
            if task is None or task.placement is None or not self._wanted:
                return None
            return task.placement.inverse()

    @property
    def is_free(self) -> bool:
        """Whether nothing is being worked out."""
        return self._worker.is_free()

    def wait_until_idle(self, timeout_s: float) -> bool:
        """Whether everything there was to work out is worked out within `timeout_s`."""
        return self._worker.wait_until_idle(timeout_s)

    # -- what the session says

    def show_document(self, opened: DeskState) -> None:
        """Follow another recording; the same one with other segments changes nothing."""
        with self._lock:
            if self._task and self._task.demonstration is opened.demonstration:
                return
        self._begin(Task(opened, self._arm, self._known_placement(opened)))

    def show_playhead(self, playhead: Playhead) -> None:
        """Take the posture of that time."""
        with self._lock:
            self._playhead = playhead
            self._draw()

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Show or hide the robot."""
        with self._lock:
            before, self._wanted = self._wanted, "robot" not in hidden
            self._draw()
        if before != self._wanted:
            self.on_stand()

    # -- what a person does

    def use_arm(self, number: int) -> None:
        """Follow with another arm."""
        with self._lock:
            self._arm = self.arms[number]
            task = self._task
        if task is not None:
            self._begin(replace(task, arm=self._arm, placement=self._known_placement(task.opened)))

    def offer_moving(self, offered: bool) -> None:
        """Show or hide the gizmo by which the robot can be moved."""
        with self._lock:
            if self._gizmo is not None:
                self._gizmo.remove()
                self._gizmo = None
            task = self._task
            if offered and task is not None:
                self._gizmo = self._add_gizmo((task.placement or Placement()).inverse())

    def place_automatically(self) -> None:
        """Forget where a person put the robot."""
        with self._lock:
            task = self._task
        if task is not None:
            forget_placement(task.opened.recording.path)
            self._begin(replace(task, placement=None))

    def place(self, base: Placement) -> None:
        """Put the robot's base there, in the recording's frame, and keep that.

        Raises LabelingError where it cannot be kept.
        """
        with self._lock:
            task = self._task
        if task is not None:
            placement = base.inverse()
            save_placement(task.opened.recording.path, task.arm.robot.name, placement)
            self._begin(replace(task, placement=placement))

    # -- lending the figure

    def lend(self) -> RobotFigure:
        """The figure, for someone else to move until `take_back`."""
        with self._lock:
            self._lent = True
            self.figure.fade(False)
            return self.figure

    def take_back(self) -> None:
        """Follow the playhead again."""
        with self._lock:
            self._lent = False
            if self._task and self._task.placement:
                self.figure.stand(self._task.placement.inverse())
            self._draw()

    # -- working it out

    def _known_placement(self, opened: DeskState) -> Placement | None:
        """Where the recording is, if that is known without working it out."""
        try:
            saved = saved_placement(opened.recording.path, self._arm.robot.name)
        except KeyphaseError as error:
            self._telling.report(error)
            saved = None
        if saved is None and within_reach(self._arm, opened.demonstration, Placement()):
            return Placement()
        return saved

    def _begin(self, task: Task) -> None:
        with self._lock:
            self._task, self._path = task, self.paths.known(task)
            self._stand(task)
        self._worker.submit(lambda: self._work_out(task), "follow")
        self.on_stand()

    def _stand(self, task: Task) -> None:
        if task.placement is not None and not self._lent:
            base = task.placement.inverse()
            self.figure.stand(base)
            if self._gizmo is not None:
                self._gizmo.position = base.position_m
                self._gizmo.wxyz = base.orientation_wxyz
        self._draw()

    def _work_out(self, task: Task) -> None:
        if task.placement is None:
            found = suggested_placement(task.arm, task.demonstration)
            placed = replace(task, placement=found)
            if not self._replaced(task, placed):
                return
            self._telling.notice("info", _placed_sentence(task.opened.recording.name))
            self.on_stand()
            task = placed
        try:
            path = self.paths.path(task, lambda: self._task is task)
        except OvertakenError:
            return
        with self._lock:
            if self._task is task:
                self._path = path
                self._draw()

    def _replaced(self, task: Task, by: Task) -> bool:
        with self._lock:
            if self._task is not task:
                return False
            self._task = by
            self._stand(by)
            return True

    # -- drawing

    def _draw(self) -> None:
        """Show the posture of the playhead. Runs under the lock."""
        if self._lent:
            return
        task, path = self._task, self._path
        shown = self._wanted and task is not None and path is not None
        with self._server.atomic():
            if shown != self.figure.visible:
                self.figure.visible = shown
            if shown:
                assert task is not None
                assert path is not None
                joints, reached = posture_at(
                    task.arm, task.demonstration, path, self._playhead.time_s, task.placement
                )
                self.figure.pose(task.arm.robot, joints)
                self.figure.fade(not reached)

    def _add_gizmo(self, base: Placement) -> viser.TransformControlsHandle:
        gizmo = self._server.scene.add_transform_controls(
            "/robot_gizmo",
            scale=_GIZMO_M,
            depth_test=False,
            position=base.position_m,
            wxyz=base.orientation_wxyz,
        )

        @gizmo.on_update
        async def _(event: viser.TransformControlsEvent) -> None:
            base = _as_placement(event.target.position, event.target.wxyz)
            with self._lock:
                self.figure.stand(base)
            if event.phase == "end":
                self._worker.submit(lambda: self.place(base))

        return gizmo


def _as_placement(position: Array, wxyz: Array) -> Placement:
    x, y, z = np.asarray(position, dtype=np.float64).tolist()
    a, b, c, d = np.asarray(wxyz, dtype=np.float64).tolist()
    return Placement((x, y, z), (a, b, c, d))


def _placed_sentence(name: str) -> str:
    return (
        f"{name} lies out of the robot's reach, so the robot stands where it reaches more of it; "
        "move it under Robot in the panel."
    )
