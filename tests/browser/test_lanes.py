"""The other arm of a table and the events of its log stand below the segments."""

from pathlib import Path

import numpy as np
from driver import LookAt

from two_arms import RECIPE

ALSO = """
events.column = "note"
channels.button = "di"
"""


def test_the_other_arm_and_the_events_are_lanes(look_at: LookAt, tmp_path: Path) -> None:
    time = np.arange(400) / 50
    left = np.interp(time, [0, 2, 3, 5, 6, 8], [0, 0.3, 0.3, 0.5, 0.5, 0.7])
    right = np.interp(time, [0, 4, 5, 8], [0.2, 0.6, 0.6, 0.3])
    rows = [
        f"{t},{a:.5f},0,0.3,0.4,{b:.5f},0.3,{int(t > 5.5)},{'part found' if t > 3 else 'search'}"
        for t, a, b in zip(time, left, right, strict=True)
    ]
    path = tmp_path / "run.csv"
    path.write_text("\n".join(["t,lx,ly,lz,rx,ry,rz,di,note", *rows, ""]))
    (tmp_path / "recipe.toml").write_text(ALSO + RECIPE)
    page = look_at(*(tmp_path / f"run.csv#{arm}" for arm in ("left", "right")))
    lane = page.page.locator(".lanes .lane-segment")
    lane.first.wait_for()
    assert page.page.locator(".event-mark").count() == 3
    assert page.row("channel/button").height > 0
    # Neither arm felt a force: nothing is said of contacts.
    assert "contact" not in page.text(".readout:has-text('motion')")
    assert page.page.get_by_role("checkbox", name="Contact forces").count() == 0
    page.picture("lanes")
    page.page.get_by_role("button", name="right", exact=True).click()
    page.until("keyphase.state.document?.name === 'run#right'")
    page.page.get_by_role("button", name="left", exact=True).wait_for()
