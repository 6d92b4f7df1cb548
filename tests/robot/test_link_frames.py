"""Frames of all links from joint values, for display."""

import numpy as np
import pytest

from keyphase.errors import RobotError
from keyphase.robot.link_frames import link_frames


def test_the_tool_frame_is_where_the_arm_says(robot, arm):
    joints = robot.start_rad + 0.1
    frames = link_frames(robot, joints)

    assert list(frames) == list(robot.links)
    assert frames["tcp_r"] == pytest.approx(arm.forward(joints))
    assert frames[robot.root] == pytest.approx(np.eye(4))


def test_without_values_the_robot_is_at_its_start_and_rest(robot):
    frames = link_frames(robot)

    assert frames["tcp_r"] == pytest.approx(link_frames(robot, robot.start_rad)["tcp_r"])
    assert frames["tcp_l"][0, 3] < frames["tcp_r"][0, 3]


def test_other_joints_can_be_moved_by_name(robot):
    opened = link_frames(robot, others={"gripper_r_joint": 0.025})
    closed = link_frames(robot, others={"gripper_r_joint": 0.0})

    for finger in ("gripper_r_finger_r", "gripper_r_finger_l"):
        moved = np.linalg.norm(opened[finger][:3, 3] - closed[finger][:3, 3])
        assert moved == pytest.approx(0.025)


def test_frames_are_copies(robot):
    first = link_frames(robot)
    before = first["tcp_r"].copy()
    link_frames(robot, robot.start_rad + 0.2)

    assert first["tcp_r"] == pytest.approx(before, abs=0)


def test_an_unknown_joint_is_refused(robot):
    with pytest.raises(RobotError, match="'elbow' came; choose one of yumi_joint_1_r"):
        link_frames(robot, others={"elbow": 1.0})


def test_a_joint_that_mimics_cannot_be_moved(robot):
    with pytest.raises(RobotError, match="gripper_r_joint_m"):
        link_frames(robot, others={"gripper_r_joint_m": 0.01})


def test_a_wrong_number_of_joints_is_refused(robot):
    with pytest.raises(RobotError, match="expected 7 joint values"):
        link_frames(robot, [0.0] * 6)
