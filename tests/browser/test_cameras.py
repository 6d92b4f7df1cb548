"""Video beside the signals: the frame on the screen is the frame of the time, to the number."""

from pathlib import Path

import pytest
from driver import KeyphasePage, LookAt
from footage import cameras, frames_at_random, name_beside, offset_of, seek_frame

from numbered_videos import H264, LIKE_LEROBOT, READ_NUMBER, write_video

CODECS = {"h264": H264, "av1": LIKE_LEROBOT}


@pytest.fixture(scope="session")
def videos(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """Three seconds at 30 frames in a second, of each kind."""
    folder = tmp_path_factory.mktemp("videos")
    return {
        name: write_video(folder / f"{name}.mp4", 90, codec=codec).read_bytes()
        for name, codec in CODECS.items()
    }


@pytest.fixture
def filmed(folder: Path, look_at: LookAt, videos: dict[str, bytes]) -> KeyphasePage:
    """The page on a recording with two cameras."""
    recording = folder / "setup1.npz"
    for name, data in videos.items():
        name_beside(recording, name).write_bytes(data)
    page = look_at(recording)
    cameras(page)
    return page


@pytest.mark.parametrize("name", CODECS)
def test_the_frame_of_the_playhead_is_the_one_that_is_seen(filmed: KeyphasePage, name: str) -> None:
    camera = next(one for one in cameras(filmed) if one["name"] == name)
    filmed.page.evaluate("name => keyphase.store.set({ camerasChosen: [name] })", name)
    for frame in frames_at_random(camera, 15, seed=1):
        assert seek_frame(filmed, camera, frame)[0] == frame


def test_keys_go_frame_by_frame_and_lay_the_camera_anew_as_edits(filmed: KeyphasePage) -> None:
    camera = cameras(filmed)[0]
    seek_frame(filmed, camera, 30)
    filmed.press("'")
    filmed.until(
        f"document.querySelector('[data-camera={camera['name']}] video').dataset.frame == 31"
    )
    filmed.press(";")
    filmed.press(";")
    filmed.until(
        f"document.querySelector('[data-camera={camera['name']}] video').dataset.frame == 29"
    )

    filmed.change(lambda: filmed.press(")"))
    assert offset_of(filmed, camera) == pytest.approx(1 / 30, abs=1e-6)
    filmed.until(
        f"document.querySelector('[data-camera={camera['name']}] video').dataset.frame == 28"
    )
    field = filmed.page.get_by_label(f"Offset of {camera['name']} in ms")
    field.fill("-500")
    filmed.change(lambda: field.press("Enter"))
    assert seek_frame(filmed, camera, 60)[0] == 60
    filmed.page.locator(".surface").focus()
    filmed.change(lambda: filmed.press("Control+z"))
    assert offset_of(filmed, camera) == pytest.approx(1 / 30, abs=1e-6)


def test_hovering_over_the_timeline_scrubs_and_leaving_it_goes_back(filmed: KeyphasePage) -> None:
    camera = cameras(filmed)[0]
    seek_frame(filmed, camera, 10)
    row = filmed.row("ruler")
    filmed.page.mouse.move(filmed.x(camera["begins_s"] + 50.5 / 30), row.y + row.height / 2)
    video = f"document.querySelector('[data-camera={camera['name']}] video')"
    filmed.until(f"Math.abs({video}.dataset.frame - 50) <= 1")
    filmed.page.mouse.move(5, 5)
    filmed.until(f"{video}.dataset.frame == 10")


def test_the_picture_runs_with_the_playhead(filmed: KeyphasePage) -> None:
    camera = cameras(filmed)[0]
    seek_frame(filmed, camera, 0)
    filmed.page.evaluate("() => keyphase.actions.play({ playing: true, speed: 0.5 })")
    filmed.until("keyphase.state.playhead.playing")
    filmed.until("keyphase.state.clock > keyphase.state.document.start_s + 1")
    apart = filmed.page.evaluate(
        f"""() => {{
          const video = document.querySelector('[data-camera="{camera["name"]}"] video');
          const number = ({READ_NUMBER})(video);
          return number / 30 - (keyphase.state.clock - {camera["begins_s"]});
        }}"""
    )
    filmed.page.evaluate("() => keyphase.actions.play({ playing: false, speed: 1 })")
    assert abs(apart) < 0.35
    filmed.until("!keyphase.state.playhead.playing")
    frame = filmed.page.evaluate(
        f"() => Math.floor((keyphase.state.clock - {camera['begins_s']}) * 30 + 0.02)"
    )
    assert seek_frame(filmed, camera, frame)[0] == frame


def test_small_pictures_stand_along_the_segments(filmed: KeyphasePage) -> None:
    filmed.page.wait_for_function(
        """() => {
          const all = [...document.querySelectorAll(".film-strip image")];
          const made = (one) => one.getAttribute("href")?.startsWith("data:image/jpeg");
          return all.length > 3 && all.every(made);
        }"""
    )
    filmed.until_seen("cameras_light", lambda _: True)
    filmed.set_theme(dark=True)
    filmed.picture("cameras_dark")
    strip = filmed.page.get_by_role("button", name="Camera", exact=True)
    strip.click()
    filmed.until("document.querySelectorAll('.film-strip image').length === 0")
    strip.click()
    filmed.until("document.querySelectorAll('.film-strip image').length > 3")
    filmed.press("h")
    filmed.until("document.getElementById('cameras').hidden")
    assert filmed.page.locator(".film-strip image").count() == 0
    filmed.set_theme(dark=False)


def test_a_video_that_is_none_is_told_and_not_shown(folder: Path, look_at: LookAt) -> None:
    (folder / "setup1.mp4").write_bytes(b"\0\0\0\x18ftypisom" + b"\0" * 500)
    page = look_at(folder / "setup1.npz")
    page.until("keyphase.state.cameras")
    page.page.locator(".camera-refused li").wait_for()
    assert "expected a whole video" in page.text(".camera-refused")
    assert page.page.locator(".camera video").count() == 0
