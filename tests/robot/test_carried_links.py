"""Links as seen from the links that carry them."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from keyphase.robot.carried_links import CarriedLinks
from keyphase.robot.link_frames import link_frames


def frame(pose):
    """The frame (4, 4) of a position and orientation wxyz (7,)."""
    placed = np.eye(4)
    placed[:3, 3] = pose[:3]
    placed[:3, :3] = Rotation.from_quat(pose[3:], scalar_first=True).as_matrix()
    return placed


def test_carried_one_by_another_they_are_where_forward_kinematics_has_them(robot):
    carriers = {
        "yumi_link_3_r": "",
        "yumi_link_5_r": "yumi_link_3_r",
        "tcp_r": "yumi_link_5_r",
        "tcp_l": "",
    }
    carried = CarriedLinks(robot, carriers)
    for joints in (robot.start_rad, robot.start_rad + 0.2):
        wanted = link_frames(robot, joints)
        poses = [frame(pose) for pose in carried.poses(joints)]
        placed = [poses[0], poses[0] @ poses[1], poses[0] @ poses[1] @ poses[2], poses[3]]
        for link, found in zip(carriers, placed, strict=True):
            assert found == pytest.approx(wanted[link], abs=1e-9)


def test_a_link_that_only_turns_on_its_carrier_keeps_its_place_there(robot):
    carried = CarriedLinks(robot, {"yumi_link_1_r": "", "yumi_link_2_r": "yumi_link_1_r"})
    before, after = carried.poses(robot.start_rad), carried.poses(robot.start_rad + 0.3)
    assert after[1, :3] == pytest.approx(before[1, :3], abs=1e-12)
    assert np.abs(after[1, 3:] - before[1, 3:]).max() > 0.05


def test_links_that_no_driven_joint_moves_stay(robot):
    for carriers in ({}, {"yumi_base_link": "", "tcp_l": ""}):
        carried = CarriedLinks(robot, carriers)
        before, after = carried.poses(robot.start_rad), carried.poses(robot.start_rad + 0.3)
        assert before.shape == (len(carriers), 7)
        assert np.array_equal(before, after)
