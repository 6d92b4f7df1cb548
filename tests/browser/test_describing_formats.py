"""Binary files nobody has described are dropped on the page: it asks what they do not say."""

from pathlib import Path

import numpy as np
import pytest
from driver import KeyphasePage, Serve, Visit

from keyphase.readers import read
from strangers_files import nobodys_hdf5, nobodys_mcap
from strangers_tables import press


def open_empty(serve: Serve, visit: Visit, folder: Path, patch: pytest.MonkeyPatch) -> KeyphasePage:
    folder.mkdir()
    patch.chdir(folder)
    page = visit(serve(folder=folder), size=(1440, 900), scene=False)
    page.until("keyphase.state.greeted")
    return page


def dropped(page: KeyphasePage, file: Path) -> None:
    page.page.locator("input[type=file]").set_input_files(file)
    page.page.locator("#describing[open]").wait_for()


def in_dialog(page: KeyphasePage, field: str):
    return page.page.locator(f'#describing [data-field="{field}"]')


def read_so(page: KeyphasePage, name: str) -> None:
    page.page.locator("#describing figure").first.wait_for()
    page.picture(f"describing_{name.partition('#')[0]}")
    in_dialog(page, "Read this one so").click()
    page.page.locator("#describing:not([open])").wait_for(state="hidden")
    page.until(f"keyphase.state.document?.name === {name!r}")


def test_an_unnamed_hdf5_shows_its_channels_and_is_read_as_many_recordings(
    serve: Serve, visit: Visit, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = open_empty(serve, visit, tmp_path / "here", monkeypatch)
    dropped(page, nobodys_hdf5(tmp_path))

    shown = page.text("#describing")
    assert "tool_pose[0]" in shown
    assert "norm of these four is 1" in shown
    assert "One more recording in the same file" in shown
    in_dialog(page, "order").select_option("xyzw")
    in_dialog(page, "down, on the table").click()
    in_dialog(page, "the robot's base").click()
    read_so(page, "session_7#take_0")

    time_s, position, force = press()
    found = read(tmp_path / "here" / "session_7.h5#take_1")
    assert len(page.state("recordings")["items"]) == 2
    np.testing.assert_allclose(found.time_s - found.start_s, time_s, atol=1e-9)
    np.testing.assert_allclose(found.position_m, 1e-3 + position, atol=1e-9)
    assert found.force_N is not None
    np.testing.assert_allclose(found.force_N, force, atol=1e-9)


def test_a_corrected_column_and_a_clock_of_an_mcap_are_read_as_chosen(
    serve: Serve, visit: Visit, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    page = open_empty(serve, visit, tmp_path / "here", monkeypatch)
    dropped(page, nobodys_mcap(tmp_path))

    names = page.state("tables")[0]["names"]
    first = names.index("/robot/state.tcp.x")
    in_dialog(page, f"column {first}").select_option("ignore")
    page.page.locator("#describing .missing", has_text="x, y and z").wait_for()
    in_dialog(page, f"column {first}").select_option("x")
    in_dialog(page, "clock force").select_option("/sensor.log_time")
    in_dialog(page, "up, on the tool").click()
    in_dialog(page, "the robot's base").click()
    read_so(page, "cell_4")

    time_s, position, force = press()
    found = read(tmp_path / "here" / "cell_4.mcap")
    assert "/sensor.log_time" in (tmp_path / "here" / "cell_4.mcap.recipe.toml").read_text()
    # A force is logged 2 ms after its stamp, and both clocks have one zero: the first and the last
    # pose have none.
    within = slice(1, -1)
    np.testing.assert_allclose(found.position_m, position[within], atol=1e-6)
    logged = np.column_stack([np.interp(time_s, time_s[::2] + 2e-3, each[::2]) for each in force.T])
    assert found.force_N is not None
    np.testing.assert_allclose(found.force_N, logged[within], atol=1e-3)
