"""Exports from the page."""

import json
import sys
from pathlib import Path

import pytest
from driver import KeyphasePage

from keyphase.writers import WRITERS


def test_control_s_writes_the_segment_file(editor: KeyphasePage) -> None:
    editor.press("Control+s")
    editor.page.locator(".notice", has_text="Written to").wait_for()
    path = Path(editor.text(".notice").removeprefix("Written to ").strip())
    written = json.loads(path.read_text())
    assert len(written["segments"]) == editor.segments.count()


def _choose(page: KeyphasePage, name: str) -> None:
    """The format in the dialog, with what is told of it."""
    page.page.locator(f"#exporting[open] [data-format='{name}']").click()


def test_any_format_is_written_from_one_dialog_that_says_what_it_loses(
    folder: Path, timeline: KeyphasePage
) -> None:
    page = timeline
    page.press("Control+Shift+S")
    dialog = page.page.locator("#exporting")
    dialog.locator("h2").wait_for()
    assert dialog.locator("[data-format]").count() == len(WRITERS)
    _choose(page, "elan")
    told = dialog.locator(".export-details").inner_text()
    for said in ("setup1.eaf", "end conditions", "whole milliseconds"):
        assert said in told
    assert not (folder / "setup1.eaf").exists()
    for dark in (False, True):
        page.page.evaluate("dark => keyphase.store.set({ dark })", dark)
        page.settle()
        page.picture(f"exporting_{'dark' if dark else 'light'}")
    dialog.get_by_role("button", name="Write", exact=True).click()
    dialog.get_by_text(f"Written to {folder / 'setup1.eaf'}").wait_for()
    found: dict[str, object] = {}
    exec(dialog.locator(".lines").inner_text(), found)
    assert found["document"]

    (folder / "setup1.skills.json").write_text("{}")
    _choose(page, "skills")
    dialog.get_by_role("button", name="Write", exact=True).click()
    page.page.get_by_role("button", name="Keep both").click()
    dialog.get_by_text(f"Written to {folder / 'setup1_2.skills.json'}").wait_for()
    assert (folder / "setup1.skills.json").read_text() == "{}"

    _choose(page, "robomimic")
    assert dialog.get_by_role("button", name="Write", exact=True).is_disabled()
    assert "robomimic" in dialog.locator(".export-refusal").inner_text()
    page.press("Escape")


def test_a_format_whose_package_is_missing_says_how_to_install_it(
    monkeypatch: pytest.MonkeyPatch, editor: KeyphasePage
) -> None:
    module = sys.modules["keyphase.writers.offers"]
    monkeypatch.setattr(module, "find_spec", lambda _name: None)
    editor.page.locator("#tab-export").click()
    editor.panel.locator("[data-export='formats']").click()
    _choose(editor, "elan")
    refusal = editor.page.locator("#exporting .export-refusal")
    assert 'pip install "keyphase[elan]"' in refusal.inner_text()
    editor.press("Escape")
    editor.page.locator("#tab-segment").click()


def test_recordings_picked_in_the_list_are_written_together(
    folder: Path, two: KeyphasePage
) -> None:
    rows = two.page.locator(".queue-row")
    rows.nth(1).click(modifiers=["Control"])
    two.until("keyphase.state.picked.length === 2")
    assert two.document["name"] == "setup1"
    two.picture("picked")
    two.press("Control+Shift+S")
    dialog = two.page.locator("#exporting")
    dialog.locator("h2").wait_for()
    assert dialog.get_by_label("Which").input_value() == "picked"
    _choose(two, "json")
    dialog.get_by_role("button", name="Write", exact=True).click()
    two.page.get_by_text("2 of 2 recordings were written").wait_for()
    assert len(list(folder.glob("*.segments.*"))) == 2
    two.press("Escape")
    rows.nth(1).click()
    two.until(
        "keyphase.state.document.name === 'synthetic_setup1' && !keyphase.state.picked.length"
    )
