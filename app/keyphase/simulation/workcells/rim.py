# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""A chamfered rim around a housing's top, which takes the cap in and lets an offset be felt."""

from math import pi, sqrt

import mujoco
import numpy as np

from keyphase.simulation.workcells.parts import CAP_M, DARK_YELLOW, HOUSING_M, add_box

CLEARANCE_M = 0.001
"""Between the cap and each side of the rim."""

WALL_M, HEIGHT_M, CHAMFER_M = 0.004, 0.003, 0.002
"""Thickness, straight height above the mating face, and width of the chamfer at 45°."""

OUTER_M = CAP_M[0] + 2 * (CLEARANCE_M + WALL_M)
"""Edge length of the housing with its rim."""

RIM = tuple(f"rim_{side}" for side in range(4))
CHAMFER = tuple(f"chamfer_{side}" for side in range(4))

_BELOW_M = 0.008
_PLATE_M = 0.002
_SIDES = ((0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0))
_MASS_KG = 0.002


def add_rim(housing: mujoco.MjsBody, friction: float, mass_factor: float) -> None:
    """Four walls around the top and a chamfer on each, as geoms RIM and CHAMFER."""
    inner, top = CAP_M[0] / 2 + CLEARANCE_M, HOUSING_M[2]
    for side, (axis, sign) in enumerate(_SIDES):
        centre = np.array([0.0, 0.0, top + (HEIGHT_M - _BELOW_M) / 2])
        centre[axis] = sign * (inner + WALL_M / 2)
        size = np.array([OUTER_M, OUTER_M, HEIGHT_M + _BELOW_M])
        size[axis] = WALL_M
        mass = mass_factor * _MASS_KG
        wall = add_box(
            housing, RIM[side], size.tolist(), centre.tolist(), friction, DARK_YELLOW, mass
        )
        _harden(wall)
        _add_chamfer(housing, side, friction, mass)


def _add_chamfer(housing: mujoco.MjsBody, side: int, friction: float, mass_kg: float) -> None:
    """A plate at 45° whose lower inner edge is the upper inner edge of the wall."""
    (axis, sign), lies = _SIDES[side], _PLATE_M / 2 * sqrt(0.5)
    centre = np.array([0.0, 0.0, HOUSING_M[2] + HEIGHT_M + CHAMFER_M / 2 - lies])
    centre[axis] = sign * (CAP_M[0] / 2 + CLEARANCE_M + CHAMFER_M / 2 + lies)
    size = np.array([OUTER_M, OUTER_M, _PLATE_M])
    size[axis] = CHAMFER_M * sqrt(2.0)
    plate = add_box(
        housing, CHAMFER[side], size.tolist(), centre.tolist(), friction, DARK_YELLOW, mass_kg
    )
    turn = np.zeros(4)
    across = np.eye(3)[1 - axis]
    mujoco.mju_axisAngle2Quat(turn, across, sign * (-pi / 4 if axis == 0 else pi / 4))
    plate.quat = turn
    _harden(plate)


def _harden(geom: mujoco.MjsGeom) -> None:
    """A rim gives way by a tenth of a millimetre, where a mating face gives way by half of one."""
    geom.priority = 1
    geom.solimp = [0.9, 0.99, 0.0005, 0.5, 2.0]
