"""The page as a person meets it: what is seen, what the mouse and the keys do."""

import io
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from playwright.sync_api import Frame, Locator, Page

from keyphase.web.server import PageServer

PICTURES = Path(__file__).parents[1] / "pictures"

SEGMENT_COLORS = ("#58A2F2", "#EFB63A", "#26C397", "#CA71B6", "#A7A425", "#8FDDE8", "#B98A63")
ACCENT = {"light": "#1c7ed6", "dark": "#4dabf7"}

_PATIENCE = 40
"""Pictures that are taken, half a second apart, until one shows what is waited for."""

_TIMEOUT_MS = 90_000
"""Of whatever is waited for: 3D is drawn in software, on cores that others use, too."""

_DRAWN = """async () => {
  for (let k = 0; k < 2; k++)
    await new Promise(done => keyphase.store.afterFrame(() => setTimeout(done)));
  await new Promise(requestAnimationFrame);
}"""

_SCENE_IDLE = """() => {
  const frame = window.__viserTestpoints?.rendererInfo.render.frame;
  if (frame === undefined) return false;
  const seen = (window.seenFrame ??= { frame, at: performance.now() });
  if (frame - seen.frame > 1) { seen.frame = frame; seen.at = performance.now(); return false; }
  return performance.now() - seen.at > 700;
}"""


@dataclass(frozen=True)
class Box:
    """A rectangle of the page in px."""

    x: float
    y: float
    width: float
    height: float

    @property
    def middle(self) -> tuple[float, float]:
        return self.x + self.width / 2, self.y + self.height / 2


@dataclass(frozen=True)
class Picture:
    """A screenshot one can ask for colours."""

    pixels: NDArray[np.int16]

    def count(self, color: str, box: Box | None = None, tolerance: int = 12) -> int:
        """Number of pixels in `box` that have a colour."""
        wanted = np.array([int(color[k : k + 2], 16) for k in (1, 3, 5)])
        part = self.pixels if box is None else self._cut(box)
        return int((np.abs(part - wanted).max(axis=2) <= tolerance).sum())

    def count_hue(self, color: str, box: Box, apart_deg: float = 10.0) -> int:
        """Number of strongly coloured pixels in `box` of a hue, in light and in shade."""
        return int(self._of_hue(color, box, apart_deg).sum())

    def _of_hue(self, color: str, box: Box, apart_deg: float) -> NDArray[np.bool_]:
        wanted = np.array([[[int(color[k : k + 2], 16) for k in (1, 3, 5)]]], dtype=np.uint8)
        hues, strengths = _hue_and_strength(self._cut(box).astype(np.uint8))
        target = _hue_and_strength(wanted)[0].item()
        apart = np.abs((hues - target + 180.0) % 360.0 - 180.0)
        return (apart <= apart_deg) & (strengths > 0.15)

    def places(self, color: str, box: Box, apart_deg: float = 10.0) -> NDArray[np.int64]:
        """Where on the page (x, y) [px] a strong colour of a hue is in `box`, also in shade."""
        rows, columns = np.nonzero(self._of_hue(color, box, apart_deg))
        return np.stack([columns + int(box.x), rows + int(box.y)], axis=1)

    def rows_with(self, color: str, box: Box, least: int, tolerance: int = 12) -> list[float]:
        """Heights on the page [px] at which at least `least` pixels have a colour."""
        wanted = np.array([int(color[k : k + 2], 16) for k in (1, 3, 5)])
        hits = (np.abs(self._cut(box) - wanted).max(axis=2) <= tolerance).sum(axis=1)
        return [box.y + float(row) for row in np.flatnonzero(hits >= least)]

    def brightness(self, box: Box) -> float:
        """Mean brightness, 0 to 255."""
        return float(self._cut(box).mean())

    def _cut(self, box: Box) -> NDArray[np.int16]:
        left, top = int(box.x), int(box.y)
        return self.pixels[top : top + int(box.height), left : left + int(box.width)]


