"""Looking: zoom, pan, fold, readout, why, playback, themes and sizes."""

import itertools
from pathlib import Path

import pytest
from driver import SEGMENT_COLORS, KeyphasePage, Serve, Visit

from keyphase.web.scene.palette import DARK, LIGHT


def span(page: KeyphasePage) -> float:
    view = page.state("view")
    return view["to"] - view["from"]


def test_the_wheel_zooms_around_the_pointer(editor: KeyphasePage) -> None:
    row = editor.row("position")
    at = (editor.x(2.0), row.y + row.height / 2)
    before = span(editor)
    editor.page.mouse.move(*at)
    editor.page.mouse.wheel(0, -600)
    editor.until(f"keyphase.state.view.to - keyphase.state.view.from < {before / 2}")
    editor.settle()
    assert editor.x(2.0) == pytest.approx(at[0], abs=2)


def test_dragging_a_track_pans_and_fit_shows_all_again(editor: KeyphasePage) -> None:
    document = editor.document
    for _ in range(3):
        editor.press("+")
    row = editor.row("position")
    y = row.y + row.height / 2
    start = editor.state("view")["from"]
    editor.drag((row.x + 0.5 * row.width, y), (row.x + 0.5 * row.width - 200, y))
    assert editor.state("view")["from"] > start
    editor.press("f")
    assert span(editor) == pytest.approx(document["end_s"] - document["start_s"])


def test_the_handles_of_the_overview_set_the_view(editor: KeyphasePage) -> None:
    row = editor.row("overview")
    y = row.y + row.height / 2
    editor.drag((row.x, y), (row.x + row.width / 2, y))
    document = editor.document
    half = (document["start_s"] + document["end_s"]) / 2
    assert editor.state("view")["from"] == pytest.approx(half, abs=0.05)


def test_a_folded_track_becomes_a_low_row(timeline: KeyphasePage) -> None:
    assert timeline.row("force").height > 60
    timeline.page.locator("[data-gutter=force] button").first.click()
    timeline.settle()
    assert timeline.row("force").height == 20
    timeline.picture("folded")
    timeline.page.locator("[data-gutter=speed] button").first.click()
    timeline.settle()
    assert timeline.row("speed").height > 40


def test_values_under_the_pointer_are_read_out(editor: KeyphasePage) -> None:
    row = editor.row("position")
    editor.page.mouse.move(editor.x(3.0), row.y + row.height / 2)
    editor.until("keyphase.state.pointer !== null")
    editor.settle()
    assert editor.text("#status").startswith("Pointer 3.0")
    values = editor.page.locator("[data-gutter=position] .value:visible").all_inner_texts()
    assert len(values) == 3
    assert all(value[0] in "+−" for value in values)


def test_resting_on_a_boundary_says_why_it_is_there(editor: KeyphasePage) -> None:
    contact = next(b for b in editor.document["boundaries"] if b["contact_change"])
    row = editor.row("boundaries")
    editor.page.mouse.move(editor.x(contact["time_s"]), row.y + row.height / 2)
    editor.page.locator("#why").wait_for()
    said = editor.text("#why")
    for sentence in contact["why"]["sentences"]:
        assert sentence in said
    typed = editor.page.get_by_label("Time of the boundary")
    assert typed.input_value() == f"{contact['time_s']:.3f}"
    assert "contact change" in said
    editor.picture("why")
    editor.page.mouse.move(400, 200)
    editor.page.locator("#why").wait_for(state="hidden")


def test_playing_moves_the_playhead_and_stops_at_the_end(editor: KeyphasePage) -> None:
    end = editor.document["end_s"]
    editor.page.evaluate("time => keyphase.actions.seek(time)", end - 0.3)
    editor.press("Space")
    editor.until(f"!keyphase.state.playhead.playing && keyphase.state.clock >= {end - 1e-3}")
    editor.settle()
    assert editor.text("#clock").startswith(f"{end:.3f}")


