"""Exports from the page."""

import json
from pathlib import Path

from driver import Serve, Visit


def test_control_s_writes_the_segment_file(folder: Path, serve: Serve, visit: Visit) -> None:
    page = visit(serve(folder / "setup1.npz"), scene=False)
    page.wait_for_document()
    page.press("Control+s")
    page.page.get_by_text("Written to").wait_for()
    path = Path(page.text(".notice").removeprefix("Written to ").strip())
    written = json.loads(path.read_text())
    assert len(written["segments"]) == page.segments.count()


def test_the_panel_says_which_file_each_export_writes_and_how_it_is_read(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    page = visit(serve(folder / "setup1.npz"), scene=False)
    page.wait_for_document()
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
