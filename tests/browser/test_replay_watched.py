"""A replay with its scene and panel: pushed by the gizmo, tried in worlds, carried elsewhere."""

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from driver import KeyphasePage
from gizmo import Gizmo
from playwright.sync_api import Browser, expect

from keyphase.web.scene.replaying.replay_push import GIZMO_M
from keyphase.web.server import PageServer

SIDEWAYS, PULLED_M = np.array([0.0, 1.0, 0.0]), 0.15
"""The spring of the gizmo then pulls with 30 N."""

ASIDE_MM = 6.0
HELD_S = 0.6

_WATCH_NAMES = """() => {
  window.heights = {};
  const look = () => {
    for (const name of document.querySelectorAll("#names .name"))
      // A force has a digit at its beginning, too: "5.3 N".
      if (/^\\d /.test(name.textContent) && name.checkVisibility({ visibilityProperty: true }))
        (window.heights[name.textContent[0]] ??= []).push(name.getBoundingClientRect().y);
    requestAnimationFrame(look);
  };
  look();
}"""
"""At which heights of the page each name stands, frame by frame."""

NEAR_PX = 20

_OFF_MM = "keyphase.state.samples.columns.get('off')[keyphase.state.samples.count - 1]"
_NOW_S = "keyphase.state.samples.time[keyphase.state.samples.count - 1]"


@pytest.fixture
def server(scene_server: PageServer) -> PageServer:
    return scene_server


@pytest.fixture
def page(server: PageServer, setup1: KeyphasePage) -> Iterator[KeyphasePage]:
    """The page with the idle segments dropped and the Replay tab open."""
    setup1.change(lambda: setup1.press("i"))
    setup1.wait_for_scene()
    setup1.panel.get_by_role("tab", name="Replay").click()
    yield setup1
    server.workbench.views[-1].replay.leave()
    setup1.until("keyphase.state.replay === null")


def phase(page: KeyphasePage, wanted: str) -> None:
    page.until(f"keyphase.state.replay?.phase === '{wanted}' && keyphase.state.samples")
    page.settle()


def steer(page: KeyphasePage, name: str) -> None:
    """By the transport's button."""
    page.page.locator("#replay-transport").get_by_role("button", name=name).click()


def button(page: KeyphasePage, name: str):
    return page.panel.get_by_role("button", name=name, exact=True)


def plays_without_a_server(browser: Browser | None, film: Path) -> None:
    assert browser
    with browser.new_context(offline=True, viewport={"width": 640, "height": 400}) as alone:
        page = alone.new_page()
        page.goto(film.as_uri())
        shown_s = page.locator("input").first
        expect(shown_s).to_have_value(re.compile(r"[1-9]"), timeout=30_000)


@pytest.mark.slow
def test_pulled_aside_by_the_gizmo_it_waits_and_goes_on(
    server: PageServer, page: KeyphasePage
) -> None:
    page.panel.get_by_label("Push the tool").check()
    button(page, "Step").click()
    page.until("keyphase.state.replay?.current === 1")
    phase(page, "paused")
    Gizmo(server, page, GIZMO_M).hold(SIDEWAYS, PULLED_M)
    page.page.evaluate("() => keyphase.actions.replay.toggle()")
    page.until(f"{_OFF_MM} > {ASIDE_MM}")
    from_s = page.page.evaluate(_NOW_S)
    page.until(f"{_NOW_S} > {from_s + HELD_S} || keyphase.state.replay.phase === 'over'")
    page.picture("replay_pushed")
    page.page.mouse.up()
    phase(page, "over")
    skill = page.state("replay")["skills"][1]
    assert skill["outcome"] == "reached"
    assert skill["end_s"] - skill["start_s"] > skill["expected_s"] + 0.5 * HELD_S


@pytest.mark.slow
def test_trials_tell_how_far_they_are_and_can_be_cancelled(page: KeyphasePage) -> None:
    button(page, "Run trials").click()
    expect(page.panel.get_by_text(re.compile(r"^[1-9]\d* of 20 worlds"))).to_be_visible(
        timeout=60_000
    )
    button(page, "Cancel").click()
    expect(page.panel.get_by_text("Cancelled.")).to_be_visible(timeout=30_000)
    expect(button(page, "Cancel")).to_be_hidden()
    assert page.page.locator("dialog.picture").count() == 0


def test_skills_and_force_are_named_in_the_scene_and_outcomes_told_in_the_panel(
    server: PageServer, page: KeyphasePage
) -> None:
    server.workbench.views[-1].replay.configure(lambda settings: replace(settings, speed=4.0))
    page.wait_for_scene()
    page.page.evaluate(_WATCH_NAMES)
    for ended in range(1, 4):
        button(page, "Step").click()
        page.until(f"keyphase.state.replay?.current === {ended}")
        phase(page, "paused")
    page.wait_for_scene()
    heights = page.page.evaluate("() => window.heights")
    assert {"1", "3", "5"} <= set(heights)
    assert all(max(heights[one]) - min(heights[one]) < NEAR_PX for one in "135"), heights
    *skills, force = page.page.locator("#names .name").all_text_contents()
    assert skills == [
        "1 Move forward",
        "3 Move down until contact",
        "5 Slide left until contact changes",
    ]
    assert re.fullmatch(r"\d+\.\d N", force)
    expect(page.page.locator("#names .name.selected")).to_have_text(
        "5 Slide left until contact changes"
    )
    expect(page.panel.get_by_role("row").nth(2)).to_contain_text("1 Forwardreached")
    page.picture("replay_named")


@pytest.mark.slow
def test_the_plan_and_the_replay_are_carried_elsewhere(
    folder: Path, server: PageServer, page: KeyphasePage
) -> None:
    server.workbench.views[-1].replay.configure(lambda settings: replace(settings, speed=4.0))
    button(page, "Run").click()
    phase(page, "over")
    page.panel.get_by_role("tab", name="Export").click()
    for kind, file in (
        ("behavior-tree", "setup1.tree.xml"),
        ("program", "setup1.program.txt"),
        ("skills", "setup1.skills.json"),
        ("page", "setup1.replay.html"),
    ):
        page.page.evaluate("kind => keyphase.actions.exportAs(kind)", kind)
        told = page.page.locator(".notice", has_text=re.compile(f"Written to .*{file}"))
        expect(told).to_be_visible(timeout=30_000)
        assert (folder / file).stat().st_size > 100
    assert "BTCPP_format" in (folder / "setup1.tree.xml").read_text()
    assert json.loads((folder / "setup1.skills.json").read_text())["skills"]
    plays_without_a_server(page.page.context.browser, folder / "setup1.replay.html")
