"""The controls of recording, replay, trials and robot: what pages ask of them and are told."""

import threading
import time
from collections.abc import Callable
from dataclasses import replace

import msgspec
from msgspec import UNSET, Struct

from keyphase.errors import RequestError
from keyphase.simulation.shapes import Shape
from keyphase.web.protocol import requests as ask
from keyphase.web.protocol.control_messages import (
    PushMessage,
    RobotMessage,
    TrialsMessage,
    record_message,
    replay_settings_message,
)
from keyphase.web.scene.replay_scene import ReplayScene
from keyphase.web.scene.replay_view import ReplayView
from keyphase.web.scene.robot_view import RobotView
from keyphase.workbench.lead_through_session import (
    LeadThroughSession,
    LeadThroughStatus,
    LeadThroughView,
)
from keyphase.workbench.replay_session import ReplaySession
from keyphase.workbench.replay_settings import ReplaySettings
from keyphase.workbench.replay_trials import TrialsRun
from keyphase.workbench.session import Controlling

TOLD_EVERY_S = 0.1
"""Numbers of a recording are told so often."""

Tell = Callable[[Struct], None]


class RecordTeller(LeadThroughView):
    """Tells pages of a recording: what can be done at once, numbers ten times a second."""

    def __init__(self, tell: Tell) -> None:
        self._tell = tell
        self._lock = threading.Lock()
        self._told_at = 0.0
        self._told: tuple[object, ...] = ()

    def show_workcell(self, status: LeadThroughStatus, shapes: tuple[Shape, ...]) -> None:  # noqa: ARG002
        """A workcell was opened."""
        self.show_status(status)

    def show_status(self, status: LeadThroughStatus) -> None:
        """How it stands now."""
        stands = (status.workcell, status.recording, status.can_undo, status.can_redo)
        with self._lock:
            now = time.monotonic()
            soon = now - self._told_at < TOLD_EVERY_S or status.running is None
            if stands == self._told and soon:
                return
            self._told, self._told_at = stands, now
        self._tell(record_message(status))


class Controls(ReplayView, Controlling):
    """Does what pages ask, and tells all of them how it stands."""

    def __init__(
        self,
        tell: Tell,
        lead: LeadThroughSession,
        replay: ReplaySession,
        scene: ReplayScene,
        robot: RobotView,
    ) -> None:
        self._tell = tell
        self._lead, self._replay, self._scene, self._robot = lead, replay, scene, robot
        self._pushing = self._moving = False
        self._arm = robot.arms[0].robot.tool_frame

    # -- what a page that has come is told

    def greet(self, tell: Tell) -> None:
        """How all controls stand."""
        tell(record_message(self._lead.status()))
        tell(replay_settings_message(self._replay.settings))
        tell(PushMessage(self._pushing))
        tell(self._robot_message())

    # -- what pages ask

    def record(self, request: ask.Record) -> None:
        """Open, close, start, stop, take back."""
        lead = self._lead
        match request.do:
            case "open":
                lead.open(_named(request))
            case "start":
                lead.record(_named(request))
            case "close":
                lead.close()
            case "stop":
                lead.stop()
            case "reset":
                lead.reset()
            case "undo_take":
                lead.undo_take()
            case "redo_take":
                lead.redo_take()

    def choose(self, request: ask.ReplaySettings) -> None:
        """Choose the world of the next replay."""
        chosen = {
            name: value
            for name, value in msgspec.structs.asdict(request).items()
            if value is not UNSET
        }
        self._replay.configure(lambda settings: replace(settings, **chosen))

    def push(self, offered: bool) -> None:
        """Show or hide the gizmo that pushes the tool."""
        self._pushing = offered
        self._scene.offer_push(offered)
        self._tell(PushMessage(offered))

    def move_robot(self, request: ask.Robot) -> None:
        """Another arm, the gizmo of its base, its own place."""
        names = self._arm_names()
        if request.arm is not None:
            if request.arm not in names:
                raise RequestError(f"There are the arms {', '.join(names)}, but no other.")
            self._arm = request.arm
            self._robot.use_arm(names.index(request.arm))
        if request.moving is not None:
            self._moving = request.moving
            self._robot.offer_moving(request.moving)
        if request.place is not None:
            self._robot.place_automatically()
        self._tell(self._robot_message())

    def share(self) -> None:
        """Write the replay that is over as a page of its own."""
        self._scene.share()

    # -- what is told

    def show_settings(self, settings: ReplaySettings) -> None:
        """These were chosen."""
        self._tell(replay_settings_message(settings))

    def show_trials(self, trials: TrialsRun) -> None:
        """Trials on the way, or over."""
        self._tell(TrialsMessage(**{name: getattr(trials, name) for name in _TRIALS}))

    def _arm_names(self) -> tuple[str, ...]:
        return tuple(arm.robot.tool_frame for arm in self._robot.arms)

    def _robot_message(self) -> RobotMessage:
        return RobotMessage(self._arm_names(), self._arm, self._moving)


_TRIALS = TrialsMessage.__struct_fields__


def _named(request: ask.Record) -> str:
    if request.workcell is None:
        raise RequestError(f"A request to {request.do} recording must name a workcell.")
    return request.workcell
