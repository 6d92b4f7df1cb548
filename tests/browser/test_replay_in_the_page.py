"""A replay in Chromium: started, paused, stepped, held, stopped, and its outcome."""

from dataclasses import replace
from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit

from keyphase.web.server import PageServer


@pytest.fixture
def server(folder: Path, serve: Serve) -> PageServer:
    return serve(folder / "setup1.npz")


@pytest.fixture
def page(server: PageServer, visit: Visit) -> KeyphasePage:
    """The timeline with the idle segments dropped; replays run at four times real time."""
    page = visit(server, scene=False)
    page.wait_for_document()
    page.change(lambda: page.press("i"))
    server.session.replay.configure(lambda settings: replace(settings, speed=4.0))
    return page


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


def test_escape_stops_it(page: KeyphasePage) -> None:
    begin(page)
    page.until("keyphase.state.replay.current === 1")
    page.press("Escape")
    phase(page, "over")
    assert "stopped" in chips(page)
    assert "contact" not in chips(page)
    assert "stopped by hand" in page.text("#replay-plan .plan-verdict")


def test_space_pauses_and_goes_on(page: KeyphasePage) -> None:
    begin(page)
    page.press("Space")
    phase(page, "paused")
    page.press("Space")
    phase(page, "running")


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
    page.page.get_by_role("button", name="Open its recording").click()
    page.until("keyphase.state.document.name.includes('_replay')")
    assert len(page.state("recordings")["items"]) == 2
