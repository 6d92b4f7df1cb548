"""Correcting a segmentation with the mouse alone."""

from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit


def _command(page: KeyphasePage, name: str) -> None:
    """Choose a command in the palette with the mouse; only the search for it is typed."""
    page.page.locator("#command-field").click()
    page.page.keyboard.type(name)
    page.page.locator("#palette li", has_text=name).first.click()


def _item(page: KeyphasePage, at: tuple[float, float], name: str) -> None:
    """Choose an item of the menu at a point."""
    page.page.mouse.click(*at, button="right")
    page.page.get_by_role("menuitem", name=name).first.click()


def _boundary(page: KeyphasePage, index: int) -> tuple[float, float]:
    """Where a boundary's mark is."""
    row = page.row("boundaries")
    return page.x(page.document["boundaries"][index]["time_s"]), row.y + row.height / 2


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


def test_a_chip_dragged_out_of_the_strip_is_taken_out(timeline: KeyphasePage) -> None:
    chip = timeline.page.locator(".chip").nth(1).bounding_box()
    assert chip
    start = (chip["x"] + 50, chip["y"] + 18)
    timeline.change(lambda: timeline.drag(start, (start[0], start[1] - 150)))
    assert [entry["segment"] for entry in timeline.document["plan"]] == [0, 4]


def test_a_dropped_segment_is_hatched(timeline: KeyphasePage) -> None:
    hatched = timeline.page.locator("[data-segment='2'] rect[style*='#hatch']")
    assert hatched.count() == 0
    timeline.change(lambda: _item(timeline, timeline.middle_of(2), "Drop"))
    timeline.picture("dropped")
    assert hatched.count() == 1


def test_split_while_playing_snaps_to_the_nearest_evidence(timeline: KeyphasePage) -> None:
    peak = next(p for p in timeline.document["peaks"] if p["rejection"])
    timeline.page.evaluate("t => keyphase.actions.seek(t)", peak["time_s"] - 0.03)
    timeline.page.evaluate("() => keyphase.actions.play({ playing: true, speed: 0.01 })")
    timeline.until("keyphase.state.playhead.playing")
    timeline.change(lambda: timeline.page.get_by_role("button", name="Split T", exact=True).click())
    added = [b for b in timeline.document["boundaries"] if b["origin"] == "user"]
    assert min(abs(added[0]["time_s"] - peak[key]) for key in ("time_s", "bin_time_s")) < 1e-6


def test_the_menu_says_whether_a_boundary_is_a_contact_change(timeline: KeyphasePage) -> None:
    assert not timeline.document["boundaries"][0]["contact_change"]
    timeline.change(lambda: _item(timeline, _boundary(timeline, 0), "A contact change"))
    assert timeline.document["boundaries"][0]["contact_change"]
    timeline.change(lambda: _item(timeline, _boundary(timeline, 0), "Not a contact change"))
    assert not timeline.document["boundaries"][0]["contact_change"]


def test_the_menu_accepts_one_name_or_all(timeline: KeyphasePage) -> None:
    def proposed() -> list[int]:
        segments = timeline.document["segments"]
        return [k for k, one in enumerate(segments) if one["proposed"] and one["kept"]]

    before = proposed()
    timeline.change(lambda: _item(timeline, timeline.middle_of(before[0]), "Accept its name"))
    assert proposed() == before[1:]
    at = timeline.middle_of(before[1])
    timeline.change(lambda: _item(timeline, at, "Accept all proposed names"))
    assert proposed() == []


def test_the_menu_gives_a_name_of_the_vocabulary(timeline: KeyphasePage) -> None:
    timeline.change(lambda: timeline.page.evaluate("() => keyphase.actions.label('Reach', 0)"))
    timeline.change(lambda: _item(timeline, timeline.middle_of(4), "Reach"))
    assert timeline.labels()[4] == "Reach"


def test_a_name_is_chosen_from_the_list_with_the_mouse(timeline: KeyphasePage) -> None:
    timeline.change(lambda: timeline.page.evaluate("() => keyphase.actions.label('Reach', 0)"))
    timeline.click(timeline.middle_of(4), count=2)
    timeline.change(lambda: timeline.page.locator("#rename li", has_text="Reach").first.click())
    assert timeline.labels()[4] == "Reach"


def test_the_menu_orders_the_plan(timeline: KeyphasePage) -> None:
    def plan() -> list[int]:
        return [entry["segment"] for entry in timeline.document["plan"]]

    timeline.change(lambda: _item(timeline, timeline.middle_of(0), "Later in the plan"))
    assert plan() == [2, 0, 4]
    timeline.change(lambda: _item(timeline, timeline.middle_of(0), "Repeat in the plan"))
    assert plan() == [2, 0, 0, 4]
    timeline.change(lambda: _item(timeline, timeline.middle_of(0), "Take out of the plan"))
    assert plan() == [2, 0, 4]


def test_unsure_boundaries_are_visited_and_accepted_by_clicks(timeline: KeyphasePage) -> None:
    timeline.page.evaluate(
        """() => {
          const { document: doc } = keyphase.state;
          const boundaries = doc.boundaries.map((b, k) => ({ ...b, confidence: k ? 0.3 : 0.6 }));
          keyphase.store.set({ document: { ...doc, boundaries: boundaries.slice(0, 2) } });
        }"""
    )
    timeline.page.get_by_role("button", name="Next unsure boundary").click()
    timeline.until("keyphase.state.current === 1")
    why = timeline.page.locator("#why")
    timeline.change(lambda: why.get_by_role("button", name="Accept").click())
    assert timeline.document["boundaries"][1]["accepted"]


def test_reset_takes_all_edits_back(timeline: KeyphasePage) -> None:
    before = timeline.document["boundaries"]
    timeline.change(lambda: _item(timeline, _boundary(timeline, 0), "Remove"))
    timeline.change(lambda: _command(timeline, "Take back all edits"))
    assert timeline.document["boundaries"] == before


def test_undo_and_redo_go_on_after_a_restart(folder: Path, serve: Serve, visit: Visit) -> None:
    server = serve(folder / "setup1.npz")
    page = visit(server, scene=False)
    page.wait_for_document()
    before = page.document["boundaries"]
    page.change(lambda: _item(page, _boundary(page, 0), "Remove"))
    after = page.document["boundaries"]
    page.close()
    server.stop()

    page = visit(serve(folder / "setup1.npz"), scene=False)
    page.wait_for_document()
    assert page.document["boundaries"] == after
    page.change(lambda: page.page.locator("#undo").click())
    assert page.document["boundaries"] == before
    page.change(lambda: page.page.locator("#redo").click())
    assert page.document["boundaries"] == after


def test_after_a_click_on_a_button_space_plays(timeline: KeyphasePage) -> None:
    timeline.click(timeline.middle_of(0))
    timeline.change(lambda: timeline.page.get_by_role("button", name="Drop X", exact=True).click())
    timeline.press("Space")
    timeline.until("keyphase.state.playhead.playing")
    assert not timeline.document["segments"][0]["kept"]
