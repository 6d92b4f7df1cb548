"""From the JSON values of a skill file, already checked against its schema, to a library."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from keyphase.demonstration import UNIT_TOLERANCE, Array
from keyphase.errors import SkillError
from keyphase.segmentation.end_condition import (
    ConfigurationEnd,
    ContactEnd,
    EndCondition,
    GripperEnd,
)
from keyphase.segmentation.end_condition.watch import Arming
from keyphase.skills.exports.skill_library import SkillLibrary, SkillRobot
from keyphase.skills.gains import SkillGains
from keyphase.skills.precondition import HeldContact, Precondition
from keyphase.skills.pressed import KeptForce, Press
from keyphase.skills.primitive import Constants, Primitive
from keyphase.skills.search import Search
from keyphase.skills.skill import Skill
from keyphase.skills.spread import Spread
from keyphase.skills.squaring import Squaring

Values = Mapping[str, Any]


def library_of_values(content: Values) -> SkillLibrary:
    """The library; raises SkillError or ParameterError where its skills cannot be executed."""
    robot = {**content["robot"]}
    robot["joints"], robot["start_joints_rad"] = (
        tuple(robot["joints"]),
        tuple(map(float, robot["start_joints_rad"])),
    )
    gains = SkillGains(**{key: float(value) for key, value in content["gains"].items()})
    skills = tuple(_skill(values) for values in content["skills"])
    return SkillLibrary(content["demonstration"], skills, SkillRobot(**robot), gains)


def _skill(values: Values) -> Skill:
    stretch, direction = values["demonstrated_s"], values["travel_direction"]
    press, arming, beyond = values["press"], values["arming"], values["shift_beyond_m"]
    seek, squaring = values["search"], values.get("squaring")
    return Skill(
        label=values["label"],
        connecting=values["connecting"],
        primitive=_primitive(values["primitive"]),
        end_condition=_end(values["end_condition"]),
        end_position_m=_numbers(values["end_position_m"]),
        end_orientation_wxyz=_quaternion(values["end_orientation_wxyz"]),
        met_m=None if values["met_m"] is None else _numbers(values["met_m"]),
        travel_direction=None if direction is None else _triple(direction),
        offset_m=float(values["offset_m"]),
        travel_limit_m=float(values["travel_limit_m"]),
        timeout_s=float(values["timeout_s"]),
        force_limit_N=float(values["force_limit_N"]),
        demonstrated_s=None if stretch is None else (float(stretch[0]), float(stretch[1])),
        arming=None if arming is None else Arming(**_floats(arming)),
        press=None if press is None else _press(press),
        kept=tuple(map(_kept, values["kept"])),
        shift_beyond_m=None if beyond is None else float(beyond),
        precondition=_precondition(values["precondition"]),
        search=None if seek is None else Search(**_floats(seek)),
        squaring=None if squaring is None else _squaring(squaring),
        agrees=values["agrees"],
        spread=_spread(values.get("spread")),
        further_m=float((values["guard"] or {}).get("further_m", 0.0)),
    )


def _spread(values: Values | None) -> Spread | None:
    if values is None:
        return None
    return Spread(int(values["demonstrations"]), _numbers(values["position_m"]))


def _squaring(values: Values) -> Squaring:
    others = ("normal", "along", "strokes", "flushing", "sides")
    numbers = _floats({key: value for key, value in values.items() if key not in others})
    across, along = values["strokes"]
    return Squaring(
        _triple(values["normal"]),
        _triple(values["along"]),
        strokes=(int(across), int(along)),
        flushing=int(values["flushing"]),
        sides=int(values["sides"]),
        **numbers,
    )


def _press(values: Values) -> Press:
    direction, position = _numbers(values["direction"]), _numbers(values["position_m"])
    return Press(direction, float(values["force_N"]), position)


def _kept(values: Values) -> KeptForce:
    direction, force = _numbers(values["direction"]), _numbers(values["force_N"])
    pushed = values.get("pushed_N")
    pushed = None if pushed is None else _numbers(pushed)
    counts = [len(direction), len(force), len(force if pushed is None else pushed)]
    if len(set(counts)) != 1:
        raise SkillError(
            f"A kept force needs as many directions as forces, but the file has {counts[0]} "
            f"and {counts[1]}, and {counts[2]} for what is pushed; export the skills again."
        )
    return KeptForce(direction, force, values["met"], values.get("carries"), pushed)


def _precondition(values: Values | None) -> Precondition | None:
    if values is None:
        return None
    wxyz = values["orientation_wxyz"]
    return Precondition(
        position_m=_numbers(values["position_m"]),
        orientation_wxyz=None if wxyz is None else _quaternion(wxyz),
        position_tolerance_m=float(values["position_tolerance_m"]),
        rotation_tolerance_rad=float(values["rotation_tolerance_rad"]),
        contacts=tuple(
            HeldContact(_numbers(held["direction"]), float(held["least_N"]))
            for held in values["contacts"]
        ),
        gripper=values["gripper"],
    )


def _end(values: Values) -> EndCondition:
    kept = {key: value for key, value in values.items() if key != "kind"}
    numbers = ("threshold_N", "offset_m", "timeout_s")
    numbers = (*numbers, "position_tolerance_m", "rotation_tolerance_rad")
    kept |= {key: float(kept[key]) for key in numbers if kept.get(key) is not None}
    if values["kind"] == "contact":
        return ContactEnd(**{**kept, "direction": _triple(kept["direction"])})
    grip = kept.pop("gripper", None)
    return ConfigurationEnd(**kept, gripper=GripperEnd(**grip) if grip else None)


def _primitive(values: Values) -> Primitive:
    counts = {len(values[key]) for key in ("centres", "widths", "weights")}
    if len(counts) != 1:
        raise SkillError(
            "A primitive needs as many centres and widths as rows of weights, but the file has "
            f"{', '.join(map(str, sorted(counts)))}; export the skills again."
        )
    return Primitive(
        duration_s=float(values["duration_s"]),
        start_position_m=_numbers(values["start_position_m"]),
        goal_position_m=_numbers(values["goal_position_m"]),
        start_orientation_wxyz=_quaternion(values["start_orientation_wxyz"]),
        goal_orientation_wxyz=_quaternion(values["goal_orientation_wxyz"]),
        centres=_numbers(values["centres"]),
        widths=_numbers(values["widths"]),
        weights=_numbers(values["weights"]),
        scaled=np.array(values["scaled"], dtype=bool),
        oriented=values["oriented"],
        constants=Constants(**_floats(values["constants"])),
    )


def _floats(values: Values) -> dict[str, float]:
    return {key: float(value) for key, value in values.items()}


def _numbers(values: Any) -> Array:
    return np.array(values, dtype=np.float64)


def _triple(values: Any) -> tuple[float, float, float]:
    x, y, z = map(float, values)
    return x, y, z


def _quaternion(values: Any) -> Array:
    wxyz = _numbers(values)
    if not abs(float(np.linalg.norm(wxyz)) - 1.0) <= UNIT_TOLERANCE:
        raise SkillError(
            f"An orientation must be a unit quaternion w x y z, but the file has {values}; "
            "export the skills again."
        )
    return wxyz
