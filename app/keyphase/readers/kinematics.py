"""Where a tool is by joint angles, and what acts on it by joint torques, through Pinocchio.

Imported only where a recipe names a robot description; everything else reads without it.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.errors import RecipeError
from keyphase.readers.formats.packages import package
from keyphase.urdf.checking import refuse_bad_urdf

EXTRA = "robot"

SINGULAR = 0.02
"""Singular values of the Jacobian below this part of the greatest count as zero: near a singular
posture joint torques say nothing of some direction, and noise would become force."""


@dataclass(frozen=True, eq=False)
class ToolKinematics:
    """The chain of joints from a robot's root to a tool frame.

    joints  their names, in the order in which joint values are given
    """

    joints: tuple[str, ...]
    _model: Any
    _frame: int

    def poses(self, joints_rad: Array) -> tuple[Array, Array]:
        """Position (N, 3) [m] and rotation matrices (N, 3, 3) of the tool frame, root's frame."""
        places = np.empty((len(joints_rad), 3))
        turns = np.empty((len(joints_rad), 3, 3))
        pinocchio, data = self._pinocchio, self._model.createData()
        for row, values in enumerate(joints_rad):
            pinocchio.forwardKinematics(self._model, data, self._configuration(values))
            pose = pinocchio.updateFramePlacement(self._model, data, self._frame)
            places[row], turns[row] = pose.translation, pose.rotation
        return places, turns

    def wrenches(self, joints_rad: Array, torques_Nm: Array) -> tuple[Array, Array]:
        """Force (N, 3) [N] and torque (N, 3) [N m] about the tool point, root's axes.

        The least wrench F with J^T F = tau, by the pseudo-inverse of the transposed Jacobian
        (Siciliano et al., Robotics, 2009, section 3.8), singular directions left out.
        """
        loads = np.empty((len(joints_rad), 6))
        for row, (values, torques) in enumerate(zip(joints_rad, torques_Nm, strict=True)):
            loads[row] = np.linalg.pinv(self._jacobian(values).T, rcond=SINGULAR) @ torques
        return loads[:, :3], loads[:, 3:]

    def _jacobian(self, values: Array) -> NDArray[np.float64]:
        pinocchio, data = self._pinocchio, self._model.createData()
        axes = pinocchio.LOCAL_WORLD_ALIGNED
        found = pinocchio.computeFrameJacobian(
            self._model, data, self._configuration(values), self._frame, axes
        )
        return found.reshape(6, -1)

    def _configuration(self, values: Array) -> Array:
        """A joint that turns without end is a cosine and a sine."""
        pinocchio, model = self._pinocchio, self._model
        return pinocchio.integrate(model, pinocchio.neutral(model), values)

    @property
    def _pinocchio(self) -> Any:
        return package("pinocchio", EXTRA, Path())


def tool_kinematics(urdf: Path, tool_frame: str, where: str) -> ToolKinematics:
    """The chain that moves a link of a robot; all other joints stand at zero.

    Raises RecipeError, beginning with `where`, for a description or frame that cannot be used,
    MissingPackageError where Pinocchio is not installed.
    """
    pinocchio = package("pinocchio", EXTRA, urdf)
    refuse_bad_urdf(urdf)
    try:
        full = pinocchio.buildModelFromUrdf(str(urdf))
    except (ValueError, RuntimeError) as error:
        raise RecipeError(
            f"{where}: {urdf} must be a URDF that Pinocchio reads ({error})."
        ) from error
    # Asked for an unknown frame, Pinocchio answers with a number all the same.
    if not full.existBodyName(tool_frame):
        links = [frame.name for frame in full.frames if frame.type == pinocchio.FrameType.BODY]
        raise RecipeError(
            f"{where}: {urdf} has no link {tool_frame[:60]!r}; choose one of "
            f"{', '.join(links[-20:])}."
        )
    parent = full.frames[full.getFrameId(tool_frame, pinocchio.FrameType.BODY)].parentJoint
    chain = [joint for joint in full.supports[parent] if joint > 0]
    if not chain:
        raise RecipeError(f"{where}: no joint of {urdf} moves {tool_frame!r}; choose another link.")
    others = [joint for joint in range(1, full.njoints) if joint not in chain]
    model = pinocchio.buildReducedModel(full, others, pinocchio.neutral(full))
    frame = model.getFrameId(tool_frame, pinocchio.FrameType.BODY)
    return ToolKinematics(tuple(str(full.names[joint]) for joint in chain), model, frame)
