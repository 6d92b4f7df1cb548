"""Correcting a segmentation with the mouse alone."""

import pytest
from driver import KeyphasePage


def test_a_dragged_boundary_moves_and_leaves_a_mark_where_it_was(timeline: KeyphasePage) -> None:
    was = timeline.document["boundaries"][0]["time_s"]
    row = timeline.row("boundaries")
    start = (timeline.x(was), row.y + row.height / 2)
    timeline.page.keyboard.down("Alt")
    timeline.change(lambda: timeline.drag(start, (start[0] + 60, start[1])))
    timeline.page.keyboard.up("Alt")
    moved = timeline.document["boundaries"][0]
    assert timeline.x(moved["time_s"]) == pytest.approx(start[0] + 60, abs=1.5)
    assert moved["was_s"] == pytest.approx(was)
    assert timeline.page.locator(".was-line").count() == 1


def test_a_dragged_boundary_snaps_to_evidence_nearby(timeline: KeyphasePage) -> None:
    peak = next(p for p in timeline.document["peaks"] if p["rejection"] == "at an end")
    last = timeline.document["boundaries"][-1]["time_s"]
    row = timeline.row("boundaries")
    y = row.y + row.height / 2
    timeline.change(
        lambda: timeline.drag((timeline.x(last), y), (timeline.x(peak["time_s"]) + 4, y), steps=20)
    )
    moved = timeline.document["boundaries"][-1]["time_s"]
    assert min(abs(moved - peak[key]) for key in ("time_s", "bin_time_s")) < 1e-6


def test_a_lens_shows_the_signal_while_dragging(timeline: KeyphasePage) -> None:
    was = timeline.document["boundaries"][2]["time_s"]
    row = timeline.row("boundaries")
    timeline.page.mouse.move(timeline.x(was), row.y + 10)
    timeline.page.mouse.down()
    timeline.page.mouse.move(timeline.x(was) - 40, row.y + 10, steps=6)
    timeline.until("keyphase.state.lens")
    timeline.settle()
    lens = timeline.box("#lens")
    assert timeline.picture("lens").count("#1c7ed6", lens, tolerance=40) > 30
    timeline.press("Escape")
    timeline.page.mouse.up()
    assert timeline.document["boundaries"][2]["time_s"] == was
    assert not timeline.page.locator("#lens").is_visible()


def test_clicking_a_segment_selects_it(timeline: KeyphasePage) -> None:
    timeline.click(timeline.middle_of(2))
    timeline.until("keyphase.state.selected === 2")
    timeline.settle()
    assert timeline.page.locator(".segment-ring").count() == 1


def test_clicking_a_track_moves_the_playhead_there(timeline: KeyphasePage) -> None:
    row = timeline.row("position")
    timeline.click((timeline.x(2.0), row.y + row.height / 2))
    timeline.until("Math.abs(keyphase.state.playhead.time_s - 2) < 0.01")
    timeline.settle()
    assert timeline.text("#clock").startswith("2.0")


def test_dragging_over_segments_merges_them(timeline: KeyphasePage) -> None:
    before = timeline.segments.count()
    timeline.change(lambda: timeline.drag(timeline.middle_of(2), timeline.middle_of(4)))
    assert timeline.segments.count() == before - 2


def test_double_click_renames_in_place(timeline: KeyphasePage) -> None:
    timeline.click(timeline.middle_of(2), count=2)
    field = timeline.page.locator("#rename input")
    field.wait_for()
    timeline.picture("rename")
    field.fill("Put on the table")
    timeline.change(lambda: timeline.press("Enter"))
    assert timeline.labels()[2] == "Put on the table"
    assert "Put on the table" in timeline.page.locator("[data-segment='2']").text_content()


def test_the_buttons_split_drop_and_undo(timeline: KeyphasePage) -> None:
    before = timeline.segments.count()
    row = timeline.row("ruler")
    timeline.click((timeline.x(0.6), row.y + 9))
    timeline.change(lambda: timeline.page.get_by_role("button", name="Split T", exact=True).click())
    assert timeline.segments.count() == before + 1
    timeline.click(timeline.middle_of(1))
    timeline.change(lambda: timeline.page.get_by_role("button", name="Drop X", exact=True).click())
    assert not timeline.document["segments"][1]["kept"]
    timeline.change(lambda: timeline.page.locator("#undo").click())
    timeline.change(lambda: timeline.page.locator("#undo").click())
    assert timeline.segments.count() == before


def test_the_menu_does_everything_to_what_was_clicked(timeline: KeyphasePage) -> None:
    before = timeline.segments.count()
    timeline.page.mouse.click(*timeline.middle_of(0), button="right")
    timeline.picture("menu")
    timeline.change(lambda: timeline.page.get_by_role("menuitem", name="Split here").click())
    assert timeline.segments.count() == before + 1
    row = timeline.row("boundaries")
    first = timeline.document["boundaries"][0]["time_s"]
    timeline.page.mouse.click(timeline.x(first), row.y + row.height / 2, button="right")
    timeline.change(lambda: timeline.page.get_by_role("menuitem", name="Remove").click())
    assert timeline.segments.count() == before


def test_all_idle_segments_are_dropped_with_one_click(timeline: KeyphasePage) -> None:
    proposed = timeline.document["proposed_drops"]
    assert proposed
    timeline.change(lambda: timeline.page.locator("#drop-idle").click())
    assert timeline.document["proposed_drops"] == []
    assert all(not timeline.document["segments"][k]["kept"] for k in proposed)


def test_chips_are_dragged_into_another_order(timeline: KeyphasePage) -> None:
    chips = timeline.page.locator(".chip")
    first, second = (chips.nth(k).bounding_box() for k in (0, 1))
    assert first
    assert second
    end = (second["x"] + second["width"] - 6, second["y"] + 18)
    timeline.change(lambda: timeline.drag((first["x"] + 50, first["y"] + 18), end))
    assert [entry["segment"] for entry in timeline.document["plan"]][:2] == [2, 0]


def test_a_chip_dragged_with_control_is_repeated(timeline: KeyphasePage) -> None:
    count = timeline.page.locator(".chip").count()
    chip = timeline.page.locator(".chip").first.bounding_box()
    assert chip
    timeline.page.keyboard.down("Control")
    start = (chip["x"] + 50, chip["y"] + 18)
    timeline.change(lambda: timeline.drag(start, (start[0] + chip["width"], start[1])))
    timeline.page.keyboard.up("Control")
    assert timeline.page.locator(".chip").count() == count + 1
    assert timeline.page.locator(".chip .repeat").count() == 1


def test_pressing_delete_on_a_chip_takes_it_out(timeline: KeyphasePage) -> None:
    count = timeline.page.locator(".chip").count()
    timeline.page.locator(".chip").nth(1).focus()
    timeline.change(lambda: timeline.press("Delete"))
    assert timeline.page.locator(".chip").count() == count - 1
