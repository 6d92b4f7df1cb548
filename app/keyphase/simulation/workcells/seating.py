# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Whether the held part sits on its housing."""

import mujoco
import numpy as np

from keyphase.simulation.simulation import Simulation
from keyphase.simulation.workcells.parts import HOUSING_M

SEATED_WITHIN_M = 0.001


def seat_gap_m(simulation: Simulation) -> float:
    """How far the held part's mating face is above the housing's top, along its axis [m]."""
    poses = simulation.part_poses()
    housing, orientation = poses["housing"]
    up = np.empty(3)
    mujoco.mju_rotVecQuat(up, np.array([0.0, 0.0, 1.0]), orientation)
    return float((poses["held"][0] - housing) @ up) - HOUSING_M[2]
