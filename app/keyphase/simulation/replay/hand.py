# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""The hand of a person on the tool during a replay: it pushes, or it holds."""

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from keyphase.demonstration import Array
from keyphase.errors import SimulationError
from keyphase.simulation.impedance import Reference, rotation_towards
from keyphase.simulation.simulated import Simulated

STIFFNESS_N_M, DAMPING_NS_M = 8000.0, 250.0
ROTATIONAL_STIFFNESS_NM_RAD, ROTATIONAL_DAMPING_NMS_RAD = 60.0, 1.5
STRONGEST_N, STRONGEST_NM = 60.0, 8.0
"""The most a hand exerts: twice what the impedance pulls with."""


class Hand:
    """Acts above the wrist sensor, which reads contact only, as in the paper."""

    def __init__(self, world: Simulated) -> None:
        self._world = world
        self.held: Reference | None = None
        self._push_N: Array | None = None
        self._acted = False

    @property
    def is_on(self) -> bool:
        """Whether the hand holds or pushes."""
        return self.held is not None or self._push_N is not None

    def push(self, force_N: ArrayLike) -> None:
        """Push the tool point with a force (3,), base frame, until told otherwise.

        Raises SimulationError for what is no force.
        """
        force = np.array(force_N, dtype=np.float64)
        if force.shape != (3,) or not np.isfinite(force).all():
            raise SimulationError(
                f"A push must be a force of three finite numbers, but is {force_N}; send newtons."
            )
        self._push_N = _bounded(force, STRONGEST_N) if force.any() else None

    def act(self) -> None:
        """Put the hand's force on the tool for the coming tick."""
        if not (self.is_on or self._acted):
            return
        self._acted = self.is_on
        self._world.exert(*self._wrench())

    def _wrench(self) -> tuple[Array, Array]:
        pushed = np.zeros(3) if self._push_N is None else self._push_N.copy()
        if self.held is None:
            return pushed, np.zeros(3)
        (position, wxyz), twist = self._world.tool_pose(), self._world.tool_velocity()
        matrix = np.empty(9)
        mujoco.mju_quat2Mat(matrix, wxyz)
        turned = rotation_towards(matrix, self.held.orientation_wxyz)
        force = STIFFNESS_N_M * (self.held.position_m - position) - DAMPING_NS_M * twist[:3]
        torque = ROTATIONAL_STIFFNESS_NM_RAD * turned - ROTATIONAL_DAMPING_NMS_RAD * twist[3:]
        return _bounded(force, STRONGEST_N) + pushed, _bounded(torque, STRONGEST_NM)


def _bounded(vector: Array, greatest: float) -> Array:
    norm = float(np.linalg.norm(vector))
    return vector * (greatest / norm) if norm > greatest else vector
