# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""A free tool body on keyphase's Cartesian impedance, without a robot."""

from dataclasses import dataclass
from math import sqrt

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.simulation.impedance import Gains, Reference, rotation_towards

MASS_KG, INERTIA_KG_M2 = 2.0, 0.03
"""Of the tool, as an arm's end feels; its inertia is that of a ball."""


@dataclass(eq=False)
class ToolBody:
    """Where the tool is and how it moves, base frame; gravity is compensated.

    position_m (3,), orientation_wxyz (4,), velocity_m_s (3,), angular_velocity_rad_s (3,)
    """

    position_m: Array
    orientation_wxyz: Array
    velocity_m_s: Array
    angular_velocity_rad_s: Array

    @property
    def joints_rad(self) -> Array:
        """(0,) It has no joints."""
        return np.zeros(0)

    def pull(self, reference: Reference, gains: Gains) -> tuple[Array, Array]:
        """Force and torque (3,) of the impedance towards `reference`."""
        spring = gains.stiffness_N_m * (reference.position_m - self.position_m)
        force = _bounded(spring, gains.greatest_force_N) + gains.damping_Ns_m * (
            reference.velocity_m_s - self.velocity_m_s
        )
        matrix = np.empty(9)
        mujoco.mju_quat2Mat(matrix, self.orientation_wxyz)
        turn = gains.rotational_stiffness_Nm_rad * rotation_towards(
            matrix, reference.orientation_wxyz
        )
        torque = _bounded(turn, gains.greatest_torque_Nm) + gains.rotational_damping_Nms_rad * (
            reference.angular_velocity_rad_s - self.angular_velocity_rad_s
        )
        return force, torque

    def advance(self, force: Array, torque: Array, h: float) -> None:
        """Move on by `h` seconds under a force and torque (3,); velocity first, then pose."""
        self.velocity_m_s = self.velocity_m_s + (h / MASS_KG) * force
        self.angular_velocity_rad_s = self.angular_velocity_rad_s + (h / INERTIA_KG_M2) * torque
        self.position_m = self.position_m + h * self.velocity_m_s
        turned = self.orientation_wxyz.copy()
        # MuJoCo integrates with the velocity in the body's own frame.
        local, back = np.empty(3), np.empty(4)
        mujoco.mju_negQuat(back, turned)
        mujoco.mju_rotVecQuat(local, self.angular_velocity_rad_s, back)
        mujoco.mju_quatIntegrate(turned, local, h)
        self.orientation_wxyz = turned


def _bounded(vector: Array, greatest: float) -> Array:
    norm = sqrt(vector.dot(vector))
    return vector * (greatest / norm) if norm > greatest else vector