def _hue_and_strength(rgb: NDArray[np.uint8]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Hue [deg] and saturation (0 to 1) of every pixel."""
    hsv = np.asarray(Image.fromarray(rgb).convert("HSV"), dtype=np.float64)
    return hsv[..., 0] * 360.0 / 256.0, hsv[..., 1] / 255.0


class KeyphasePage:
    """One browser page on a keyphase server."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.errors: list[str] = []
        page.set_default_timeout(_TIMEOUT_MS)
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.on(
            "console",
            lambda said: self.errors.append(said.text) if said.type == "error" else None,
        )

    # -- waiting

    def wait_for_document(self) -> None:
        """Until a recording is drawn with its curves."""
        self.until("keyphase.state.document && keyphase.state.whole && keyphase.state.layout")
        self.settle()

    def wait_for_scene(self) -> Frame:
        """Until the 3D scene has come to rest."""
        frame = self.scene
        frame.wait_for_function(_SCENE_IDLE, polling=100)
        return frame

    def until(self, condition: str) -> None:
        """Until an expression of the page's is true."""
        self.page.wait_for_function(f"() => Boolean(window.keyphase && ({condition}))")

    def settle(self) -> None:
        """Until what changed has been drawn, and what is drawn later than the timeline, too."""
        self.page.evaluate(_DRAWN)

    def change(self, act: Callable[[], object]) -> None:
        """Do something and wait until the server's answer is drawn."""
        before = self.document["revision"]
        act()
        self.until(f"keyphase.state.document.revision > {before} && !keyphase.state.pending.length")
        self.settle()

    # -- what is known and seen

    @property
    def scene(self) -> Frame:
        """viser's client."""
        element = self.page.locator("#viser").element_handle()
        frame = element.content_frame() if element else None
        assert frame is not None
        return frame

    @property
    def document(self) -> dict[str, Any]:
        return self.page.evaluate("() => keyphase.state.document")

    def state(self, name: str) -> Any:
        return self.page.evaluate("name => keyphase.state[name]", name)

    @property
    def segments(self) -> Locator:
        """The segments drawn in the band."""
        return self.page.locator("[data-segment]")

    @property
    def boundaries(self) -> Locator:
        """The boundaries drawn."""
        return self.page.locator("[data-boundary][data-origin]")

    def labels(self) -> list[str]:
        return [segment["label"] for segment in self.document["segments"]]

    def box(self, selector: str) -> Box:
        """Where an element is on the page."""
        found = self.page.locator(selector).first.bounding_box()
        assert found is not None, f"{selector} is not on the page"
        return Box(**found)

    def row(self, key: str) -> Box:
        """Where a row of the timeline is, without gutter and margin."""
        surface = self.box(".surface")
        row = self.page.evaluate("key => keyphase.state.layout.rows.get(key)", key)
        return Box(surface.x, surface.y + row["y"], self.state("plotWidth"), row["height"])

    def x(self, time_s: float) -> float:
        """Where a time is on the page [px]."""
        return self.box(".surface").x + self.page.evaluate(
            "time => keyphase.timeline.scale().x(time)", time_s
        )

    def middle_of(self, segment: int) -> tuple[float, float]:
        """A point on the page inside a segment of the band."""
        one = self.document["segments"][segment]
        band = self.row("segments")
        return self.x((one["start_s"] + one["end_s"]) / 2), band.y + band.height / 2

    def picture(self, name: str) -> Picture:
        """A screenshot, kept as tests/pictures/NAME.png."""
        PICTURES.mkdir(exist_ok=True)
        raw = self.page.screenshot(path=PICTURES / f"{name}.png")
        return Picture(np.asarray(Image.open(io.BytesIO(raw)).convert("RGB"), dtype=np.int16))

    def until_seen(self, name: str, shows: Callable[[Picture], bool]) -> Picture:
        """The first of several pictures that shows it; the last one if none does."""
        for _ in range(_PATIENCE):
            picture = self.picture(name)
            if shows(picture):
                break
            self.page.wait_for_timeout(500)
        return picture

    @property
    def panel(self) -> Locator:
        """The panel at the right."""
        return self.page.locator("#panel")

    def slider(self, title: str) -> tuple[float, float]:
        """Where the thumb of a slider of the panel is."""
        found = self.panel.get_by_label(title, exact=True).first
        box = found.bounding_box()
        assert box, f"the panel has no slider {title}"
        share = float(found.evaluate("node => node.style.getPropertyValue('--share')"))
        return box["x"] + 4 + share * (box["width"] - 8), box["y"] + box["height"] / 2

    def set_parameter(self, name: str, value: float | str | None) -> None:
        """As if a control of the panel had been let go there; drawn when this returns."""
        told = "([name, value]) => keyphase.actions.setParameter(name, value, false)"
        self.change(lambda: self.page.evaluate(told, [name, value]))

    def text(self, selector: str) -> str:
        return re.sub(r"\s+", " ", self.page.locator(selector).first.inner_text()).strip()

    # -- what a person does

    def drag(self, start: tuple[float, float], end: tuple[float, float], steps: int = 12) -> None:
        """With the left button."""
        mouse = self.page.mouse
        mouse.move(*start)
        mouse.down()
        mouse.move(*end, steps=steps)
        mouse.up()

    def click(self, at: tuple[float, float], count: int = 1) -> None:
        self.page.mouse.click(*at, click_count=count)

    def press(self, key: str) -> None:
        self.page.keyboard.press(key)

    def resize(self, width: int, height: int) -> None:
        """Make the window of another size."""
        self.page.set_viewport_size({"width": width, "height": height})
        self.until(f"innerWidth === {width} && innerHeight === {height}")
        self.settle()

    def set_theme(self, dark: bool) -> None:
        """By the button, where the other theme is shown."""
        if self.state("dark") != dark:
            self.page.locator("#theme").click()
            self.until(f"keyphase.state.dark === {str(dark).lower()}")
        self.settle()

    def tab_to(self, condition: str) -> None:
        """With the Tab key, until the focused element `at` meets the condition."""
        met = f"() => {{ const at = document.activeElement; return Boolean({condition}); }}"
        for _ in range(200):
            if self.page.evaluate(met):
                return
            self.press("Tab")
        raise AssertionError(f"Tab reaches nothing where {condition}")

    def close(self) -> None:
        self.page.close()


Serve = Callable[..., PageServer]
Visit = Callable[..., KeyphasePage]
LookAt = Callable[..., KeyphasePage]
