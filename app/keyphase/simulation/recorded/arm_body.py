# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""The tool of an arm, with the face of a free tool body."""

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.simulation.impedance import CartesianImpedance, Gains
from keyphase.simulation.recorded.body import ToolBody
from keyphase.simulation.recorded.robot_arm import TOOL_SITE, RobotArm

_SITE = int(mujoco.mjtObj.mjOBJ_SITE)


class ArmBody(ToolBody):
    """A tool that is moved by an arm's joints: what pulls it acts through them."""

    def __init__(self, arm: RobotArm, gains: Gains) -> None:
        """The arm at its start, at rest."""
        self._model = arm.model
        self._data = mujoco.MjData(self._model)
        self._tool = self._model.site(TOOL_SITE).id
        self._posture = arm.start_rad
        joints = np.array([self._model.joint(name).id for name in arm.joints])
        self._control = CartesianImpedance(self._model, self._tool, joints, gains)
        self._data.qpos[:] = arm.start_rad
        mujoco.mj_forward(self._model, self._data)
        super().__init__(np.zeros(3), np.zeros(4), np.zeros(3), np.zeros(3))
        self._look()

    @property
    def joints_rad(self) -> Array:
        """(J,) angles of the arm's joints."""
        return self._data.qpos.copy()

    def advance(self, force: Array, torque: Array, h: float) -> None:
        """Move on under a force and torque (3,) at the tool."""
        self._model.opt.timestep = h
        wrench = np.concatenate((force, torque))
        torques = self._control.torques_of(self._data, wrench, self._posture)
        self._data.qfrc_applied[:] = torques
        mujoco.mj_step(self._model, self._data)
        # What the next pull is worked out from is as of now, not of before the step.
        mujoco.mj_kinematics(self._model, self._data)
        mujoco.mj_comPos(self._model, self._data)
        mujoco.mj_comVel(self._model, self._data)
        self._look()

    def _look(self) -> None:
        twist, wxyz = np.empty(6), np.empty(4)
        mujoco.mj_objectVelocity(self._model, self._data, _SITE, self._tool, twist, 0)
        mujoco.mju_mat2Quat(wxyz, self._data.site_xmat[self._tool])
        self.position_m = self._data.site_xpos[self._tool].copy()
        self.orientation_wxyz = wxyz
        self.velocity_m_s, self.angular_velocity_rad_s = twist[3:], twist[:3]
