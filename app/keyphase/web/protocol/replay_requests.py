"""What a page asks of the simulation: replays, trials, recording by hand."""

from typing import Annotated, Literal

from msgspec import UNSET, Meta, UnsetType

from keyphase.web.protocol.request_kinds import Name, PageRequest, Value
from keyphase.workbench.leading.session import LeadAction
from keyphase.workbench.replaying.settings import SPEEDS, Action, EndBy


class Replay(PageRequest, tag="replay", frozen=True):
    """Begin, steer or end a replay of the plan."""

    do: Action
    speed: Annotated[float, Meta(ge=SPEEDS[0], le=SPEEDS[1])] | None = None


class ReplaySettings(PageRequest, tag="replay_settings", frozen=True):
    """Choose the world of the next replay; what is left out stays as it is."""

    workcell: Name | UnsetType = UNSET
    part_height_m: Value | UnsetType = UNSET
    part_aside_m: Value | UnsetType = UNSET
    friction: Value | UnsetType = UNSET
    sensor_noise: Value | UnsetType = UNSET
    end_by: EndBy | UnsetType = UNSET
    speed: Value | UnsetType = UNSET
    seed: Annotated[int, Meta(ge=0, le=2**31)] | UnsetType = UNSET


class Push(PageRequest, tag="push", frozen=True):
    """Show or hide what pushes the tool while a replay runs."""

    offered: bool


class Trials(PageRequest, tag="trials", frozen=True):
    """Run the plan in so many disturbed worlds."""

    count: Annotated[int, Meta(ge=1, le=1000)]


class TrialsCancel(PageRequest, tag="trials_cancel", frozen=True):
    """Give up the trials that run."""


class Margin(PageRequest, tag="margin", frozen=True):
    """Try how far the world may differ until the plan fails, or give that up."""

    do: Literal["begin", "cancel"]


class Record(PageRequest, tag="record", frozen=True):
    """Open or close a workcell to be led by hand, start or stop a take, take one back.

    `open` and `start` name the workcell.
    """

    do: LeadAction
    workcell: Name | None = None
