"""All recordings of a folder beside each other: seen, aligned, renamed in all, opened there."""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from driver import KeyphasePage, Serve, Visit
from ten_recordings import finish, ten_recordings

from keyphase.files.shipped import shipped
from keyphase.labeling.storage.folder_settings import read_folder_settings
from keyphase.readers import read, save_npz

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
    """Ten recordings of a task, of which the first is done and one stops early, and one of
    another."""
    ten_recordings(tmp_path)
    _stop_early(tmp_path / "take_05.npz")
    shutil.copy(shipped("data") / "wipe.npz", tmp_path / "other.npz")
    finish(tmp_path / "take_00.npz")
    page = visit(serve(tmp_path), size=(1440, 900), scene=False)
    page.wait_for_document()
    page.press("Shift+G")
    page.until("keyphase.state.grid?.rows.some(one => one.standing === 'outlier')")
    page.until("keyphase.state.grid.rows.filter(one => one.proposed_from.length).length === 9")
    page.settle()
    return page


def _stop_early(path: Path) -> None:
    """Leave out the last phase, the slide."""
    whole = read(path)
    until = int(np.searchsorted(whole.time_s, 0.72 * whole.duration_s))
    cut = replace(
        whole,
        time_s=whole.time_s[:until],
        position_m=whole.position_m[:until],
        force_N=whole.force_N[:until] if whole.force_N is not None else None,
    )
    path.unlink()
    save_npz(cut, path)


def _names(page: KeyphasePage, name: str) -> list[str]:
    """What stands on the strip of a recording, or on the last of two."""
    row = page.page.locator(".grid-row", has=page.page.locator(f".grid-name :text-is('{name}')"))
    found = row.locator(".grid-strip").last.locator("i:not(.dropped)").all_inner_texts()
    return [text.strip() for text in found]


def _begins(page: KeyphasePage, phase: str) -> set[int]:
    """Where a phase begins on the strips [px]."""
    boxes = page.page.locator(f".grid-strip i:text-is('{phase}')").all()
    return {round(box["x"]) for one in boxes if (box := one.bounding_box())}


def _look(page: KeyphasePage, name: str, dark: bool) -> None:
    """In a theme: nothing for axe to find, nothing that overlaps in any size; pictures are kept."""
    page.page.evaluate("dark => keyphase.store.set({ dark })", dark)
    page.settle()
    assert page.page.evaluate(_FOUND) == []
    for width, height in ((1280, 720), (390, 844), (1440, 900)):
        page.resize(width, height)
        page.picture(f"grid_{name}_{width}_{'dark' if dark else 'light'}")
        assert page.page.evaluate(_OVERLAPS) == []


def test_all_are_seen_aligned_changed_and_opened_there(page: KeyphasePage, tmp_path: Path) -> None:
    assert AXE.exists(), "axe-core is missing; `make page-scripts` installs it"
    page.page.evaluate(AXE.read_text())
    standings = page.page.locator(".grid-standing").all_inner_texts()
    assert standings == ["outlier", "differs", "unsure", "done", *7 * ["proposed"]]
    listed = page.page.locator(".queue-confidence").all_text_contents()
    assert (listed.count("differs"), listed.count("unlike")) == (1, 1)
    told = page.page.locator(".grid-standing.differs").get_attribute("title")
    assert told == "Proposed from take_00, but 'Slide' is missing"
    _look(page, "start", dark=False)
    _align(page)
    _rename_in_all(page)
    _arrange_phases(page, tmp_path)
    _open_by_keys(page)
    _begins_at_the_open_one(page)


def _align(page: KeyphasePage) -> None:
    """At a phase or with all equally long, a phase begins at one place on all strips."""
    align = page.page.get_by_label("Aligned at")
    assert len(_begins(page, "Slide")) > 5
    for how in ("at:Slide", "equal"):
        align.select_option(how)
        page.until("document.querySelectorAll('.grid-row').length === 11")
        page.settle()
        assert len(_begins(page, "Slide")) == 1


