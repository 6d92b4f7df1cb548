"""Correcting a segmentation with the mouse alone."""

import pytest
from driver import KeyphasePage


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


def test_a_dragged_boundary_moves_and_leaves_a_mark_where_it_was(editor: KeyphasePage) -> None:
    was = editor.document["boundaries"][0]["time_s"]
    row = editor.row("boundaries")
    start = (editor.x(was), row.y + row.height / 2)
    editor.page.keyboard.down("Alt")
    editor.change(lambda: editor.drag(start, (start[0] + 60, start[1])))
    editor.page.keyboard.up("Alt")
    moved = editor.document["boundaries"][0]
    assert editor.x(moved["time_s"]) == pytest.approx(start[0] + 60, abs=1.5)
    assert moved["was_s"] == pytest.approx(was)
    assert editor.page.locator(".was-line").count() == 1


def test_with_shift_all_later_boundaries_go_along(editor: KeyphasePage) -> None:
    before = [boundary["time_s"] for boundary in editor.document["boundaries"]]
    start = _boundary(editor, 1)
    editor.page.keyboard.down("Alt")
    editor.page.keyboard.down("Shift")
    editor.page.mouse.move(*start)
    editor.page.mouse.down()
    editor.page.mouse.move(start[0] + 30, start[1], steps=6)
    editor.settle()
    editor.picture("ripple")
    editor.change(editor.page.mouse.up)
    editor.page.keyboard.up("Shift")
    editor.page.keyboard.up("Alt")
    after = [boundary["time_s"] for boundary in editor.document["boundaries"]]
    moved = [new - old for new, old in zip(after, before, strict=True)]
    assert moved[0] == 0.0
    assert moved[1] > 0.05
    assert moved[1:] == pytest.approx([moved[1]] * len(moved[1:]))
    editor.change(lambda: editor.press("Control+z"))
    assert [one["time_s"] for one in editor.document["boundaries"]] == pytest.approx(before)


def test_a_dragged_boundary_snaps_to_evidence_nearby(editor: KeyphasePage) -> None:
    editor.set_parameter("variant", "paper")
    peak = next(p for p in editor.document["peaks"] if p["rejection"] == "at an end")
    last = editor.document["boundaries"][-1]["time_s"]
    row = editor.row("boundaries")
    y = row.y + row.height / 2
    editor.change(
        lambda: editor.drag((editor.x(last), y), (editor.x(peak["time_s"]) - 4, y), steps=20)
    )
    moved = editor.document["boundaries"][-1]["time_s"]
    assert min(abs(moved - peak[key]) for key in ("time_s", "bin_time_s")) < 1e-6


def test_a_lens_shows_the_signal_while_dragging(editor: KeyphasePage) -> None:
    was = editor.document["boundaries"][2]["time_s"]
    row = editor.row("boundaries")
    editor.page.mouse.move(editor.x(was), row.y + 10)
    editor.page.mouse.down()
    editor.page.mouse.move(editor.x(was) - 40, row.y + 10, steps=6)
    editor.until("keyphase.state.lens")
    editor.settle()
    lens = editor.box("#lens")
    assert lens.y + lens.height < editor.box("#transport").y
    assert editor.picture("lens").count("#1c7ed6", lens, tolerance=40) > 30
    editor.press("Escape")
    editor.page.mouse.up()
    assert editor.document["boundaries"][2]["time_s"] == was
    assert not editor.page.locator("#lens").is_visible()


def test_clicking_a_segment_selects_it(editor: KeyphasePage) -> None:
    editor.click(editor.middle_of(2))
    editor.until("keyphase.state.selected === 2")
    editor.settle()
    assert editor.page.locator(".segment-ring").count() == 1


def test_clicking_a_track_moves_the_playhead_there(editor: KeyphasePage) -> None:
    row = editor.row("position")
    editor.click((editor.x(2.0), row.y + row.height / 2))
    editor.until("Math.abs(keyphase.state.playhead.time_s - 2) < 0.01")
    editor.settle()
    assert editor.text("#clock").startswith("2.0")


def test_dragging_over_segments_merges_them(editor: KeyphasePage) -> None:
    before = editor.segments.count()
    editor.change(lambda: editor.drag(editor.middle_of(2), editor.middle_of(4)))
    assert editor.segments.count() == before - 2


