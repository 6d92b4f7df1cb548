"""The robot in the scene: it follows the playhead, or says where it cannot."""

import shutil
import threading
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from framing import Frame, frame
from talking import PageClient, StartServer

from keyphase.demonstration import Demonstration
from keyphase.errors import RobotError
from keyphase.files.shipped import shipped
from keyphase.readers import read, save_npz
from keyphase.robot.arms import robot_arms
from keyphase.robot.link_frames import link_frames
from keyphase.robot.pose import Placement, matrix
from keyphase.robot.yumi import yumi
from keyphase.web.scene.page_robot import PageRobot
from keyphase.workbench.placing.placements import save_placement, saved_placement
from keyphase.workbench.view import View

WAIT_S = 60.0

Opened = Callable[[Path], tuple[Frame, PageClient]]


@pytest.fixture
def recorded(tmp_path: Path) -> Path:
    return Path(shutil.copy(shipped("data") / "setup1.npz", tmp_path))


@pytest.fixture
def opened(start_server: StartServer) -> Iterator[Opened]:
    """Opens a recording in a page with a frame; the robot is worked out on return."""
    with ExitStack() as stack:

        def open_one(path: Path) -> tuple[Frame, PageClient]:
            server = start_server(path)
            client = PageClient(server)
            client.wait_for("document")
            framed = stack.enter_context(frame(server, client.page))
            framed.settle()
            return framed, client

        yield open_one


def view_of(framed: Frame) -> View:
    return framed.server.workbench.find_view(framed.page)


def notices(framed: Frame, client: PageClient) -> list[str]:
    """What was said up to now."""
    view_of(framed).telling.notice("info", "that was all")
    client.wait_for("notice", lambda notice: notice["text"] == "that was all")
    return [message["text"] for message in client.heard if message["type"] == "notice"][:-1]


def moved(path: Path, to: Path, offset_m: tuple[float, float, float]) -> Demonstration:
    """The recording made elsewhere in space, without joints."""
    demonstration = read(path)
    elsewhere = replace(
        demonstration, position_m=demonstration.position_m + offset_m, joints_rad=None, source=None
    )
    save_npz(elsewhere, to)
    return elsewhere


def link(framed: Frame, name: str) -> np.ndarray:
    """Where a link is drawn, in the robot's base frame."""
    links = framed.scene.robot.figure._links
    chain = links[name].name.split("/")[2:]
    pose = np.eye(4)
    for each in chain:
        pose = pose @ matrix(links[each].position, links[each].wxyz)
    return pose[:3, 3]


def test_the_hand_is_where_the_recorded_joints_put_it(recorded: Path, opened: Opened) -> None:
    framed, _ = opened(recorded)
    demonstration = read(recorded)
    for share in (0.0, 0.4, 0.9):
        row = round(share * (len(demonstration) - 1))
        time_s = float(demonstration.time_s[row])
        view_of(framed).move_playhead(lambda head, time_s=time_s: head.at(time_s))
        framed.settle()
        assert demonstration.joints_rad is not None
        expected = link_frames(yumi("r"), demonstration.joints_rad[row])["gripper_r_base"][:3, 3]
        assert link(framed, "gripper_r_base") == pytest.approx(expected, abs=1e-5)
    assert framed.scene.robot.figure.visible


def test_a_recording_without_joints_is_followed_too(tmp_path: Path, opened: Opened) -> None:
    framed, client = opened(Path(shutil.copy(shipped("data") / "synthetic_setup1.npz", tmp_path)))
    assert framed.scene.robot.figure.visible
    assert not [text for text in notices(framed, client) if "robot" in text]


