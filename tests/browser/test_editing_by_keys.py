"""Correcting a segmentation with the keyboard alone."""

from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit


def _command(page: KeyphasePage, name: str) -> None:
    page.press("Control+k")
    page.page.keyboard.type(name)
    page.press("Enter")


def _play_until(page: KeyphasePage, time_s: float) -> None:
    """From where the playhead is; it goes on playing."""
    page.press("Space")
    page.until(f"keyphase.state.clock >= {time_s}")


def test_split_and_undo_and_redo(editor: KeyphasePage) -> None:
    before = editor.segments.count()
    editor.press("Home")
    editor.press(".")
    editor.press(",")
    editor.press("Home")
    _play_until(editor, 0.3)
    editor.press("Space")
    editor.until("!keyphase.state.playhead.playing")
    editor.change(lambda: editor.press("t"))
    assert editor.segments.count() == before + 1
    editor.change(lambda: editor.press("Control+z"))
    assert editor.segments.count() == before
    editor.change(lambda: editor.press("Control+Shift+Z"))
    assert editor.segments.count() == before + 1


def test_select_merge_and_drop(editor: KeyphasePage) -> None:
    before = editor.segments.count()
    editor.press("]")
    editor.until("keyphase.state.selected === 0")
    editor.change(lambda: editor.press("x"))
    assert not editor.document["segments"][0]["kept"]
    editor.change(lambda: editor.press("m"))
    assert editor.segments.count() == before - 1


def test_name_a_segment(editor: KeyphasePage) -> None:
    editor.press("]")
    editor.press("l")
    editor.page.locator("#rename input").wait_for()
    editor.page.keyboard.type("Reach")
    editor.change(lambda: editor.press("Tab"))
    assert editor.labels()[0] == "Reach"
    assert editor.state("renaming") == 2, "Tab goes on to the next that is kept"
    editor.press("Escape")
    assert editor.page.locator("#plan .chip").first.inner_text().split("\n")[1] == "Reach"
    editor.press("]")
    editor.press("]")
    editor.change(lambda: editor.press("Enter"))
    assert not editor.document["segments"][2]["proposed"]
    editor.change(lambda: editor.press("Shift+Enter"))
    assert not any(s["proposed"] for s in editor.document["segments"] if s["kept"])


def test_a_name_typed_at_once_is_taken_from_its_first_letter(editor: KeyphasePage) -> None:
    editor.press("]")
    focused = editor.page.evaluate(
        """() => {
          dispatchEvent(new KeyboardEvent("keydown", { key: "l" }));
          return document.activeElement.ariaLabel;
        }"""
    )
    assert focused == "Label of the segment"
    editor.press("Escape")


def test_visit_move_and_remove_a_boundary(editor: KeyphasePage) -> None:
    before = editor.document["boundaries"]
    editor.press("Home")
    editor.press(".")
    editor.until("keyphase.state.current === 0")
    editor.change(lambda: editor.press(">"))
    moved = editor.document["boundaries"][0]["time_s"]
    assert moved == pytest.approx(before[0]["time_s"] + 0.01, abs=1e-3)
    editor.press("Home")
    editor.press(".")
    editor.change(lambda: editor.press("c"))
    assert editor.document["boundaries"][0]["contact_change"]
    editor.change(lambda: editor.press("Delete"))
    assert len(editor.document["boundaries"]) == len(before) - 1


def test_unsure_boundaries_are_visited_least_certain_first(editor: KeyphasePage) -> None:
    editor.page.evaluate(
        """() => {
          const doc = keyphase.state.document;
          for (const boundary of doc.boundaries) boundary.unsure = false;
          Object.assign(doc.boundaries[0], { confidence: 0.6, unsure: true });
          Object.assign(doc.boundaries[1], { confidence: 0.3, unsure: true });
        }"""
    )
    editor.press("n")
    assert editor.state("current") == 1
    editor.page.locator("#why").wait_for()
    editor.press("n")
    assert editor.state("current") == 0
    editor.press("Shift+N")
    editor.change(lambda: editor.press("Enter"))
    assert editor.document["boundaries"][1]["accepted"]


def test_the_plan_is_ordered_repeated_and_shortened(editor: KeyphasePage) -> None:
    def plan() -> list[int]:
        return [entry["segment"] for entry in editor.document["plan"]]

    assert plan() == [0, 2, 4]
    editor.press("]")
    editor.until("keyphase.state.selected === 0")
    editor.change(lambda: editor.press("}"))
    assert plan() == [2, 0, 4]
    editor.change(lambda: editor.press("r"))
    assert plan() == [2, 0, 0, 4]
    editor.change(lambda: editor.press("Shift+X"))
    assert plan() == [2, 0, 4]
    editor.change(lambda: editor.press("{"))
    assert plan() == [0, 2, 4]


def test_idle_segments_are_dropped_with_one_key(editor: KeyphasePage) -> None:
    editor.change(lambda: editor.press("i"))
    assert editor.document["proposed_drops"] == []


