# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Setup 2: a cap is turned to fit between the rails of its housing, then pushes others along.

The cap is narrow across the rails and long along them: unless it is turned to align, it rests on
the rails instead of the housing. Two buttons assembled before stand in the way sideways, as free
bodies.
"""

from collections.abc import Mapping

import mujoco
import numpy as np

from keyphase.simulation.disturbance import Disturbance
from keyphase.simulation.simulation import Simulation
from keyphase.simulation.workcells.parts import (
    DARK_YELLOW,
    HOUSING_M,
    YELLOW,
    add_box,
    add_held_part,
    add_housing,
    add_knob,
    add_table,
)
from keyphase.simulation.workcells.seating import SLACK_M, is_seated, lie_of
from keyphase.simulation.workcells.workcell import Event, Workcell

HOUSING_POSITION_M = (0.43, -0.24)
START_TURN_RAD = float(np.radians(55.0))
"""How far the held part is turned about the vertical at the start."""

GAP_M = 0.065
"""Free way of the housing before it meets the first button."""

BUTTONS = ("button_1", "button_2")
MOVED_M = 0.020

_CAP_M = (0.040, 0.050, 0.025)
_RAIL_M = (0.0035, 0.050, 0.008)
_RAIL_INNER_M = 0.0265
_BUTTON_MASS_KG = 0.45

CLEARANCES_M = (_RAIL_INNER_M - _CAP_M[0] / 2, (HOUSING_M[1] - _CAP_M[1]) / 2)
"""How far the cap may lie aside: across until it meets a rail, along until it hangs over."""

OTHERS_FORCE_N = 0.2
FITS = 2
"""The cap is longer than wide: it fits in two turns."""


def _furnish(spec: mujoco.MjSpec, disturbance: Disturbance) -> None:
    height, friction = disturbance.part_height_m, disturbance.friction
    add_table(spec, height, friction)
    position = np.array(HOUSING_POSITION_M) + disturbance.part_offset_m
    housing = add_housing(
        spec,
        "housing",
        (*position, height),
        friction,
        mass_kg=0.12 * disturbance.mass,
        turn_rad=disturbance.part_turn_rad,
    )
    _add_rails(housing, "housing", friction)
    x, y = HOUSING_POSITION_M
    for place, name in enumerate(BUTTONS):
        centre = y + GAP_M + (place + 1) * HOUSING_M[1] + place * 0.0005
        _add_button(spec, name, (x, centre, height), friction, _BUTTON_MASS_KG * disturbance.mass)
    add_held_part(spec, disturbance.tilt_rad, _CAP_M)


def _add_rails(housing: mujoco.MjsBody, name: str, friction: float) -> None:
    for side, sign in (("near", -1.0), ("far", 1.0)):
        centre = (sign * (_RAIL_INNER_M + _RAIL_M[0] / 2), 0.0, HOUSING_M[2] + _RAIL_M[2] / 2)
        add_box(housing, f"{name}_rail_{side}", _RAIL_M, centre, friction, DARK_YELLOW)


def _add_button(
    spec: mujoco.MjSpec,
    name: str,
    position_m: tuple[float, float, float],
    friction: float,
    mass_kg: float,
) -> None:
    button = spec.worldbody.add_body(name=name, pos=list(position_m))
    button.add_freejoint()
    half = HOUSING_M[2] / 2
    add_box(button, name, HOUSING_M, (0, 0, half), friction, DARK_YELLOW, 0.7 * mass_kg)
    cap = (0.0, 0.0, HOUSING_M[2] + _CAP_M[2] / 2)
    add_box(button, f"{name}_cap", _CAP_M, cap, friction, YELLOW, 0.2 * mass_kg)
    add_knob(button, f"{name}_knob", HOUSING_M[2] + _CAP_M[2], 0.1 * mass_kg)


def _is_seated(simulation: Simulation) -> bool:
    lie = lie_of(simulation, FITS)
    inside = all(abs(lie.aside_m) < np.array(CLEARANCES_M) + SLACK_M)
    return is_seated(lie) and inside and simulation.contact_forces()["contact"] > 0.0


def _others_met(simulation: Simulation) -> bool:
    return simulation.contact_forces()["others"] > OTHERS_FORCE_N


def _checks(simulation: Simulation) -> Mapping[str, bool]:
    poses = simulation.part_poses()
    moved = [
        float(np.linalg.norm(poses[name][0] - simulation.start_parts[name][0])) for name in BUTTONS
    ]
    return {"seated": _is_seated(simulation), "buttons moved": min(moved) > MOVED_M}


SETUP2 = Workcell(
    name="setup2",
    title="Turn the cap, seat it, push the others along",
    start_joints_rad=(1.205051, -1.348127, -1.249897, 0.320995, -2.144437, 1.156503, -0.321195),
    furnish=_furnish,
    parts=("table", "held", "housing", *BUTTONS),
    pairs={
        "contact": (("cap",), ("housing",)),
        "others": (
            ("housing", "cap"),
            (BUTTONS[0], f"{BUTTONS[0]}_cap"),
        ),
    },
    onsets=("contact", "others"),
    ends_at_contact=False,
    events=(Event("cap seated", _is_seated), Event("others met", _others_met)),
    checks=_checks,
)
"""The second of the paper's experiments."""
