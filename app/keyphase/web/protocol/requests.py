"""What a page may say to the server, checked before anything is done with it.

docs/protocol.md has both directions in words. Unknown types and fields, wrong kinds, numbers that
are not finite or far out of range and texts that are too long are refused with a reason.
"""

import msgspec
from msgspec import Struct

from keyphase.errors import RequestError
from keyphase.web.protocol.document_requests import (
    Compare,
    Cut,
    Done,
    Edit,
    Export,
    ForgetLabel,
    KeepLabels,
    Lanes,
    Offers,
    PhaseForAll,
    Phases,
    PhaseUndo,
    Redo,
    Reset,
    Select,
    Set,
    Signals,
    Spread,
    TakeJournal,
    TakeOver,
    Undo,
)
from keyphase.web.protocol.import_requests import (
    Describe,
    DescribeConfirm,
    DescribeLeave,
    DescribeTry,
)
from keyphase.web.protocol.replay_requests import (
    Margin,
    Push,
    Record,
    Replay,
    ReplaySettings,
    Trials,
    TrialsCancel,
)
from keyphase.web.protocol.request_kinds import OnDocument as OnDocument
from keyphase.web.protocol.view_requests import (
    Cameras,
    Follow,
    Grid,
    InView,
    Latency,
    Open,
    OpenDemonstration,
    Play,
    PlayAround,
    Robot,
    Seek,
    Show,
    Theme,
    Upload,
    UploadCancel,
)

EditingRequest = (
    Set
    | Reset
    | Edit
    | Undo
    | Redo
    | Done
    | KeepLabels
    | TakeJournal
    | ForgetLabel
    | Spread
    | PhaseForAll
    | PhaseUndo
    | Phases
    | Compare
    | Lanes
    | TakeOver
    | Cut
    | Offers
    | Export
)
"""What changes, compares or writes one document."""

LookRequest = (
    Open
    | OpenDemonstration
    | Follow
    | Seek
    | Play
    | PlayAround
    | Show
    | InView
    | Grid
    | Theme
    | Robot
    | Latency
)
"""What concerns only what a page looks at."""

ReplayRequest = Replay | ReplaySettings | Push

BesideReplayRequest = Trials | TrialsCancel | Margin

DispatchedRequest = (
    EditingRequest
    | Select
    | Signals
    | Cameras
    | LookRequest
    | ReplayRequest
    | BesideReplayRequest
    | Record
)
"""What is done at once; the others are conversations of several messages."""

UploadRequest = Upload | UploadCancel

DescribeRequest = Describe | DescribeTry | DescribeConfirm | DescribeLeave

Request = DispatchedRequest | UploadRequest | DescribeRequest

LOOKING_REQUESTS = (
    Open,
    Follow,
    Select,
    Seek,
    Play,
    PlayAround,
    Show,
    InView,
    Grid,
    Theme,
    Signals,
    Cameras,
    Latency,
    Compare,
    Lanes,
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
