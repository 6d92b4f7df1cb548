"""The joints that were recorded, where they are those of the arm that is shown."""

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.robot.arm import Arm
from keyphase.robot.follow import JointPath, tool_poses

SAME_PLACE_M = 1e-3
"""Recorded joints whose tool point is no further than this from the recorded position are ours."""

_COMPARED = 50


def recorded_path(arm: Arm, demonstration: Demonstration) -> JointPath | None:
    """The recorded joints, taken as they are; None where they are not this arm's.

    They are its own if there are as many and if, at samples all along the recording, they put the
    tool point where it was recorded.
    """
    joints = demonstration.joints_rad
    if joints is None or joints.shape[1] != len(arm.robot.joint_names):
        return None
    rows = np.unique(np.linspace(0, len(demonstration) - 1, _COMPARED).astype(int))
    recorded = tool_poses(demonstration)[rows, :3, 3]
    reached = np.array([arm.forward(joints[row])[:3, 3] for row in rows])
    if np.linalg.norm(reached - recorded, axis=1).max() > SAME_PLACE_M:
        return None
    nothing = np.zeros(len(demonstration))
    return JointPath(demonstration.time_s, joints, nothing, nothing)
