# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Cartesian impedance control of the right arm: the one controller of keyphase.

Lead-through, recording and replay differ only in where the reference comes from.
"""

from dataclasses import dataclass, field
from math import sqrt

import mujoco
import numpy as np
from numpy.typing import NDArray
from scipy.linalg.lapack import dgesv

from keyphase.demonstration import Array
from keyphase.errors import SimulationError

RATE_HZ = 250.0
"""Control and recording rate."""


@dataclass(frozen=True)
class Gains:
    """Stiffness and damping of the tool point, and the posture held in the null space.

    The defaults are soft enough to meet a hard part at 40 mm/s with a few newtons and not to jam
    at a friction of 0.8.
    """

    stiffness_N_m: float = 2000.0
    damping_Ns_m: float = 180.0
    rotational_stiffness_Nm_rad: float = 40.0
    rotational_damping_Nms_rad: float = 3.0
    posture_stiffness_Nm_rad: float = 30.0
    posture_damping_Nms_rad: float = 4.0
    greatest_force_N: float = 30.0
    greatest_torque_Nm: float = 6.0
    limit_margin_rad: float = 0.1
    limit_stiffness_Nm_rad: float = 300.0


@dataclass(frozen=True, eq=False)
class Reference:
    """Where the tool is wanted, in the robot's base frame.

    position_m (3,), orientation_wxyz (4,), velocity_m_s (3,), angular_velocity_rad_s (3,)
    """

    position_m: Array
    orientation_wxyz: Array
    velocity_m_s: Array = field(default_factory=lambda: np.zeros(3))
    angular_velocity_rad_s: Array = field(default_factory=lambda: np.zeros(3))


class CartesianImpedance:
    """Joint torques that make the tool point behave as a spring and damper towards a reference.

    tau = J^T (K (x_r - x) + D (xdot_r - xdot)) + N^T tau_posture + h(q, qdot) + tau_limit, with N
    the dynamically consistent null space of J (Khatib 1987) and h gravity and Coriolis, the held
    load included. Spring and posture are bounded, so that a far reference pulls, never throws.
    """

    def __init__(self, model: mujoco.MjModel, tool: int, joints: Array, gains: Gains) -> None:
        """`tool` is the site that is controlled, `joints` the ids of the driven joints.

        Raises SimulationError for joints that are not those of one chain.
        """
        self.gains = gains
        self._model, self._tool = model, tool
        self._positions, self._dofs = (
            _run(model.jnt_qposadr[joints]),
            _run(model.jnt_dofadr[joints]),
        )
        low, high = model.jnt_range[joints].T
        self._low, self._high = low + gains.limit_margin_rad, high - gains.limit_margin_rad
        self._stiffness = np.repeat((gains.stiffness_N_m, gains.rotational_stiffness_Nm_rad), 3)
        self._damping = np.repeat((gains.damping_Ns_m, gains.rotational_damping_Nms_rad), 3)
        self._spring = np.zeros(6)
        self._jacobian = np.zeros((6, model.nv))
        self._moving, self._turning = self._jacobian[:3], self._jacobian[3:]
        self._inverse = np.zeros((6, model.nv))
        self._of_the_arm = self._jacobian[:, self._dofs], self._inverse[:, self._dofs]

    def torques(self, data: mujoco.MjData, reference: Reference, posture: Array) -> Array:
        """Torques of the driven joints [N m], (J,), towards `reference`, near `posture`."""
        self._see(data)
        twist = self._of_the_arm[0].dot(data.qvel[self._dofs])
        return self._joined(data, self._wrench(data, reference, twist), posture)

    def torques_of(self, data: mujoco.MjData, wrench: Array, posture: Array) -> Array:
        """Torques (J,) that exert a wrench (6,) at the tool, force first, near `posture`."""
        self._see(data)
        return self._joined(data, wrench, posture)

    def _see(self, data: mujoco.MjData) -> None:
        mujoco.mj_jacSite(self._model, data, self._moving, self._turning, self._tool)
        mujoco.mj_solveM(self._model, data, self._inverse, self._jacobian)

    def _joined(self, data: mujoco.MjData, wrench: Array, posture: Array) -> Array:
        gains, dofs = self.gains, self._dofs
        q, qd = data.qpos[self._positions], data.qvel[dofs]
        jacobian, inverse = self._of_the_arm
        free = gains.posture_stiffness_Nm_rad * (posture - q) - gains.posture_damping_Nms_rad * qd
        # What `np.linalg.solve` calls, without the four times longer way to it.
        _, _, seen, _ = dgesv(inverse.dot(jacobian.T), inverse.dot(free))
        wrench -= seen
        free += jacobian.T.dot(wrench)
        free += data.qfrc_bias[dofs]
        self._keep_within_limits(free, q, qd)
        return free

    def _wrench(self, data: mujoco.MjData, reference: Reference, twist: Array) -> Array:
        """Spring and damper (6,) towards `reference` for a tool that moves with `twist` (6,)."""
        spring, rotation = self._spring, data.site_xmat[self._tool]
        np.subtract(reference.position_m, data.site_xpos[self._tool], spring[:3])
        spring[3:] = rotation_towards(rotation, reference.orientation_wxyz)
        spring *= self._stiffness
        _bound(spring[:3], self.gains.greatest_force_N)
        _bound(spring[3:], self.gains.greatest_torque_Nm)
        wrench = np.negative(twist, twist)
        wrench[:3] += reference.velocity_m_s
        wrench[3:] += reference.angular_velocity_rad_s
        wrench *= self._damping
        wrench += spring
        return wrench

    def _keep_within_limits(self, torques: Array, q: Array, qd: Array) -> None:
        back = np.minimum(np.maximum(q, self._low), self._high) - q
        if np.count_nonzero(back):
            torques += self.gains.limit_stiffness_Nm_rad * back - 5.0 * qd * (back != 0.0)


def rotation_towards(rotation: Array, wxyz: Array) -> Array:
    """Rotation vector, base frame, that turns the row-major matrix (9,) into the quaternion."""
    now, local, turned = np.empty(4), np.empty(3), np.empty(3)
    mujoco.mju_mat2Quat(now, rotation)
    mujoco.mju_subQuat(local, wxyz, now)
    mujoco.mju_mulMatVec3(turned, rotation, local)
    return turned


def _run(addresses: NDArray[np.int32]) -> slice:
    """The addresses as a slice, which gives views where the array would give copies."""
    first, last = int(addresses[0]), int(addresses[-1])
    if not np.array_equal(addresses, np.arange(first, last + 1)):
        raise SimulationError(
            "The driven joints must lie side by side in the model, as those of one chain do, but "
            f"have the addresses {addresses.tolist()}; drive all joints of one arm."
        )
    return slice(first, last + 1)


def _bound(vector: Array, greatest: float) -> None:
    norm = sqrt(vector.dot(vector))
    if norm > greatest:
        vector *= greatest / norm
