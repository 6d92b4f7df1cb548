"""A replay as a page without a browser steers it and hears of it."""

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from framing import Frame, frame
from talking import Message, PageClient, StartServer

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.readers import read
from keyphase.web.server import PageServer
from keyphase.workbench.replaying.session import ReplaySession

FAST = 4.0


@pytest.fixture
def setup1(tmp_path: Path, start_server: StartServer) -> PageServer:
    """A server on the recorded Setup 1, replays at four times real time."""
    return start_server(Path(shutil.copy(shipped("data") / "setup1.npz", tmp_path)))


@pytest.fixture
def replaying(setup1: PageServer) -> Iterator[PageClient]:
    """A page that has dropped the idle segments and begun a replay."""
    with PageClient(setup1) as page:
        page.wait_for("document")
        page.send("edit", edit={"kind": "drop_idle"})
        page.wait_for("document", lambda m: not m["proposed_drops"])
        page.send("replay", do="run", speed=FAST)
        page.wait_for("replay", lambda m: m["phase"] == "running")
        yield page


def _replay(server: PageServer) -> ReplaySession:
    (view,) = server.workbench.views
    return view.replay


def over(page: PageClient) -> Message:
    return page.wait_for("replay", lambda m: m["phase"] == "over")


def rows(page: PageClient) -> list[list[float]]:
    """All samples told so far."""
    told: list[list[float]] = []
    for message in page.heard:
        if message["type"] == "replay_samples":
            told[message["first"] :] = message["rows"]
    return told


def outcomes(message: Message) -> list[str | None]:
    return [skill["outcome"] for skill in message["skills"] if skill["segment"] is not None]


def test_a_replay_runs_to_success_and_says_how_each_skill_ended(replaying: PageClient) -> None:
    end = over(replaying)
    assert end["succeeded"]
    assert outcomes(end) == ["reached", "contact", "contact"]


def test_as_one_skill_ends_the_next_one_is_the_current(replaying: PageClient) -> None:
    ended = replaying.wait_for("replay", lambda m: m["skills"][0]["outcome"] is not None)
    assert ended["skills"][1]["outcome"] is None
    assert ended["current"] == 1


def test_every_sample_is_told_once_and_in_order(replaying: PageClient) -> None:
    end = over(replaying)
    times = np.array(rows(replaying))[:, 0]
    assert np.allclose(np.diff(times), 0.008)
    assert times[-1] == pytest.approx(end["time_s"], abs=0.01)


def test_stopped_it_is_over_and_its_skill_was_stopped(replaying: PageClient) -> None:
    replaying.wait_for("replay", lambda m: m["current"] == 1)
    replaying.send("replay", do="stop")
    end = over(replaying)
    assert "stopped" in outcomes(end)
    assert not end["succeeded"]


def test_paused_it_stands_still_until_it_goes_on(replaying: PageClient) -> None:
    replaying.send("replay", do="pause")
    paused = replaying.wait_for("replay", lambda m: m["phase"] == "paused")
    replaying.send("replay", do="run")
    goes_on = replaying.wait_for("replay", lambda m: m["phase"] == "running")
    assert goes_on["time_s"] == paused["time_s"]


def test_skill_by_skill_it_pauses_where_one_has_ended(replaying: PageClient) -> None:
    replaying.send("replay", do="pause")
    before = replaying.wait_for("replay", lambda m: m["phase"] == "paused")
    replaying.send("replay", do="next")
    after = replaying.wait_for(
        "replay", lambda m: m["phase"] == "paused" and m["time_s"] > before["time_s"]
    )
    ended = sum(skill["outcome"] is not None for skill in before["skills"])
    assert sum(skill["outcome"] is not None for skill in after["skills"]) == ended + 1


def test_held_it_waits_and_let_go_it_resumes_to_success(replaying: PageClient) -> None:
    replaying.wait_for("replay", lambda m: m["current"] == 1)
    replaying.send("replay", do="hold")
    replaying.wait_for("replay", lambda m: m["held"])
    held_mm = np.array(replaying.wait_for("replay_samples")["rows"][-1][1:4])
    later = [replaying.wait_for("replay_samples")["rows"][-1][1:4] for _ in range(10)]
    assert np.linalg.norm(np.array(later) - held_mm, axis=1).max() < 5.0
    replaying.send("replay", do="release")
    assert over(replaying)["succeeded"]


