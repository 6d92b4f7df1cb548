"""How quick the page is, counted in the page, in real Chromium with 3D drawn in software.

Threshold: from the input event that carried the value to the first frame of the timeline with the
new segments, for the line and for the panel's slider. A million samples: zooming, panning, and
dragging a boundary, as time between frames.
"""

import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser

sys.path.insert(0, str(Path(__file__).parents[1]))
sys.path.insert(0, str(Path(__file__).parents[1] / "browser"))
from chromium import chromium_browser
from driver import KeyphasePage

from keyphase.shipped import shipped
from keyphase.web.server import PageServer
from synthetic import setup1

MOVES = 100
PAUSE_MS = 60
MILLION = 1_000_000

_FRAMES = """act => new Promise(async done => {
  const times = [];
  let running = true;
  const frame = now => { times.push(now); if (running) requestAnimationFrame(frame); };
  requestAnimationFrame(frame);
  for (let k = 0; k < 60; k++) {
    window.keyphaseBenchmark[act](k);
    await new Promise(next => requestAnimationFrame(next));
  }
  running = false;
  done(times.slice(1).map((time, k) => time - times[k]));
})"""
"""Acts once a frame and reports the time between frames."""

_ACTS = """() => {
  const { actions, state } = window.keyphase;
  window.keyphaseBenchmark = {
    zoom: k => actions.zoom(k % 20 < 10 ? 1.6 : 1 / 1.6, (state.view.from + state.view.to) / 2),
    pan: k => {
      const by = 0.02 * (k % 30 < 15 ? 1 : -1) * (state.view.to - state.view.from);
      keyphase.store.set({ view: { from: state.view.from + by, to: state.view.to + by } });
    },
    drag: k => {
      const scale = keyphase.timeline.scale();
      const by = 10 * Math.sin(k) * (scale.to - scale.from) / scale.width;
      const time = state.document.boundaries[1].time_s + by;
      keyphase.store.set({ drag: { boundary: 1, time, snapped: "", x: 400, y: 200 } });
    },
  };
}"""


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with chromium_browser() as running:
        yield running


@pytest.fixture(scope="module")
def short(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[KeyphasePage]:
    """The recorded Setup 1."""
    path = tmp_path_factory.mktemp("short") / "setup1.npz"
    shutil.copy(shipped("data") / "setup1.npz", path)
    yield from visited(browser, path)


@pytest.fixture(scope="module")
def long(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[KeyphasePage]:
    """A million samples: Setup 1 again and again, at 250 Hz for more than an hour."""
    path = tmp_path_factory.mktemp("long") / "million.npz"
    write_million(path)
    yield from visited(browser, path)


def visited(browser: Browser, path: Path) -> Iterator[KeyphasePage]:
    server = PageServer([path])
    page = KeyphasePage(browser.new_page(viewport={"width": 1920, "height": 1080}))
    page.page.set_default_timeout(180_000)
    page.page.goto(server.link)
    page.wait_for_document()
    page.wait_for_scene()
    yield page
    page.close()
    server.stop()


def write_million(path: Path) -> None:
    """Setup 1 there and back, repeated, so that position stays continuous."""
    one = setup1(5000, "real", forces=True).demonstration
    there_and_back = np.concatenate([one.position_m, one.position_m[::-1]])
    assert one.force_N is not None
    force = np.concatenate([one.force_N, one.force_N[::-1]])
    times = -(-MILLION // len(there_and_back))
    noise = np.random.default_rng(0).normal(0.0, 0.05, (MILLION, 3))
    np.savez(
        path,
        time_s=np.arange(MILLION) / one.rate_hz,
        position_m=np.tile(there_and_back, (times, 1))[:MILLION],
        force_N=np.tile(force, (times, 1))[:MILLION] + noise,
    )


def percentiles(values: list[float]) -> tuple[float, float]:
    """Median and 95th percentile."""
    return float(np.median(values)), float(np.percentile(values, 95))


def line_point(page: KeyphasePage) -> tuple[float, float]:
    row = page.row("error")
    told = page.page.evaluate(
        "() => keyphase.timeline.thresholdY(keyphase.state.document.threshold)"
    )
    return row.x + 0.6 * row.width, page.box(".surface").y + told


def to_and_fro(page: KeyphasePage, start: tuple[float, float], by: tuple[float, float]) -> None:
    """Hold and move on a triangle, one move each PAUSE_MS, as a hand does."""
    mouse = page.page.mouse
    mouse.move(*start)
    mouse.down()
    for k in range(MOVES):
        share = abs((k / 12) % 2 - 1)
        mouse.move(start[0] + by[0] * share, start[1] + by[1] * share)
        page.page.wait_for_timeout(PAUSE_MS)
    mouse.up()
    page.page.wait_for_timeout(1000)


def latencies(page: KeyphasePage, source: str) -> list[float]:
    measured = page.page.evaluate("() => keyphase.latency.splice(0)")
    return [one["milliseconds"] for one in measured if one["source"] == source]


def frames(page: KeyphasePage, act: str) -> list[float]:
    page.page.evaluate(_ACTS)
    page.page.evaluate("() => keyphase.store.set({ holding: true })")
    times = page.page.evaluate(_FRAMES, act)
    page.page.evaluate("() => keyphase.store.set({ drag: null, holding: false })")
    return times


@pytest.mark.parametrize("source", ["line", "slider"])
def test_threshold_to_new_segments(short: KeyphasePage, benchmark, source: str) -> None:
    latencies(short, source)
    start = line_point(short) if source == "line" else short.threshold_slider()
    by = (0.0, -30.0) if source == "line" else (30.0, 0.0)
    benchmark.pedantic(to_and_fro, args=(short, start, by), rounds=1, iterations=1)
    measured = latencies(short, source)
    median, late = percentiles(measured)
    benchmark.extra_info.update(count=len(measured), median_ms=median, p95_ms=late)
    print(f"\n{source}: {len(measured)} moves, median {median:.1f} ms, 95 % {late:.1f} ms")
    assert median < 50.0
    assert late < 100.0


@pytest.mark.parametrize("act", ["zoom", "pan", "drag"])
def test_a_million_samples(long: KeyphasePage, benchmark, act: str) -> None:
    if act == "drag":
        long.page.evaluate("() => keyphase.actions.zoom(60)")
    measured = benchmark.pedantic(frames, args=(long, act), rounds=1, iterations=1)
    median, late = percentiles(measured)
    benchmark.extra_info.update(count=len(measured), median_ms=median, p95_ms=late)
    print(f"\n{act}: {len(measured)} frames, median {median:.1f} ms, 95 % {late:.1f} ms")
    assert late < 50.0
