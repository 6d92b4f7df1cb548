"""Forward kinematics and Jacobian of one arm."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from keyphase.errors import RobotError

STEP = 1e-6


@settings(max_examples=30)
@given(shares=st.lists(st.floats(0.01, 0.99), min_size=7, max_size=7))
def test_the_jacobian_is_what_small_steps_of_the_joints_do(robot, arm, shares):
    joints = robot.lower_rad + np.array(shares) * (robot.upper_rad - robot.lower_rad)
    jacobian = arm.jacobian(joints)

    assert jacobian.shape == (6, 7)
    for number, step in enumerate(np.eye(7) * STEP):
        before, after = arm.forward(joints - step), arm.forward(joints + step)
        moved = (after[:3, 3] - before[:3, 3]) / (2 * STEP)
        turned = Rotation.from_matrix(after[:3, :3] @ before[:3, :3].T).as_rotvec() / (2 * STEP)
        assert jacobian[:, number] == pytest.approx(np.concatenate([moved, turned]), abs=1e-6)


def test_forward_gives_a_copy(robot, arm):
    first = arm.forward(robot.start_rad)
    before = first.copy()
    arm.forward(robot.start_rad + 0.3)

    assert first == pytest.approx(before, abs=0)


def test_a_wrong_number_of_joints_is_refused(arm):
    with pytest.raises(RobotError, match=r"expected 7 joint values \(yumi_joint_1_r"):
        arm.forward([0.0] * 14)
