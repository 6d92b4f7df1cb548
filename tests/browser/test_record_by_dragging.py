"""Recording in the page: the tool is dragged with the mouse, by the gizmo in the scene."""

from pathlib import Path

import numpy as np
import pytest
from driver import KeyphasePage, Serve, Visit
from gizmo import Gizmo

from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.web.scene.replaying.workcell_scene import GIZMO_M
from keyphase.web.server import PageServer
from keyphase.workbench import workbench as workbench_module

FORWARD, FORWARD_M = np.array([1.0, 0.0, 0.0]), 0.12
DOWN, DOWN_M = np.array([0.0, 0.0, -1.0]), 0.115
"""From its start the tool is dragged forward over the housing, then down onto it and into it."""

CONTACT_WITHIN_S = 0.06
ARROW = "#e8590c"


@pytest.fixture
def server(tmp_path: Path, serve: Serve) -> PageServer:
    """A server without any recording; new ones go into the test's folder."""
    return serve(folder=tmp_path)


@pytest.fixture
def page(server: PageServer, visit: Visit) -> KeyphasePage:
    """Its page with the Record tab open."""
    page = visit(server, size=(1280, 1000))
    page.wait_for_scene()
    page.panel.get_by_role("tab", name="Record").click()
    return page


def press(page: KeyphasePage, button: str) -> None:
    page.panel.get_by_role("button", name=button, exact=True).click()


def wait_until_at_rest(server: PageServer, page: KeyphasePage, least_s: float) -> None:
    """Until so much has been simulated from now; the simulation may be slower than the clock."""
    lead = server.workbench.views[-1].lead
    state = lead.status().running
    assert state is not None
    end_s = state.sample.time_s + least_s
    while (state := lead.status().running) and state.sample.time_s < end_s:
        page.settle()


def force_shown(page: KeyphasePage) -> float:
    return float(
        page.panel.get_by_role("meter").get_attribute("aria-valuetext", timeout=5_000)[:-2]
    )


@pytest.mark.slow
def test_a_contact_made_by_dragging_is_seen_as_it_is_pressed_and_found_in_the_recording(
    tmp_path: Path, server: PageServer, page: KeyphasePage
) -> None:
    press(page, "Record")
    page.panel.get_by_role("button", name="Stop", exact=True).wait_for()
    page.wait_for_scene()
    scene = page.box("#viser")
    before = page.picture("free").count(ARROW, scene, tolerance=40)
    gizmo = Gizmo(server, page, GIZMO_M)
    for axis, distance_m in ((FORWARD, FORWARD_M), (DOWN, DOWN_M)):
        gizmo.pull(axis, distance_m)
        wait_until_at_rest(server, page, 0.8)
    page.settle()
    assert page.picture("pressing").count(ARROW, scene, tolerance=40) > before + 300
    assert force_shown(page) > 5.0

    press(page, "Stop")
    page.wait_for_document()
    page.picture("recorded")
    assert page.document["name"] == "setup1_01"
    demonstration = read(tmp_path / "setup1_01.npz")
    touched_s = demonstration.metadata["ground_truth"]["contact_onsets_s"]["snap"]
    shown = [b["time_s"] for b in page.document["boundaries"] if b["contact_change"]]
    assert any(abs(time_s - touched_s) < CONTACT_WITHIN_S for time_s in shown)
    found = [b.time_s for b in segment(demonstration).boundaries if b.contact_change]
    assert shown == pytest.approx(found)


@pytest.mark.slow
def test_a_take_is_undone_and_brought_back(
    tmp_path: Path, server: PageServer, page: KeyphasePage
) -> None:
    press(page, "Record")
    page.panel.get_by_role("button", name="Stop", exact=True).wait_for()
    wait_until_at_rest(server, page, 2.0)
    press(page, "Stop")
    page.wait_for_document()
    press(page, "Undo last take")
    page.until("keyphase.state.recordings.items.length === 0")
    assert not (tmp_path / "setup1_01.npz").exists()
    press(page, "Bring back take")
    page.until("keyphase.state.document?.name === 'setup1_01'")
    assert (tmp_path / "setup1_01.npz").exists()


@pytest.mark.slow
def test_a_take_is_kept_when_the_browser_closes_midway(
    tmp_path: Path,
    server: PageServer,
    page: KeyphasePage,
    visit: Visit,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(workbench_module, "KEPT_S", 1.0)
    press(page, "Record")
    page.panel.get_by_role("button", name="Stop", exact=True).wait_for()
    wait_until_at_rest(server, page, 2.0)
    page.page.goto("about:blank")
    again = visit(server, scene=False)
    again.page.locator(".queue-row", has_text="setup1_01").click(timeout=90_000)
    again.wait_for_document()
    assert again.document["name"] == "setup1_01"
    assert read(tmp_path / "setup1_01.npz").duration_s > 1.5
