"""What a page asks about what it looks at, and the files it sends."""

from typing import Annotated, Literal

from msgspec import Meta

from keyphase.web.protocol.request_kinds import Counter, Id, Name, PageRequest, Time

Speed = Annotated[float, Meta(ge=-100.0, le=100.0)]

LEAST_SPEED = 0.01
"""A playhead does not run more slowly than this."""


class Open(PageRequest, tag="open", frozen=True):
    """Look at a recording."""

    id: Id


class OpenDemonstration(PageRequest, tag="open_demonstration", frozen=True):
    """Look at a copy of the recording that comes with keyphase."""


class Cameras(PageRequest, tag="cameras", frozen=True):
    """Tell which videos there are of a recording that is open."""

    recording: Id


class Follow(PageRequest, tag="follow", frozen=True):
    """See what another page sees; null: no more."""

    page: Id | None


class Upload(PageRequest, tag="upload", frozen=True):
    """A file follows in binary messages."""

    name: Annotated[str, Meta(max_length=1000)]
    size: Annotated[int, Meta(ge=0, le=2**50)]


class UploadCancel(PageRequest, tag="upload_cancel", frozen=True):
    """The file on its way is not wanted after all."""


class Seek(PageRequest, tag="seek", frozen=True):
    """Move the playhead."""

    time_s: Time


class PlayAround(PageRequest, tag="play_around", frozen=True):
    """Play what is right before and after a time again and again, until anything else is asked."""

    time_s: Time


class Play(PageRequest, tag="play", frozen=True):
    """Start, pause, or change how playback runs; backwards below zero."""

    playing: bool
    speed: Speed = 1.0
    loop: bool = False

    def __post_init__(self) -> None:
        """Refuse a standstill that says it plays."""
        if abs(self.speed) < LEAST_SPEED:
            raise ValueError(f"Expected a speed of {LEAST_SPEED} or more, but got {self.speed}")


class Show(PageRequest, tag="show", frozen=True):
    """Show or hide a part of the scene."""

    what: Name
    visible: bool


class InView(PageRequest, tag="in_view", frozen=True):
    """Draw in the scene what of the recording's path lies in this time."""

    recording: Id
    from_s: Time
    to_s: Time


class Grid(PageRequest, tag="grid", frozen=True):
    """Tell how all recordings of the folder stand, now and whenever one changes; or no more."""

    shown: bool


class Theme(PageRequest, tag="theme", frozen=True):
    """The page has become light or dark."""

    dark: bool


class Robot(PageRequest, tag="robot", frozen=True):
    """Which arm follows the recording, whether the robot can be moved, where it stands."""

    arm: Name | None = None
    moving: bool | None = None
    place: Literal["automatically"] | None = None


class Latency(PageRequest, tag="latency", frozen=True):
    """How long it took from an input event to the first frame that shows what it did."""

    event: Counter
    milliseconds: Annotated[float, Meta(ge=0.0, le=1e7)]
