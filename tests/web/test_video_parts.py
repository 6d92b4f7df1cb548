"""Videos are sent in parts: what a browser asks for, and what nobody gets."""

import os
from pathlib import Path

import pytest
from talking import cookie, get

from keyphase.web.server import PageServer
from keyphase.web.transport.video_parts import MAX_PART_BYTES, Video, video_part

SIZE = 3 * MAX_PART_BYTES + 17


@pytest.fixture
def video(tmp_path: Path) -> Video:
    file = tmp_path / "run.mp4"
    file.write_bytes(os.urandom(SIZE))
    return Video(file, "video/mp4")


@pytest.mark.parametrize(
    ("asked", "first", "last"),
    [
        ("bytes=0-", 0, MAX_PART_BYTES - 1),
        ("bytes=10-19", 10, 19),
        (f"bytes={SIZE - 5}-", SIZE - 5, SIZE - 1),
        ("bytes=-7", SIZE - 7, SIZE - 1),
        (f"bytes=5-{10**17}", 5, MAX_PART_BYTES + 4),
    ],
)
def test_a_range_is_answered_with_that_part_and_no_more_than_a_piece(
    video: Video, asked: str, first: int, last: int
) -> None:
    response = video_part(video, {"Range": asked})

    assert response.status_code == 206
    assert response.headers["Content-Range"] == f"bytes {first}-{last}/{SIZE}"
    assert response.body == video.file.read_bytes()[first : last + 1]
    assert response.headers["Content-Type"] == "video/mp4"


@pytest.mark.parametrize(
    "asked",
    [None, f"bytes={SIZE}-", "bytes=5-2", "bytes=-", "bytes=-0", "bytes=0-1,5-6", "lines=0-1", "x"],
)
def test_what_is_no_single_range_of_the_file_is_416(video: Video, asked: str | None) -> None:
    response = video_part(video, {"Range": asked} if asked else {})

    assert response.status_code == 416
    assert response.headers["Content-Range"] == f"bytes */{SIZE}"


def test_a_small_video_comes_whole_where_no_range_is_asked_for(tmp_path: Path) -> None:
    file = tmp_path / "small.mp4"
    file.write_bytes(b"small")

    assert video_part(Video(file, "video/mp4"), {}).status_code == 200


def test_a_video_that_became_a_pipe_or_went_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")

    for name in ("pipe", "gone"):
        response = video_part(Video(tmp_path / name, "video/mp4"), {"Range": "bytes=0-"})
        assert response.status_code == 404


def test_only_what_was_lent_is_served_and_only_to_who_has_the_token(
    server: PageServer, tmp_path: Path
) -> None:
    assert get(server, "/app/video/x", cookie(server))[0].status == 404
    assert get(server, "/app/video/%2e%2e/etc/passwd", cookie(server))[0].status == 404
    assert get(server, f"/app/video/{tmp_path}", cookie(server))[0].status == 404
    assert get(server, "/app/video/x", {})[0].status == 403
