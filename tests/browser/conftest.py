"""Fixtures of the browser tests: the real server on real files, and real Chromium looking at it."""

import shutil
from collections.abc import Generator, Iterator
from functools import partial
from pathlib import Path

import pytest
from chromium import chromium_browser
from driver import KeyphasePage, LookAt, Serve, Visit
from playwright.sync_api import Browser

from keyphase.files.shipped import shipped
from keyphase.readers import find_recordings
from keyphase.web.server import PageServer


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if Path(__file__).parent in item.path.parents:
            item.add_marker(pytest.mark.browser)


_FAILED = pytest.StashKey[bool]()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    item.stash[_FAILED] = call.excinfo is not None
    return (yield)


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


_FORGET = """() => {
  localStorage.clear();
  history.replaceState(null, "", location.pathname);
}"""
"""What a page would begin with: its choices, and the recording that its address names."""


class _Editor:
    """A server without a folder of its own, and a page of it that stays open."""

    def __init__(self, chromium: Browser, folder: Path, size: tuple[int, int], scene: bool) -> None:
        self.server = PageServer([], folder=folder)
        self._size = {"width": size[0], "height": size[1]}
        self._new = partial(_opened, chromium, self.server, size, dark=False, scene=scene)
        self._page: KeyphasePage | None = None
        self._before = ""

    def open(self, *recordings: Path) -> KeyphasePage:
        """The page on the first of these recordings."""
        page = self._page = self._page or self._new()
        page.until("keyphase.state.greeted")
        workbench = self.server.workbench
        added = [workbench.recordings.add(one) for one in recordings]
        workbench.views[-1].open(added[0].id)
        workbench.looking.begin()
        page.until(f"keyphase.state.recordings?.items.length === {len(added)}")
        page.wait_for_document()
        self._before = page.page.evaluate(_AS_OPENED)
        return page

    def put_away(self, again: bool, changed: bool = False) -> None:
        """Close all recordings, and the page unless it is wanted `again`.

        `changed`: more of it than the document is not as it was; it is loaded again.
        """
        page, self._page = self._page, None
        assert page
        try:
            page.press("Escape")
            page.page.mouse.move(0, 0)
            after = page.page.evaluate(_AS_OPENED)
            same = changed or after == self._before
            assert same, "the next test needs a page of its own: take `timeline`"
            assert not page.errors
            self._page = page if again else None
        finally:
            for one in self.server.workbench.recordings.recordings:
                self.server.workbench.remove(one.path)
            if self._page is None:
                page.close()
        if self._page:
            page.until("keyphase.state.recordings.items.length === 0")
        if self._page and changed:
            page.page.evaluate(_FORGET)
            page.page.set_viewport_size(self._size)
            page.page.reload()

    def close(self) -> None:
        if self._page:
            self._page.close()
        self.server.stop()


@pytest.fixture(scope="session")
def _editor(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[_Editor]:
    editor = _Editor(chromium, tmp_path_factory.mktemp("editor"), (1920, 1080), scene=False)
    yield editor
    editor.close()


@pytest.fixture(scope="session")
def _scene_editor(chromium: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[_Editor]:
    editor = _Editor(chromium, tmp_path_factory.mktemp("editor"), (1280, 720), scene=True)
    yield editor
    editor.close()


@pytest.fixture
def editor(
    request: pytest.FixtureRequest, _editor: _Editor, folder: Path
) -> Iterator[KeyphasePage]:
    """Like `timeline`, for tests that change nothing but the document and what is seen of it.

    The page stays open from one of them to the next, unless one fails; the recording is a new one.
    """
    yield _editor.open(folder / "setup1.npz")
    _editor.put_away(again=not request.node.stash.get(_FAILED, False))


@pytest.fixture
def scene_editor(
    request: pytest.FixtureRequest, _scene_editor: _Editor, folder: Path
) -> Iterator[KeyphasePage]:
    """The same like `setup1`, for tests that leave camera, panel and what is shown as they are."""
    yield _scene_editor.open(folder / "setup1.npz")
    _scene_editor.put_away(again=not request.node.stash.get(_FAILED, False))


@pytest.fixture
def timeline(
    request: pytest.FixtureRequest, _editor: _Editor, folder: Path
) -> Iterator[KeyphasePage]:
    """The page at 1920x1080 with an empty scene, on the recorded Setup 1; loaded again after."""
    yield _editor.open(folder / "setup1.npz")
    _editor.put_away(again=not request.node.stash.get(_FAILED, False), changed=True)


@pytest.fixture
def look_at(request: pytest.FixtureRequest, _editor: _Editor) -> Iterator[LookAt]:
    """Opens that page on any recordings; its size and theme may be changed."""
    yield _editor.open
    _editor.put_away(again=not request.node.stash.get(_FAILED, False), changed=True)


@pytest.fixture
def two(request: pytest.FixtureRequest, _editor: _Editor, folder: Path) -> Iterator[KeyphasePage]:
    """The same on two recordings, the first of them open."""
    yield _editor.open(folder / "setup1.npz", folder / "synthetic_setup1.npz")
    _editor.put_away(again=not request.node.stash.get(_FAILED, False), changed=True)


@pytest.fixture
def setup1(
    request: pytest.FixtureRequest, _scene_editor: _Editor, folder: Path
) -> Iterator[KeyphasePage]:
    """The page at 1280x720 with its scene, on the recorded Setup 1; loaded again after."""
    yield _scene_editor.open(folder / "setup1.npz")
    _scene_editor.put_away(again=not request.node.stash.get(_FAILED, False), changed=True)


@pytest.fixture
def editor_server(_editor: _Editor) -> PageServer:
    """The server of the page that `editor` is."""
    return _editor.server


@pytest.fixture
def scene_server(_scene_editor: _Editor) -> PageServer:
    """The server of the page that `setup1` is."""
    return _scene_editor.server


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


_WITHOUT_SCENE = """
Object.defineProperty(HTMLIFrameElement.prototype, "src", { set() {} });
"""
"""The frame of the scene stays empty. Answering in its place would switch off the cache."""


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
        page.add_init_script(_WITHOUT_SCENE)
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