def test_double_click_renames_in_place(editor: KeyphasePage) -> None:
    editor.click(editor.middle_of(2), count=2)
    field = editor.page.locator("#rename input")
    field.wait_for()
    editor.picture("rename")
    field.fill("Put on the table")
    editor.change(lambda: editor.press("Enter"))
    assert editor.labels()[2] == "Put on the table"
    assert "Put on the table" in editor.page.locator("[data-segment='2']").text_content()

    editor.click(editor.middle_of(0), count=2)
    field.fill("Reach")
    row = editor.row("ruler")
    editor.change(lambda: editor.click((row.x + 5, row.y + 5)))
    assert editor.labels()[0] == "Reach"


def test_the_buttons_split_drop_and_undo(editor: KeyphasePage) -> None:
    before = editor.segments.count()
    row = editor.row("ruler")
    editor.click((editor.x(0.6), row.y + 9))
    editor.change(lambda: editor.page.get_by_role("button", name="Split T", exact=True).click())
    assert editor.segments.count() == before + 1
    editor.click(editor.middle_of(1))
    editor.change(lambda: editor.page.get_by_role("button", name="Drop X", exact=True).click())
    assert not editor.document["segments"][1]["kept"]
    editor.change(lambda: editor.page.locator("#undo").click())
    editor.change(lambda: editor.page.locator("#undo").click())
    assert editor.segments.count() == before


def test_the_menu_does_everything_to_what_was_clicked(editor: KeyphasePage) -> None:
    before = editor.segments.count()
    editor.page.mouse.click(*editor.middle_of(0), button="right")
    editor.picture("menu")
    editor.change(lambda: editor.page.get_by_role("menuitem", name="Split here").click())
    assert editor.segments.count() == before + 1
    row = editor.row("boundaries")
    first = editor.document["boundaries"][0]["time_s"]
    editor.page.mouse.click(editor.x(first), row.y + row.height / 2, button="right")
    editor.change(lambda: editor.page.get_by_role("menuitem", name="Remove").click())
    assert editor.segments.count() == before


def test_all_idle_segments_are_dropped_with_one_click(editor: KeyphasePage) -> None:
    proposed = editor.document["proposed_drops"]
    assert proposed
    editor.change(lambda: editor.page.locator("#drop-idle").click())
    assert editor.document["proposed_drops"] == []
    assert all(not editor.document["segments"][k]["kept"] for k in proposed)


def test_chips_are_dragged_into_another_order(editor: KeyphasePage) -> None:
    chips = editor.page.locator(".chip")
    first, second = (chips.nth(k).bounding_box() for k in (0, 1))
    assert first
    assert second
    end = (second["x"] + second["width"] - 6, second["y"] + 18)
    editor.change(lambda: editor.drag((first["x"] + 50, first["y"] + 18), end))
    assert [entry["segment"] for entry in editor.document["plan"]][:2] == [2, 0]


def test_a_chip_dragged_with_control_is_repeated(editor: KeyphasePage) -> None:
    count = editor.page.locator(".chip").count()
    chip = editor.page.locator(".chip").first.bounding_box()
    assert chip
    editor.page.keyboard.down("Control")
    start = (chip["x"] + 50, chip["y"] + 18)
    editor.change(lambda: editor.drag(start, (start[0] + chip["width"], start[1])))
    editor.page.keyboard.up("Control")
    assert editor.page.locator(".chip").count() == count + 1
    assert editor.page.locator(".chip .repeat").count() == 1


def test_pressing_delete_on_a_chip_takes_it_out(editor: KeyphasePage) -> None:
    count = editor.page.locator(".chip").count()
    editor.page.locator(".chip").nth(1).focus()
    editor.change(lambda: editor.press("Delete"))
    assert editor.page.locator(".chip").count() == count - 1


def test_a_chip_dragged_out_of_the_strip_is_taken_out(editor: KeyphasePage) -> None:
    chip = editor.page.locator(".chip").nth(1).bounding_box()
    assert chip
    start = (chip["x"] + 50, chip["y"] + 18)
    editor.change(lambda: editor.drag(start, (start[0], start[1] - 150)))
    assert [entry["segment"] for entry in editor.document["plan"]] == [0, 4]


def test_a_dropped_segment_is_hatched(editor: KeyphasePage) -> None:
    hatched = editor.page.locator("[data-segment='2'] rect[style*='#hatch']")
    assert hatched.count() == 0
    editor.change(lambda: _item(editor, editor.middle_of(2), "Drop"))
    editor.picture("dropped")
    assert hatched.count() == 1