def test_the_palette_finds_and_runs_a_command(editor: KeyphasePage) -> None:
    editor.press("Control+k")
    editor.page.keyboard.type("drop all")
    editor.picture("palette")
    editor.change(lambda: editor.press("Enter"))
    assert editor.document["proposed_drops"] == []


def test_the_sheet_of_keys_names_every_key_and_none_of_the_cameras(editor: KeyphasePage) -> None:
    editor.press("?")
    keys = editor.page.locator("#keys kbd").all_inner_texts()
    editor.picture("keys")
    assert {"T", "M", "X", "L", "N", "I", "Ctrl K", "Space"} <= set(keys)
    assert not {"W", "A", "S", "D", "Q", "E"} & set(keys)
    editor.press("Escape")
    assert not editor.page.locator("#keys").is_visible()


def test_keys_pressed_in_the_scene_reach_the_page(setup1: KeyphasePage) -> None:
    setup1.wait_for_scene()
    view = setup1.box("#viser")
    setup1.click((view.x + 20, view.y + view.height - 20))
    setup1.press("]")
    setup1.until("keyphase.state.selected === 0")


def test_the_documentation_names_every_key(editor: KeyphasePage) -> None:
    documented = (Path(__file__).parents[2] / "docs" / "page.md").read_text()
    editor.press("?")
    keys = editor.page.locator("#keys section:not(:last-of-type) kbd").all_inner_texts()
    assert len(keys) > 20
    missing = [key for key in keys if key not in documented]
    assert not missing


def test_the_playhead_goes_to_the_ends_and_from_boundary_to_boundary(
    editor: KeyphasePage,
) -> None:
    document = editor.document
    for key, time_s in (
        ("End", document["end_s"]),
        (",", document["boundaries"][-1]["time_s"]),
        ("Home", document["start_s"]),
        (".", document["boundaries"][0]["time_s"]),
    ):
        editor.press(key)
        editor.until(f"Math.abs(keyphase.state.playhead.time_s - {time_s}) < 1e-6")


def test_split_while_playing_snaps_to_the_nearest_evidence_unless_switched_off(
    timeline: KeyphasePage,
) -> None:
    timeline.set_parameter("variant", "paper")
    peak = next(p for p in timeline.document["peaks"] if p["rejection"])
    boundaries = [b["time_s"] for b in timeline.document["boundaries"]]
    timeline.press("Home")
    for before_s in (time_s for time_s in boundaries if time_s < peak["time_s"]):
        timeline.press(".")
        timeline.until(f"Math.abs(keyphase.state.clock - {before_s}) < 1e-6")
    _play_until(timeline, peak["time_s"] - 0.6)
    timeline.press("Space")
    for _ in range(3):
        _command(timeline, "play slower")
    timeline.until("keyphase.state.playhead.speed === 0.1")
    _play_until(timeline, peak["time_s"] - 0.03)

    def marked() -> list[float]:
        timeline.page.evaluate("time => keyphase.actions.seek(time)", peak["time_s"] - 0.03)
        timeline.page.evaluate("() => keyphase.actions.play({ playing: true })")
        timeline.until("keyphase.state.playhead.playing")
        timeline.change(lambda: timeline.press("t"))
        added = [b["time_s"] for b in timeline.document["boundaries"] if b["origin"] == "user"]
        timeline.change(lambda: timeline.press("Control+z"))
        return [abs(added[0] - peak[key]) for key in ("time_s", "bin_time_s")]

    assert min(marked()) < 1e-6
    timeline.press("v")
    timeline.until("!keyphase.state.snap")
    assert min(marked()) > 1e-3


def test_a_number_held_while_it_plays_names_what_plays_meanwhile(timeline: KeyphasePage) -> None:
    timeline.press("]")
    timeline.press("l")
    timeline.page.keyboard.type("reach")
    timeline.change(lambda: timeline.press("Enter"))
    timeline.press("Escape")
    timeline.press("v")
    timeline.until("!keyphase.state.snap")
    timeline.page.evaluate("() => keyphase.actions.setSpeed(0.25)")
    timeline.page.evaluate("() => keyphase.actions.seek(2.5)")
    _play_until(timeline, 2.6)
    timeline.page.keyboard.down("1")
    timeline.until("keyphase.state.naming && keyphase.state.clock > 3.1")
    timeline.picture("naming_while_playing")
    timeline.change(lambda: timeline.page.keyboard.up("1"))
    released_s = timeline.state("clock")
    timeline.page.evaluate("() => keyphase.actions.play({ playing: false })")
    named = [s for s in timeline.document["segments"] if s["label"] == "reach"]
    assert len(named) == 2
    assert 2.4 < named[1]["start_s"] < 2.9
    assert 3.05 < named[1]["end_s"] <= released_s
    timeline.change(lambda: timeline.press("Control+z"))
    assert timeline.labels().count("reach") == 1


