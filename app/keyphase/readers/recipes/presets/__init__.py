"""Recipes that ship with a format: what is known of it, in the language of recipes.

A preset names the columns by which its files are known (`needs`). What a format leaves open, such
as a rate or the sign of a wrench, its preset leaves open, too, and a recipe of a few lines says it:
`preset = "umi"`, then the section that is missing.
"""

import difflib
import tomllib
from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files
from typing import Any

from keyphase.errors import RecipeError

_ENDING = ".toml"
_NEEDS, _EXAMPLE = "needs", "example"

ROBOT_QUESTIONS = ('# urdf = "arm.urdf"', '# tool_frame = "tool0"    # the link that is the tool')
WRENCH_QUESTIONS = {
    "frame": '# frame = "base"    # or "tool": in whose axes is the wrench written?',
    "sign": "# sign = 1          # 1: pressing down on a table gives a force upwards; else -1",
}
"""What a person says of a wrench, by key, each as a comment to complete."""


@cache
def preset_names() -> tuple[str, ...]:
    """All presets, in alphabetical order."""
    entries = files(__name__).iterdir()
    return tuple(sorted(e.name.removesuffix(_ENDING) for e in entries if e.name.endswith(_ENDING)))


def preset_values(name: Any, recipe: str) -> dict[str, Any]:
    """What a preset says, as the values of a recipe. Raises RecipeError for an unknown one."""
    if name not in preset_names():
        near = difflib.get_close_matches(str(name)[:60], preset_names(), n=1)
        hint = f"did you mean {near[0]!r}?" if near else f"they are {', '.join(preset_names())}."
        raise RecipeError(f"{recipe}: there is no preset {str(name)[:60]!r}; {hint}")
    values = _shipped(str(name))
    return {key: value for key, value in values.items() if key not in (_NEEDS, _EXAMPLE)}


def example_of(name: str) -> str:
    """A path of a recording that a preset reads."""
    return str(_shipped(name)[_EXAMPLE])


def fitting_preset(columns: Iterable[str]) -> str | None:
    """The preset all of whose needed columns are there; of several, the one that needs most."""
    there = set(columns)
    fitting = [name for name in preset_names() if there.issuperset(_shipped(name)[_NEEDS])]
    return max(fitting, key=lambda name: len(_shipped(name)[_NEEDS]), default=None)


def preset_sides(columns: Iterable[str]) -> tuple[str, ...]:
    """The tools side by side by the fitting preset; none where it knows one, or none fits."""
    name = fitting_preset(columns)
    several = _shipped(name).get("demonstration", ()) if name else ()
    return tuple(one["name"] for one in several)


def left_open(name: str) -> dict[str, list[str]]:
    """What a preset leaves for a person to say, by section, each as a comment to complete."""
    values = _shipped(name)
    several = values.get("demonstration") or ({},)
    every = {**values, **several[0]}
    wrench, loaded = every.get("wrench", {}), bool({"force", "torque"} & every.keys())
    found: dict[str, list[str]] = {}
    if "time" not in every:
        found["time"] = ["# rate_hz = 50    # how many rows a second?"]
    if loaded and not {"frame", "sign"} <= wrench.keys():
        found["wrench"] = [line for key, line in WRENCH_QUESTIONS.items() if key not in wrench]
    if not {"pose", "position"} & every.keys():
        found["robot"] = list(ROBOT_QUESTIONS)
    if "joint_torques" in every:
        found["joint_torques"] = ["# sign = 1    # 1: torques that act on the robot; else -1"]
    return found


def merged(below: Mapping[str, Any], above: Mapping[str, Any]) -> dict[str, Any]:
    """Values of two recipes; where both say something, the one above says it.

    A section that says its columns or its rate anew says all of itself anew.
    """
    out = dict(below)
    for key, value in above.items():
        under = out.get(key)
        whole = isinstance(value, dict) and not {"columns", "column", "rate_hz"}.isdisjoint(value)
        if isinstance(under, dict) and isinstance(value, dict) and not whole:
            out[key] = {**under, **value}
        else:
            out[key] = value
    return out


@cache
def _shipped(name: str) -> dict[str, Any]:
    return tomllib.loads((files(__name__) / f"{name}{_ENDING}").read_text())
