"""Correcting a segmentation with the keyboard alone."""

from pathlib import Path

import pytest
from driver import KeyphasePage


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
