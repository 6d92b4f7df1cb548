"""What a page may say to the server, checked before anything is done with it.

docs/protocol.md has both directions in words. Unknown types and fields, wrong kinds, numbers that
are not finite or far out of range and texts that are too long are refused with a reason.
"""

from typing import Annotated, Literal

import msgspec
from msgspec import UNSET, Meta, Struct, UnsetType

from keyphase.errors import RequestError
from keyphase.labeling import edits as labeling
from keyphase.labeling.storage.written_files import IfThere
from keyphase.workbench.replaying.settings import SPEEDS, Action, EndBy

_Time = Annotated[float, Meta(ge=-1e9, le=1e10)]
_Value = Annotated[float, Meta(ge=-1e12, le=1e12)]
_Id = Annotated[str, Meta(max_length=4096)]
_Name = Annotated[str, Meta(max_length=100)]
_Counter = Annotated[int, Meta(ge=0, le=2**53)]
_Width = Annotated[int, Meta(ge=2, le=20_000)]
"""Fewer than two pixels is no curve, and the decimation panics."""
_Speed = Annotated[float, Meta(ge=0.01, le=100.0)]


class _Request(Struct, frozen=True, tag_field="type", forbid_unknown_fields=True):
    """A message from a page."""


class OnDocument(_Request, frozen=True, kw_only=True):
    """A request about a recording; `revision` is that of the document it was made on.

    `event` is the page's own number of it: the document that contains it names it as its cause,
    or it comes back as `refused`.
    """

    recording: _Id
    revision: _Counter
    event: _Counter | None = None


class Open(_Request, tag="open", frozen=True):
    """Look at a recording."""

    id: _Id


class OpenDemonstration(_Request, tag="open_demonstration", frozen=True):
    """Look at a copy of the recording that comes with keyphase."""


class Follow(_Request, tag="follow", frozen=True):
    """See what another page sees; null: no more."""

    page: _Id | None


class Set(OnDocument, tag="set", frozen=True):
    """Change a parameter; `held` while the person is still dragging."""

    parameter: _Name
    value: _Value | _Name | None
    held: bool = False


class Reset(OnDocument, tag="reset", frozen=True):
    """Parameters back to automatic."""


class Edit(OnDocument, tag="edit", frozen=True):
    """Apply one edit."""

    edit: labeling.Edit


class Undo(OnDocument, tag="undo", frozen=True):
    """Take back the last edit or parameter change."""


class Redo(OnDocument, tag="redo", frozen=True):
    """Do again what was taken back."""


class Done(OnDocument, tag="done", frozen=True):
    """This recording is, or is not, finished."""

    done: bool


class KeepLabels(OnDocument, tag="keep_labels", frozen=True):
    """The recording has changed since it was labeled, and the labels are to be kept."""


class TakeJournal(OnDocument, tag="take_journal", frozen=True):
    """Take over what was done to the same bytes under another name."""


class ForgetLabel(OnDocument, tag="forget_label", frozen=True):
    """Take a label out of the folder's vocabulary."""

    label: _Name


class Spread(OnDocument, tag="spread", frozen=True):
    """Tell what these parameters would do to all recordings of the folder; do it; or never mind.

    With `include_done` those that are done are opened again; without, they are left alone.
    """

    step: Literal["look", "apply", "leave"]
    include_done: bool = False


class Compare(OnDocument, tag="compare", frozen=True):
    """Compare with another segmentation of this recording; null: tell with which one can."""

    other: _Id | None = msgspec.field(name="with", default=None)


class TakeOver(OnDocument, tag="take_over", frozen=True):
    """Make another segmentation of this recording its own, as one edit."""

    other: _Id = msgspec.field(name="from")


class Upload(_Request, tag="upload", frozen=True):
    """A file follows in binary messages."""

    name: Annotated[str, Meta(max_length=1000)]
    size: Annotated[int, Meta(ge=0, le=2**50)]


class UploadCancel(_Request, tag="upload_cancel", frozen=True):
    """The file on its way is not wanted after all."""


class Select(OnDocument, tag="select", frozen=True):
    """Select a segment, or none."""

    segment: Annotated[int, Meta(ge=0, le=1_000_000)] | None


class Seek(_Request, tag="seek", frozen=True):
    """Move the playhead."""

    time_s: _Time


class Play(_Request, tag="play", frozen=True):
    """Start, pause, or change how playback runs."""

    playing: bool
    speed: _Speed = 1.0
    loop: bool = False


class Signals(_Request, tag="signals", frozen=True):
    """Ask for the visible range of some tracks."""

    recording: _Id
    request: _Counter
    tracks: Annotated[list[_Name], Meta(max_length=20)]
    from_s: _Time
    to_s: _Time
    width: _Width


