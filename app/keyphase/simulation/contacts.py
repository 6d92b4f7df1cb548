# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Which parts touch, and how hard: the simulator's own view, which no sensor has."""

from collections.abc import Mapping, Sequence

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SimulationError

Pair = tuple[tuple[str, ...], tuple[str, ...]]
"""Two groups of geom names that may touch."""


class Contacts:
    """Normal forces between named pairs of parts.

    Raises SimulationError for a geom the model does not have.
    """

    def __init__(self, model: mujoco.MjModel, pairs: Mapping[str, Pair]) -> None:
        self.names = tuple(pairs)
        self._index = np.full((model.ngeom, model.ngeom), -1)
        for index, (first, second) in enumerate(pairs.values()):
            ids = np.ix_(_ids(model, first), _ids(model, second))
            self._index[ids] = index
            self._index.T[ids] = index

    def normal_forces(self, data: mujoco.MjData) -> Array:
        """Sum of the normal forces of each pair, in the order of `names`."""
        total = np.zeros(len(self.names))
        if data.ncon:
            contact = data.contact
            first, second = contact.geom.T
            pair, address = self._index[first, second], contact.efc_address
            counted = (pair >= 0) & (address >= 0)
            np.add.at(total, pair[counted], data.efc_force[address[counted]])
        return total


def _ids(model: mujoco.MjModel, names: Sequence[str]) -> list[int]:
    ids = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, name) for name in names]
    if -1 in ids:
        missing = names[ids.index(-1)]
        raise SimulationError(f"The workcell must have a part '{missing}', but it does not.")
    return ids
