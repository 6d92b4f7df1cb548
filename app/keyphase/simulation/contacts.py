# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Which parts touch, and how hard: the simulator's own view, which no sensor has."""

from collections.abc import Mapping, Sequence

import mujoco
import numpy as np
from numpy.typing import NDArray

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
        self._listed = b""
        self._watched: tuple[tuple[int, int], ...] = ()
        self._index = np.full((model.ngeom, model.ngeom), -1)
        for index, (first, second) in enumerate(pairs.values()):
            ids = np.ix_(_ids(model, first), _ids(model, second))
            self._index[ids] = index
            self._index.T[ids] = index

    def normal_forces(self, data: mujoco.MjData) -> Array:
        """Sum of the normal forces of each pair, in the order of `names`."""
        total = np.zeros(len(self.names))
        contact = data.contact
        geoms = contact.geom
        listed = geoms.tobytes()
        if listed != self._listed:
            self._listed, self._watched = listed, self._pairs_among(geoms)
        if self._watched:
            addresses, forces = contact.efc_address, data.efc_force
            for number, pair in self._watched:
                if addresses[number] >= 0:
                    total[pair] += forces[addresses[number]]
        return total

    def _pairs_among(self, geoms: NDArray[np.int32]) -> tuple[tuple[int, int], ...]:
        """Number and pair of those contacts between `geoms` (C, 2) that belong to a pair.

        The list of what touches what seldom changes from one step of the physics to the next, and
        mostly the parts only rest on the table: so it is kept.
        """
        pairs = self._index[geoms[:, 0], geoms[:, 1]].tolist()
        return tuple((number, pair) for number, pair in enumerate(pairs) if pair >= 0)


def _ids(model: mujoco.MjModel, names: Sequence[str]) -> list[int]:
    ids = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, name) for name in names]
    if -1 in ids:
        missing = names[ids.index(-1)]
        raise SimulationError(f"The workcell must have a part '{missing}', but it does not.")
    return ids
