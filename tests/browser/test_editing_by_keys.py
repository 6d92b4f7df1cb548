"""Correcting a segmentation with the keyboard alone."""

from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit


def _command(page: KeyphasePage, name: str) -> None:
    page.press("Control+k")
    page.page.keyboard.type(name)
    page.press("Enter")


def test_split_and_undo_and_redo(timeline: KeyphasePage) -> None:
    before = timeline.segments.count()
    timeline.press("Home")
    timeline.press(".")
    timeline.press(",")
    timeline.page.evaluate("() => keyphase.actions.seek(0.6)")
    timeline.change(lambda: timeline.press("t"))
    assert timeline.segments.count() == before + 1
    timeline.change(lambda: timeline.press("Control+z"))
    assert timeline.segments.count() == before
    timeline.change(lambda: timeline.press("Control+Shift+Z"))
    assert timeline.segments.count() == before + 1


def test_select_merge_and_drop(timeline: KeyphasePage) -> None:
    before = timeline.segments.count()
    timeline.press("]")
    timeline.until("keyphase.state.selected === 0")
    timeline.change(lambda: timeline.press("x"))
    assert not timeline.document["segments"][0]["kept"]
    timeline.change(lambda: timeline.press("m"))
    assert timeline.segments.count() == before - 1


def test_name_a_segment(timeline: KeyphasePage) -> None:
    timeline.press("]")
    timeline.press("l")
    timeline.page.locator("#rename input").wait_for()
    timeline.page.keyboard.type("Reach")
    timeline.change(lambda: timeline.press("Enter"))
    assert timeline.labels()[0] == "Reach"
    timeline.press("]")
    timeline.press("]")
    timeline.change(lambda: timeline.press("Enter"))
    assert not timeline.document["segments"][2]["proposed"]
    timeline.change(lambda: timeline.press("Shift+Enter"))
    assert not any(s["proposed"] for s in timeline.document["segments"] if s["kept"])


def test_visit_move_and_remove_a_boundary(timeline: KeyphasePage) -> None:
    before = timeline.document["boundaries"]
    timeline.press("Home")
    timeline.press(".")
    timeline.until("keyphase.state.current === 0")
    timeline.change(lambda: timeline.press(">"))
    moved = timeline.document["boundaries"][0]["time_s"]
    assert moved == pytest.approx(before[0]["time_s"] + 0.01, abs=1e-3)
    timeline.press("Home")
    timeline.press(".")
    timeline.change(lambda: timeline.press("c"))
    assert timeline.document["boundaries"][0]["contact_change"]
    timeline.change(lambda: timeline.press("Delete"))
    assert len(timeline.document["boundaries"]) == len(before) - 1


def test_unsure_boundaries_are_visited_least_certain_first(timeline: KeyphasePage) -> None:
    timeline.page.evaluate(
        """() => {
          const doc = keyphase.state.document;
          doc.boundaries[0].confidence = 0.6;
          doc.boundaries[1].confidence = 0.3;
        }"""
    )
    timeline.press("n")
    assert timeline.state("current") == 1
    assert timeline.page.locator("#why").is_visible()
    timeline.press("n")
    assert timeline.state("current") == 0
    timeline.press("Shift+N")
    timeline.change(lambda: timeline.press("Enter"))
    assert timeline.document["boundaries"][1]["accepted"]


def test_the_plan_is_ordered_repeated_and_shortened(timeline: KeyphasePage) -> None:
    def plan() -> list[int]:
        return [entry["segment"] for entry in timeline.document["plan"]]

    assert plan() == [0, 2, 4]
    timeline.press("]")
    timeline.until("keyphase.state.selected === 0")
    timeline.change(lambda: timeline.press("}"))
    assert plan() == [2, 0, 4]
    timeline.change(lambda: timeline.press("r"))
    assert plan() == [2, 0, 0, 4]
    timeline.change(lambda: timeline.press("Shift+X"))
    assert plan() == [2, 0, 4]
    timeline.change(lambda: timeline.press("{"))
    assert plan() == [0, 2, 4]


def test_idle_segments_are_dropped_with_one_key(timeline: KeyphasePage) -> None:
    timeline.change(lambda: timeline.press("i"))
    assert timeline.document["proposed_drops"] == []


def test_the_palette_finds_and_runs_a_command(timeline: KeyphasePage) -> None:
    timeline.press("Control+k")
    timeline.page.keyboard.type("drop all")
    timeline.picture("palette")
    timeline.change(lambda: timeline.press("Enter"))
    assert timeline.document["proposed_drops"] == []


def test_the_sheet_of_keys_names_every_key_and_none_of_the_cameras(timeline: KeyphasePage) -> None:
    timeline.press("?")
    keys = timeline.page.locator("#keys kbd").all_inner_texts()
    timeline.picture("keys")
    assert {"T", "M", "X", "L", "N", "I", "Ctrl K", "Space"} <= set(keys)
    assert not {"W", "A", "S", "D", "Q", "E"} & set(keys)
    timeline.press("Escape")
    assert not timeline.page.locator("#keys").is_visible()


def test_keys_pressed_in_the_scene_reach_the_page(setup1: KeyphasePage) -> None:
    setup1.scene.locator("canvas").first.focus()
    setup1.scene.evaluate("() => window.focus()")
    setup1.scene.evaluate(
        "() => window.dispatchEvent(new KeyboardEvent('keydown', {key: ']', bubbles: true}))"
    )
    setup1.until("keyphase.state.selected === 0")