def test_split_while_playing_snaps_to_the_nearest_evidence(timeline: KeyphasePage) -> None:
    timeline.set_parameter("variant", "paper")
    peak = next(p for p in timeline.document["peaks"] if p["rejection"])
    timeline.page.evaluate("t => keyphase.actions.seek(t)", peak["time_s"] - 0.03)
    timeline.page.evaluate("() => keyphase.actions.play({ playing: true, speed: 0.01 })")
    timeline.until("keyphase.state.playhead.playing")
    timeline.change(lambda: timeline.page.get_by_role("button", name="Split T", exact=True).click())
    added = [b for b in timeline.document["boundaries"] if b["origin"] == "user"]
    assert min(abs(added[0]["time_s"] - peak[key]) for key in ("time_s", "bin_time_s")) < 1e-6


def test_the_menu_says_whether_a_boundary_is_a_contact_change(editor: KeyphasePage) -> None:
    assert not editor.document["boundaries"][0]["contact_change"]
    editor.change(lambda: _item(editor, _boundary(editor, 0), "A contact change"))
    assert editor.document["boundaries"][0]["contact_change"]
    editor.change(lambda: _item(editor, _boundary(editor, 0), "Not a contact change"))
    assert not editor.document["boundaries"][0]["contact_change"]


def test_the_menu_accepts_one_name_or_all(editor: KeyphasePage) -> None:
    def proposed() -> list[int]:
        segments = editor.document["segments"]
        return [k for k, one in enumerate(segments) if one["proposed"] and one["kept"]]

    before = proposed()
    editor.change(lambda: _item(editor, editor.middle_of(before[0]), "Accept its name"))
    assert proposed() == before[1:]
    at = editor.middle_of(before[1])
    editor.change(lambda: _item(editor, at, "Accept all proposed names"))
    assert proposed() == []


def test_the_menu_gives_a_name_of_the_vocabulary(editor: KeyphasePage) -> None:
    editor.change(lambda: editor.page.evaluate("() => keyphase.actions.label('Reach', 0)"))
    editor.change(lambda: _item(editor, editor.middle_of(4), "Reach"))
    assert editor.labels()[4] == "Reach"


def test_a_name_is_chosen_from_the_list_with_the_mouse(editor: KeyphasePage) -> None:
    editor.change(lambda: editor.page.evaluate("() => keyphase.actions.label('Reach', 0)"))
    editor.click(editor.middle_of(4), count=2)
    editor.change(lambda: editor.page.locator("#rename li", has_text="Reach").first.click())
    assert editor.labels()[4] == "Reach"


def test_the_menu_orders_the_plan(editor: KeyphasePage) -> None:
    def plan() -> list[int]:
        return [entry["segment"] for entry in editor.document["plan"]]

    editor.change(lambda: _item(editor, editor.middle_of(0), "Later in the plan"))
    assert plan() == [2, 0, 4]
    editor.change(lambda: _item(editor, editor.middle_of(0), "Repeat in the plan"))
    assert plan() == [2, 0, 0, 4]
    editor.change(lambda: _item(editor, editor.middle_of(0), "Take out of the plan"))
    assert plan() == [2, 0, 4]


def test_unsure_boundaries_are_visited_and_accepted_by_clicks(editor: KeyphasePage) -> None:
    editor.page.evaluate(
        """() => {
          const { document: doc } = keyphase.state;
          const boundaries = doc.boundaries.map(
            (b, k) => ({ ...b, unsure: true, confidence: k ? 0.3 : 0.6 }));
          keyphase.store.set({ document: { ...doc, boundaries: boundaries.slice(0, 2) } });
        }"""
    )
    editor.page.get_by_role("button", name="Next unsure boundary").click()
    editor.until("keyphase.state.current === 1")
    why = editor.page.locator("#why")
    editor.change(lambda: why.get_by_role("button", name="Accept").click())
    assert editor.document["boundaries"][1]["accepted"]


def test_reset_takes_all_edits_back(editor: KeyphasePage) -> None:
    before = editor.document["boundaries"]
    editor.change(lambda: _item(editor, _boundary(editor, 0), "Remove"))
    editor.change(lambda: _command(editor, "Take back all edits"))
    assert editor.document["boundaries"] == before


def test_after_a_click_on_a_button_space_plays(editor: KeyphasePage) -> None:
    editor.click(editor.middle_of(0))
    editor.change(lambda: editor.page.get_by_role("button", name="Drop X", exact=True).click())
    editor.press("Space")
    editor.until("keyphase.state.playhead.playing")
    assert not editor.document["segments"][0]["kept"]
