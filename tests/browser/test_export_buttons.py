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


def test_the_panel_has_a_button_for_every_export(folder: Path, serve: Serve, visit: Visit) -> None:
    page = visit(serve(folder / "setup1.npz"))
    page.wait_for_document()
    scene = page.wait_for_scene()
    scene.get_by_role("tab", name="Export").click()
    assert scene.get_by_role("button").filter(has_text="JSON").count() >= 1
    assert scene.get_by_role("button").filter(has_text="CSV").count() >= 1
    scene.get_by_role("button").filter(has_text="Segment file").click()
    page.page.get_by_text("Written to").wait_for()
    assert (folder / "setup1.segments.json").exists()