def _rename_in_all(page: KeyphasePage) -> None:
    """Shown before it is done, with the done one only where that is meant; undo takes it back."""
    phases = page.page.locator(".phases input[type=text]")
    assert [one.input_value() for one in phases.all()] == ["Reach", "Lower", "Slide"]
    phases.first.fill("Approach")
    phases.first.press("Enter")
    change = page.page.locator(".grid-change")
    change.wait_for()
    assert "0 recordings of 11 would change" in change.inner_text()
    change.get_by_role("checkbox").check()
    assert "1 recording of 11 would change" in change.inner_text()
    assert _names(page, "take_00") == ["Approach", "Lower", "Slide"]
    _look(page, "change", dark=True)
    change.get_by_role("button", name="Apply to all").click()
    page.until("keyphase.state.grid.undo")
    page.until("keyphase.state.grid.phases[0].name === 'Approach'")
    page.page.get_by_role("button", name="Undo: Rename").click()
    page.until("keyphase.state.grid.phases[0].name === 'Reach'")
    page.settle()
    assert _names(page, "take_00") == ["Reach", "Lower", "Slide"]


def _arrange_phases(page: KeyphasePage, folder: Path) -> None:
    """Ends and order of the phases are kept in the folder, and taken back step by step."""
    page.page.get_by_label("What Lower ends with").select_option("gripper")
    page.page.get_by_role("button", name="Later: Reach").click()
    page.until("keyphase.state.grid.phases[1].name === 'Reach'")
    _wait_until_kept(page, folder, [("Lower", "gripper"), ("Reach", "configuration")])
    undo = page.page.get_by_role("button", name="Undo the last change of the list of phases")
    page.picture("grid_phases")
    undo.click()
    undo.click()
    undo.wait_for(state="hidden")
    _wait_until_kept(page, folder, [("Reach", "configuration"), ("Lower", "contact")])


def _wait_until_kept(page: KeyphasePage, folder: Path, expected: list[tuple[str, str]]) -> None:
    """Until the folder's first phases and their ends are these."""
    for _ in range(100):
        phases = read_folder_settings(folder).tasks[0].phases
        if [(one.name, one.end) for one in phases][:2] == expected:
            return
        page.page.wait_for_timeout(50)
    raise AssertionError(phases)


def _open_by_keys(page: KeyphasePage) -> None:
    """The second phase of the fourth row: the recording opens there."""
    page.page.get_by_role("listbox", name="Recordings").last.focus()
    for key in ("Home", "ArrowDown", "ArrowDown", "ArrowDown", "ArrowRight"):
        page.press(key)
    page.press("Enter")
    page.until("keyphase.state.document.name === 'take_00' && !keyphase.state.gridShown")
    lower = next(one for one in page.document["segments"] if one["label"] == "Lower")
    page.until(f"Math.abs(keyphase.state.clock - {lower['start_s']}) < 0.01")


def _begins_at_the_open_one(page: KeyphasePage) -> None:
    """However another recording came to be open: the arrow keys begin there."""
    page.press("PageDown")
    page.until("keyphase.state.document.name !== 'take_00'")
    page.press("Shift+G")
    page.page.locator(".grid-row.active").wait_for()
    name = page.page.locator(".grid-row.active .grid-name").inner_text()
    assert name.strip() == page.document["name"]


def test_an_empty_page_says_what_to_do(serve: Serve, visit: Visit) -> None:
    page = visit(serve(), size=(1280, 720), scene=False)
    page.until("keyphase.state.greeted")
    page.press("Shift+G")
    page.page.locator(".grid-empty").wait_for()
    assert "Ctrl O" in page.page.locator(".grid-empty").inner_text()
    shown = page.page.locator("#grid :is(button, select, input):visible").all_inner_texts()
    assert shown == ["Close"]
    page.press("Escape")
    page.until("!keyphase.state.gridShown")

    for tab in ("Replay", "Export"):
        page.page.get_by_role("tab", name=tab).click()
        page.settle()
        enabled = page.panel.locator("button:visible:enabled:not([role=tab], summary *)")
        assert enabled.all_inner_texts() == []
        page.picture(f"empty_{tab.lower()}")
