"""Fixtures of the browser tests: the real server on real files, and real Chromium looking at it."""

import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from chromium import chromium_browser
from driver import KeyphasePage, Serve, Visit
from playwright.sync_api import Browser, Route

from keyphase.readers import find_recordings
from keyphase.shipped import shipped
from keyphase.web.server import PageServer


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if Path(__file__).parent in item.path.parents:
            item.add_marker(pytest.mark.browser)


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    with chromium_browser() as browser:
        yield browser


_AS_OPENED = """() => {
  const { snap, playhead, logarithmic, folded, hidden } = keyphase.state;
  const tracks = [logarithmic, [...folded], [...hidden]];
  return JSON.stringify([snap, playhead.speed, playhead.loop, tracks]);
}"""
"""What of a page stays as it is from one recording to the next."""


@dataclass
class _Editor:
    """A server without a folder of its own, and a page of it that stays open."""

    server: PageServer
    page: KeyphasePage
    _before: str = ""

    def open(self, recording: Path) -> None:
        self.server.session.queue.add(recording)
        self.page.until("keyphase.state.recordings.items.length === 1")
        self.page.wait_for_document()
        self._before = self.page.page.evaluate(_AS_OPENED)

    def put_away(self, recording: Path) -> None:
        self.page.press("Escape")
        self.page.page.mouse.move(0, 0)
        after = self.page.page.evaluate(_AS_OPENED)
        assert after == self._before, "the next test needs a page of its own: take `timeline`"
        self.server.session.queue.remove(recording)
        self.page.until("keyphase.state.recordings.items.length === 0")
        assert not self.page.errors


@pytest.fixture(scope="module")
def _editor(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[_Editor]:
    server = PageServer([], folder=tmp_path_factory.mktemp("editor"))
    page = _opened(chromium, server, (1920, 1080), dark=False, scene=False)
    yield _Editor(server, page)
    page.close()
    server.stop()


@pytest.fixture
def editor(_editor: _Editor, folder: Path) -> Iterator[KeyphasePage]:
    """Like `timeline`, for tests that change nothing but the document and what is seen of it.

    The page stays open from one of them to the next, the recording is a new one.
    """
    recording = folder / "setup1.npz"
    _editor.open(recording)
    yield _editor.page
    _editor.put_away(recording)


@pytest.fixture
def serve() -> Iterator[Serve]:
    """Starts servers on copies, since labels are kept beside the recording."""
    servers: list[PageServer] = []

    def start(*paths: Path, **options: object) -> PageServer:
        found = [recording.path for recording in find_recordings(paths)]
        servers.append(PageServer(found, **options))  # type: ignore
        return servers[-1]

    yield start
    for server in servers:
        server.stop()


def _answer_nothing(route: Route) -> None:
    route.fulfill(body="<html></html>", content_type="text/html")


_WITHOUT_SMOOTH_EDGES = """
const ofCanvas = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function (kind, wanted) {
  const asked = kind.startsWith("webgl") ? { ...wanted, antialias: false } : wanted;
  return ofCanvas.call(this, kind, asked);
};
"""
"""Without a graphics card, smooth edges of the 3D scene are half the work of drawing it."""


def _opened(
    chromium: Browser, server: PageServer, size: tuple[int, int], dark: bool, scene: bool
) -> KeyphasePage:
    page = chromium.new_page(
        viewport={"width": size[0], "height": size[1]},
        color_scheme="dark" if dark else "light",
    )
    opened = KeyphasePage(page)
    page.add_init_script(_WITHOUT_SMOOTH_EDGES)
    if not scene:
        page.route("**/viser/**", _answer_nothing)
    page.goto(server.link)
    return opened


@pytest.fixture
def visit(chromium: Browser) -> Iterator[Visit]:
    """Opens a server's page; at the end no script may have failed.

    Without `scene` the frame of the 3D scene stays empty: drawing it in software takes seconds,
    which tests of the timeline alone can do without.
    """
    pages: list[KeyphasePage] = []

    def open_page(
        server: PageServer,
        size: tuple[int, int] = (1920, 1080),
        dark: bool = False,
        scene: bool = True,
    ) -> KeyphasePage:
        pages.append(_opened(chromium, server, size, dark, scene))
        return pages[-1]

    yield open_page
    errors = [error for page in pages for error in page.errors]
    for page in pages:
        page.close()
    assert not errors


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with copies of the bundled recordings."""
    demonstrations = tmp_path / "demonstrations"
    demonstrations.mkdir()
    for name in ("setup1.npz", "synthetic_setup1.npz"):
        shutil.copy(shipped("data") / name, demonstrations)
    return demonstrations


@pytest.fixture
def setup1(folder: Path, serve: Serve, visit: Visit) -> KeyphasePage:
    """The page at 1280x720 on the recorded Setup 1."""
    page = visit(serve(folder / "setup1.npz"), size=(1280, 720))
    page.wait_for_document()
    return page


@pytest.fixture
def timeline(folder: Path, serve: Serve, visit: Visit) -> KeyphasePage:
    """The same at 1920x1080 with an empty scene, for tests of the timeline alone."""
    page = visit(serve(folder / "setup1.npz"), scene=False)
    page.wait_for_document()
    return page
