"""Inverse kinematics of one pose."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from keyphase.robot.arm import Arm
from keyphase.robot.description import load_description
from keyphase.robot.inverse import inverse
from keyphase.robot.pose import TOOL_DOWN_WXYZ, matrix


@given(shares=st.lists(st.floats(0, 1), min_size=7, max_size=7))
def test_every_pose_the_arm_can_take_is_found_within_two_micrometres(robot, arm, shares):
    joints = robot.lower_rad + np.array(shares) * (robot.upper_rad - robot.lower_rad)
    target = arm.forward(joints)

    solution = inverse(arm, target)

    assert solution.reached
    reached = arm.forward(solution.joints_rad)
    assert np.linalg.norm(reached[:3, 3] - target[:3, 3]) <= 2e-6
    assert reached[:3, :3] == pytest.approx(target[:3, :3], abs=2e-5)


@settings(max_examples=15)
@given(position=st.tuples(st.floats(-1, 1.5), st.floats(-1.5, 1), st.floats(-0.5, 1.5)))
def test_limits_hold_wherever_the_target_is(robot, arm, position):
    solution = inverse(arm, matrix(position, TOOL_DOWN_WXYZ))

    assert (solution.joints_rad >= robot.lower_rad).all()
    assert (solution.joints_rad <= robot.upper_rad).all()


def test_a_target_out_of_reach_gives_the_nearest_pose_and_its_distance(arm):
    target = matrix((2.0, -0.2, 0.3), TOOL_DOWN_WXYZ)
    solution = inverse(arm, target)

    assert not solution.reached
    tool = arm.forward(solution.joints_rad)
    assert solution.distance_m == pytest.approx(np.linalg.norm(tool[:3, 3] - target[:3, 3]))
    assert 1.0 < solution.distance_m < 1.5
    assert tool[0, 3] > 0.5


def test_a_start_near_the_target_gives_the_posture_near_it(robot, arm):
    joints = robot.start_rad + np.array([0.3, -0.2, 0.2, 0.2, 0.3, -0.2, 0.4])
    solution = inverse(arm, arm.forward(joints), start_rad=joints + 0.01)

    assert np.abs(solution.joints_rad - joints).max() < 0.05


def test_the_same_seed_gives_the_same_joints(arm):
    target = matrix((0.1, -0.5, 0.5), TOOL_DOWN_WXYZ)

    first, again = inverse(arm, target, seed=3), inverse(arm, target, seed=3)

    assert first.joints_rad.tobytes() == again.joints_rad.tobytes()


def test_an_arm_of_one_joint_reaches_what_it_can(urdf):
    arm = Arm(load_description(urdf(), "tool"))

    assert inverse(arm, arm.forward([1.7])).joints_rad == pytest.approx([1.7], abs=1e-4)
    behind = inverse(arm, matrix((0, 0, 1), (np.cos(-0.75), 0, np.sin(-0.75), 0)))
    assert behind.joints_rad == pytest.approx([-1])
    assert behind.angle_rad == pytest.approx(0.5)
