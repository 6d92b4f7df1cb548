"""All recordings of a folder beside each other: seen, aligned, renamed in all, opened there."""

import shutil
from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit
from ten_recordings import finish, ten_recordings

from keyphase.files.shipped import shipped

AXE = Path(__file__).parents[2] / "node_modules" / "axe-core" / "axe.min.js"

_FOUND = """async () => {
  const { violations } = await axe.run({ include: ["#grid"] }, { resultTypes: ["violations"] });
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, any }) => `${id}: ${target} ${any[0]?.message ?? ""}`));
}"""

_OVERLAPS = """() => {
  const seen = [...document.querySelectorAll(
    "#grid button, #grid select, #grid input, #grid h2, #grid h3, #grid .grid-name, "
    + "#grid .grid-standing, #grid .grid-strips, #grid .grid-told")]
    .filter((one) => one.checkVisibility());
  const edge = document.getElementById("grid").getBoundingClientRect();
  const boxes = seen.map((one) => [one, one.getBoundingClientRect()]);
  const met = [];
  for (const [one, a] of boxes) {
    if (a.left < edge.left - 1 || a.right > edge.right + 1) met.push(`${one.outerHTML} sticks out`);
    for (const [other, b] of boxes)
      if (one !== other && !one.contains(other) && one.compareDocumentPosition(other) & 4
          && one.closest(".grid-rows, .grid-phases, .grid-head, .grid-change")
             === other.closest(".grid-rows, .grid-phases, .grid-head, .grid-change")
          && a.left < b.right - 1 && b.left < a.right - 1 && a.top < b.bottom - 1
          && b.top < a.bottom - 1)
        met.push(`${one.outerHTML} | ${other.outerHTML}`);
  }
  return met;
}"""


@pytest.fixture
def page(tmp_path: Path, serve: Serve, visit: Visit) -> KeyphasePage:
    """Ten recordings of a task, of which the first is done, and one of another."""
    ten_recordings(tmp_path)
    shutil.copy(shipped("data") / "wipe.npz", tmp_path / "other.npz")
    finish(tmp_path / "take_00.npz")
    page = visit(serve(tmp_path), size=(1440, 900), scene=False)
    page.wait_for_document()
    page.press("Shift+G")
    page.until("keyphase.state.grid?.rows.some(one => one.standing === 'outlier')")
    page.until("keyphase.state.grid.rows.filter(one => one.proposed_from.length).length === 9")
    page.settle()
    return page


def _names(page: KeyphasePage, row: str) -> list[str]:
    return page.page.locator(
        f"[data-recording]:has(.grid-name:text-is('{row}')) i"
    ).all_inner_texts()


def test_the_grid_is_seen_aligned_and_changed_in_all(page: KeyphasePage, tmp_path: Path) -> None:
    rows = page.page.locator(".grid-row")
    assert rows.count() == 11
    assert "outlier" in rows.first.inner_text()
    page.page.evaluate(AXE.read_text())
    for dark in (False, True):
        page.page.evaluate("dark => keyphase.store.set({ dark })", dark)
        page.settle()
        assert page.page.evaluate(_FOUND) == []
        for width, height in ((1440, 900), (1280, 720), (390, 844)):
            page.resize(width, height)
            page.picture(f"grid_{width}_{'dark' if dark else 'light'}")
            assert page.page.evaluate(_OVERLAPS) == []
    page.resize(1440, 900)
