"""Keys, clicks and drags at random on the page in real Chromium: does any script of it fail?

    python tests/benchmarks/random_hands.py --seeds 5 --actions 1000

All bundled recordings are open; the 3D scene stays empty. Hands go on while documents come, other
recordings open, dialogs stand and the window changes its size. Ends with 1 and the last actions
where a script failed, or the page is not connected at the end.
"""

import argparse
import random
import shutil
import sys
import tempfile
from pathlib import Path

TESTS = Path(__file__).parents[1]
sys.path[:0] = [str(TESTS), str(TESTS / "browser")]

from chromium import chromium_browser  # noqa: E402
from driver import KeyphasePage  # noqa: E402
from playwright.sync_api import Browser, Page  # noqa: E402

from keyphase.files.shipped import shipped  # noqa: E402
from keyphase.web.server import PageServer  # noqa: E402

SIZES = ((1280, 720), (1920, 1080), (900, 600), (390, 800))
WITHOUT_SCENE = 'Object.defineProperty(HTMLIFrameElement.prototype, "src", { set() {} });'
KEYS = (
    *"abceghijklmnopqrstuvwxyz0123456789[],.+-?{} ",
    *["Enter", "Escape", "Tab", "Home", "End", "Delete", "Backspace", "PageDown", "PageUp", "F2"],
    *["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Shift+ArrowRight", "Alt+ArrowRight"],
    *["Control+z", "Control+Shift+z", "Control+k", "Control+s", "Control+Shift+s"],
    *["Shift+Enter", "Shift+n", "Shift+k", "Shift+1"],
)
TEXTS = ("reach", "<b>a</b>", "“x”", "9.5", "-1")


class Hands:
    """What one person does who looks at nothing."""

    def __init__(self, page: Page, seed: int) -> None:
        self._page, self._random = page, random.Random(seed)

    def act(self) -> str:
        """One action; what it was."""
        kinds = {self._press: 55, self._click: 25, self._drag: 12, self._wheel: 3}
        kinds |= {self._type: 3, self._resize: 2}
        (act,) = self._random.choices(list(kinds), list(kinds.values()))
        return act()

    def _place(self) -> tuple[int, int]:
        size = self._page.viewport_size or {"width": 390, "height": 600}
        return self._random.randrange(size["width"]), self._random.randrange(size["height"])

    def _press(self) -> str:
        key = self._random.choice(KEYS)
        self._page.keyboard.press(key)
        return key

    def _click(self) -> str:
        x, y = self._place()
        button = self._random.choice(["left"] * 5 + ["right"])
        count = self._random.choice([1, 1, 1, 2])
        self._page.mouse.click(x, y, button=button, click_count=count)  # type: ignore
        return f"{button} click at {x}, {y} ({count})"

    def _drag(self) -> str:
        start, end = self._place(), self._place()
        self._page.mouse.move(*start)
        self._page.mouse.down()
        self._page.mouse.move(*end, steps=4)
        self._page.mouse.up()
        return f"drag from {start} to {end}"

    def _wheel(self) -> str:
        self._page.mouse.wheel(self._random.choice([0, 100]), self._random.choice([-400, 400]))
        return "wheel"

    def _type(self) -> str:
        text = self._random.choice(TEXTS)
        self._page.keyboard.type(text)
        return f"typed {text}"

    def _resize(self) -> str:
        width, height = self._random.choice(SIZES)
        self._page.set_viewport_size({"width": width, "height": height})
        return f"window of {width} x {height}"


def faults(browser: Browser, folder: Path, seed: int, actions: int) -> list[str]:
    """Errors of the page's scripts, each with what was done just before."""
    recordings = [Path(shutil.copy(one, folder)) for one in sorted(shipped("data").glob("*.npz"))]
    server = PageServer(recordings, folder=folder)
    page = KeyphasePage(browser.new_page(viewport={"width": 1280, "height": 720}))
    page.page.add_init_script(WITHOUT_SCENE)
    page.page.on("dialog", lambda dialog: dialog.dismiss())
    page.page.goto(server.link)
    page.wait_for_document()
    hands, done, found = Hands(page.page, seed), [], []
    for _ in range(actions):
        done.append(hands.act())
        found += [f"{error} after {done[-6:]}" for error in page.errors]
        page.errors.clear()
    page.settle()
    if not page.state("connected"):
        found.append(f"the page lost its server within {done[-20:]}")
    page.close()
    server.stop()
    return found


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seeds", type=int, default=5)
    options.add_argument("--first", type=int, default=0, help="the first of the seeds")
    options.add_argument("--actions", type=int, default=1000, help="for each seed")
    chosen = options.parse_args()
    failed = False
    with chromium_browser() as browser:
        for seed in range(chosen.first, chosen.first + chosen.seeds):
            with tempfile.TemporaryDirectory() as folder:
                found = faults(browser, Path(folder), seed, chosen.actions)
            failed |= bool(found)
            print(f"seed {seed}: {chosen.actions} actions, {len(found)} faults")
            for fault in found[:3]:
                print(f"  {fault}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
