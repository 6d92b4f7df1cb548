"""A replay in Chromium: started, paused, stepped, held, stopped, and its outcome."""

from collections.abc import Iterator
from dataclasses import replace

import pytest
from driver import KeyphasePage

from keyphase.web.server import PageServer
from keyphase.workbench.replaying.settings import ReplaySettings


@pytest.fixture
def server(editor_server: PageServer, editor: KeyphasePage) -> PageServer:
    """Replays of the page that `editor` is run at four times real time."""
    editor_server.workbench.views[-1].replay.configure(lambda _: ReplaySettings(speed=4.0))
    return editor_server


@pytest.fixture
def page(server: PageServer, editor: KeyphasePage) -> Iterator[KeyphasePage]:
    """The timeline with the idle segments dropped."""
    editor.change(lambda: editor.press("i"))
    yield editor
    server.workbench.views[-1].replay.leave()
    editor.until("keyphase.state.replay === null")


def begin(page: KeyphasePage) -> None:
    page.press("p")
    page.until("keyphase.state.replay && keyphase.state.samples")


def phase(page: KeyphasePage, wanted: str) -> None:
    page.until(f"keyphase.state.replay.phase === '{wanted}'")
    page.settle()


def chips(page: KeyphasePage) -> list[str]:
    return [
        chip.get_attribute("data-outcome") or ""
        for chip in page.page.locator("#replay-plan .chip").all()
    ]


def test_it_runs_to_success_and_shows_every_outcome(page: KeyphasePage) -> None:
    begin(page)
    phase(page, "over")
    assert chips(page) == ["reached", "contact", "contact"]
    assert page.page.locator("#replay-timeline [data-end]").count() == 3
    assert "Success" in page.text("#replay-plan .plan-verdict")
    assert page.text("#replay-how") == "succeeded · 3 of 3 skills ended"
    page.resize(1024, 576)
    assert page.box("#scene").height >= 160
    page.resize(1920, 1080)


def test_escape_stops_it_and_closes_what_is_over(page: KeyphasePage) -> None:
    assert page.state("tab") == "segment"
    begin(page)
    assert page.state("tab") == "replay"
    page.until("keyphase.state.replay.current === 1")
    page.press("Escape")
    phase(page, "over")
    assert "stopped" in chips(page)
    assert "contact" not in chips(page)
    assert "Stopped by you in “" in page.text("#replay-plan .plan-verdict")
    page.press("Escape")
    page.until("keyphase.state.replay === null")


def test_space_pauses_and_goes_on(page: KeyphasePage) -> None:
    begin(page)
    page.press("Space")
    phase(page, "paused")
    page.set_theme(dark=True)
    page.press("Space")
    phase(page, "running")
    assert page.state("dark")
    page.set_theme(dark=False)


def test_next_skill_runs_until_one_has_ended(page: KeyphasePage) -> None:
    begin(page)
    page.press("Space")
    phase(page, "paused")
    page.page.get_by_role("button", name="Next skill").click()
    page.until("keyphase.state.replay.phase === 'running'")
    phase(page, "paused")
    ended = page.page.locator("#replay-timeline [data-progress=done]").count()
    assert ended >= 1


def test_held_the_running_skill_waits(page: KeyphasePage) -> None:
    begin(page)
    page.page.get_by_role("button", name="Hold").click()
    page.until("keyphase.state.replay.held")
    assert "held" in page.text("#replay-how")
    page.press("h")
    page.until("!keyphase.state.replay.held")
    phase(page, "over")
    assert "Success" in page.text("#replay-plan .plan-verdict")


def test_no_key_edits_the_demonstration_meanwhile(page: KeyphasePage) -> None:
    begin(page)
    revision = page.document["revision"]
    page.press("t")
    page.press("x")
    phase(page, "over")
    assert page.document["revision"] == revision


def test_the_result_stays_until_it_is_closed(page: KeyphasePage) -> None:
    begin(page)
    page.press("Escape")
    phase(page, "over")
    page.page.locator("#replay-transport").get_by_role("button", name="Close").click()
    page.until("keyphase.state.replay === null")
    page.settle()
    assert page.page.locator("#timeline").is_visible()
    assert page.page.locator("#plan .chip").count() == 3


def test_its_recording_is_opened_from_the_result(page: KeyphasePage) -> None:
    begin(page)
    phase(page, "over")
    page.page.locator("#replay-transport").get_by_role("button", name="Open its recording").click()
    page.until("keyphase.state.document.name.includes('_replay')")
    assert len(page.state("recordings")["items"]) == 2


@pytest.mark.parametrize(
    ("moved", "said"),
    [
        ({"part_height_m": -0.008}, "parts 8 mm lower"),
        ({"part_aside_m": 0.004}, "part 4 mm aside"),
    ],
)
def test_parts_moved_before_the_run_are_met_by_contact_ends(
    server: PageServer, page: KeyphasePage, moved: dict[str, float], said: str
) -> None:
    server.workbench.views[-1].replay.configure(lambda settings: replace(settings, **moved))
    begin(page)
    assert said in page.text("#replay-what")
    phase(page, "over")
    assert chips(page) == ["reached", "contact", "contact"]
    assert "Success" in page.text("#replay-plan .plan-verdict")


def test_parts_moved_before_the_run_are_missed_without_contact_ends(
    server: PageServer, page: KeyphasePage
) -> None:
    server.workbench.views[-1].replay.configure(
        lambda settings: replace(settings, part_height_m=-0.008, end_by="configuration")
    )
    begin(page)
    assert "without contact ends" in page.text("#replay-what")
    phase(page, "over")
    assert "Success" not in page.text("#replay-plan .plan-verdict")


def test_trials_end_with_their_picture(server: PageServer, page: KeyphasePage) -> None:
    page.panel.get_by_role("tab", name="Replay").click()
    server.workbench.views[-1].replay.run_trials(2)
    page.panel.locator(".beside-picture:not([hidden])").click(timeout=120_000)
    picture = page.page.locator("dialog.picture img")
    picture.wait_for()
    page.picture("replay_trials")
    assert "of 2" in (picture.get_attribute("alt") or "")
    assert picture.evaluate("image => image.naturalWidth") > 300
    page.page.locator("dialog.picture").get_by_role("button", name="Close").click()
    assert page.page.locator("dialog.picture").count() == 0
    page.panel.get_by_role("tab").first.click()


def test_the_wheel_zooms_a_drag_shifts_and_f_shows_all(page: KeyphasePage) -> None:
    begin(page)
    phase(page, "over")
    box = page.box("#replay-timeline")
    x, y = box.x + 0.5 * box.width, box.y + 0.6 * box.height
    page.page.mouse.move(x, y)
    page.page.mouse.wheel(0, -600)
    page.until("keyphase.state.replayView !== null")
    page.settle()
    zoomed = page.state("replayView")
    assert zoomed["to"] - zoomed["from"] < 0.6 * page.state("replay")["time_s"]
    assert page.page.locator("#replay-timeline .overview-window").count() == 1
    page.picture("replay_zoomed")
    page.drag((x, y), (x + 120, y))
    page.settle()
    shifted = page.state("replayView")
    assert shifted["from"] < zoomed["from"]
    assert shifted["to"] - shifted["from"] == pytest.approx(zoomed["to"] - zoomed["from"])
    page.press("f")
    page.until("keyphase.state.replayView === null")
    page.page.mouse.wheel(0, -600)
    page.until("keyphase.state.replayView !== null")
    page.page.locator("#replay-transport").get_by_role("button", name="Fit").click()
    page.until("keyphase.state.replayView === null")
