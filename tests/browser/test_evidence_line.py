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


def test_the_number_shown_at_the_line_is_what_comes_when_it_is_let_go(wipe: KeyphasePage) -> None:
    x, y = wipe.box('[data-tag="motion_threshold"] text').middle
    row = wipe.row("evidence")
    profile = wipe.page.locator('[data-profile="motion_threshold"]')
    wipe.page.mouse.move(x, y)
    profile.wait_for()
    wipe.page.mouse.down()
    for share in (0.15, 0.6, 0.9):
        wipe.page.mouse.move(x, row.y + share * row.height, steps=4)
        wipe.until("'motion_threshold' in keyphase.state.held")
        wipe.settle()
        shown = int(profile.get_attribute("data-count") or -1)
        wipe.until(f"keyphase.state.document.boundaries.length === {shown}")
        wipe.picture(f"profile_{share}")
    wipe.page.mouse.up()
    wipe.until("!('motion_threshold' in keyphase.state.held)")
    assert len(wipe.document["boundaries"]) == shown


def test_what_another_parameter_holds_back_is_counted_and_released(wipe: KeyphasePage) -> None:
    wipe.set_parameter("least_step_N", 8.0)
    before = len(wipe.document["boundaries"])
    release = wipe.page.locator("[data-release='least_step_N']")
    count = int(release.inner_text().split()[0])
    wipe.picture("held_back")
    wipe.change(release.click)
    assert len(wipe.document["boundaries"]) == before + count
    assert wipe.document["parameters"]["least_step_N"] == 0.0
