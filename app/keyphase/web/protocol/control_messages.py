"""What the page draws as controls: recording by hand, the world of a replay, trials, the robot."""

from typing import get_args

import numpy as np
from msgspec import Struct

from keyphase.simulation.recorded.cell import RecordedCell
from keyphase.simulation.workcells.registry import workcell, workcell_names
from keyphase.workbench.footage import LentFootage
from keyphase.workbench.leading.status import LeadThroughStatus
from keyphase.workbench.recordings import printable
from keyphase.workbench.replaying.margin import MarginRun
from keyphase.workbench.replaying.settings import RANGES, EndBy, ReplaySettings
from keyphase.workbench.replaying.trials import TrialsRun

FULL_FORCE_N = 20.0
"""The force at which the bar beside a recording is full."""


class WorkcellChoice(Struct, frozen=True):
    """A workcell that can be chosen."""

    name: str
    title: str


class RecordMessage(Struct, frozen=True, tag_field="type", tag="record"):
    """Recording by hand: which workcell is open, and how its take goes.

    workcell    name of the open one; null where none is
    recorded_s  length of the take so far; null where none is recorded
    force_N     what the wrist measures; null where no workcell is open
    newest      of a take: where the tool is [m] and the force on it [N], base frame, x y z each
    """

    workcell: str | None
    choices: tuple[WorkcellChoice, ...]
    recording: bool
    recorded_s: float | None
    force_N: float | None
    full_force_N: float
    can_undo: bool
    can_redo: bool
    newest: tuple[float, float, float, float, float, float] | None = None


class ReplaySettingsMessage(Struct, frozen=True, tag_field="type", tag="replay_settings"):
    """The world of the next replay, and what can be chosen."""

    workcell: str
    part_height_m: float
    part_aside_m: float
    friction: float
    sensor_noise: float
    end_by: EndBy
    speed: float
    choices: tuple[WorkcellChoice, ...]
    ends: tuple[str, ...]
    ranges: dict[str, tuple[float, float]]


class PushMessage(Struct, frozen=True, tag_field="type", tag="push"):
    """Whether the gizmo that pushes the tool is shown while a replay runs."""

    offered: bool


class TrialsMessage(Struct, frozen=True, tag_field="type", tag="trials_run"):
    """Trials on the way, or what came of them.

    outcome  in one line, once they are over
    svg      their picture; null on the way, and where they were cancelled
    """

    count: int
    done: int
    over: bool = False
    title: str = ""
    outcome: str | None = None
    svg: str | None = None


class MarginMessage(Struct, frozen=True, tag_field="type", tag="margin_run"):
    """A margin being tried, or what came of it.

    done, count  axes of all plans that were tried, and how many there are
    outcome      how far the plan reaches beside others, once it is over
    svg          its picture; null on the way, and where it was cancelled
    """

    count: int
    done: int
    over: bool = False
    title: str = ""
    outcome: str | None = None
    svg: str | None = None


class RobotMessage(Struct, frozen=True, tag_field="type", tag="robot"):
    """Which arm follows the recording, of which that could, and whether it can be moved."""

    arms: tuple[str, ...]
    arm: str
    moving: bool


def record_message(status: LeadThroughStatus) -> RecordMessage:
    """How recording by hand stands."""
    state = status.running
    return RecordMessage(
        workcell=None if state is None else status.workcell,
        choices=workcell_choices(),
        recording=status.recording,
        recorded_s=None if state is None else state.recorded_s,
        force_N=None if state is None else float(np.linalg.norm(state.sample.force_N)),
        full_force_N=FULL_FORCE_N,
        can_undo=status.can_undo,
        can_redo=status.can_redo,
        newest=_newest(status),
    )


def _newest(status: LeadThroughStatus) -> tuple[float, float, float, float, float, float] | None:
    if status.running is None or not status.recording:
        return None
    x, y, z = status.running.sample.position_m.tolist()
    force_x, force_y, force_z = status.running.sample.force_N.tolist()
    return x, y, z, force_x, force_y, force_z


def trials_message(trials: TrialsRun) -> TrialsMessage:
    """How trials stand."""
    return TrialsMessage(
        trials.count, trials.done, trials.over, trials.title, trials.outcome, trials.svg
    )


def margin_message(margin: MarginRun) -> MarginMessage:
    """How a margin stands."""
    return MarginMessage(
        margin.count, margin.done, margin.over, margin.title, margin.outcome, margin.svg
    )


def replay_settings_message(settings: ReplaySettings) -> ReplaySettingsMessage:
    """What was chosen for the next replay."""
    return ReplaySettingsMessage(
        workcell=settings.workcell,
        part_height_m=settings.part_height_m,
        part_aside_m=settings.part_aside_m,
        friction=settings.friction,
        sensor_noise=settings.sensor_noise,
        end_by=settings.end_by,
        speed=settings.speed,
        choices=world_choices(),
        ends=get_args(EndBy),
        ranges=dict(RANGES),
    )


def workcell_choices() -> tuple[WorkcellChoice, ...]:
    """The workcells there are."""
    return tuple(WorkcellChoice(name, workcell(name).title) for name in workcell_names())


def world_choices() -> tuple[WorkcellChoice, ...]:
    """The workcells, and the world made from the recording."""
    return (*workcell_choices(), WorkcellChoice(RecordedCell.name, RecordedCell.title))


class CameraMessage(Struct, frozen=True):
    """A video of a recording; its frame k lies at `from_s + k / fps` of the file.

    id        the video is at /app/video/ID, in parts
    begins_s  when its first frame was taken, on the recording's clock
    """

    id: str
    name: str
    fps: float
    frames: int
    from_s: float
    begins_s: float
    width: int
    height: int


class CamerasMessage(Struct, frozen=True, tag_field="type", tag="cameras"):
    """The videos of a recording; `refused` says of each that cannot be shown why."""

    recording: str
    cameras: tuple[CameraMessage, ...]
    refused: tuple[str, ...]


def cameras_message(lent: LentFootage) -> CamerasMessage:
    """What a page is told of the videos of a recording."""
    cameras = tuple(
        CameraMessage(
            id,
            printable(one.name),
            one.fps,
            one.frames,
            one.from_s,
            one.begins_s,
            one.width,
            one.height,
        )
        for id, one in ((lent_camera.id, lent_camera.camera) for lent_camera in lent.cameras)
    )
    return CamerasMessage(lent.recording, cameras, tuple(map(printable, lent.refused)))
