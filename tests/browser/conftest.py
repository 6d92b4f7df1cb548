"""Fixtures of the browser tests: the real server on real files, and real Chromium looking at it."""

import shutil
from collections.abc import Iterator
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
        page = chromium.new_page(
            viewport={"width": size[0], "height": size[1]},
            color_scheme="dark" if dark else "light",
        )
        pages.append(KeyphasePage(page))
        page.add_init_script(_WITHOUT_SMOOTH_EDGES)
        if not scene:
            page.route("**/viser/**", _answer_nothing)
        page.goto(server.link)
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
