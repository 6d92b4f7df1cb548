# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Setup 1: an emergency stop button is snapped together and slid along the table to a wall.

The right gripper holds the cap by its knob. The housing stands in a light locating seat. Between
them a plunger on an over-centre spring gives the detent: it resists up to about 2.5 N, then
flips down, and the cap falls onto the housing.
"""

from collections.abc import Mapping

import mujoco
import numpy as np

from keyphase.simulation.disturbance import Disturbance
from keyphase.simulation.simulation import Simulation
from keyphase.simulation.workcells.parts import (
    GREY,
    HOUSING_M,
    RED,
    about_z,
    add_box,
    add_held_part,
    add_housing,
    add_table,
)
from keyphase.simulation.workcells.rim import CHAMFER, CLEARANCE_M, OUTER_M, RIM, add_rim
from keyphase.simulation.workcells.seating import is_seated, lie_of, within_clearance
from keyphase.simulation.workcells.workcell import Event, Workcell

HOUSING_POSITION_M = (0.43, -0.19)
WALL_FACE_Y_M = HOUSING_POSITION_M[1] + OUTER_M / 2 + 0.075

PLUNGER_ABOVE_TOP_M = 0.0019
_PLUNGER_TRAVEL_M = 0.0025
_ABOVE_CENTRE_M = 0.0015
_SPRING_ARM_M = 0.004
_SPRING_REST_M = 0.0043076
_SPRING_STIFFNESS_N_M = 54.8e3

WALL_FORCE_N = 1.0
SLID_M = 0.015
"""A housing that has moved this far from where it stood has left its seat: the slide is on."""

FITS = 4
"""The cap is square: it fits in four turns."""


def _furnish(spec: mujoco.MjSpec, disturbance: Disturbance) -> None:
    height, friction = disturbance.part_height_m, disturbance.friction
    table = add_table(spec, height, friction)
    position = np.array(HOUSING_POSITION_M) + disturbance.part_offset_m
    _add_seat(table, position, friction, disturbance.part_turn_rad)
    wall = (HOUSING_POSITION_M[0], WALL_FACE_Y_M + 0.006, 0.012)
    add_box(table, "wall", (0.16, 0.012, 0.024), wall, friction, GREY)
    housing = add_housing(
        spec,
        "housing",
        (*position, height),
        friction,
        mass_kg=0.12 * disturbance.mass,
        turn_rad=disturbance.part_turn_rad,
    )
    add_rim(housing, friction, disturbance.mass)
    _add_plunger(spec, housing)
    add_held_part(spec, disturbance.tilt_rad)


def _add_seat(
    table: mujoco.MjsBody, position: np.ndarray, friction: float, turn_rad: float
) -> None:
    # A low rail behind and a stop at each rear corner, open towards the wall.
    seat = table.add_body(name="seat", pos=[*position, 0.0], quat=about_z(turn_rad))
    inner, rail, low = HOUSING_M[0] / 2 + 0.0015, 0.006, 0.003
    for name, side in (("seat_near", -1.0), ("seat_far", 1.0)):
        centre = (side * (inner + rail / 2), -HOUSING_M[1] / 2 + 0.004, low / 2)
        add_box(seat, name, (rail, 0.008, low), centre, friction, GREY)
    centre = (0.0, -inner - rail / 2, low / 2)
    add_box(seat, "seat_back", (2 * (inner + rail), rail, low), centre, friction, GREY)


def _add_plunger(spec: mujoco.MjSpec, housing: mujoco.MjsBody) -> None:
    """A plate on a vertical slide with a bistable spring: the detent.

    A spring of stiffness k and rest length L between the plate and a point a beside its path
    pushes it by k (L - l) z / l, l = sqrt(a^2 + z^2): up while above centre, down below it.
    """
    top = HOUSING_M[2] + PLUNGER_ABOVE_TOP_M
    plunger = housing.add_body(name="plunger", pos=[0.0, 0.0, top])
    plunger.add_joint(
        name="plunger",
        type=mujoco.mjtJoint.mjJNT_SLIDE,
        axis=[0.0, 0.0, 1.0],
        range=[-_PLUNGER_TRAVEL_M, 0.0],
        limited=mujoco.mjtLimited.mjLIMITED_TRUE,
        damping=[2.0, 0.0, 0.0],
        armature=0.03,
    )
    add_box(plunger, "plunger", (0.036, 0.036, 0.004), (0, 0, -0.002), 0.2, RED, 0.01)
    plunger.add_site(name="spring_plunger", pos=[0.0, 0.0, 0.0])
    housing.add_site(name="spring_housing", pos=[_SPRING_ARM_M, 0.0, top - _ABOVE_CENTRE_M])
    spring = spec.add_tendon(
        name="detent",
        stiffness=[_SPRING_STIFFNESS_N_M, 0.0, 0.0],
        springlength=[_SPRING_REST_M, _SPRING_REST_M],
    )
    spring.wrap_site("spring_plunger")
    spring.wrap_site("spring_housing")


def _is_seated(simulation: Simulation) -> bool:
    lie = lie_of(simulation, FITS)
    snapped = simulation.contact_forces()["snap"] > 0.0
    return is_seated(lie) and within_clearance(lie, CLEARANCE_M) and snapped


def _has_slid(simulation: Simulation) -> bool:
    moved = simulation.part_poses()["housing"][0] - simulation.start_parts["housing"][0]
    return float(np.linalg.norm(moved)) > SLID_M


def _at_the_wall(simulation: Simulation) -> bool:
    return simulation.contact_forces()["wall"] > WALL_FORCE_N


def _checks(simulation: Simulation) -> Mapping[str, bool]:
    return {"seated": _is_seated(simulation)}


SETUP1 = Workcell(
    name="setup1",
    title="Snap the button together, slide it to the wall",
    start_joints_rad=(0.995802, -1.677143, -1.37282, 0.860193, -2.490649, 1.350952, 0.804149),
    furnish=_furnish,
    parts=("table", "seat", "held", "housing", "plunger"),
    pairs={
        "touch": (("cap",), ("plunger",)),
        "snap": (("cap",), ("housing",)),
        "wall": (("housing", "cap", *RIM, *CHAMFER), ("wall",)),
    },
    onsets=("snap", "wall"),
    ends_at_contact=True,
    events=(
        Event("snapped on", _is_seated),
        Event("slid together", _has_slid),
        Event("wall reached", _at_the_wall),
    ),
    checks=_checks,
)
"""The first of the paper's experiments."""