def test_the_documentation_names_every_key(timeline: KeyphasePage) -> None:
    documented = (Path(__file__).parents[2] / "docs" / "page.md").read_text()
    timeline.press("?")
    keys = timeline.page.locator("#keys section:not(:last-of-type) kbd").all_inner_texts()
    assert len(keys) > 20
    missing = [key for key in keys if key not in documented]
    assert not missing


def test_the_playhead_goes_to_the_ends_and_from_boundary_to_boundary(
    timeline: KeyphasePage,
) -> None:
    document = timeline.document
    for key, time_s in (
        ("End", document["end_s"]),
        (",", document["boundaries"][-1]["time_s"]),
        ("Home", document["start_s"]),
        (".", document["boundaries"][0]["time_s"]),
    ):
        timeline.press(key)
        timeline.until(f"Math.abs(keyphase.state.playhead.time_s - {time_s}) < 1e-6")


def test_split_while_playing_snaps_to_the_nearest_evidence_unless_switched_off(
    timeline: KeyphasePage,
) -> None:
    peak = next(p for p in timeline.document["peaks"] if p["rejection"])

    def marked() -> list[float]:
        timeline.page.evaluate("t => keyphase.actions.seek(t)", peak["time_s"] - 0.03)
        timeline.page.evaluate("() => keyphase.actions.play({ playing: true, speed: 0.01 })")
        timeline.until("keyphase.state.playhead.playing")
        timeline.change(lambda: timeline.press("t"))
        added = [b["time_s"] for b in timeline.document["boundaries"] if b["origin"] == "user"]
        timeline.change(lambda: timeline.press("Control+z"))
        return [abs(added[0] - peak[key]) for key in ("time_s", "bin_time_s")]

    assert min(marked()) < 1e-6
    timeline.press("v")
    timeline.until("!keyphase.state.snap")
    assert min(marked()) > 1e-3


def test_reset_takes_all_edits_back(timeline: KeyphasePage) -> None:
    before = timeline.document["boundaries"]
    timeline.press(".")
    timeline.change(lambda: timeline.press("Delete"))
    timeline.change(lambda: _command(timeline, "take back all"))
    assert timeline.document["boundaries"] == before


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
    page.change(lambda: page.press("Control+y"))
    assert page.document["boundaries"] == after


@pytest.mark.parametrize("key", ["Shift+F10", "ContextMenu"])
def test_the_menu_of_the_selected_segment_opens_and_acts_by_keys(
    timeline: KeyphasePage, key: str
) -> None:
    timeline.press("]")
    timeline.press("]")
    timeline.until("keyphase.state.selected === 1")
    timeline.press(key)
    assert timeline.text("#menu h5") == "Segment 2"
    timeline.press("ArrowDown")
    while "Split here" not in timeline.text("#menu button:focus"):
        timeline.press("ArrowDown")
    count = timeline.segments.count()
    timeline.change(lambda: timeline.press("Enter"))
    assert timeline.segments.count() == count + 1


def test_the_menu_of_the_current_boundary_opens_by_keys_and_escape_closes_it(
    timeline: KeyphasePage,
) -> None:
    timeline.press("Home")
    timeline.press(".")
    timeline.press("Shift+F10")
    assert timeline.text("#menu h5") == "Boundary 1"
    timeline.settle()
    timeline.picture("menu_of_a_boundary")
    timeline.press("Escape")
    assert timeline.page.locator("#menu").is_hidden()
    timeline.change(lambda: timeline.press("Delete"))


def test_keys_on_a_chip_mean_this_entry_and_the_focus_stays_with_it(
    timeline: KeyphasePage,
) -> None:
    def plan() -> list[int]:
        return [entry["segment"] for entry in timeline.document["plan"]]

    def focused() -> str:
        return timeline.page.evaluate("() => document.activeElement.dataset.entry")

    timeline.page.locator(".chip").nth(0).focus()
    timeline.change(lambda: timeline.press("r"))
    assert (plan(), focused()) == ([0, 0, 2, 4], "1")
    timeline.change(lambda: timeline.press("}"))
    assert (plan(), focused()) == ([0, 2, 0, 4], "2")
    timeline.press("Enter")
    timeline.until("keyphase.state.selected === 0")
    timeline.change(lambda: timeline.press("Delete"))
    assert (plan(), focused()) == ([0, 2, 4], "2")


def test_a_lost_edit_is_brought_back_and_forgotten_by_keys(timeline: KeyphasePage) -> None:
    first = timeline.document["boundaries"][0]["time_s"]
    timeline.change(
        lambda: timeline.page.evaluate("t => keyphase.actions.moveBoundary(t, t + 0.05)", first)
    )
    one_gaussian = "() => keyphase.actions.send({type: 'set', parameter: 'gaussians', value: 1})"
    timeline.change(lambda: timeline.page.evaluate(one_gaussian))
    timeline.until("keyphase.state.document.inapplicable.length > 0")
    lost = len(timeline.document["inapplicable"])
    timeline.page.locator("#theme").focus()
    while timeline.page.evaluate("() => document.activeElement.textContent") != "Bring back":
        timeline.press("Tab")
    timeline.change(lambda: timeline.press("Enter"))
    assert len(timeline.document["inapplicable"]) == lost - 1
    timeline.change(lambda: timeline.press("Control+z"))
    timeline.page.locator("#theme").focus()
    while timeline.page.evaluate("() => document.activeElement.textContent") != "Forget":
        timeline.press("Tab")
    timeline.change(lambda: timeline.press("Enter"))
    assert len(timeline.document["inapplicable"]) == lost - 1
