"""A stranger's table is dropped on the page: it asks what it cannot know, and reads it."""

from pathlib import Path

import numpy as np
import pytest
from driver import KeyphasePage, Serve, Visit

from keyphase.readers import read
from strangers_tables import Stranger, press, strangers

MAX_CLICKS = 15


class Hand:
    """Chooses in the dialog as a person does, and counts."""

    def __init__(self, page: KeyphasePage) -> None:
        self.page, self.clicks = page.page, 0

    def click(self, text: str) -> None:
        self.page.locator(f'#describing [data-field="{text}"]').click()
        self.clicks += 1
        self.page.wait_for_timeout(100)

    def choose(self, field: str, value: str) -> None:
        """Opening a list and choosing in it are two."""
        self.page.locator(f'#describing [data-field="{field}"]').select_option(value)
        self.clicks += 2
        self.page.wait_for_timeout(100)

    def write(self, field: str, value: str) -> None:
        box = self.page.locator(f'#describing [data-field="{field}"]')
        box.fill(value)
        box.press("Tab")
        self.clicks += 1


@pytest.fixture(scope="module")
def empty(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("strangers")


def dropped(page: KeyphasePage, stranger: Stranger) -> None:
    page.page.locator("input[type=file]").set_input_files(
        {"name": stranger.name, "mimeType": "text/plain", "buffer": stranger.data}
    )
    page.page.locator("#describing[open]").wait_for()


def test_six_strangers_tables_are_read_in_a_few_clicks(
    serve: Serve, visit: Visit, empty: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(empty)
    page = visit(serve(folder=empty), size=(1440, 900), scene=False)
    page.until("keyphase.state.greeted")
    time_s, position, force = press()
    for stranger in strangers():
        hand = Hand(page)
        dropped(page, stranger)
        if "quaternion" in page.state("tables")[0]["answers"]["parts"]:
            hand.choose("order", "xyzw")
        if "roll" in page.state("tables")[0]["answers"]["parts"]:
            hand.choose("sequence", "xyz")
        if stranger.name == "trajectory.dat":
            hand.write("rate_hz", "125")
            for column, part in zip((7, 8, 9), ("fx", "fy", "fz"), strict=True):
                hand.choose(f"column {column}", part)
            hand.choose("unit force", "N")
        hand.click("up, on the tool" if stranger.sign == 1 else "down, on the table")
        hand.click("the tool" if stranger.frame == "tool" else "the robot's base")
        page.page.locator("#describing figure").first.wait_for()
        page.picture(f"describing_{Path(stranger.name).stem}")
        hand.click("Read this one so")
        page.page.locator("#describing:not([open])").wait_for(state="hidden")
        page.until(f"keyphase.state.document?.name === {Path(stranger.name).stem!r}")

        found = read(empty / stranger.name)
        assert hand.clicks <= MAX_CLICKS
        np.testing.assert_allclose(found.time_s - found.start_s, time_s, atol=1e-3)
        np.testing.assert_allclose(found.position_m, position, atol=1e-5)
        assert found.force_N is not None
        np.testing.assert_allclose(found.force_N, force, atol=1e-3)


def test_leaving_the_question_leaves_nothing_behind(
    serve: Serve, visit: Visit, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    page = visit(serve(folder=tmp_path), size=(1280, 720), scene=False)
    page.until("keyphase.state.greeted")
    dropped(page, strangers()[0])

    page.press("Escape")
    page.page.locator("#describing:not([open])").wait_for(state="hidden")

    assert list(tmp_path.iterdir()) == []
