"""Video that a robot sends packet by packet, as Foxglove's CompressedVideo in an MCAP file."""

import base64
import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import av
import pytest
from google.protobuf.descriptor_pb2 import FieldDescriptorProto, FileDescriptorSet
from google.protobuf.descriptor_pool import DescriptorPool
from google.protobuf.message_factory import GetMessageClass
from google.protobuf.timestamp_pb2 import DESCRIPTOR as TIMESTAMP
from mcap.writer import Writer

from keyphase.cameras import footage_of
from keyphase.cameras.kept import Kept
from numbered_videos import HEIGHT, WIDTH, numbers_in, picture

BEGIN_NS = 1_700_000_000 * 10**9
STEP_NS = 50_000_000
SCHEMA = {"type": "object", "title": "foxglove.CompressedVideo"}

Write = Callable[[Path, dict[int, bytes], str], Path]


@pytest.fixture
def kept(tmp_path: Path) -> Kept:
    return Kept(tmp_path / "cache")


def packets(codec: str, count: int = 24) -> dict[int, bytes]:
    """Frame by frame, each packet one frame, a key frame every eight, no B-frames."""
    encoder = av.CodecContext.create(codec, "w")
    encoder.width, encoder.height, encoder.pix_fmt = WIDTH, HEIGHT, "yuv420p"
    encoder.time_base, encoder.framerate = Fraction(1, 20), Fraction(20)
    encoder.gop_size, encoder.max_b_frames = 8, 0
    options = {"preset": "ultrafast", "tune": "zerolatency"}
    more = {"x265-params": "repeat-headers=1:log-level=none"} if codec == "libx265" else {}
    encoder.options = options | more
    made = []
    for number in range(count):
        frame = av.VideoFrame.from_ndarray(picture(number), format="rgb24").reformat(
            format="yuv420p"
        )
        frame.pts = number
        made += encoder.encode(frame)
    made += encoder.encode(None)
    assert len(made) == count
    return {number: bytes(one) for number, one in enumerate(made)}


def as_json(path: Path, video: dict[int, bytes], form: str = "h264") -> Path:
    """With a force beside it, from 0.1 s before the first frame on."""
    with path.open("wb") as stream:
        writer = Writer(stream)
        writer.start()
        schema = writer.register_schema(
            "foxglove.CompressedVideo", "jsonschema", json.dumps(SCHEMA).encode()
        )
        camera = writer.register_channel("/wrist/image", "json", schema)
        force = writer.register_channel("/force", "json", 0)
        for number in range(30):
            at = BEGIN_NS - 100_000_000 + number * STEP_NS
            content = {"timestamp": _stamp(at), "z": float(number)}
            writer.add_message(force, at, json.dumps(content).encode(), at)
        for number, data in video.items():
            at = BEGIN_NS + number * STEP_NS
            content = {
                "timestamp": _stamp(at),
                "frame_id": "wrist",
                "data": base64.b64encode(data).decode(),
                "format": form,
            }
            writer.add_message(camera, at, json.dumps(content).encode(), at)
        writer.finish()
    return path


