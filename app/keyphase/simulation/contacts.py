# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Which parts touch, and how hard: the simulator's own view, which no sensor of the robot has."""

from collections.abc import Iterator, Mapping

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SimulationError

Pair = tuple[tuple[str, ...], tuple[str, ...]]
"""Two groups of geom names that may touch."""

_MAX_POINTS = 8
"""Two boxes touch in at most so many points."""

_FORCE = 1 << int(mujoco.mjtConDataField.mjCONDATA_FORCE)
"""Of each point the force (3,) in the contact's frame, its normal component first."""


def watch_contacts(spec: mujoco.MjSpec, pairs: Mapping[str, Pair]) -> None:
    """Add MuJoCo's contact sensors for named pairs of parts; `Contacts` reads them.

    Raises SimulationError for a geom that the scene does not have.
    """
    for name, first, second in _geoms_of(pairs):
        for geom in (first, second):
            if spec.geom(geom) is None:
                raise SimulationError(
                    f"The workcell must have a part '{geom}', but it does not; "
                    "name a part of the workcell in its pairs."
                )
        spec.add_sensor(
            name=_sensor(name, first, second),
            type=mujoco.mjtSensor.mjSENS_CONTACT,
            objtype=mujoco.mjtObj.mjOBJ_GEOM,
            objname=first,
            reftype=mujoco.mjtObj.mjOBJ_GEOM,
            refname=second,
            intprm=[_FORCE, 0, _MAX_POINTS],
        )


class Contacts:
    """Normal forces between named pairs of parts, of a scene that watches them."""

    def __init__(self, model: mujoco.MjModel, pairs: Mapping[str, Pair]) -> None:
        self.names = tuple(pairs)
        self._sums = np.zeros((len(self.names), model.nsensordata))
        for name, first, second in _geoms_of(pairs):
            address = int(model.sensor(_sensor(name, first, second)).adr[0])
            normals = slice(address, address + 3 * _MAX_POINTS, 3)
            self._sums[self.names.index(name), normals] = 1.0

    def normal_forces(self, sensordata: Array) -> Array:
        """Sum of the normal forces of each pair, in the order of `names`, from all readings."""
        return self._sums.dot(sensordata)


def _geoms_of(pairs: Mapping[str, Pair]) -> Iterator[tuple[str, str, str]]:
    """Name of the pair, and one geom of each of its groups."""
    for name, (these, those) in pairs.items():
        for first in these:
            for second in those:
                yield name, first, second


def _sensor(pair: str, first: str, second: str) -> str:
    return f"{pair}: {first} on {second}"
