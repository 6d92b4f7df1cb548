# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""What the parts of a workcell look like, for whoever draws them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import mujoco
import numpy as np

from keyphase.demonstration import Array

_KINDS: dict[int, Literal["box", "cylinder"]] = {
    int(mujoco.mjtGeom.mjGEOM_BOX): "box",
    int(mujoco.mjtGeom.mjGEOM_CYLINDER): "cylinder",
}


@dataclass(frozen=True, eq=False)
class Shape:
    """A box or an upright cylinder fixed to a part.

    body              name of the part it moves with
    size_m            (3,) edges of a box; diameter, diameter and height of a cylinder
    position_m        (3,) of its centre, orientation_wxyz (4,), both in the part's frame
    rgba              colour, 0 to 1
    """

    name: str
    body: str
    kind: Literal["box", "cylinder"]
    size_m: Array
    position_m: Array
    orientation_wxyz: Array
    rgba: tuple[float, float, float, float]


def shapes_in(model: mujoco.MjModel, parts: Sequence[str]) -> tuple[Shape, ...]:
    """Every shape of the parts of these names."""
    bodies = {model.body(name).id: name for name in parts}
    return tuple(
        _shape(model.geom(index), bodies[int(model.geom_bodyid[index])])
        for index in range(model.ngeom)
        if int(model.geom_bodyid[index]) in bodies
    )


def _shape(geom, body: str) -> Shape:
    kind = _KINDS[int(geom.type[0])]
    half = np.array(geom.size)
    red, green, blue, alpha = geom.rgba.tolist()
    return Shape(
        name=geom.name,
        body=body,
        kind=kind,
        size_m=2.0 * (half if kind == "box" else half[[0, 0, 1]]),
        position_m=np.array(geom.pos),
        orientation_wxyz=np.array(geom.quat),
        rgba=(red, green, blue, alpha),
    )
