"""The robot in the scene: it follows the playhead, or says where it cannot."""

import shutil
import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from talking import PageClient, StartServer, scene_of

from keyphase.demonstration import Demonstration
from keyphase.errors import RobotError
from keyphase.files.shipped import shipped
from keyphase.readers import read, save_npz
from keyphase.robot.arms import robot_arms
from keyphase.robot.link_frames import link_frames
from keyphase.robot.pose import Placement, matrix
from keyphase.robot.yumi import yumi
from keyphase.web.server import PageServer
from keyphase.workbench.placing.placements import save_placement, saved_placement

WAIT_S = 60.0

Opened = Callable[[Path], tuple[PageServer, PageClient]]


@pytest.fixture
def recorded(tmp_path: Path) -> Path:
    return Path(shutil.copy(shipped("data") / "setup1.npz", tmp_path))


@pytest.fixture
def opened(start_server: StartServer) -> Opened:
    """Opens a recording; the robot is worked out on return."""

    def open_one(path: Path) -> tuple[PageServer, PageClient]:
        server = start_server(path)
        client = PageClient(server)
        client.wait_for("document")
        settle(server)
        return server, client

    return open_one


def settle(server: PageServer) -> None:
    scene = scene_of(server)
    assert scene.wait_until_shown(WAIT_S)
    assert scene.robot.wait_until_idle(WAIT_S)
    assert scene.wait_until_shown(WAIT_S)


def notices(server: PageServer, client: PageClient) -> list[str]:
    """What was said up to now."""
    scene_of(server).view.telling.notice("info", "that was all")
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


def link(server: PageServer, name: str) -> np.ndarray:
    """Where a link is drawn, in the robot's base frame."""
    links = scene_of(server).robot.figure._links
    chain = links[name].name.split("/")[2:]
    pose = np.eye(4)
    for each in chain:
        pose = pose @ matrix(links[each].position, links[each].wxyz)
    return pose[:3, 3]


def test_the_hand_is_where_the_recorded_joints_put_it(recorded: Path, opened: Opened) -> None:
    server, _ = opened(recorded)
    demonstration = read(recorded)
    for share in (0.0, 0.4, 0.9):
        row = round(share * (len(demonstration) - 1))
        time_s = float(demonstration.time_s[row])
        scene_of(server).view.move_playhead(lambda head, time_s=time_s: head.at(time_s))
        settle(server)
        assert demonstration.joints_rad is not None
        expected = link_frames(yumi("r"), demonstration.joints_rad[row])["gripper_r_base"][:3, 3]
        assert link(server, "gripper_r_base") == pytest.approx(expected, abs=1e-5)
    assert scene_of(server).robot.figure.visible


def test_a_recording_without_joints_is_followed_too(tmp_path: Path, opened: Opened) -> None:
    server, client = opened(Path(shutil.copy(shipped("data") / "synthetic_setup1.npz", tmp_path)))
    assert scene_of(server).robot.figure.visible
    assert scene_of(server).robot.base == Placement()
    assert not [text for text in notices(server, client) if "robot" in text]


def test_the_robot_can_be_hidden(recorded: Path, opened: Opened) -> None:
    server, _ = opened(recorded)
    scene_of(server).view.scene.show("robot", False)
    settle(server)
    assert not scene_of(server).robot.figure.visible
    assert scene_of(server).robot.base is None


def test_the_robot_goes_to_recordings_out_of_its_reach(
    recorded: Path, tmp_path: Path, opened: Opened
) -> None:
    moved(recorded, tmp_path / "far.npz", (10.0, 0.0, 0.0))
    server, client = opened(tmp_path / "far.npz")
    assert scene_of(server).robot.figure.visible
    base = scene_of(server).robot.base
    assert base is not None
    assert 9.0 < base.position_m[0] < 11.0
    assert any("out of the robot's reach" in text for text in notices(server, client))


def test_where_a_person_puts_the_robot_is_kept(
    recorded: Path, tmp_path: Path, opened: Opened
) -> None:
    elsewhere = tmp_path / "far.npz"
    moved(recorded, elsewhere, (10.0, 0.0, 0.0))
    server, _ = opened(elsewhere)
    chosen = Placement((10.02, 0.01, 0.0))
    scene_of(server).robot.place(chosen)
    settle(server)
    server.stop()
    again, _ = opened(elsewhere)
    base = scene_of(again).robot.base
    assert base is not None
    assert base.position_m == pytest.approx(chosen.position_m)
    scene_of(again).robot.place_automatically()
    settle(again)
    assert saved_placement(elsewhere, "yumi") is None


def test_what_is_out_of_reach_is_said_with_time_and_distance(
    recorded: Path, opened: Opened
) -> None:
    save_placement(recorded, yumi("r").name, Placement((0.35, 0.0, 0.0)))
    server, client = opened(recorded)
    (said,) = [text for text in notices(server, client) if "cannot follow" in text]
    assert " s (" in said
    assert "mm away" in said
    path = scene_of(server).robot._path
    assert path is not None
    missed = float(path.time_s[np.argmin(path.reached)])
    scene_of(server).view.move_playhead(lambda head: head.at(missed))
    settle(server)
    mesh, _ = scene_of(server).robot.figure._meshes[0]
    assert mesh.opacity is not None


def test_the_other_arm_can_follow(recorded: Path, opened: Opened) -> None:
    server, _ = opened(recorded)
    right = link(server, "gripper_r_base")
    scene_of(server).robot.use_arm(1)
    settle(server)
    assert np.linalg.norm(link(server, "gripper_r_base") - right) > 0.1


def test_working_out_the_joints_gives_way_to_what_is_asked_for(
    tmp_path: Path, start_server: StartServer
) -> None:
    server = start_server()
    busy, asked = threading.Event(), threading.Event()
    busy.set()

    def gives_way() -> bool:
        asked.set()
        return busy.is_set()

    with PageClient(server) as page:
        page.send("seek", time_s=0.0)
        page.wait_for("playhead")
        scene_of(server).robot.paths.gives_way = gives_way
        scene_of(server).view.add(
            Path(shutil.copy(shipped("data") / "synthetic_setup1.npz", tmp_path))
        )
        assert asked.wait(WAIT_S)
        assert not scene_of(server).robot.wait_until_idle(0.0)
        assert scene_of(server).robot._path is None
        busy.clear()
        settle(server)
        assert scene_of(server).robot._path is not None


def test_what_is_being_worked_out_is_given_up_as_the_server_stops(
    tmp_path: Path, start_server: StartServer
) -> None:
    server = start_server()
    begun = threading.Event()

    def gives_way() -> bool:
        begun.set()
        return True

    with PageClient(server) as page:
        page.send("seek", time_s=0.0)
        page.wait_for("playhead")
        scene_of(server).robot.paths.gives_way = gives_way
        recording = shutil.copy(shipped("data") / "synthetic_setup1.npz", tmp_path)
        scene_of(server).view.add(Path(recording))
        assert begun.wait(WAIT_S)
        server.stop()
    assert scene_of(server).robot._path is None


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
