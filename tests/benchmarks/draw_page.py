"""Takes the pictures of the page in README and docs, in real Chromium, from the bundled recordings.

python tests/benchmarks/draw_page.py --output docs/pictures
python tests/benchmarks/draw_page.py --real FOLDER  also those of real recordings, one set a folder
"""

import argparse
import shutil
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path

from playwright.sync_api import Browser

sys.path.insert(0, str(Path(__file__).parents[1] / "browser"))
from chromium import chromium_browser
from driver import KeyphasePage

from keyphase.files.shipped import shipped
from keyphase.web.server import PageServer

LARGE = (1920, 1080)
MIDDLE = (1440, 900)
SMALL = (1280, 720)
WAIT_S = 120.0
LOADED_MS = 5_000
REAL = ("lund_yumi", "hiro_snap_assembly", "lasa_peeling")

_PARTS_SHOWN = """() => Object.keys(window.__viserMutable?.nodeRefFromName ?? {})
  .some(name => name.startsWith("/parts/"))"""

_ALL_HEARD = "() => window.__viserMutable?.messageQueue?.length === 0"

Take = Callable[[str], None]


def main() -> None:
    """Take them all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("docs/pictures"))
    parser.add_argument("--real", type=Path, help="the folder that holds the sets of recordings")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as copies, chromium_browser() as browser:
        folder = Path(copies) / "assembly"
        folder.mkdir()
        for name in ("setup1", "setup2", "wipe"):
            shutil.copy(shipped("data") / f"{name}.npz", folder)
        take = partial(_take, given.output)
        for dark in (False, True):
            with _opened(browser, folder, dark=dark) as (server, page):
                _explained(server, page, partial(take, page), "dark" if dark else "light")
        with _opened(browser, folder, MIDDLE) as (server, page):
            _pressing(server, page, partial(take, page))
            _exporting(page, partial(take, page))
        with _opened(browser, folder, SMALL) as (server, page):
            _recorded(server, page, partial(take, page))
        with _opened(browser, folder) as (server, page):
            _replayed(server, page, partial(take, page))
        for name in REAL if given.real else ():
            with _opened(browser, _some(given.real / name, Path(copies))) as (server, page):
                _at_rest(server, page)
                take(page, f"real_{name}")


@contextmanager
def _opened(
    browser: Browser, folder: Path, size: tuple[int, int] = LARGE, dark: bool = False
) -> Iterator[tuple[PageServer, KeyphasePage]]:
    server = PageServer(sorted(folder.glob("*.npz")), folder=folder)
    page = KeyphasePage(
        browser.new_page(
            viewport={"width": size[0], "height": size[1]},
            color_scheme="dark" if dark else "light",
        )
    )
    try:
        page.page.goto(server.link)
        page.wait_for_document()
        page.until("keyphase.state.recordings.items.every(one => one.strip.length || one.error)")
        yield server, page
    finally:
        page.close()
        server.stop()


def _explained(server: PageServer, page: KeyphasePage, take: Take, theme: str) -> None:
    """A segment selected, the playhead in it, and why the contact after it is there."""
    contact = next(b for b in page.document["boundaries"] if b["contact_change"])
    page.page.evaluate("() => keyphase.actions.label('Reach', 0)")
    page.until("keyphase.state.document.edits === 1")
    page.click(page.middle_of(2))
    page.page.evaluate("() => keyphase.actions.seek(0.9)")
    row = page.row("boundaries")
    page.page.mouse.move(page.x(contact["time_s"]), row.y + row.height / 2)
    page.page.locator("#why").wait_for()
    _with_parts(server, page)
    take(f"page_{theme}")
    page.page.evaluate("() => keyphase.actions.undo()")
    page.until("keyphase.state.document.edits === 0")


def _pressing(server: PageServer, page: KeyphasePage, take: Take) -> None:
    """The robot where the parts meet."""
    contact = next(b for b in page.document["boundaries"] if b["contact_change"])
    page.page.evaluate("time => keyphase.actions.seek(time)", contact["time_s"])
    _with_parts(server, page)
    take("page_robot_light")


def _exporting(page: KeyphasePage, take: Take) -> None:
    """Every format, and what it leaves behind."""
    page.resize(940, 620)
    page.press("Control+Shift+S")
    page.page.locator("#exporting[open] [type=radio]").first.wait_for()
    page.page.get_by_text("ELAN annotation file").click()
    page.settle()
    take("page_export")


def _recorded(server: PageServer, page: KeyphasePage, take: Take) -> None:
    page.panel.get_by_role("tab", name="Record").click()
    page.panel.get_by_role("button", name="Open workcell").click()
    page.until("keyphase.state.record?.workcell")
    _at_rest(server, page)
    take("page_record_setup1")


def _replayed(server: PageServer, page: KeyphasePage, take: Take) -> None:
    page.change(lambda: page.press("i"))
    page.press("p")
    page.until("keyphase.state.replay?.phase === 'over'")
    _at_rest(server, page)
    take("replay")


def _at_rest(server: PageServer, page: KeyphasePage) -> None:
    """Robot, path and names are all where they belong, also what is loaded after a first frame."""
    assert server.scenes.wait_until_drawn(WAIT_S)
    page.wait_for_scene()
    page.page.wait_for_timeout(LOADED_MS)
    # On cores that others use, too, one frame may take longer than the scene seems at rest.
    page.scene.wait_for_function(_ALL_HEARD, polling=200)
    page.wait_for_scene()
    page.settle()


def _with_parts(server: PageServer, page: KeyphasePage) -> None:
    """The parts of the recording's workcell come after the robot."""
    page.scene.wait_for_function(_PARTS_SHOWN, polling=200)
    _at_rest(server, page)


def _some(real: Path, copies: Path) -> Path:
    """A copy of the first recordings of a set: what one does is kept beside them."""
    folder = copies / real.name
    folder.mkdir()
    for recording in sorted(real.glob("*.npz"))[:4]:
        shutil.copy(recording, folder)
    return folder


def _take(folder: Path, page: KeyphasePage, name: str) -> None:
    page.page.screenshot(path=folder / f"{name}.png")


if __name__ == "__main__":
    main()