def test_beside_a_recording_that_is_not_its_own_the_robot_is_a_ghost(
    recorded: Path, tmp_path: Path, opened: Opened, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It is one before its joints are known, so that it is never seen otherwise."""
    work_out, looks = PageRobot._work_out, []
    monkeypatch.setattr(
        PageRobot,
        "_work_out",
        lambda robot, task: (looks.append(robot.figure._look), work_out(robot, task)),
    )
    demonstration = replace(read(recorded), joints_rad=None, source=None, metadata={})
    save_npz(demonstration, tmp_path / "hand.npz")
    framed, _ = opened(tmp_path / "hand.npz")

    mesh, _ = framed.scene.robot.figure._meshes[0]
    assert framed.scene.robot.figure.visible
    assert looks[0] == "ghost"
    assert mesh.opacity is not None
    assert mesh.opacity < 0.2
    assert framed.scene.robot.base is None
    assert "/stand" not in framed.nodes


def test_the_robot_can_be_hidden(recorded: Path, opened: Opened) -> None:
    framed, _ = opened(recorded)
    view_of(framed).scene.show("robot", False)
    framed.settle()
    assert not framed.scene.robot.figure.visible
    assert framed.scene.robot.base is None


def test_what_is_drawn_anew_as_the_robot_comes_or_goes_is_as_it_was_last(
    recorded: Path, opened: Opened
) -> None:
    """The path, its colours and the tool, seen from elsewhere."""
    framed, client = opened(recorded)
    framed.settle()
    document = next(m for m in client.heard if m["type"] == "document")
    client.send("edit", edit={"kind": "merge", "from_s": 0.01, "to_s": document["end_s"] - 0.01})
    client.wait_for("document", lambda m: len(m["segments"]) == 1)
    client.send("in_view", recording=document["id"], from_s=1.0, to_s=2.0)
    client.send("seek", time_s=1.5)
    client.wait_for("playhead", lambda m: m["time_s"] == 1.5)
    before = framed.node("/path/pieces")
    view_of(framed).scene.show("robot", False)

    after, tool = framed.node("/path/pieces"), framed.node("/frame/tool")
    demonstration = read(recorded)
    assert after is not before
    drawn, was = (np.ptp(one.batched_positions, axis=0) for one in (after, before))
    assert drawn == pytest.approx(was, abs=0.005)
    assert np.linalg.norm(drawn) < 0.2 * np.linalg.norm(np.ptp(demonstration.position_m, axis=0))
    assert len(np.unique(after.batched_colors, axis=0)) == 1
    index = demonstration.index_at(1.5)
    assert tool.position == pytest.approx(demonstration.position_m[index])


def test_the_robot_goes_to_recordings_out_of_its_reach(
    recorded: Path, tmp_path: Path, opened: Opened
) -> None:
    moved(recorded, tmp_path / "far.npz", (10.0, 0.0, 0.0))
    framed, client = opened(tmp_path / "far.npz")
    assert framed.scene.robot.figure.visible
    base = framed.scene.robot.base
    assert base is not None
    assert 9.0 < base.position_m[0] < 11.0
    assert any("out of the robot's reach" in text for text in notices(framed, client))


def test_where_a_person_puts_the_robot_is_kept(
    recorded: Path, tmp_path: Path, opened: Opened
) -> None:
    elsewhere = tmp_path / "far.npz"
    moved(recorded, elsewhere, (10.0, 0.0, 0.0))
    framed, _ = opened(elsewhere)
    chosen = Placement((10.02, 0.01, 0.0))
    framed.scene.put_robot(chosen)
    framed.settle()
    framed.server.stop()
    again, _ = opened(elsewhere)
    base = again.scene.robot.base
    assert base is not None
    assert base.position_m == pytest.approx(chosen.position_m)
    again.scene.place_robot()
    again.settle()
    assert saved_placement(elsewhere, "yumi") is None


def test_what_is_out_of_reach_is_said_with_time_and_distance(
    recorded: Path, opened: Opened
) -> None:
    save_placement(recorded, yumi("r").name, Placement((0.35, 0.0, 0.0)))
    framed, client = opened(recorded)
    (said,) = [text for text in notices(framed, client) if "cannot follow" in text]
    assert " s (" in said
    assert "mm away" in said
    path = framed.scene.robot._path
    assert path is not None
    missed = float(path.time_s[np.argmin(path.reached)])
    view_of(framed).move_playhead(lambda head: head.at(missed))
    framed.settle()
    mesh, _ = framed.scene.robot.figure._meshes[0]
    assert mesh.opacity is not None


def test_the_other_arm_can_follow(recorded: Path, opened: Opened) -> None:
    framed, _ = opened(recorded)
    right = link(framed, "gripper_r_base")
    view_of(framed).scene.choose_robot(arm="tcp_l")
    framed.settle()
    assert np.linalg.norm(link(framed, "gripper_r_base") - right) > 0.1


def test_working_out_the_joints_gives_way_to_what_is_asked_for(
    tmp_path: Path, start_server: StartServer
) -> None:
    server = start_server()
    busy, asked = threading.Event(), threading.Event()
    busy.set()

    def gives_way() -> bool:
        asked.set()
        return busy.is_set()

    server.shared.paths.gives_way = gives_way
    with PageClient(server) as client, frame(server, client.page) as framed:
        view_of(framed).add(Path(shutil.copy(shipped("data") / "synthetic_setup1.npz", tmp_path)))
        assert asked.wait(WAIT_S)
        assert not server.shared.wait_until_idle(0.0)
        busy.clear()
        framed.settle()
        assert framed.scene.robot._path is not None


def test_what_is_being_worked_out_is_given_up_as_the_server_stops(
    tmp_path: Path, start_server: StartServer
) -> None:
    server = start_server()
    begun = threading.Event()

    def gives_way() -> bool:
        begun.set()
        return True

    server.shared.paths.gives_way = gives_way
    with frame(server) as framed:
        view_of(framed).add(Path(shutil.copy(shipped("data") / "synthetic_setup1.npz", tmp_path)))
        assert begun.wait(WAIT_S)
        server.stop()
    assert server.shared.wait_until_idle(0.0)


def test_a_robot_needs_both_its_file_and_its_tool() -> None:
    urdf = shipped("static_robots") / "yumi" / "yumi.urdf"
    with pytest.raises(RobotError, match="name it with --tool-frame"):
        robot_arms(urdf, None)
    with pytest.raises(RobotError, match="name the robot's URDF with --robot"):
        robot_arms(None, "tcp_r")
    with pytest.raises(RobotError, match="it has none named 'hand'"):
        robot_arms(urdf, "hand")
    (left,) = robot_arms(urdf, "tcp_l")
    assert left.tool_frame == "tcp_l"