class Export(OnDocument, tag="export", frozen=True):
    """Write a file.

    The segment file as `json` or `csv`, or those of `all` recordings; the plan as `skills`,
    `behavior tree`, `program`, `urscript` or `rapid`; the replay that is over as a `page` that
    needs no server. `if_there` says what becomes of files that keyphase did not write as they are;
    without, `in_the_way` tells which there are.
    """

    kind: Literal[
        "json", "csv", "all", "skills", "behavior tree", "program", "urscript", "rapid", "page"
    ]
    if_there: IfThere = "ask"


class Show(_Request, tag="show", frozen=True):
    """Show or hide a part of the scene."""

    what: _Name
    visible: bool


class Theme(_Request, tag="theme", frozen=True):
    """The page has become light or dark."""

    dark: bool


class Replay(_Request, tag="replay", frozen=True):
    """Begin, steer or end a replay of the plan."""

    do: Action
    speed: Annotated[float, Meta(ge=SPEEDS[0], le=SPEEDS[1])] | None = None


class ReplaySettings(_Request, tag="replay_settings", frozen=True):
    """Choose the world of the next replay; what is left out stays as it is."""

    workcell: _Name | UnsetType = UNSET
    part_height_m: _Value | UnsetType = UNSET
    part_aside_m: _Value | UnsetType = UNSET
    friction: _Value | UnsetType = UNSET
    sensor_noise: _Value | UnsetType = UNSET
    end_by: EndBy | UnsetType = UNSET
    speed: _Value | UnsetType = UNSET
    seed: Annotated[int, Meta(ge=0, le=2**31)] | UnsetType = UNSET


class Push(_Request, tag="push", frozen=True):
    """Show or hide what pushes the tool while a replay runs."""

    offered: bool


class Trials(_Request, tag="trials", frozen=True):
    """Run the plan in so many disturbed worlds."""

    count: Annotated[int, Meta(ge=1, le=1000)]


class TrialsCancel(_Request, tag="trials_cancel", frozen=True):
    """Give up the trials that run."""


class Margin(_Request, tag="margin", frozen=True):
    """Try how far the world may differ until the plan fails, or give that up."""

    do: Literal["begin", "cancel"]


class Record(_Request, tag="record", frozen=True):
    """Open or close a workcell to be led by hand, start or stop a take, take one back.

    `open` and `start` name the workcell.
    """

    do: Literal["open", "close", "start", "stop", "reset", "undo_take", "redo_take"]
    workcell: _Name | None = None


class Robot(_Request, tag="robot", frozen=True):
    """Which arm follows the recording, whether the robot can be moved, where it stands."""

    arm: _Name | None = None
    moving: bool | None = None
    place: Literal["automatically"] | None = None


class Latency(_Request, tag="latency", frozen=True):
    """How long it took from an input event to the first frame that shows what it did."""

    event: _Counter
    milliseconds: Annotated[float, Meta(ge=0.0, le=1e7)]


Request = (
    Open
    | OpenDemonstration
    | Follow
    | Set
    | Reset
    | Edit
    | Undo
    | Redo
    | Done
    | KeepLabels
    | TakeJournal
    | ForgetLabel
    | Spread
    | Compare
    | TakeOver
    | Upload
    | UploadCancel
    | Select
    | Seek
    | Play
    | Signals
    | Export
    | Show
    | Theme
    | Replay
    | ReplaySettings
    | Push
    | Trials
    | TrialsCancel
    | Margin
    | Record
    | Robot
    | Latency
)

LOOKING_REQUESTS = (
    Open,
    Follow,
    Select,
    Seek,
    Play,
    Show,
    Theme,
    Signals,
    Latency,
    Compare,
)
"""What a page may ask that was opened by the link for looking."""

_MAX_BYTES = 256 << 10
_decoder = msgspec.json.Decoder(Request)


def parse(raw: str | bytes) -> Request:
    """The request in a message from a page.

    Raises RequestError with what is wrong and where.
    """
    if len(raw) > _MAX_BYTES:
        raise RequestError(
            f"A message may have {_MAX_BYTES} characters at most, but has {len(raw)}."
        )
    if isinstance(raw, bytes):
        raise RequestError("A message must be text holding one JSON object, but is binary.")
    try:
        return _decoder.decode(raw)
    except (msgspec.MsgspecError, UnicodeError, RecursionError) as error:
        raise RequestError(f"This message is refused: {error}.") from error


def about(raw: str | bytes) -> tuple[str, int | None]:
    """Type and event of a message that was refused as a whole, where it tells them."""
    try:
        told = msgspec.json.decode(raw, type=_About)
    except (msgspec.MsgspecError, UnicodeError, RecursionError):
        return "", None
    return told.type[:100], told.event


class _About(Struct, frozen=True):
    type: str = ""
    event: int | None = None
