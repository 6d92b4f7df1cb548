"""Moving the threshold, by its line and by the panel's slider, changes both views.

The line lies over the normalized error, so the segmentation is the paper's.
"""

import pytest
from driver import ACCENT, SEGMENT_COLORS, KeyphasePage, Picture


@pytest.fixture
def by_paper(editor: KeyphasePage) -> KeyphasePage:
    editor.set_parameter("variant", "paper")
    return editor


def line_height(page: KeyphasePage) -> float:
    """Where the threshold line is told to be on the page [px]."""
    told = page.page.evaluate("() => keyphase.timeline.thresholdY()")
    return page.box(".surface").y + told


def drawn_height(page: KeyphasePage, picture: Picture) -> float:
    """Where the accent-coloured line is seen [px]."""
    row = page.row("error")
    rows = picture.rows_with(ACCENT["light"], row, least=int(row.width / 3), tolerance=24)
    return sum(rows) / len(rows)


def contacts(page: KeyphasePage) -> int:
    return sum(boundary["contact_change"] for boundary in page.document["boundaries"])


def test_the_line_stays_where_it_was_dragged(by_paper: KeyphasePage) -> None:
    row = by_paper.row("error")
    x = row.x + 0.5 * row.width
    target = line_height(by_paper) - 20
    by_paper.change(lambda: by_paper.drag((x, line_height(by_paper)), (x, target)))
    by_paper.until("!('force_threshold' in keyphase.state.held)")
    by_paper.page.mouse.move(10, 10)
    by_paper.settle()
    assert abs(drawn_height(by_paper, by_paper.picture("threshold_dragged")) - target) < 2


def test_dragging_the_line_above_all_peaks_takes_the_contact_change_away(
    by_paper: KeyphasePage,
) -> None:
    assert contacts(by_paper) >= 1
    row = by_paper.row("error")
    x = row.x + 0.5 * row.width
    by_paper.drag((x, line_height(by_paper)), (x, row.y + 2))
    by_paper.until("keyphase.state.document.boundaries.every(b => !b.contact_change)")
    assert by_paper.boundaries.count() == len(by_paper.document["boundaries"])
    assert by_paper.segments.count() == len(by_paper.document["segments"])


def test_what_would_come_or_go_is_shown_until_the_line_is_let_go(by_paper: KeyphasePage) -> None:
    row = by_paper.row("error")
    x = row.x + 0.5 * row.width
    mouse = by_paper.page.mouse
    mouse.move(x, line_height(by_paper))
    mouse.down()
    mouse.move(x, row.y + 2, steps=8)
    by_paper.until("keyphase.state.ghost.some(g => g.fate === 'goes')")
    by_paper.settle()
    assert by_paper.page.locator(".ghost.goes").count() >= 1
    by_paper.picture("ghosts")
    mouse.up()
    by_paper.until("keyphase.state.ghost.length === 0")
    by_paper.settle()
    assert by_paper.page.locator(".ghost").count() == 0


def test_the_panels_slider_moves_the_line_and_recolors_the_trajectory(
    scene_editor: KeyphasePage,
) -> None:
    scene_editor.set_parameter("variant", "paper")
    scene_editor.wait_for_scene()
    before = scene_editor.picture("slider_before")
    segments = scene_editor.segments.count()
    height = drawn_height(scene_editor, before)
    middle = scene_editor.slider("Threshold")
    scene_editor.drag(middle, (middle[0] + 60, middle[1]), steps=6)
    scene_editor.until("keyphase.state.document.boundaries.every(b => !b.contact_change)")
    scene_editor.settle()
    scene_editor.wait_for_scene()
    after = scene_editor.picture("slider_after")
    assert drawn_height(scene_editor, after) < height - 10
    assert scene_editor.segments.count() == len(scene_editor.document["segments"])
    if scene_editor.segments.count() != segments:
        view, color = scene_editor.box("#viser"), SEGMENT_COLORS[2]
        assert before.count_hue(color, view) != after.count_hue(color, view)


def test_dragging_the_line_moves_the_panels_value(by_paper: KeyphasePage) -> None:
    row = by_paper.row("error")
    x = row.x + 0.5 * row.width
    target = line_height(by_paper) - 25
    by_paper.change(lambda: by_paper.drag((x, line_height(by_paper)), (x, target)))
    by_paper.until("!('force_threshold' in keyphase.state.held)")
    threshold = by_paper.document["parameters"]["force_threshold"]
    shown = by_paper.panel.get_by_label("Threshold, value").input_value()
    assert float(shown) == pytest.approx(threshold, rel=1e-3)


def test_a_slider_falls_into_the_notch_of_its_automatic_value(by_paper: KeyphasePage) -> None:
    thumb = by_paper.slider("Threshold")
    by_paper.change(lambda: by_paper.drag(thumb, (thumb[0] + 40, thumb[1])))
    by_paper.until("!('force_threshold' in keyphase.state.held)")
    assert by_paper.document["parameters"]["force_threshold"] is not None
    away = by_paper.slider("Threshold")
    by_paper.change(lambda: by_paper.drag(away, (thumb[0] + 1, thumb[1])))
    by_paper.until("!('force_threshold' in keyphase.state.held)")
    assert by_paper.document["parameters"]["force_threshold"] is None


def test_every_move_is_timed_from_the_hand_to_the_frame(timeline: KeyphasePage) -> None:
    timeline.set_parameter("variant", "paper")
    timeline.page.evaluate("() => keyphase.latency.splice(0)")
    row = timeline.row("error")
    x = row.x + 0.5 * row.width
    timeline.drag((x, line_height(timeline)), (x, line_height(timeline) - 25), steps=6)
    timeline.until("keyphase.latency.length > 0")
    measured = timeline.page.evaluate("() => keyphase.latency")
    assert all(0 < one["milliseconds"] < 60_000 for one in measured)
    assert {one["source"] for one in measured} == {"line"}


def test_the_threshold_is_typed_and_given_back_by_keys_alone(by_paper: KeyphasePage) -> None:
    automatic = by_paper.document["threshold"]
    by_paper.tab_to("at.getAttribute('aria-label') === 'Threshold, value'")
    by_paper.press("Control+a")
    by_paper.page.keyboard.type("5000")
    by_paper.press("Enter")
    by_paper.until("keyphase.state.document.parameters.force_threshold === 5000")
    assert contacts(by_paper) == 0

    by_paper.page.locator("#help").focus()
    by_paper.press("Control+k")
    by_paper.page.keyboard.type("threshold back")
    by_paper.press("Enter")
    by_paper.until("keyphase.state.document.parameters.force_threshold === null")
    assert by_paper.document["threshold"] == automatic


def test_the_panels_button_gives_all_parameters_back(editor: KeyphasePage) -> None:
    editor.set_parameter("force_threshold", 0.9)
    reset = editor.panel.get_by_role("button", name="Reset to automatic")
    editor.change(lambda: reset.click())
    assert editor.document["parameters"]["force_threshold"] is None
