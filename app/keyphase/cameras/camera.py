"""A camera: one video of a recording, and how its frames lie on the recording's clock."""

from dataclasses import dataclass
from pathlib import Path

MAX_NAME_LENGTH = 100


@dataclass(frozen=True)
class Camera:
    """A video that a browser can play, and the stretch of it that belongs to one recording.

    Its frame k is on the screen at `from_s + k / fps` of the file and was taken at
    `begins_s + k / fps` of the recording, before what a person corrects.

    name        what it is called, unique among the cameras of a recording
    file        a regular file
    media_type  video/mp4 or video/webm
    fps         frames in a second
    frames      how many belong to the recording
    from_s      where the first of them lies in the file [s]
    begins_s    when the first of them was taken, on the recording's clock [s]
    """

    name: str
    file: Path
    media_type: str
    fps: float
    frames: int
    from_s: float
    begins_s: float
    width: int
    height: int

    @property
    def duration_s(self) -> float:
        """How long its stretch is."""
        return self.frames / self.fps


@dataclass(frozen=True)
class Footage:
    """The cameras of a recording, and one sentence about each video that cannot be shown."""

    cameras: tuple[Camera, ...] = ()
    refused: tuple[str, ...] = ()


@dataclass(frozen=True)
class Stretch:
    """A video that was found, not looked at yet.

    from_s, to_s  the part of the file that belongs to the recording; to_s None: to its end
    begins_s      as of a camera; None: at the start of the recording
    """

    name: str
    file: Path
    from_s: float = 0.0
    to_s: float | None = None
    begins_s: float | None = None
