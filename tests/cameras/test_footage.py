"""Which videos belong to a recording, and which of their frames was taken when."""

import os
from pathlib import Path

import pytest

from keyphase.cameras import footage_of
from keyphase.cameras.kept import Kept
from numbered_videos import write_video


@pytest.fixture
def kept(tmp_path: Path) -> Kept:
    return Kept(tmp_path / "cache")


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    made = tmp_path / "recordings"
    made.mkdir()
    return made


def test_videos_named_after_a_recording_are_its_cameras(folder: Path, kept: Kept) -> None:
    recording = folder / "run.csv"
    for name in ("run.mp4", "run.wrist.mp4", "run_scene.webm", "runner.mp4", "other.mp4"):
        codec = ("libvpx-vp9", {"deadline": "realtime"}) if name.endswith("webm") else None
        write_video(folder / name, 10, 25.0, **({"codec": codec} if codec else {}))
    found = footage_of(recording, 3.0, kept=kept)
    assert {one.name: one.media_type for one in found.cameras} == {
        "camera": "video/mp4",
        "wrist": "video/mp4",
        "scene": "video/webm",
    }
    first = found.cameras[0]
    assert (first.fps, first.frames, first.begins_s, first.width) == (25.0, 10, 3.0, 256)
    assert not found.refused


def test_a_video_belongs_to_the_longest_name_it_is_named_after(folder: Path, kept: Kept) -> None:
    for name in ("run.csv", "run_2.csv"):
        (folder / name).touch()
    write_video(folder / "run_2.mp4", 5)
    assert not footage_of(folder / "run.csv", 0.0, kept=kept).cameras
    assert len(footage_of(folder / "run_2.csv", 0.0, kept=kept).cameras) == 1


def test_what_no_browser_plays_is_made_playable_once(folder: Path, kept: Kept) -> None:
    write_video(folder / "run.mp4", 12, codec=("mpeg4", {}))
    (camera,) = footage_of(folder / "run.csv", 0.0, kept=kept).cameras
    assert camera.file.parent == folder.parent / "cache"
    assert camera.frames == 12
    before = camera.file.stat().st_ino
    (again,) = footage_of(folder / "run.csv", 0.0, kept=kept).cameras
    assert (again.file, again.file.stat().st_ino) == (camera.file, before)


def cut(path: Path) -> None:
    whole = write_video(path, 30).read_bytes()
    path.write_bytes(whole[: len(whole) // 2])


def pipe(path: Path) -> None:
    os.mkfifo(path)


def endless(path: Path) -> None:
    path.symlink_to("/dev/zero")


def empty_space(path: Path) -> None:
    path.write_bytes(b"\0\0\0\x18ftypisom")
    os.truncate(path, 1 << 40)


def playlist(path: Path) -> None:
    path.write_text("#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\nfile:///etc/passwd\n")


def index_without_end(path: Path) -> None:
    path.write_bytes(b"\0\0\0\x18ftypisom" + b"\0" * 12 + b"\0\0\0\x08free" * 200_000)


@pytest.mark.parametrize(
    "hostile", [cut, pipe, endless, empty_space, playlist, index_without_end, Path.mkdir]
)
def test_what_is_no_whole_video_is_refused_in_a_sentence(hostile, folder: Path, kept: Kept) -> None:
    hostile(folder / "run.mp4")
    found = footage_of(folder / "run.csv", 0.0, kept=kept)
    assert not found.cameras
    (told,) = found.refused
    assert told.startswith(str(folder / "run.mp4"))
    assert "\n" not in told