def _stamp(at_ns: int) -> dict[str, int]:
    return {"sec": at_ns // 10**9, "nsec": at_ns % 10**9}


def as_protobuf(path: Path, video: dict[int, bytes], form: str = "h264") -> Path:
    """The same message as Foxglove defines it."""
    described = FileDescriptorSet()
    TIMESTAMP.CopyToProto(described.file.add())
    file = described.file.add(
        name="video.proto", package="foxglove", syntax="proto3", dependency=[TIMESTAMP.name]
    )
    kind = file.message_type.add(name="CompressedVideo")
    kinds = FieldDescriptorProto
    fields = [("timestamp", kinds.TYPE_MESSAGE), ("frame_id", kinds.TYPE_STRING)]
    fields += [("data", kinds.TYPE_BYTES), ("format", kinds.TYPE_STRING)]
    for number, (name, type_) in enumerate(fields, 1):
        one = kind.field.add(name=name, number=number, type=type_, label=kinds.LABEL_OPTIONAL)
        if type_ == kinds.TYPE_MESSAGE:
            one.type_name = ".google.protobuf.Timestamp"
    pool = DescriptorPool()
    for one in described.file:
        pool.Add(one)
    message = GetMessageClass(pool.FindMessageTypeByName("foxglove.CompressedVideo"))
    with path.open("wb") as stream:
        writer = Writer(stream)
        writer.start()
        schema = writer.register_schema(
            "foxglove.CompressedVideo", "protobuf", described.SerializeToString()
        )
        camera = writer.register_channel("/wrist/image", "protobuf", schema)
        for number, data in video.items():
            at = BEGIN_NS + number * STEP_NS
            seconds = {"seconds": at // 10**9, "nanos": at % 10**9}
            content = message(timestamp=seconds, frame_id="wrist", data=data, format=form)
            writer.add_message(camera, at, content.SerializeToString(), at)
        writer.finish()
    return path


@pytest.mark.parametrize("write", [as_json, as_protobuf])
def test_h264_without_a_gap_is_put_into_mp4_as_it_is(
    write: Write, tmp_path: Path, kept: Kept
) -> None:
    video = packets("libx264")
    found = footage_of(write(tmp_path / "run.mcap", video, "h264"), 0.0, kept=kept)
    assert not found.refused
    (camera,) = found.cameras
    assert (camera.name, camera.fps, camera.frames) == ("wrist", pytest.approx(20.0), 24)
    assert camera.begins_s == pytest.approx(0.1 if write is as_json else 0.0)
    assert numbers_in(camera.file) == list(range(24))
    with av.open(str(camera.file)) as made:
        held = [packet.size for packet in made.demux(video=0) if packet.size]
    # The start codes become lengths of as many bytes; parameter sets may move to the head.
    assert abs(sum(held) - sum(map(len, video.values()))) < 0.02 * sum(held) + 200
    assert not list((tmp_path / "cache").glob("*.h264"))


def test_a_video_that_was_joined_late_begins_at_its_first_key_frame(
    tmp_path: Path, kept: Kept
) -> None:
    video = {number: data for number, data in packets("libx264").items() if number >= 3}
    (camera,) = footage_of(as_json(tmp_path / "run.mcap", video), 0.0, kept=kept).cameras
    assert camera.begins_s == pytest.approx(0.1 + 8 * 0.05)
    assert numbers_in(camera.file) == list(range(8, 24))


@pytest.mark.parametrize(("codec", "form"), [("libx264", "h264"), ("libx265", "h265")])
def test_what_has_gaps_or_a_browser_does_not_play_is_made_anew(
    codec: str, form: str, tmp_path: Path, kept: Kept
) -> None:
    if codec not in av.codecs_available:
        codec, form = "libx264", "h264"
    # The last two of a group are lost, so that what follows can still be decoded.
    video = {n: data for n, data in packets(codec).items() if n not in (14, 15)}
    found = footage_of(as_json(tmp_path / "run.mcap", video, form), 0.0, kept=kept)
    assert not found.refused
    (camera,) = found.cameras
    assert numbers_in(camera.file) == [*range(14), 13, 16, *range(16, 24)]


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (lambda data: data[4:], "with start codes"),
        (lambda data: data + data, "expected one frame in each of 24 messages"),
        (lambda _data: b"\0\0\1\x65" + bytes(40), "cannot be"),
    ],
)
def test_packets_that_are_none_are_refused_and_leave_nothing_behind(
    spoil: Callable[[bytes], bytes], said: str, tmp_path: Path, kept: Kept
) -> None:
    video = {number: spoil(data) for number, data in packets("libx264").items()}
    found = footage_of(as_json(tmp_path / "run.mcap", video), 0.0, kept=kept)
    assert not found.cameras
    assert said in found.refused[0]
    assert not list((tmp_path / "cache").iterdir())


def test_a_file_without_pictures_has_no_camera_and_no_complaint(tmp_path: Path, kept: Kept) -> None:
    found = footage_of(as_json(tmp_path / "run.mcap", {}), 0.0, kept=kept)
    assert (found.cameras, found.refused) == ((), ())
