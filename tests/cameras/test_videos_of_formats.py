"""Videos that a dataset names, or that a file holds, in the layouts those formats have."""

import json
from fractions import Fraction
from pathlib import Path

import av
import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from rosbags.rosbag2 import StoragePlugin, Writer
from rosbags.typesys import Stores, get_typestore

from keyphase.cameras import footage_of
from keyphase.cameras.kept import Kept
from numbered_videos import H264, numbers_in, picture, write_video

KEY = "observation.images.front"


@pytest.fixture
def kept(tmp_path: Path) -> Kept:
    return Kept(tmp_path / "cache")


def lerobot(folder: Path, version: str, pattern: str) -> Path:
    (folder / "meta").mkdir(parents=True)
    (folder / "data").mkdir()
    info = {
        "codebase_version": version,
        "total_episodes": 3,
        "fps": 20,
        "video_path": pattern,
        "features": {KEY: {"dtype": "video", "shape": [144, 256, 3], "names": None}},
    }
    (folder / "meta" / "info.json").write_text(json.dumps(info))
    return folder


def shared(folder: Path, ends: list[float]) -> Path:
    """A v3.0 dataset whose episodes lie one after another in one video."""
    made = lerobot(
        folder, "v3.0", "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4"
    )
    rows: dict[str, list[object]] = {
        "episode_index": [0, 1, 2],
        f"videos/{KEY}/chunk_index": [0, 0, 0],
        f"videos/{KEY}/file_index": [0, 0, 0],
        f"videos/{KEY}/from_timestamp": [0.0, *ends[:-1]],
        f"videos/{KEY}/to_timestamp": ends,
    }
    (made / "meta/episodes/chunk-000").mkdir(parents=True)
    pq.write_table(pa.table(rows), made / "meta/episodes/chunk-000/file-000.parquet")
    video = made / "videos" / KEY / "chunk-000" / "file-000.mp4"
    video.parent.mkdir(parents=True)
    write_video(video, 90, 20.0)
    return made


def test_an_episode_of_a_shared_file_has_its_own_stretch_of_it(tmp_path: Path, kept: Kept) -> None:
    dataset = shared(tmp_path / "set", [1.5, 3.0, 4.5])
    (camera,) = footage_of(tmp_path / "set#episode_1", 0.0, kept=kept).cameras
    assert camera.file == dataset / "videos" / KEY / "chunk-000" / "file-000.mp4"
    assert (camera.name, camera.from_s, camera.frames, camera.begins_s) == ("front", 1.5, 30, 0.0)


@pytest.mark.parametrize("ends", [[1.5, 1.5, 4.5], [1.5, float("nan"), 4.5], [40.0, 60.0, 80.0]])
def test_a_stretch_that_cannot_be_is_refused(ends: list[float], tmp_path: Path, kept: Kept) -> None:
    shared(tmp_path / "set", ends)
    found = footage_of(tmp_path / "set#episode_1", 0.0, kept=kept)
    assert not found.cameras
    assert len(found.refused) == 1


def test_a_pattern_that_leads_out_of_the_dataset_is_refused(tmp_path: Path, kept: Kept) -> None:
    write_video(tmp_path / "secret.mp4", 5)
    lerobot(tmp_path / "set", "v2.1", "../secret.mp4")
    found = footage_of(tmp_path / "set#episode_1", 0.0, kept=kept)
    assert not found.cameras
    assert "not a file in it" in found.refused[0]


def test_each_episode_of_an_older_dataset_has_a_file(tmp_path: Path, kept: Kept) -> None:
    pattern = "videos/chunk-{episode_chunk:03d}/{video_key}/episode_{episode_index:06d}.mp4"
    video = lerobot(tmp_path / "set", "v2.1", pattern) / pattern.format(
        episode_chunk=0, video_key=KEY, episode_index=2
    )
    video.parent.mkdir(parents=True)
    write_video(video, 8, 20.0)
    (camera,) = footage_of(tmp_path / "set#episode_2", 0.0, kept=kept).cameras
    assert (camera.file, camera.frames) == (video, 8)


