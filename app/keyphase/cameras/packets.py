"""Packets of a video, as robots send them, in a file that a browser finds any frame of.

H.264 at a steady rate is put into mp4 as it is. Anything else, and what has gaps, is decoded and
made anew at a steady rate, as images are.
"""

import re
from collections.abc import Iterable, Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.cameras.bag_pictures import EXTRA, Picture
from keyphase.errors import CameraError
from keyphase.readers.formats.damage import what_is_wrong
from keyphase.readers.formats.packages import package

MAX_PACKET_BYTES = 32 << 20
_DECODERS = {"h264": "h264", "h265": "hevc", "vp9": "vp9", "av1": "libdav1d"}
_MOST_PIXELS = 64_000_000
_UNIT = re.compile(rb"\x00\x00\x01(.)", re.DOTALL)
_BEGINS = re.compile(rb"\x00\x00\x00?\x01")
_IDR, _TYPE = 5, 0x1F


def begins_anew(data: bytes) -> bool:
    """Whether a packet of H.264 in byte-stream form can be decoded without those before it."""
    return any(found[1][0] & _TYPE == _IDR for found in _UNIT.finditer(data))


def is_steady(times_s: NDArray[np.float64]) -> bool:
    """Whether no frame is missing: each lies within half a step of its place."""
    steps = np.diff(times_s)
    step = float(np.median(steps))
    places = np.arange(len(times_s)) * step
    return step > 0.0 and bool((np.abs(times_s - times_s[0] - places) < 0.5 * step).all())


def remux(path: Path, packets: Iterable[Picture], fps: float, to: Path) -> None:
    """Put packets of H.264, one frame each and the first a key frame, into an mp4 as they are.

    Raises CameraError where they are not that.
    """
    av = package("av", EXTRA, path)
    raw = to.with_suffix(".h264")
    try:
        count = _join(path, packets, raw)
        rate = Fraction(fps).limit_denominator(1001)
        with (
            av.open(str(raw), format="h264") as source,
            av.open(str(to), "w", format="mp4") as output,
        ):
            stream = output.add_stream_from_template(source.streams.video[0])
            written = 0
            for packet in source.demux(video=0):
                if not packet.size:
                    continue
                packet.stream, packet.time_base = stream, 1 / rate
                packet.pts = packet.dts = written
                packet.duration = 1
                written += 1
                output.mux(packet)
    except (av.FFmpegError, ValueError, IndexError) as error:
        raise CameraError(
            f"{path}: its packets of H.264 cannot be read ({what_is_wrong(path, error)})."
        ) from error
    finally:
        raw.unlink(missing_ok=True)
    if written != count:
        raise CameraError(
            f"{path}: expected one frame in each of {count} messages of H.264, but there are "
            f"{written}; record it so, as Foxglove's CompressedVideo asks for."
        )


def _join(path: Path, packets: Iterable[Picture], raw: Path) -> int:
    count = 0
    with raw.open("wb") as file:
        for packet in packets:
            file.write(_checked(path, packet))
            count += 1
    return count


def decoded(path: Path, packets: Iterable[Picture]) -> Iterator[tuple[int, Any]]:
    """The number of each packet that shows a picture, and the picture.

    Raises CameraError for packets of no known kind or that cannot be decoded.
    """
    av = package("av", EXTRA, path)
    decoder: Any = None
    try:
        for number, packet in enumerate(packets):
            if decoder is None:
                decoder = av.CodecContext.create(_decoder_of(path, packet), "r")
                decoder.options = {"max_pixels": str(_MOST_PIXELS)}
            sent = av.Packet(_checked(path, packet))
            sent.pts = sent.dts = number
            sent.time_base = Fraction(1, 1000)
            yield from ((frame.pts, frame) for frame in decoder.decode(sent))
        if decoder is not None:
            yield from ((frame.pts, frame) for frame in decoder.decode(None))
    except (av.FFmpegError, ValueError) as error:
        raise CameraError(
            f"{path}: its video cannot be decoded ({what_is_wrong(path, error)})."
        ) from error


def _decoder_of(path: Path, packet: Picture) -> str:
    name = _DECODERS.get(packet.format.lower())
    if name is None:
        raise CameraError(
            f"{path}: expected a video of {', '.join(_DECODERS)}, but its packets are of "
            f"{packet.format[:40]!r}."
        )
    return name


def _checked(path: Path, packet: Picture) -> bytes:
    if len(packet.data) > MAX_PACKET_BYTES:
        raise CameraError(
            f"{path}: expected at most {MAX_PACKET_BYTES >> 20} MiB in a packet of video, but "
            f"one has {len(packet.data)} bytes."
        )
    if packet.format.lower() in ("h264", "h265") and not _BEGINS.match(packet.data):
        raise CameraError(
            f"{path}: expected {packet.format[:10]} with start codes (Annex B), but a packet has "
            "none; record it so, as Foxglove's CompressedVideo asks for."
        )
    return packet.data
