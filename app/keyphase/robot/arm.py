"""One arm: the chain of joints from a robot's root to its tool frame, through Pinocchio."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import pinocchio  # pyright: ignore[reportMissingImports]
from numpy.typing import ArrayLike

from keyphase.demonstration import Array
from keyphase.errors import RobotError
from keyphase.robot.description import RobotDescription
from keyphase.robot.link_frames import configuration


@dataclass(frozen=True, eq=False)
class Arm:
    """Kinematics of a description's chain; immutable, and safe to use from several threads."""

    robot: RobotDescription

    @cached_property
    def model(self) -> pinocchio.Model:
        """Pinocchio's model of the chain alone, all other joints locked."""
        full = self.robot.model
        locked = [i for i in range(1, full.njoints) if full.names[i] not in self.robot.joint_names]
        return pinocchio.buildReducedModel(full, locked, pinocchio.neutral(full))

    @cached_property
    def frame(self) -> int:
        """Pinocchio's number of the tool frame."""
        return self.model.getFrameId(self.robot.tool_frame, pinocchio.FrameType.BODY)

    def forward(self, joints_rad: ArrayLike) -> Array:
        """Pose (4, 4) of the tool frame in the root's frame at joint values (J,)."""
        return self.pose_and_jacobian(joints_rad, self.model.createData())[0].homogeneous

    def jacobian(self, joints_rad: ArrayLike) -> Array:
        """Jacobian (6, J): velocity of the tool point, then angular velocity, root's axes."""
        return self.pose_and_jacobian(joints_rad, self.model.createData())[1]

    def pose_and_jacobian(
        self, joints_rad: ArrayLike, data: pinocchio.Data
    ) -> tuple[pinocchio.SE3, Array]:
        """Both at once; the pose is a view into `data` that the next call overwrites.

        Raises RobotError where the number of joint values is wrong.
        """
        q = self._configuration(np.asarray(joints_rad, dtype=np.float64))
        axes = pinocchio.LOCAL_WORLD_ALIGNED
        jacobian = pinocchio.computeFrameJacobian(self.model, data, q, self.frame, axes)
        # For a single joint Pinocchio's array has lost its second axis.
        columns = jacobian.reshape(6, -1)
        return pinocchio.updateFramePlacement(self.model, data, self.frame), columns

    @cached_property
    def _all_are_angles(self) -> bool:
        return self.model.nq == self.model.nv

    def _configuration(self, joints_rad: Array) -> Array:
        if joints_rad.shape != (len(self.robot.joint_names),):
            raise RobotError(
                f"{self.robot.name}: expected {len(self.robot.joint_names)} joint values "
                f"({', '.join(self.robot.joint_names)}), but the shape {joints_rad.shape} came."
            )
        if self._all_are_angles:
            return joints_rad
        named = zip(self.robot.joint_names, joints_rad.tolist(), strict=True)
        return configuration(self.model, dict(named))
