"""The robot in the scene of one page: it follows the playhead of the recording that is open there.

How its joints must move is worked out once for each recording, in a thread that all pages share.
Where the recording lies elsewhere in space the robot is put to where it reaches it, and a person
can move it. Beside a recording that is not its own it is a ghost: the path is what is looked at.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import viser

from keyphase.demonstration import Array
from keyphase.errors import KeyphaseError
from keyphase.robot.arm import Arm
from keyphase.robot.follow import JointPath, posture_at
from keyphase.robot.placing import suggested_placement, within_reach
from keyphase.robot.pose import Placement
from keyphase.robot.recorded import recorded_path
from keyphase.simulation.choosing import recorded_in
from keyphase.web.scene.figures.robot_figure import RobotFigure
from keyphase.web.scene.shared import Shared
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.placing.joint_paths import OvertakenError, Task
from keyphase.workbench.placing.placements import forget_placement, save_placement, saved_placement
from keyphase.workbench.playback import Playhead
from keyphase.workbench.view import View

ROOT = "/robot"

_GIZMO_M = 0.35

Later = Callable[[Callable[[], None]], None]
"""Run something in the thread that draws the page's scene."""


class PageRobot:
    """The robot of one page. All but what is said to work elsewhere runs in the drawing thread.

    `on_stand` is called when the robot stands elsewhere than before, or has appeared or gone;
    `on_found` when it is known how it moves, or that this cannot be known.
    """

    def __init__(
        self,
        client: viser.ClientHandle,
        shared: Shared,
        view: View,
        later: Later,
        on_stand: Callable[[], None],
        on_found: Callable[[], None],
    ) -> None:
        self.figure = RobotFigure(client, shared.arms[0].robot, ROOT)
        self.figure.visible = False
        self._client, self._shared, self._telling = client, shared, view.telling
        self._later, self._on_stand, self._on_found = later, on_stand, on_found
        self._task: Task | None = None
        self._path: JointPath | None = None
        self._sought = False
        self._arm = shared.arms[0]
        self._own = True
        self._playhead = Playhead()
        self._wanted = True
        self._lent = False
        self._gizmo: viser.TransformControlsHandle | None = None

    @property
    def base(self) -> Placement | None:
        """Where the robot stands in the recording's frame, if it stands there as one does."""
        task = self._task
        if task is None or task.placement is None or not self._wanted or not self._own:
            return None
        return task.placement.inverse() if self._path is not None else None

    @property
    def is_awaited(self) -> bool:
        """Whether the recording's own robot is to be seen, and is not there yet."""
        return self._sought and self._path is None and self._own and self._wanted

    def close(self) -> None:
        """Want nothing worked out any more."""
        self._task = None

    # -- what the page shows

    def show_document(self, shown: DeskState) -> None:
        """Follow another recording; the same one with other segments changes nothing."""
        if self._task is None or self._task.demonstration is not shown.demonstration:
            self._own = is_own(shown, self._arm)
            self._begin(Task(shown, self._arm, self._known_placement(shown)))

    def clear(self) -> None:
        """Follow nothing: another recording is on its way."""
        self._task = self._path = None
        self._sought = False
        self._draw()

    def show_playhead(self, playhead: Playhead) -> None:
        """Take the posture of that time."""
        self._playhead = playhead
        self._draw()

    def show_parts(self, hidden: frozenset[str]) -> None:
        """Show or hide the robot."""
        before, self._wanted = self._wanted, "robot" not in hidden
        self._draw()
        if before != self._wanted:
            self._on_stand()

    # -- what a person does

    def use_arm(self, name: str) -> None:
        """Follow with the arm whose tool has that name."""
        arm = next((arm for arm in self._shared.arms if arm.robot.tool_frame == name), self._arm)
        if arm is not self._arm:
            self._arm = arm
            if (task := self._task) is not None:
                self._own = is_own(task.opened, arm)
                self._begin(replace(task, arm=arm, placement=self._known_placement(task.opened)))

    def offer_moving(self, offered: bool) -> None:
        """Show or hide the gizmo by which the robot can be moved."""
        if offered == (self._gizmo is not None):
            return
        if self._gizmo is not None:
            self._gizmo.remove()
            self._gizmo = None
        elif self._task is not None:
            self._gizmo = self._add_gizmo((self._task.placement or Placement()).inverse())

    def place_automatically(self) -> None:
        """Forget where a person put the robot."""
        if (task := self._task) is not None:
            forget_placement(task.opened.recording.path)
            self._begin(replace(task, placement=None))

    def place(self, base: Placement) -> None:
        """Put the robot's base there, in the recording's frame, and keep that.

        Raises LabelingError where it cannot be kept.
        """
        if (task := self._task) is not None:
            placement = base.inverse()
            save_placement(task.opened.recording.path, task.arm.robot.name, placement)
            self._begin(replace(task, placement=placement))

    # -- lending the figure

    def lend(self) -> RobotFigure:
        """The figure, for someone else to move until `take_back`."""
        self._lent = True
        self.figure.be("solid")
        return self.figure

    def take_back(self) -> None:
        """Follow the playhead again."""
        self._lent = False
        if self._task and self._task.placement:
            self.figure.stand(self._task.placement.inverse())
        self._draw()

    # -- working it out

    def _known_placement(self, shown: DeskState) -> Placement | None:
        """Where the recording is, if that is known without working it out."""
        try:
            saved = saved_placement(shown.recording.path, self._arm.robot.name)
        except KeyphaseError as error:
            self._telling.report(error)
            saved = None
        if saved is None and within_reach(self._arm, shown.demonstration, Placement()):
            return Placement()
        return saved

    def _begin(self, task: Task) -> None:
        self._task, self._path = task, self._shared.paths.known(task)
        self._sought = True
        if not self._lent:
            # Before it is seen: a browser that draws in software takes a while for it.
            self.figure.be("solid" if self._own else "ghost")
        self._stand(task)
        self._shared.joints.submit(lambda: self._work_out(task), f"robot of {id(self)}")
        self._on_stand()

    def _stand(self, task: Task) -> None:
        if task.placement is not None and not self._lent:
            base = task.placement.inverse()
            self.figure.stand(base)
            if self._gizmo is not None:
                self._gizmo.position = base.position_m
                self._gizmo.wxyz = base.orientation_wxyz
        self._draw()

    def _work_out(self, task: Task) -> None:
        """Runs in the thread that all pages share."""
        if self._task is not task:
            return
        placed = task
        if task.placement is None:
            placed = replace(task, placement=suggested_placement(task.arm, task.demonstration))
        try:
            path = self._shared.paths.path(placed, lambda: self._task is task, self._telling)
        except OvertakenError:
            return
        except Exception as error:
            self._telling.report(error)
            self._later(lambda: self._give_up(task))
            return
        self._later(lambda: self._found(task, placed, path))

    def _found(self, task: Task, placed: Task, path: JointPath) -> None:
        if self._task is not task:
            return
        if placed is not task and self._own:
            self._telling.notice("info", _placed_sentence(task.opened.recording.name))
        self._task, self._path = placed, path
        self._stand(placed)
        self._on_stand()
        self._on_found()

    def _give_up(self, task: Task) -> None:
        if self._task is task:
            self._sought = False
            self._on_found()

    # -- drawing

    def _draw(self) -> None:
        """Show the posture of the playhead."""
        if self._lent:
            return
        task, path = self._task, self._path
        shown = self._wanted and task is not None and path is not None
        with self._client.atomic():
            if task is not None and path is not None and shown:
                joints, reached = posture_at(
                    task.arm, task.demonstration, path, self._playhead.time_s, task.placement
                )
                self.figure.pose(task.arm.robot, joints)
                self.figure.be("ghost" if not self._own else "solid" if reached else "faded")
            if shown != self.figure.visible:
                self.figure.visible = shown

    def _add_gizmo(self, base: Placement) -> viser.TransformControlsHandle:
        gizmo = self._client.scene.add_transform_controls(
            "/robot_gizmo",
            scale=_GIZMO_M,
            depth_test=False,
            position=base.position_m,
            wxyz=base.orientation_wxyz,
        )

        @gizmo.on_update
        async def _(event: viser.TransformControlsEvent) -> None:
            base = _as_placement(event.target.position, event.target.wxyz)
            self._later(lambda: self.figure.stand(base))
            if event.phase == "end":
                self._later(lambda: self.place(base))

        return gizmo


def is_own(shown: DeskState, arm: Arm) -> bool:
    """Whether a recording was made by the robot that is shown, or in a workcell of ours."""
    demonstration = shown.demonstration
    made_here = recorded_in(demonstration) is not None
    return made_here or recorded_path(arm, demonstration) is not None


def _as_placement(position: Array, wxyz: Array) -> Placement:
    x, y, z = np.asarray(position, dtype=np.float64).tolist()
    a, b, c, d = np.asarray(wxyz, dtype=np.float64).tolist()
    return Placement((x, y, z), (a, b, c, d))


def _placed_sentence(name: str) -> str:
    return (
        f"{name} lies out of the robot's reach, so the robot stands where it reaches more of it; "
        "move it under Robot in the panel."
    )
