"""The binary frame that answers a request for curves: a header, then times and values."""

import struct
from collections.abc import Sequence

import msgspec
from msgspec import Struct

from keyphase.web.protocol.document_requests import Signals
from keyphase.workbench.showing.signals import POINTS_PER_PIXEL, SignalTracks


class SeriesHeader(Struct, frozen=True):
    """One curve: its name, and how many times and values follow."""

    key: str
    rows: int


class TrackHeader(Struct, frozen=True):
    """The curves of one track, in the order in which they follow."""

    name: str
    series: tuple[SeriesHeader, ...]


class SignalsHeader(Struct, frozen=True, tag_field="type", tag="signals"):
    """The head of a binary frame: which request it answers, and which curves follow.

    request       number of the request
    id            the recording
    from_s, to_s  the stretch that was asked for
    """

    request: int
    id: str
    from_s: float
    to_s: float
    tracks: tuple[TrackHeader, ...]


def signals_frame(tracks: SignalTracks, asked: Signals) -> bytes:
    """The tracks that were asked for, as far as the recording has them.

    Four bytes with the header's length (little-endian), the header as JSON padded with spaces so
    that what follows is aligned to 8 bytes; then for each series its times and its values, both
    as float64.
    """
    named: list[TrackHeader] = []
    arrays: list[bytes] = []
    for name in asked.tracks:
        series: list[SeriesHeader] = []
        for curve in tracks.track(name):
            points = POINTS_PER_PIXEL * asked.width
            time, values = curve.decimated(asked.from_s, asked.to_s, points)
            series.append(SeriesHeader(curve.key, len(time)))
            arrays += [time.tobytes(), values.tobytes()]
        if series:
            named.append(TrackHeader(name, tuple(series)))
    header = SignalsHeader(asked.request, asked.recording, asked.from_s, asked.to_s, tuple(named))
    return _with_header(header, arrays)


def _with_header(header: SignalsHeader, arrays: Sequence[bytes]) -> bytes:
    text = msgspec.json.encode(header)
    text += b" " * (-(len(text) + 4) % 8)
    return b"".join([struct.pack("<I", len(text)), text, *arrays])
