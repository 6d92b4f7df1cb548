"""Fixtures of the browser tests: the real server on real files, and real Chromium looking at it."""

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from driver import KeyphasePage
from playwright.sync_api import Browser, sync_playwright

from keyphase.shipped import shipped
from keyphase.web.server import PageServer

FLAGS = [
    "--headless",
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--ignore-gpu-blocklist",
    "--disable-gpu-compositing",
    "--disable-dev-shm-usage",
    "--hide-scrollbars",
]
"""Software rendering; without --disable-gpu-compositing one click in three is lost."""

NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")

Serve = Callable[..., PageServer]
Visit = Callable[..., KeyphasePage]


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if Path(__file__).parent in item.path.parents:
            item.add_marker(pytest.mark.browser)


@pytest.fixture(scope="session")
def chromium() -> Iterator[Browser]:
    found = next(filter(None, map(shutil.which, NAMES)), None)
    if found is None:
        pytest.skip("no Chromium or Chrome found; `make test` installs one or says how")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=found, headless=True, args=FLAGS)
        yield browser
        browser.close()


@pytest.fixture
def serve() -> Iterator[Serve]:
    """Starts servers on copies, since labels are kept beside the recording."""
    servers: list[PageServer] = []

    def start(*paths: Path, **options: object) -> PageServer:
        servers.append(PageServer(list(paths), **options))  # type: ignore
        return servers[-1]

    yield start
    for server in servers:
        server.stop()


@pytest.fixture
def visit(chromium: Browser) -> Iterator[Visit]:
    """Opens a server's page; at the end no script may have failed."""
    pages: list[KeyphasePage] = []

    def open_page(
        server: PageServer, size: tuple[int, int] = (1920, 1080), dark: bool = False
    ) -> KeyphasePage:
        page = chromium.new_page(
            viewport={"width": size[0], "height": size[1]},
            color_scheme="dark" if dark else "light",
        )
        pages.append(KeyphasePage(page))
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
    for name in ("setup1.npz", "synthetic_setup1.npz"):
        shutil.copy(shipped("data") / name, tmp_path)
    return tmp_path


@pytest.fixture
def setup1(folder: Path, serve: Serve, visit: Visit) -> KeyphasePage:
    """The page at 1920x1080 on the recorded Setup 1."""
    page = visit(serve(folder / "setup1.npz"))
    page.wait_for_document()
    return page