def test_a_boundary_goes_to_the_time_that_is_typed(editor: KeyphasePage) -> None:
    before = editor.document["boundaries"][0]["time_s"]
    editor.press(".")
    editor.press("Shift+T")
    field = editor.page.get_by_label("Time of the boundary")
    field.fill("never")
    field.press("Enter")
    assert field.get_attribute("aria-invalid") == "true"
    field.fill("1,25")
    editor.change(lambda: field.press("Enter"))
    moved = editor.document["boundaries"][0]
    assert (moved["time_s"], moved["was_s"]) == (1.25, before)
    editor.until("document.activeElement?.className !== 'typed-time'")
    editor.change(lambda: editor.press("Control+z"))
    assert editor.document["boundaries"][0]["time_s"] == before


def test_reset_takes_all_edits_back(editor: KeyphasePage) -> None:
    before = editor.document["boundaries"]
    editor.press(".")
    editor.change(lambda: editor.press("Delete"))
    editor.change(lambda: _command(editor, "take back all"))
    assert editor.document["boundaries"] == before


def test_undo_and_redo_go_on_after_a_restart(folder: Path, serve: Serve, visit: Visit) -> None:
    server = serve(folder / "setup1.npz")
    page = visit(server, scene=False)
    page.wait_for_document()
    before = page.document["boundaries"]
    page.press("Home")
    page.press(".")
    page.change(lambda: page.press("Delete"))
    after = page.document["boundaries"]
    page.close()
    server.stop()

    page = visit(serve(folder / "setup1.npz"), scene=False)
    page.wait_for_document()
    page.change(lambda: page.press("Control+z"))
    assert page.document["boundaries"] == before
    page.change(lambda: page.page.locator("#redo").click())
    assert page.document["boundaries"] == after
    page.change(lambda: page.page.locator("#undo").click())
    page.change(lambda: page.press("Control+y"))
    assert page.document["boundaries"] == after


@pytest.mark.parametrize("key", ["Shift+F10", "ContextMenu"])
def test_the_menu_of_the_selected_segment_opens_and_acts_by_keys(
    editor: KeyphasePage, key: str
) -> None:
    editor.press("]")
    editor.press("]")
    editor.until("keyphase.state.selected === 1")
    editor.press(key)
    assert editor.text("#menu .menu-heading") == "Segment 2"
    editor.press("ArrowDown")
    while "Split here" not in editor.text("#menu button:focus"):
        editor.press("ArrowDown")
    count = editor.segments.count()
    editor.change(lambda: editor.press("Enter"))
    assert editor.segments.count() == count + 1


def test_the_menu_of_the_current_boundary_opens_by_keys_and_escape_closes_it(
    editor: KeyphasePage,
) -> None:
    editor.press("Home")
    editor.press(".")
    editor.press("Shift+F10")
    assert editor.text("#menu .menu-heading") == "Boundary 1"
    editor.settle()
    editor.picture("menu_of_a_boundary")
    editor.press("Escape")
    assert editor.page.locator("#menu").is_hidden()
    editor.change(lambda: editor.press("Delete"))


def test_keys_on_a_chip_mean_this_entry_and_the_focus_stays_with_it(
    editor: KeyphasePage,
) -> None:
    def plan() -> list[int]:
        return [entry["segment"] for entry in editor.document["plan"]]

    def focused() -> str:
        return editor.page.evaluate("() => document.activeElement.dataset.entry")

    editor.tab_to("at.dataset.entry === '0'")
    editor.change(lambda: editor.press("r"))
    assert (plan(), focused()) == ([0, 0, 2, 4], "1")
    editor.change(lambda: editor.press("}"))
    assert (plan(), focused()) == ([0, 2, 0, 4], "2")
    editor.press("Enter")
    editor.until("keyphase.state.selected === 0")
    editor.change(lambda: editor.press("Delete"))
    assert (plan(), focused()) == ([0, 2, 4], "2")


def test_a_lost_edit_is_brought_back_and_forgotten_by_keys(editor: KeyphasePage) -> None:
    """The slider that leaves it without its place is moved by keys in `test_threshold.py`."""
    editor.set_parameter("variant", "paper")
    editor.press("Home")
    editor.press(".")
    editor.until("keyphase.state.current === 0")
    editor.change(lambda: editor.press(">"))
    one_gaussian = "() => keyphase.actions.send({type: 'set', parameter: 'gaussians', value: 1})"
    editor.change(lambda: editor.page.evaluate(one_gaussian))
    editor.until("keyphase.state.document.inapplicable.length > 0")
    lost = len(editor.document["inapplicable"])
    editor.tab_to("at.textContent === 'Bring back'")
    editor.change(lambda: editor.press("Enter"))
    assert len(editor.document["inapplicable"]) == lost - 1
    editor.change(lambda: editor.press("Control+z"))
    editor.tab_to("at.textContent === 'Forget'")
    editor.change(lambda: editor.press("Enter"))
    assert len(editor.document["inapplicable"]) == lost - 1