def test_linear_and_logarithmic(timeline: KeyphasePage) -> None:
    timeline.set_parameter("variant", "paper")
    logarithmic = timeline.picture("error_log")
    timeline.page.get_by_role("button", name="Linear", exact=True).click()
    timeline.settle()
    linear = timeline.picture("error_linear")
    row = timeline.row("error")
    assert logarithmic.count("#343a40", row, 40) != linear.count("#343a40", row, 40)
    assert not timeline.state("logarithmic")


def test_both_themes_in_both_sizes(setup1: KeyphasePage) -> None:
    setup1.wait_for_scene()
    for dark, size in itertools.product((False, True), ((1280, 720), (1920, 1080))):
        setup1.resize(*size)
        setup1.set_theme(dark)
        _assert_looks_right(setup1, dark, size)


def _assert_looks_right(page: KeyphasePage, dark: bool, size: tuple[int, int]) -> None:
    page.click(page.middle_of(2))
    page.until("keyphase.state.selected === 2")
    page.page.evaluate("() => keyphase.actions.seek(0.9)")
    contact = next(b for b in page.document["boundaries"] if b["contact_change"])
    row = page.row("boundaries")
    page.page.mouse.move(page.x(contact["time_s"]), row.y + row.height / 2)
    page.page.locator("#why").wait_for()
    page.wait_for_scene()
    sky = f"#{bytes((DARK if dark else LIGHT).sky).hex()}"
    view = page.box("#viser")
    picture = page.until_seen(
        f"page_{'dark' if dark else 'light'}_{size[0]}",
        lambda now: (
            now.count(sky, view, tolerance=2) > 500 and (now.brightness(view) < 110) == dark
        ),
    )
    assert picture.count(sky, view, tolerance=2) > 500
    assert picture.count_hue(SEGMENT_COLORS[1], view) > 200
    assert (picture.brightness(page.box("#plan")) < 100) == dark
    assert (picture.brightness(page.box("#viser")) < 110) == dark
    assert picture.count(SEGMENT_COLORS[0], page.row("segments")) > 500
    plate = picture.brightness(page.box("#names .name"))
    assert plate < 90 if dark else plate > 180
    assert_nothing_overflows(page)


def assert_nothing_overflows(page: KeyphasePage) -> None:
    """No bar is wider than the window, no button is cut."""
    cut = page.page.evaluate(
        """() => [...document.querySelectorAll('#header > *, #transport > *, #status > *')]
          .filter(node => node.offsetParent && node.getBoundingClientRect().right > innerWidth + 1)
          .map(node => node.outerHTML.slice(0, 80))"""
    )
    assert cut == []


def test_the_button_changes_the_theme_of_page_and_scene(setup1: KeyphasePage) -> None:
    setup1.wait_for_scene()
    scene = setup1.box("#viser")
    light = setup1.picture("theme_light").brightness(scene)
    setup1.page.locator("#theme").click()
    setup1.until("document.documentElement.dataset.theme === 'dark'")
    dark = setup1.until_seen("theme_dark", lambda now: now.brightness(scene) < light - 80)
    assert dark.brightness(scene) < light - 80
    assert dark.brightness(setup1.box("#plan")) < 100


def test_the_splitter_gives_the_timeline_more_room(timeline: KeyphasePage) -> None:
    before = timeline.box("#timeline").height
    splitter = timeline.box("#splitter")
    x, y = splitter.middle
    timeline.drag((x, y), (x, y - 80))
    timeline.settle()
    assert timeline.box("#timeline").height == pytest.approx(before + 80, abs=2)
    assert timeline.row("force").height > 100


def test_another_recording_is_chosen_from_the_queue(
    folder: Path, serve: Serve, visit: Visit
) -> None:
    page = visit(serve(folder), scene=False)
    page.wait_for_document()
    page.page.locator(".queue-row", has_text="synthetic_setup1").click()
    page.until("keyphase.state.document.name === 'synthetic_setup1'")
    page.until("keyphase.state.whole")
    page.settle()
    assert page.text("#name") == "synthetic_setup1"
    assert page.segments.count() == len(page.document["segments"])
