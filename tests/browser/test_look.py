"""As calm and readable as it was drawn: at no size anything is squeezed, cut or written over."""

from collections.abc import Callable, Iterator

import pytest
from driver import KeyphasePage

SIZES = [(1280, 720), (1440, 900), (1920, 1080)]
LEAST_SCENE_PX = 240

Resize = Callable[[tuple[int, int]], None]

_WRITTEN_OVER = """() => {
  const written = [...document.querySelectorAll(
    "#timeline .gutter-name, #timeline .gutter-note, #timeline .switch, #timeline .readout-row b")]
    .filter(node => node.checkVisibility()).map(node => {
      const range = document.createRange();
      range.selectNodeContents(node);
      return [range.getBoundingClientRect(), node.textContent];
    });
  return [...document.querySelectorAll("#timeline .tick")].filter(tick => tick.checkVisibility())
    .flatMap(tick => {
      const box = tick.getBoundingClientRect();
      return written.filter(([other]) => box.left < other.right && other.left < box.right &&
        box.top + 2 < other.bottom && other.top < box.bottom - 2)
        .map(([, text]) => `${tick.textContent} over ${text}`);
    });
}"""

_SMALL_OR_SQUEEZED = """() => {
  const found = new Set();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const node = walker.currentNode.parentElement;
    if (!walker.currentNode.data.trim() || !node.checkVisibility()) continue;
    const { fontSize, letterSpacing } = getComputedStyle(node);
    if (parseFloat(fontSize) > 0 && parseFloat(fontSize) < 11 || parseFloat(letterSpacing) < 0)
      found.add(`${node.className.baseVal ?? node.className}: ${fontSize} ${letterSpacing}`);
  }
  return [...found];
}"""

_OUT_OF_THE_WINDOW = """() => [...document.querySelectorAll(
  "#timeline text, #header *, #transport *, #status *")]
  .filter(node => node.checkVisibility() && node.textContent.trim())
  .filter(node => node.getBoundingClientRect().right > innerWidth)
  .map(node => node.textContent)"""


@pytest.fixture
def resize(editor: KeyphasePage) -> Iterator[Resize]:
    """Makes the window of another size; afterwards it is as it was."""

    def to(size: tuple[int, int]) -> None:
        editor.page.set_viewport_size({"width": size[0], "height": size[1]})
        editor.until(f"innerWidth === {size[0]}")
        editor.settle()

    yield to
    to((1920, 1080))


@pytest.mark.parametrize("size", SIZES, ids=str)
def test_no_tick_lies_over_a_title_and_nothing_leaves_the_window(
    editor: KeyphasePage, resize: Resize, size: tuple[int, int]
) -> None:
    resize(size)
    for variant in ("evidence", "paper"):
        if editor.document["parameters"]["variant"] != variant:
            editor.set_parameter("variant", variant)
        assert editor.page.locator("#timeline .tick").count() > 4
        assert editor.page.evaluate(_WRITTEN_OVER) == []
        assert editor.page.evaluate(_OUT_OF_THE_WINDOW) == []
        editor.picture(f"look_{variant}_{size[0]}")


@pytest.mark.parametrize("size", SIZES, ids=str)
def test_no_text_is_under_11_px_or_squeezed(
    editor: KeyphasePage, resize: Resize, size: tuple[int, int]
) -> None:
    resize(size)
    for tab in ("Record", "Replay", "Export", "Segment"):
        editor.panel.get_by_role("tab", name=tab).click()
        editor.settle()
        assert editor.page.evaluate(_SMALL_OR_SQUEEZED) == []


def test_a_small_window_leaves_room_for_the_scene(editor: KeyphasePage, resize: Resize) -> None:
    """At least so much, or about as much as the timeline has in a window of little height."""
    resize((1280, 720))
    assert editor.box("#viser").height >= LEAST_SCENE_PX, editor.text("#banners")
    for size in ((1024, 576), (800, 600)):
        resize(size)
        assert editor.box("#viser").height >= 0.95 * editor.box("#timeline").height
    resize((1024, 512))
    assert editor.box("#queue-rows").height > 0.5 * editor.box("#queue").height


def test_beside_the_evidence_the_error_is_folded_and_draws_no_line_that_decides(
    editor: KeyphasePage,
) -> None:
    dotted = editor.page.locator("[data-gutter=error] .dotted")
    assert editor.row("error").height == 20
    fold = editor.page.locator("[data-gutter=error] button").first
    fold.click()
    editor.settle()
    assert editor.row("error").height > 60
    assert editor.page.locator("[data-track=error] .uplot").count() == 1
    assert dotted.is_hidden()

    editor.set_parameter("variant", "paper")
    assert dotted.is_visible()
    assert editor.row("error").height > 60
    editor.set_parameter("variant", "evidence")
    fold.click()
    editor.settle()
    assert editor.row("error").height == 20
