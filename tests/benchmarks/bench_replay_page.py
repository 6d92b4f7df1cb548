"""A replay watched in real Chromium: does it keep real time while it is streamed, and how soon
does it stop?

Jitter: how far replay time runs off the clock within windows of half a second, by the page's own
clock. Stopping: from the key press to the message that it is over.
"""

import shutil
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "browser"))
from chromium import chromium_browser
from driver import KeyphasePage

from keyphase.shipped import shipped
from keyphase.web.server import PageServer

WINDOW_S = 0.5
MOST_JITTER = 0.05
MOST_STOP_MS = 100.0
STOPS = 5

_WATCH = """() => {
  window.seen = [];
  keyphase.store.on(['samples'], ({ samples }) => {
    if (samples?.count) seen.push([performance.now() / 1000, samples.time[samples.count - 1]]);
  });
}"""

_STOP_MS = """() => new Promise(done => {
  const before = performance.now();
  const watch = () => keyphase.state.replay.phase !== 'running'
    ? done(performance.now() - before) : setTimeout(watch, 1);
  document.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', bubbles: true }));
  watch();
})"""


def test_a_replay_keeps_real_time_and_stops_at_once(tmp_path: Path) -> None:
    shutil.copy(shipped("data") / "setup1.npz", tmp_path)
    server = PageServer([tmp_path / "setup1.npz"])
    with chromium_browser() as browser:
        page = KeyphasePage(browser.new_page(viewport={"width": 1280, "height": 720}))
        page.page.goto(server.link)
        page.wait_for_document()
        page.wait_for_scene()
        page.change(lambda: page.press("i"))
        page.page.evaluate(_WATCH)
        page.press("p")
        page.until("keyphase.state.replay && keyphase.state.replay.phase === 'over'")
        factors = paces(np.array(page.page.evaluate("() => seen")))
        stops = [stop_ms(page) for _ in range(STOPS)]
    server.stop()
    jitter = np.abs(factors - 1.0)
    print(
        f"real-time factor {factors.mean():.3f}, jitter {100 * np.median(jitter):.1f} % median, "
        f"{100 * jitter.max():.1f} % largest over {WINDOW_S} s; stopped within "
        f"{np.median(stops):.0f} ms median, {max(stops):.0f} ms largest"
    )
    assert abs(factors.mean() - 1.0) < MOST_JITTER
    assert np.median(jitter) < MOST_JITTER
    assert max(stops) < MOST_STOP_MS


def paces(seen: np.ndarray) -> np.ndarray:
    """Replay time per real time, window by window; the first moments of a run do not count."""
    wall, replayed = seen[3:].T
    edges = np.arange(wall[0], wall[-1], WINDOW_S)
    return np.diff(np.interp(edges, wall, replayed)) / WINDOW_S


def stop_ms(page: KeyphasePage) -> float:
    """How long one replay takes to stop."""
    page.page.evaluate("() => keyphase.actions.replay.again()")
    page.until("keyphase.state.replay?.phase === 'running' && keyphase.state.replay.current === 1")
    return float(page.page.evaluate(_STOP_MS))