def test_pushed_it_leaves_the_path_and_comes_back(
    replaying: PageClient, setup1: PageServer
) -> None:
    replaying.wait_for("replay", lambda m: m["current"] == 1)
    replaying.send("replay", do="speed", speed=1.0)
    _replay(setup1).push(np.array([0.0, -40.0, 0.0]))
    replaying.wait_for("replay_samples", lambda m: m["rows"][-1][10] > 8.0)
    _replay(setup1).push(np.zeros(3))
    assert over(replaying)["succeeded"]


def test_a_page_that_comes_back_is_told_everything(
    replaying: PageClient, setup1: PageServer
) -> None:
    over(replaying)
    with PageClient(setup1, page=replaying.page) as back:
        told = back.wait_for("replay")
        samples = back.wait_for("replay_samples")
    assert told["phase"] == "over"
    assert samples["rows"] == rows(replaying)
    assert len(samples["demonstrated"]) == len(told["skills"])


def test_its_recording_joins_the_list_and_is_opened(replaying: PageClient, tmp_path: Path) -> None:
    over(replaying)
    replaying.send("replay", do="keep")
    opened = replaying.wait_for("document", lambda m: "_replay" in m["name"])
    assert opened["channels"] == ["position", "orientation", "force", "torque", "joints"]
    assert read(tmp_path / "setup1_replay_01.npz").metadata["operator"] == "replay"


def test_in_a_world_made_from_the_recording_its_path_is_drawn_without_a_robot(
    page: PageClient,
) -> None:
    with frame(page.server, page.page) as framed:
        assert framed.node("/robot").visible
        page.send("replay", do="run", speed=FAST)
        told = over(page)
        assert told["words"] == "in the world made from it"
        assert any(name.startswith("/replay/done/") for name in framed.nodes)
        assert not framed.node("/robot").visible
        recorded = read(page.server.workbench.recordings.recordings[0].path)
        assert framed.node("/grid/ground").position[2] < min(recorded.position_m[:, 2])
        _is_seen_in_its_own_size(framed, told, recorded)
        page.send("export", kind="page")
        assert Path(page.wait_for("saved")["path"]).stat().st_size > 100_000
        page.send("replay", do="keep")
        page.wait_for("document", lambda m: "_replay" in m["name"])
        assert framed.node("/robot").visible
        assert framed.scene.robot.base is None, "a ghost, since it did not run there"
    assert not [m for m in page.heard if m["type"] == "notice" and m["level"] == "error"]


def _is_seen_in_its_own_size(framed: Frame, told: Message, recorded: Demonstration) -> None:
    """Not in that of a workcell: the camera, and the largest arrow, are as of the recording."""
    size_m = float(np.linalg.norm(np.ptp(recorded.position_m, axis=0)))
    assert recorded.force_N is not None
    top_N = float(np.linalg.norm(recorded.force_N, axis=1).max())
    assert told["force_arrow"]["metres_per_N"] * top_N == pytest.approx(size_m / 3, rel=0.02)
    camera = framed.scene.client.camera
    away_m = float(np.linalg.norm(camera.position - camera.look_at))
    assert away_m < 2.5 * size_m


def test_closed_it_is_shown_no_more(replaying: PageClient) -> None:
    replaying.send("replay", do="leave")
    assert replaying.wait_for("replay_closed")


def test_an_empty_plan_is_refused_with_what_to_do(replaying: PageClient) -> None:
    replaying.send("edit", edit={"kind": "plan", "order": []})
    replaying.wait_for("document", lambda m: not m["plan"])
    replaying.send("replay", do="again")
    assert "keep a segment" in replaying.wait_for("notice")["text"]


@pytest.mark.parametrize("fields", [{"do": "dance"}, {"do": "run", "speed": 1e3}, {}])
def test_what_no_replay_can_do_is_refused(replaying: PageClient, fields: dict[str, Any]) -> None:
    replaying.send("replay", **fields)
    assert replaying.wait_for("refused")["request"] == "replay"


def test_who_may_only_look_cannot_replay(setup1: PageServer) -> None:
    with PageClient(setup1, setup1.access.looking_token) as page:
        page.wait_for("document")
        page.send("replay", do="run")
        assert "looking only" in page.wait_for("refused")["text"]
    assert all(view.replay.running is None for view in setup1.workbench.views)
