"""Dragging a line over the evidence chooses among the boundaries that could be."""

import shutil
from pathlib import Path

import pytest
from driver import KeyphasePage, LookAt

from keyphase.files.shipped import shipped


@pytest.fixture
def wipe(tmp_path: Path, look_at: LookAt) -> KeyphasePage:
    """The page on the bundled wipe with its light first touch."""
    page = look_at(Path(shutil.copy(shipped("data") / "wipe.npz", tmp_path)))
    page.resize(1440, 900)
    page.until("keyphase.state.whole.tracks.has('evidence')")
    page.settle()
    return page


def line_height(page: KeyphasePage) -> float:
    """Where the force line is on the page [px]."""
    told = page.page.evaluate("() => keyphase.timeline.lineY('force_threshold')")
    return page.box(".surface").y + told


def drag_to(page: KeyphasePage, height: float) -> None:
    """The force line by its tag in the margin to a height of the page [px]."""
    x, y = page.box('[data-tag="force_threshold"] text').middle
    page.change(lambda: page.drag((x, y), (x, y + height - line_height(page))))
    page.until("!('force_threshold' in keyphase.state.held)")
    page.settle()


def test_dragging_the_force_line_chooses_boundaries_and_falls_back_to_automatic(
    wipe: KeyphasePage,
) -> None:
    automatic = wipe.document["threshold"]
    boundaries = len(wipe.document["boundaries"])
    row = wipe.row("evidence")
    home = line_height(wipe)

    drag_to(wipe, row.y + 2)
    assert wipe.document["parameters"]["force_threshold"] > 0.9
    assert len(wipe.document["boundaries"]) < boundaries
    shown = wipe.panel.get_by_label("Threshold, value").first.input_value()
    assert float(shown) == pytest.approx(wipe.document["threshold"], rel=0.02)

    drag_to(wipe, row.y + row.height - 2)
    assert len(wipe.document["boundaries"]) > boundaries

    drag_to(wipe, home + 3)
    assert wipe.document["parameters"]["force_threshold"] is None
    assert wipe.document["threshold"] == automatic
    assert len(wipe.document["boundaries"]) == boundaries


def test_a_candidate_that_became_no_boundary_says_what_would_let_it_in(
    wipe: KeyphasePage,
) -> None:
    hollow = wipe.page.locator('.candidate[data-given="false"]').first
    box = hollow.bounding_box()
    assert box
    wipe.page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    note = wipe.page.locator(".candidate-note")
    note.wait_for(state="visible")
    assert "would let it in" in note.inner_text()


def test_the_published_way_has_the_line_of_its_error_and_no_evidence(wipe: KeyphasePage) -> None:
    assert wipe.page.locator(".threshold-line").count() == 0
    wipe.set_parameter("variant", "paper")
    wipe.until("!keyphase.state.layout.rows.has('evidence')")
    wipe.settle()
    assert wipe.page.locator(".evidence-line:visible").count() == 0
    assert wipe.page.locator(".threshold-line").count() == 1
