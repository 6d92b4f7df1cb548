"""Exports from the page."""

import json
from pathlib import Path

from driver import KeyphasePage


def test_control_s_writes_the_segment_file(editor: KeyphasePage) -> None:
    editor.press("Control+s")
    editor.page.get_by_text("Written to").wait_for()
    path = Path(editor.text(".notice").removeprefix("Written to ").strip())
    written = json.loads(path.read_text())
    assert len(written["segments"]) == editor.segments.count()


def test_the_panel_says_which_file_each_export_writes_and_how_it_is_read(
    folder: Path, timeline: KeyphasePage
) -> None:
    page = timeline
    page.panel.get_by_role("tab", name="Export").click()
    for kind, file in (("json", "setup1.segments.json"), ("skills", "setup1.skills.json")):
        button = page.panel.locator(f"[data-export='{kind}']")
        assert file in button.inner_text()
        button.click()
        page.page.get_by_text(f"{file}").first.wait_for()
        page.until(f"keyphase.state.saved?.path.endsWith('{file}')")
        page.settle()
        assert (folder / file).exists()
        assert str(folder / file) in page.panel.locator(".saved-card .path").inner_text()
    lines = page.panel.locator(".saved-card .lines").inner_text()
    found: dict[str, object] = {}
    exec(lines, found)
    assert found["skills"]
    page.picture("exported")
