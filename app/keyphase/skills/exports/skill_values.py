"""A skill library as JSON values, in their final order."""

from dataclasses import asdict
from typing import Any

from keyphase.demonstration import Array
from keyphase.segmentation.end_condition import ContactEnd, EndCondition
from keyphase.skills import search
from keyphase.skills.coupling import MAX_STEP, REFERENCE_REACH
from keyphase.skills.end_monitor import FELL_AWAY, PROGRESS_FRACTION, PROGRESS_M, REACHED_AFTER
from keyphase.skills.execution import executor, grip, guard, pressing, seeking, squared
from keyphase.skills.exports.skill_library import SkillLibrary
from keyphase.skills.exports.stages import pressing_of, seeking_of
from keyphase.skills.precondition import Precondition
from keyphase.skills.pressed import KeptForce
from keyphase.skills.primitive import Primitive
from keyphase.skills.skill import Skill
from keyphase.skills.spread import Spread
from keyphase.skills.squaring import Squaring


def library_values(library: SkillLibrary) -> dict[str, Any]:
    """All but the file's own name and version."""
    return {
        "demonstration": library.demonstration,
        "robot": asdict(library.robot),
        "gains": asdict(library.gains),
        "execution": execution_values(),
        "skills": [_skill(skill) for skill in library.skills],
    }


def execution_values() -> dict[str, Any]:
    """The numbers that an executor has for all skills."""
    return {
        "step_s": executor.STEP_S,
        "largest_step": MAX_STEP,
        "reach_m": REFERENCE_REACH[0],
        "reach_rad": REFERENCE_REACH[1],
        "reached_after": REACHED_AFTER,
        "progress_fraction": PROGRESS_FRACTION,
        "progress_m": PROGRESS_M,
        "fell_away": FELL_AWAY,
        "pressed_least_s": executor.PRESSED_S[0],
        "pressed_most_s": executor.PRESSED_S[1],
        "still_m_s": executor.STILL_M_S,
        "loaded_within": executor.LOADED_WITHIN,
        "loaded_within_N": executor.LOADED_WITHIN_N,
        "rest_s": executor.REST_S,
        "followed_beyond_m": pressing.MAX_DISTANCE_M,
        "touching_N": pressing.TOUCHING_N,
        "gripped_firmer": pressing.FIRMER,
        "dragged_s": pressing.DRAGGED_S,
        "pushed_s": pressing.PUSHED_S,
        "gripped_below": pressing.GRIPPED_BELOW,
        "heavy": pressing.HEAVY,
        "heavy_m_s": pressing.HEAVY_M_S,
        "touch_N": search.TOUCH_N,
        "touch_smoothed": search.SMOOTHED,
        "bounce_s": search.BOUNCE_TICKS * executor.STEP_S,
        "seat_giving": seeking.GIVING,
        "seat_turning": seeking.TURNING,
        "squared_turning": squared.FLATTENING,
        "seating_s": seeking.SEATING_S,
        "seat_fall_s": search.FALL_S,
        "seat_fall": search.FALL_SHARE,
        "seat_fell": search.FELL_SHARE,
        "seat_crept": search.CREPT_SHARE,
        "seat_sinking": [list(one) for one in search.SINKING],
        "seat_presses": search.MAX_PRESSES,
        "seat_yields": search.YIELDS,
        "brake_m_s2": guard.BRAKE_M_S2,
        "gripper_still": grip.STILL,
    }


def _skill(skill: Skill) -> dict[str, Any]:
    arming, press = skill.arming, skill.press
    return {
        "label": skill.label,
        "connecting": skill.connecting,
        "demonstrated_s": skill.demonstrated_s,
        "agrees": skill.agrees,
        "precondition": _precondition(skill.precondition),
        "end_condition": _end(skill.end_condition),
        "end_position_m": skill.end_position_m.tolist(),
        "end_orientation_wxyz": skill.end_orientation_wxyz.tolist(),
        "met_m": None if skill.met_m is None else skill.met_m.tolist(),
        "travel_direction": skill.travel_direction,
        "offset_m": skill.offset_m,
        "travel_limit_m": skill.travel_limit_m,
        "timeout_s": skill.timeout_s,
        "force_limit_N": skill.force_limit_N,
        "debounce_s": skill.debounce_s,
        "arming": None if arming is None else asdict(arming),
        "guard": _guard(skill),
        "press": None
        if press is None
        else {
            "direction": press.direction.tolist(),
            "force_N": press.force_N,
            "position_m": press.position_m.tolist(),
        },
        "kept": [_kept(force) for force in skill.kept],
        "shift_beyond_m": skill.shift_beyond_m,
        "search": None if skill.search is None else asdict(skill.search),
        "squaring": _squaring(skill.squaring),
        "pressing": pressing_of(skill),
        "seeking": seeking_of(skill),
        "primitive": _primitive(skill.primitive),
        **_spread(skill.spread),
    }


def _spread(spread: Spread | None) -> dict[str, Any]:
    if spread is None:
        return {}
    return {
        "spread": {
            "demonstrations": spread.demonstrations,
            "position_m": spread.position_m.tolist(),
            "stiffness": spread.stiffness.tolist(),
        }
    }


def _squaring(squaring: Squaring | None) -> dict[str, Any] | None:
    if squaring is None:
        return None
    return {key: list(v) if isinstance(v, tuple) else v for key, v in asdict(squaring).items()}


def _guard(skill: Skill) -> dict[str, float] | None:
    speed = guard.guarded_speed(skill)
    if speed is None:
        return None
    return {
        "stretch_m": guard.guarded_stretch(skill),
        "speed_m_s": speed,
        "further_m": skill.further_m,
    }


def _precondition(needs: Precondition | None) -> dict[str, Any] | None:
    if needs is None:
        return None
    wxyz = needs.orientation_wxyz
    return {
        "position_m": needs.position_m.tolist(),
        "orientation_wxyz": None if wxyz is None else wxyz.tolist(),
        "position_tolerance_m": needs.position_tolerance_m,
        "rotation_tolerance_rad": needs.rotation_tolerance_rad,
        "contacts": [
            {"direction": held.direction.tolist(), "least_N": held.least_N}
            for held in needs.contacts
        ],
        "gripper": needs.gripper,
    }


def _kept(force: KeptForce) -> dict[str, Any]:
    return {
        "met": force.met,
        "direction": force.direction.tolist(),
        "force_N": force.force_N.tolist(),
        "carries": force.carries,
        "pushed_N": None if force.pushed_N is None else force.pushed_N.tolist(),
    }


def _end(end: EndCondition) -> dict[str, Any]:
    if isinstance(end, ContactEnd):
        return {"kind": "contact", **asdict(end), "direction": [float(c) for c in end.direction]}
    values = {"kind": "configuration", **asdict(end)}
    return {key: value for key, value in values.items() if key != "gripper" or value is not None}


def _primitive(primitive: Primitive) -> dict[str, Any]:
    def listed(array: Array) -> list[Any]:
        return array.tolist()

    return {
        "duration_s": primitive.duration_s,
        "start_position_m": listed(primitive.start_position_m),
        "goal_position_m": listed(primitive.goal_position_m),
        "start_orientation_wxyz": listed(primitive.start_orientation_wxyz),
        "goal_orientation_wxyz": listed(primitive.goal_orientation_wxyz),
        "centres": listed(primitive.centres),
        "widths": listed(primitive.widths),
        "weights": listed(primitive.weights),
        "scaled": listed(primitive.scaled),
        "oriented": primitive.oriented,
        "constants": asdict(primitive.constants),
    }
