# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Which parts touch, and how hard: the simulator's own view, which no sensor of the robot has."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SimulationError

Pair = tuple[tuple[str, ...], tuple[str, ...]]
"""Two groups of geom names that may touch."""

_MAX_POINTS = 8
"""Two boxes touch in at most so many points."""

MAX_POINTS_OF_BODY = 24
"""A body touches in at most so many points that count."""

_FORCE = 1 << int(mujoco.mjtConDataField.mjCONDATA_FORCE)
"""Of each point the force (3,) in the contact's frame, its normal component first."""


def watch_contacts(spec: mujoco.MjSpec, pairs: Mapping[str, Pair]) -> None:
    """Add MuJoCo's contact sensors for named pairs of parts; `Contacts` reads them.

    Where a group holds all of a body that can touch, one sensor watches the body.

    Raises SimulationError for a geom that the scene does not have.
    """
    for name, (these, those) in pairs.items():
        for geom in (*these, *those):
            if spec.geom(geom) is None:
                raise SimulationError(
                    f"The workcell must have a part '{geom}', but it does not; "
                    "name a part of the workcell in its pairs."
                )
        watched = _watched(spec, these), _watched(spec, those)
        for number, (first, second) in enumerate(product(*watched)):
            points = _MAX_POINTS * max(first.geoms, second.geoms, 1)
            spec.add_sensor(
                name=f"{name}: {number}",
                type=mujoco.mjtSensor.mjSENS_CONTACT,
                objtype=first.kind,
                objname=first.name,
                reftype=second.kind,
                refname=second.name,
                intprm=[_FORCE, 0, min(points, MAX_POINTS_OF_BODY)],
            )


class Contacts:
    """Normal forces between named pairs of parts, of a scene that watches them."""

    def __init__(self, model: mujoco.MjModel, pairs: Mapping[str, Pair]) -> None:
        self.names = tuple(pairs)
        self._sums = np.zeros((len(self.names), model.nsensordata))
        for index in range(model.nsensor):
            sensor = model.sensor(index)
            name = sensor.name.rpartition(": ")[0]
            if name in pairs:
                first, count = int(sensor.adr[0]), int(sensor.dim[0])
                self._sums[self.names.index(name), first : first + count : 3] = 1.0

    def normal_forces(self, sensordata: Array) -> Array:
        """Sum of the normal forces of each pair, in the order of `names`, from all readings."""
        return self._sums.dot(sensordata)


@dataclass(frozen=True)
class _Watched:
    """A geom, or a body of so many geoms that can touch."""

    kind: mujoco.mjtObj
    name: str
    geoms: int = 1


def _watched(spec: mujoco.MjSpec, group: tuple[str, ...]) -> list[_Watched]:
    left, found = list(group), []
    for body in spec.bodies:
        own = [geom.name for geom in body.geoms if geom.contype or geom.conaffinity]
        if len(own) > 1 and set(own) <= set(left):
            found.append(_Watched(mujoco.mjtObj.mjOBJ_BODY, body.name, len(own)))
            left = [name for name in left if name not in own]
    return [*found, *(_Watched(mujoco.mjtObj.mjOBJ_GEOM, name) for name in left)]
