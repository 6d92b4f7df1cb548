"""How quick the page is, counted in the page, in real Chromium with 3D drawn in software.

Threshold: from the input event that carried the value to the first frame of the timeline with the
new segments, and to that of the 3D scene, for the line and for the panel's slider. A million
samples: how long the page takes to open, and zooming, panning and dragging a boundary with the
mouse, from each input event to the frame of the timeline that shows it. All of it without a camera,
and with one beside the scene whose picture follows the pointer.
"""

import math
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from playwright.sync_api import Browser

sys.path.insert(0, str(Path(__file__).parents[1]))
sys.path.insert(0, str(Path(__file__).parents[1] / "browser"))
from chromium import chromium_browser
from driver import KeyphasePage
from footage import name_beside

from keyphase.files.shipped import shipped
from keyphase.web.server import PageServer
from long_recording import write_long
from numbered_videos import LIKE_LEROBOT, write_video

MOVES = 100
PAUSE_MS = 60

GESTURE_MOVES = 80

_WATCH = """() => {
  const seen = (window.gestureMs ??= []);
  const watch = event => {
    if (event.type === "pointermove" && !event.buttons) return;
    const first = event.getCoalescedEvents?.()[0] ?? event;
    keyphase.store.afterFrame(() => seen.push(performance.now() - first.timeStamp));
  };
  addEventListener("wheel", watch, { capture: true, passive: true });
  addEventListener("pointermove", watch, { capture: true });
}"""
"""Times every turn of the wheel and every move with a button held, until it has been drawn."""


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium_browser() as running:
        yield running


@pytest.fixture(scope="module", params=["no camera", "camera"])
def camera(request: pytest.FixtureRequest) -> bool:
    return request.param == "camera"


@pytest.fixture(scope="module")
def short(
    browser: Browser, tmp_path_factory: pytest.TempPathFactory, camera: bool
) -> Iterator[KeyphasePage]:
    """The recorded Setup 1, under the method whose line lies over the normalized error."""
    path = tmp_path_factory.mktemp("short") / "setup1.npz"
    shutil.copy(shipped("data") / "setup1.npz", path)
    for page in visited(browser, path, (200, 30.0) if camera else None):
        page.set_parameter("variant", "paper")
        yield page


@pytest.fixture(scope="module")
def long(
    browser: Browser, tmp_path_factory: pytest.TempPathFactory, camera: bool
) -> Iterator[KeyphasePage]:
    """A million samples: Setup 1 again and again, at 250 Hz for more than an hour."""
    path = tmp_path_factory.mktemp("long") / "million.npz"
    write_long(path)
    yield from visited(browser, path, (2000, 0.5) if camera else None)


def visited(
    browser: Browser, path: Path, video: tuple[int, float] | None = None
) -> Iterator[KeyphasePage]:
    """The page on a recording, with a video of so many frames at so many a second beside it."""
    if video is not None:
        file, (frames, fps) = name_beside(path, "above"), video
        write_video(file, frames, fps, codec=LIKE_LEROBOT, size=(640, 360))
    begun = time.perf_counter()
    server = PageServer([path])
    page = KeyphasePage(browser.new_page(viewport={"width": 1920, "height": 1080}))
    page.page.set_default_timeout(180_000)
    page.page.goto(server.link)
    page.wait_for_document()
    drawn = time.perf_counter()
    page.wait_for_scene()
    # The robot joins the scene once its joints are worked out.
    assert server.scenes.wait_until_drawn(180.0)
    page.wait_for_scene()
    rest = time.perf_counter()
    print(f"\n{path.stem}: timeline after {drawn - begun:.1f} s, scene after {rest - begun:.1f} s")
    if video is not None:
        page.until("document.querySelector('.camera video')?.readyState >= 2")
    page.page.evaluate(_WATCH)
    yield page
    page.close()
    server.stop()


def percentiles(values: list[float]) -> tuple[float, float]:
    """Median and 95th percentile."""
    return float(np.median(values)), float(np.percentile(values, 95))


def line_point(page: KeyphasePage) -> tuple[float, float]:
    row = page.row("error")
    told = page.page.evaluate("() => keyphase.timeline.thresholdY()")
    return row.x + 0.6 * row.width, page.box(".surface").y + told


def to_and_fro(page: KeyphasePage, start: tuple[float, float], by: tuple[float, float]) -> None:
    """Hold and move on a triangle, one move each PAUSE_MS, as a hand does.

    As far as to where the threshold takes segments away, so that the scene changes, too.
    """
    mouse = page.page.mouse
    mouse.move(*start)
    mouse.down()
    for k in range(MOVES):
        share = abs((k / 12) % 2 - 1)
        mouse.move(start[0] + by[0] * share, start[1] + by[1] * share)
        page.page.wait_for_timeout(PAUSE_MS)
    mouse.up()
    page.page.wait_for_timeout(1000)


