"""A recording of another robot in Chromium: replayed in the world made from it, and its margin."""

import sys
from functools import partial
from pathlib import Path

import pytest
from driver import KeyphasePage, Serve, Visit

from keyphase.readers import save_npz
from keyphase.workbench.replaying import margin as margin_module

sys.path.insert(0, str(Path(__file__).parents[1] / "simulation"))
from drawn_contact import pressed_slide

ALONG = ("towards the tool", "away from it")


@pytest.fixture
def page(
    tmp_path: Path, serve: Serve, visit: Visit, monkeypatch: pytest.MonkeyPatch
) -> KeyphasePage:
    """A hand that goes down onto a table, presses, and slides; the Replay tab is open."""
    tried = partial(margin_module.margin_of, axes=ALONG)
    monkeypatch.setattr(margin_module, "margin_of", tried)
    monkeypatch.setattr(margin_module, "JOBS", 1)
    save_npz(pressed_slide(), tmp_path / "stranger.npz")
    page = visit(serve(tmp_path / "stranger.npz"), scene=False)
    page.wait_for_document()
    page.panel.get_by_role("tab", name="Replay").click()
    return page


def test_it_runs_in_the_world_made_from_it_and_tells_its_margin(page: KeyphasePage) -> None:
    assert page.state("replaySettings")["workcell"] == "recording"
    page.press("p")
    page.until("keyphase.state.replay?.phase === 'over'")
    page.settle()
    assert "Success" in page.text("#replay-plan .plan-verdict")
    page.panel.get_by_role("button", name="Try the margin").click()
    page.until("keyphase.state.margin && !keyphase.state.margin.over")
    page.until("keyphase.state.margin.over")
    page.settle()
    told = page.state("margin")["outcome"]
    assert told.startswith("works from −")
    assert "by pose alone" in told
    assert told in page.panel.inner_text()
    page.panel.locator(".beside-picture").first.click()
    picture = page.page.locator("dialog.picture img")
    picture.wait_for()
    assert picture.evaluate("image => image.naturalWidth") > 300
    page.picture("replay_margin")


def test_a_margin_that_is_cancelled_says_so(page: KeyphasePage) -> None:
    page.panel.get_by_role("button", name="Try the margin").click()
    page.until("keyphase.state.margin && !keyphase.state.margin.over")
    page.panel.get_by_role("button", name="Cancel").click()
    page.until("keyphase.state.margin.over")
    assert page.state("margin")["outcome"] == "Cancelled."


def test_a_workcell_that_does_not_fit_is_refused_in_words(page: KeyphasePage) -> None:
    page.panel.get_by_label("Scene").select_option("setup1")
    page.until("keyphase.state.replaySettings.workcell === 'setup1'")
    page.panel.get_by_role("button", name="Run", exact=True).click()
    page.page.locator(".notice", has_text="does not fit setup1").wait_for()
    page.settle()
    page.picture("replay_unfit")
    assert page.state("replay") is None