def test_the_bytes_of_a_video_inside_hdf5_are_copied_out_and_lie_on_its_clock(
    tmp_path: Path, kept: Kept
) -> None:
    data = write_video(tmp_path / "made.mp4", 12, first=7).read_bytes()
    with h5py.File(tmp_path / "run.h5", "w") as file:
        file["hama1"] = np.void(data)
        file["hand"] = np.frombuffer(data, dtype=np.uint8)
        file["timestamps/pose"] = 1.7e9 + np.arange(5) / 10
        file["timestamps/hama1"] = 1.7e9 + 0.25 + np.arange(12) / 30
        file["robot_state/pose"] = np.zeros((5, 7))
    cameras = {one.name: one for one in footage_of(tmp_path / "run.h5", 0.0, kept=kept).cameras}
    assert cameras["hama1"].begins_s == pytest.approx(0.25)
    assert cameras["hand"].begins_s == 0.0
    assert numbers_in(cameras["hama1"].file) == list(range(7, 19))


def compressed(pixels: np.ndarray) -> np.ndarray:
    codec = av.CodecContext.create("mjpeg", "w")
    codec.width, codec.height, codec.pix_fmt = 256, 144, "yuvj420p"
    codec.time_base = Fraction(1, 30)
    frame = av.VideoFrame.from_ndarray(pixels, format="rgb24").reformat(format="yuvj420p")
    packets = [*codec.encode(frame), *codec.encode(None)]
    return np.frombuffer(b"".join(map(bytes, packets)), dtype=np.uint8)


def bag(folder: Path, jpeg_of) -> Path:
    """Images at 10 Hz, two of them lost, the first 0.2 s after the first of the signals."""
    store = get_typestore(Stores.ROS2_HUMBLE)
    types, begin = store.types, 1_700_000_000
    with Writer(folder / "run", version=9, storage_plugin=StoragePlugin.MCAP) as writer:

        def topic(name: str, kind: str):
            return writer.add_connection(name, kind, typestore=store)

        images = topic("/cam/image_raw/compressed", "sensor_msgs/msg/CompressedImage")
        points = topic("/tool", "geometry_msgs/msg/PointStamped")
        for tenth in range(20):
            stamp = types["builtin_interfaces/msg/Time"](begin + tenth // 10, tenth % 10 * 10**8)
            header = types["std_msgs/msg/Header"](stamp=stamp, frame_id="base")
            point = types["geometry_msgs/msg/Point"](x=0.1 * tenth, y=0.0, z=0.0)
            message = types["geometry_msgs/msg/PointStamped"](header=header, point=point)
            at = begin * 10**9 + tenth * 10**8 + 5_000_000
            writer.write(points, at, store.serialize_cdr(message, points.msgtype))
            if tenth >= 2 and tenth not in (10, 11):
                data = jpeg_of(tenth)
                image = types["sensor_msgs/msg/CompressedImage"](header, "jpeg", data)
                writer.write(images, at, store.serialize_cdr(image, images.msgtype))
    return folder / "run"


def test_images_of_a_bag_become_a_video_that_shows_the_nearest_at_every_instant(
    tmp_path: Path, kept: Kept
) -> None:
    found = footage_of(bag(tmp_path, lambda k: compressed(picture(k))), 0.0, kept=kept)
    assert not found.refused
    (camera,) = found.cameras
    assert (camera.name, camera.begins_s) == ("cam", pytest.approx(0.2))
    assert camera.fps == pytest.approx(10.0)
    assert numbers_in(camera.file) == [*range(2, 10), 9, 12, *range(12, 20)]


def test_images_that_are_none_are_refused_and_leave_nothing_behind(
    tmp_path: Path, kept: Kept
) -> None:
    found = footage_of(bag(tmp_path, lambda _: np.zeros(20, np.uint8)), 0.0, kept=kept)
    assert not found.cameras
    assert "expected JPEG or PNG" in found.refused[0]
    assert not list((tmp_path / "cache").iterdir())


def test_h264_stays_as_it_is(tmp_path: Path, kept: Kept) -> None:
    video = write_video(tmp_path / "run.mp4", 5, codec=H264)
    (camera,) = footage_of(tmp_path / "run.csv", 0.0, kept=kept).cameras
    assert camera.file == video