def latencies(page: KeyphasePage) -> list[dict[str, Any]]:
    return page.page.evaluate("() => keyphase.latency.splice(0)")


def of(measured: list[dict[str, Any]], source: str) -> list[float]:
    return [one["milliseconds"] for one in measured if one["source"] == source]


def turn_the_wheel(page: KeyphasePage) -> None:
    """Closer and further over the middle of a track."""
    page.page.mouse.move(*page.row("position").middle)
    for k in range(GESTURE_MOVES):
        page.page.mouse.wheel(0, -150 if k % 40 < 20 else 150)
        page.page.wait_for_timeout(PAUSE_MS / 2)


def pan(page: KeyphasePage) -> None:
    swing(page, page.row("position").middle, 200.0)


def drag_a_boundary(page: KeyphasePage) -> None:
    """The first one in view, with forty seconds in view."""
    page.page.evaluate("() => keyphase.store.set({ view: { from: 2000, to: 2040 } })")
    page.page.wait_for_timeout(1000)
    row = page.row("boundaries")
    times = [one["time_s"] for one in page.document["boundaries"]]
    first = next(time_s for time_s in times if time_s > 2020)
    swing(page, (page.x(first), row.middle[1]), 15.0)


def swing(page: KeyphasePage, start: tuple[float, float], reach: float) -> None:
    """Hold, move to both sides, let go where it was."""
    mouse = page.page.mouse
    mouse.move(*start)
    mouse.down()
    for k in range(GESTURE_MOVES):
        mouse.move(start[0] + reach * math.sin(k / 4), start[1])
        page.page.wait_for_timeout(PAUSE_MS / 2)
    page.press("Escape")
    mouse.up()


GESTURES = {"zoom": turn_the_wheel, "pan": pan, "drag": drag_a_boundary}


def thread_clock(page: KeyphasePage) -> Callable[[], float]:
    """Tells what the page's thread has worked since [ms]; comparable on cores that others use."""
    session = page.page.context.new_cdp_session(page.page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})

    def busy_ms() -> float:
        metrics = session.send("Performance.getMetrics")["metrics"]
        return next(1000.0 * one["value"] for one in metrics if one["name"] == "TaskDuration")

    begun_ms = busy_ms()
    return lambda: busy_ms() - begun_ms


def gesture_ms(page: KeyphasePage, gesture: str) -> list[float]:
    page.page.evaluate("() => window.gestureMs.splice(0)")
    GESTURES[gesture](page)
    return page.page.evaluate("() => window.gestureMs.splice(0)")


@pytest.mark.parametrize("source", ["line", "slider"])
def test_threshold_to_new_segments(short: KeyphasePage, benchmark, source: str) -> None:
    # From where the threshold is by itself, which the slider can reach.
    short.page.evaluate("() => keyphase.actions.automaticThreshold()")
    short.page.wait_for_timeout(2000)
    latencies(short)
    start = line_point(short) if source == "line" else short.slider("Threshold")
    by = (0.0, -60.0) if source == "line" else (30.0, 0.0)
    benchmark.pedantic(to_and_fro, args=(short, start, by), rounds=1, iterations=1)
    measured = latencies(short)
    for shown, values in ((source, of(measured, source)), ("3D scene", of(measured, "scene"))):
        if not values:
            print(f"\n{source}: {shown}, not timed: no move of the hand changed a segment there")
            continue
        median, late = percentiles(values)
        print(f"\n{source}: {shown}, {len(values)} moves: {median:.1f} ms, 95 % {late:.1f} ms")
        benchmark.extra_info[shown] = {"count": len(values), "median_ms": median, "p95_ms": late}
    median, late = percentiles(of(measured, source))
    assert median < 50.0
    assert late < 100.0


@pytest.mark.parametrize("gesture", GESTURES)
def test_a_million_samples(long: KeyphasePage, benchmark, gesture: str) -> None:
    busy_ms = thread_clock(long)
    measured = benchmark.pedantic(gesture_ms, args=(long, gesture), rounds=1, iterations=1)
    busy = busy_ms() / len(measured)
    assert busy > 0.5
    median, late = percentiles(measured)
    benchmark.extra_info.update(count=len(measured), median_ms=median, p95_ms=late, busy_ms=busy)
    print(f"\n{gesture}: {len(measured)} inputs, median {median:.1f} ms, 95 % {late:.1f} ms")
    print(f"{gesture}: {busy:.1f} ms of the page's thread for each")
    if gesture == "zoom":
        assert median < 100.0
    else:
        assert late < 50.0
