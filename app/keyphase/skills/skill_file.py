"""The skill file: a library of skills as versioned JSON with a published schema.

The same skills give the same bytes; reading them back gives the same skills, to the last bit.
"""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from importlib.resources import files
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
from jsonschema import Draft202012Validator

from keyphase import __version__
from keyphase.demonstration import UNIT_TOLERANCE, Array
from keyphase.errors import ParameterError, SkillError
from keyphase.files.writing import write_whole
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, EndCondition
from keyphase.skills.primitive import Constants, Primitive
from keyphase.skills.skill import Skill

FORMAT = "keyphase skills"
VERSION = 1


@dataclass(frozen=True, eq=False)
class SkillLibrary:
    """Skills in the order of their plan, and the name of the demonstration they came from."""

    demonstration: str
    skills: tuple[Skill, ...]


def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of a skill file."""
    return json.loads((files("keyphase.skills") / "skills.schema.json").read_text("utf-8"))


def skill_text(library: SkillLibrary) -> str:
    """The library as the text of a skill file."""
    content = {
        "format": FORMAT,
        "version": VERSION,
        "software": f"keyphase {__version__}",
        "demonstration": library.demonstration,
        "skills": [_skill_values(s) for s in library.skills],
    }
    return json.dumps(content, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def library_of_text(text: str, name: str = "skill file") -> SkillLibrary:
    """The library in the text of a skill file; `name` is used in messages.

    Raises SkillError where the text is no JSON, does not follow the schema or holds skills that
    cannot be executed.
    """
    content = _parsed(text, name)
    error = next(iter(Draft202012Validator(schema()).iter_errors(content)), None)
    if error is not None:
        raise SkillError(
            f"{name} is no skill file of version {VERSION}: at {error.json_path} "
            f"{error.message[:200]}; export the skills again."
        )
    try:
        skills = tuple(_skill(values) for values in content["skills"])
    except ParameterError as refused:
        raise SkillError(f"{name}: {refused}") from refused
    return SkillLibrary(content["demonstration"], skills)


def write_skills(path: Path, library: SkillLibrary) -> None:
    """Write a skill file whole. Raises SkillError where the folder takes no files."""
    write_whole(path, skill_text(library).encode(), refusal=SkillError)


def read_skills(path: Path) -> SkillLibrary:
    """Read a skill file. Raises SkillError where it is missing, damaged or not one."""
    try:
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise SkillError(f"{path} cannot be read as a skill file ({error}).") from error
    return library_of_text(text, str(path))


def _skill_values(skill: Skill) -> dict[str, Any]:
    return {
        "label": skill.label,
        "connecting": skill.connecting,
        "demonstrated_s": skill.demonstrated_s,
        "end_condition": _end_values(skill.end_condition),
        "end_position_m": skill.end_position_m.tolist(),
        "end_orientation_wxyz": skill.end_orientation_wxyz.tolist(),
        "travel_direction": skill.travel_direction,
        "offset_m": skill.offset_m,
        "travel_limit_m": skill.travel_limit_m,
        "timeout_s": skill.timeout_s,
        "force_limit_N": skill.force_limit_N,
        "primitive": _primitive_values(skill.primitive),
    }


def _end_values(end: EndCondition) -> dict[str, Any]:
    if isinstance(end, ContactEnd):
        direction = [float(c) for c in end.direction]
        return {"kind": "contact", "direction": direction, "threshold_N": end.threshold_N}
    return {
        "kind": "configuration",
        "position_tolerance_m": end.position_tolerance_m,
        "rotation_tolerance_rad": end.rotation_tolerance_rad,
    }


def _primitive_values(primitive: Primitive) -> dict[str, Any]:
    return {
        "duration_s": primitive.duration_s,
        "start_position_m": primitive.start_position_m.tolist(),
        "goal_position_m": primitive.goal_position_m.tolist(),
        "start_orientation_wxyz": primitive.start_orientation_wxyz.tolist(),
        "goal_orientation_wxyz": primitive.goal_orientation_wxyz.tolist(),
        "centres": primitive.centres.tolist(),
        "widths": primitive.widths.tolist(),
        "weights": primitive.weights.tolist(),
        "scaled": primitive.scaled.tolist(),
        "oriented": primitive.oriented,
        "constants": asdict(primitive.constants),
    }


def _skill(values: Mapping[str, Any]) -> Skill:
    stretch, direction = values["demonstrated_s"], values["travel_direction"]
    return Skill(
        label=values["label"],
        connecting=values["connecting"],
        primitive=_primitive(values["primitive"]),
        end_condition=_end(values["end_condition"]),
        end_position_m=_numbers(values["end_position_m"]),
        end_orientation_wxyz=_quaternion(values["end_orientation_wxyz"]),
        travel_direction=None if direction is None else tuple(map(float, direction)),  # pyright: ignore
        offset_m=float(values["offset_m"]),
        travel_limit_m=float(values["travel_limit_m"]),
        timeout_s=float(values["timeout_s"]),
        force_limit_N=float(values["force_limit_N"]),
        demonstrated_s=None if stretch is None else (float(stretch[0]), float(stretch[1])),
    )


def _end(values: Mapping[str, Any]) -> EndCondition:
    if values["kind"] == "contact":
        x, y, z = map(float, values["direction"])
        return ContactEnd((x, y, z), float(values["threshold_N"]))
    return ConfigurationEnd(
        float(values["position_tolerance_m"]), float(values["rotation_tolerance_rad"])
    )


def _primitive(values: Mapping[str, Any]) -> Primitive:
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
        constants=Constants(**{k: float(v) for k, v in values["constants"].items()}),
    )


def _numbers(values: Any) -> Array:
    return np.array(values, dtype=np.float64)


def _quaternion(values: Any) -> Array:
    wxyz = _numbers(values)
    if not abs(float(np.linalg.norm(wxyz)) - 1.0) <= UNIT_TOLERANCE:
        raise SkillError(
            f"An orientation must be a unit quaternion w x y z, but the file has {values}; "
            "export the skills again."
        )
    return wxyz


def _parsed(text: str, name: str) -> Any:
    def refuse(constant: str) -> NoReturn:
        raise ValueError(f"{constant} is no number")

    try:
        return json.loads(text, parse_constant=refuse)
    except (ValueError, RecursionError) as error:
        raise SkillError(
            f"{name} must be JSON as keyphase writes it, but is not ({error}); "
            "export the skills again."
        ) from error
