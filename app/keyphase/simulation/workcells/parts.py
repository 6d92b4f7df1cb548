# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""The parts of an emergency stop button, table and wall, as boxes and cylinders.

All lengths in metres; a part's origin is the middle of its underside, a held part's the middle of
its mating face.
"""

from collections.abc import Sequence

import mujoco
import numpy as np

from keyphase.simulation.robot_scene import HELD, ROBOT, SCENE, TOOL_BODY

TOOL_TO_MATING_FACE_M = 0.032
"""How far the held part's mating face lies beyond the tool point, along the tool's z axis."""

HOUSING_M = (0.060, 0.060, 0.026)
CAP_M = (0.060, 0.060, 0.025)
KNOB_RADIUS_M, KNOB_HEIGHT_M = 0.018, 0.015
SERRATED = 2.0
"""Friction of the serrated mating faces: once pressed together they do not slide."""

YELLOW, DARK_YELLOW = (0.93, 0.76, 0.16, 1.0), (0.78, 0.62, 0.10, 1.0)
RED, GREY, WOOD = (0.80, 0.10, 0.10, 1.0), (0.45, 0.47, 0.50, 1.0), (0.66, 0.60, 0.52, 1.0)

_SOLREF = [0.01, 1.0]
_SOLIMP = [0.3, 0.95, 0.001, 0.5, 2.0]


def add_box(
    body: mujoco.MjsBody,
    name: str,
    size_m: Sequence[float],
    centre_m: Sequence[float],
    friction: float,
    rgba: Sequence[float],
    mass_kg: float = 0.0,
    group: int = SCENE,
) -> mujoco.MjsGeom:
    """A colliding box of full edge lengths `size_m`."""
    return body.add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=[edge / 2 for edge in size_m],
        pos=list(centre_m),
        mass=mass_kg,
        rgba=list(rgba),
        friction=[friction, 0.005, 0.0001],
        solref=_SOLREF,
        solimp=_SOLIMP,
        contype=group,
        conaffinity=ROBOT | HELD | SCENE if group == SCENE else 0,
    )


def about_z(angle_rad: float) -> np.ndarray:
    """Quaternion w x y z of a turn about the vertical."""
    return np.array([np.cos(angle_rad / 2), 0.0, 0.0, np.sin(angle_rad / 2)])


def add_knob(body: mujoco.MjsBody, name: str, base_z_m: float, mass_kg: float) -> None:
    """The red mushroom on top of a cap; seen, and held by the gripper, but in nobody's way."""
    body.add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_CYLINDER,
        size=[KNOB_RADIUS_M, KNOB_HEIGHT_M / 2, 0.0],
        pos=[0.0, 0.0, base_z_m + KNOB_HEIGHT_M / 2],
        mass=mass_kg,
        rgba=list(RED),
        contype=0,
        conaffinity=0,
    )


def add_table(spec: mujoco.MjSpec, height_m: float, friction: float) -> mujoco.MjsBody:
    """The table, its surface `height_m` above the robot's base; fixtures are added to it."""
    table = spec.worldbody.add_body(name="table", pos=[0.0, 0.0, height_m])
    add_box(table, "table", (0.7, 1.1, 0.04), (0.38, 0.0, -0.02), friction, WOOD)
    return table


def add_held_part(
    spec: mujoco.MjSpec, tilt_rad: float, size_m: Sequence[float] = CAP_M, mass_kg: float = 0.12
) -> None:
    """The upper part, held by its knob: a cap whose mating face looks along the tool's z axis."""
    # Turned about x by pi, so that the part's own z axis points back into the gripper.
    turn = np.zeros(4)
    mujoco.mju_euler2Quat(turn, np.array([np.pi, tilt_rad, 0.0]), "xyz")
    held = spec.body(TOOL_BODY).add_body(
        name="held", pos=[0.0, 0.0, TOOL_TO_MATING_FACE_M], quat=turn
    )
    centre = (0.0, 0.0, size_m[2] / 2)
    add_box(held, "cap", size_m, centre, 0.0, YELLOW, 0.8 * mass_kg, HELD)
    add_knob(held, "knob", size_m[2], 0.2 * mass_kg)


def add_housing(
    spec: mujoco.MjSpec,
    name: str,
    position_m: Sequence[float],
    friction: float,
    mass_kg: float,
    turn_rad: float = 0.0,
) -> mujoco.MjsBody:
    """A lower part: a free body whose serrated top meets the cap, turned about the vertical."""
    housing = spec.worldbody.add_body(name=name, pos=list(position_m), quat=about_z(turn_rad))
    housing.add_freejoint()
    add_box(housing, name, HOUSING_M, (0.0, 0.0, HOUSING_M[2] / 2), friction, DARK_YELLOW, mass_kg)
    # A pair of its own, so that the serration does not depend on what the table is like.
    spec.add_pair(
        name="serration",
        geomname1="cap",
        geomname2=name,
        condim=3,
        friction=[SERRATED, SERRATED, 0.005, 0.0001, 0.0001],
        solref=_SOLREF,
        solimp=_SOLIMP,
    )
    return housing
