"""Pictures made into a video that a browser plays and finds any frame of quickly."""

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import Any

from keyphase.cameras.container import EXTRA, MAX_FILE_BYTES, Video, opened_video
from keyphase.errors import CameraError
from keyphase.readers.formats.packages import package

_ENCODERS = (
    ("libx264", {"preset": "veryfast", "crf": "20", "bf": "0"}),
    ("libsvtav1", {"preset": "10", "crf": "30"}),
)
_KEYFRAME_EVERY = 12
"""A frame is found by decoding from the key frame before it."""

MOST_FRAMES = 1_000_000


class Encoder:
    """Writes frames, one after another, at a steady rate."""

    def __init__(self, file: Path, fps: float) -> None:
        self._av = package("av", EXTRA, file)
        self._rate = Fraction(fps).limit_denominator(1001)
        self._output = self._av.open(str(file), "w", format="mp4")
        self._stream: Any = None
        self._frames = 0

    def add(self, frame: Any) -> None:
        """One frame more. Raises CameraError where there are too many."""
        if self._frames >= MOST_FRAMES:
            raise CameraError(f"A video may have {MOST_FRAMES} frames at most.")
        if self._stream is None:
            self._stream = self._begin(frame.width & ~1, frame.height & ~1)
        shown = frame.reformat(self._stream.width, self._stream.height, "yuv420p")
        shown.pts, shown.time_base = self._frames, 1 / self._rate
        shown.pict_type = 0
        self._frames += 1
        self._output.mux(self._stream.encode(shown))

    def close(self) -> None:
        """Write the end of it."""
        if self._stream is not None:
            self._output.mux(self._stream.encode())
        self._output.close()

    def _begin(self, width: int, height: int) -> Any:
        for name, options in _ENCODERS:
            try:
                self._av.codec.Codec(name, "w")
            except ValueError:
                continue
            stream = self._output.add_stream(name, rate=self._rate, options=options)
            stream.width, stream.height, stream.pix_fmt = width, height, "yuv420p"
            stream.time_base = 1 / self._rate
            stream.codec_context.gop_size = _KEYFRAME_EVERY
            return stream
        raise CameraError("This PyAV has no encoder for H.264 or AV1; install another build of it.")


@contextmanager
def encoder(file: Path, fps: float) -> Iterator[Encoder]:
    """Writes a video; it is whole after the `with` statement."""
    writing = Encoder(file, fps)
    try:
        yield writing
    finally:
        writing.close()


def converted(source: Path, video: Video, to: Path) -> None:
    """Write a video that browsers cannot play as one that they can, frame by frame."""
    with (
        opened_video(source, video.media_type, MAX_FILE_BYTES) as container,
        encoder(to, video.fps) as writing,
    ):
        for frame in container.decode(container.streams.video[0]):
            writing.add(frame)
