"""A replay watched in real Chromium: does it keep real time while it is streamed, and how soon
does it stop?

Jitter: how far replay time runs off the clock within windows of half a second; of the server by
its own clock at each batch of ticks, of the page by the page's as it draws. The processor time of
the replay's own thread says how much of a core it needs, whatever else the machine does. Stopping:
from the key press to the message that it stands still.
"""

import shutil
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "browser"))
from chromium import chromium_browser
from driver import KeyphasePage

from keyphase.files.shipped import shipped
from keyphase.web.server import PageServer
from keyphase.workbench.replaying.run import Tick
from keyphase.workbench.replaying.running import Running
from keyphase.workbench.watcher import Watcher

WINDOW_S = 0.5
MAX_JITTER = 0.05
MAX_STOP_MS = 100.0
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


class Paced(Watcher):
    """Notes at each batch of ticks the clock, replay time, and the thread's processor time."""

    def __init__(self) -> None:
        self.noted: list[tuple[float, float, float]] = []

    def show_tick(self, running: Running, tick: Tick) -> None:
        """Called in the replay's own thread."""
        if running.number == 1:
            self.noted.append((time.perf_counter(), tick.state.elapsed_s, time.thread_time()))


def test_a_replay_keeps_real_time_and_stops_at_once(tmp_path: Path) -> None:
    shutil.copy(shipped("data") / "setup1.npz", tmp_path)
    server = PageServer([tmp_path / "setup1.npz"])
    paced = Paced()
    with chromium_browser() as browser:
        page = KeyphasePage(browser.new_page(viewport={"width": 1280, "height": 720}))
        page.page.goto(server.link)
        page.wait_for_document()
        server.workbench.views[0].watch(paced)
        page.wait_for_scene()
        page.change(lambda: page.press("i"))
        page.page.evaluate(_WATCH)
        page.press("p")
        page.until("keyphase.state.replay && keyphase.state.replay.phase === 'over'")
        in_page = paces(np.array(page.page.evaluate("() => seen")))
        stops = [stop_ms(page) for _ in range(STOPS)]
    server.stop()
    noted = np.array(paced.noted)
    on_server = paces(noted[:, :2])
    share = np.ptp(noted[:, 2]) / np.ptp(noted[:, 1])
    print(f"\nserver: {said(on_server)}; its thread takes {100 * share:.0f} % of a core")
    print(f"page: {said(in_page)}")
    print(f"stopped within {np.median(stops):.0f} ms median, {max(stops):.0f} ms largest")
    for factors in (on_server, in_page):
        assert abs(factors.mean() - 1.0) < MAX_JITTER
        assert np.median(np.abs(factors - 1.0)) < MAX_JITTER
    assert max(stops) < MAX_STOP_MS


def said(factors: np.ndarray) -> str:
    """Real-time factor and jitter in words."""
    jitter = 100 * np.abs(factors - 1.0)
    return (
        f"real-time factor {factors.mean():.3f}, jitter {np.median(jitter):.1f} % median, "
        f"{jitter.max():.1f} % largest over {WINDOW_S} s"
    )


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
