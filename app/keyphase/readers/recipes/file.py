"""Recipes as files: TOML, every word of which is known and checked."""

import hashlib
import re
import tomllib
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeGuard

from keyphase.errors import RecipeError
from keyphase.files.reading import read_regular
from keyphase.readers.recipes.channels import named_key
from keyphase.readers.recipes.keys import Keys
from keyphase.readers.recipes.presets import merged, preset_values
from keyphase.readers.recipes.recipe import Recipe
from keyphase.readers.recipes.sections import (
    events_of,
    joint_torques_of,
    load_of,
    named_of,
    orientation_of,
    pose_of,
    robot_of,
    rows_of,
    scaled_of,
    split_of,
    table_of,
    time_of,
    wrench_file_of,
    wrench_of,
)

_MAX_RECIPE_BYTES = 64 * 1024
_TOO_DEEP = re.compile(r"""(?<![\w"'-])(?:[\w"'-]++[ \t]*+\.[ \t]*+){12}""")
_MAX_JOINTS = 100
_MAX_PARTS = 100
_CHANNELS = (
    *("pose", "position", "orientation", "force", "torque", "joints", "joint_torques", "gripper"),
)


def load_recipe(path: Path | str) -> Recipe:
    """Read and check a recipe file.

    Raises RecipeError for what is no TOML, for words that are not known (with the nearest one that
    is), for missing ones and for values that cannot be.
    """
    path = Path(path)
    try:
        data = read_regular(path, _MAX_RECIPE_BYTES)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise RecipeError(
            f"{path}: the recipe cannot be read ({reason}); check the path and that it is a recipe."
        ) from error
    try:
        return parse_recipe(data.decode(), str(path))
    except UnicodeDecodeError as error:
        raise RecipeError(f"{path}: a recipe must be UTF-8 text; save it as such.") from error


def parse_recipe(text: str, name: str) -> Recipe:
    """The recipe written in `text`; raises RecipeError as `load_recipe` does."""
    # The parser takes minutes over keys nested thousands deep.
    if len(text) > _MAX_RECIPE_BYTES or _TOO_DEEP.search(text):
        raise RecipeError(
            f"{name}: a recipe has at most {_MAX_RECIPE_BYTES} characters and no key of more than "
            "twelve parts; check that it is a recipe."
        )
    try:
        values = tomllib.loads(text)
    except (ValueError, RecursionError) as error:
        raise RecipeError(f"{name}: the recipe must be TOML, but is not ({error}).") from error
    digest = hashlib.sha256(text.encode(errors="backslashreplace")).hexdigest()
    recipe = recipe_of(values, name)
    parts = {part: replace(one, sha256=digest) for part, one in recipe.parts.items()}
    return replace(recipe, sha256=digest, parts=parts)


def recipe_of(values: Mapping[str, Any], name: str) -> Recipe:
    """The recipe in the values of a TOML file; raises RecipeError as `load_recipe` does."""
    values = dict(values)
    if "preset" in values:
        values = merged(preset_values(values.pop("preset"), name), values)
    several = values.pop("demonstration", None)
    if several is None:
        return _one(values, name)
    parts = {
        part: _one(merged(values, own), f"{name}#{part}") for part, own in _named(several, name)
    }
    first = next(iter(parts.values()))
    return replace(first, name=name, parts=parts)


def _named(several: Any, name: str) -> list[tuple[str, dict[str, Any]]]:
    """Each [[demonstration]] by its name, without it."""
    found: dict[str, dict[str, Any]] = {}
    for one in several if isinstance(several, list) else [None]:
        own = dict(one) if isinstance(one, dict) else {}
        part = own.pop("name", None)
        if not _is_plain(part) or part in found:
            raise RecipeError(
                f"{name}: each [[demonstration]] needs a name of its own, without # and /; add it."
            )
        found[part] = own
    if not 0 < len(found) <= _MAX_PARTS:
        raise RecipeError(f"{name}: expected 1 to {_MAX_PARTS} of [[demonstration]].")
    return list(found.items())


def _is_plain(name: object) -> TypeGuard[str]:
    if not isinstance(name, str) or not 0 < len(name) <= 100:
        return False
    return name.isprintable() and not set(name) & set("#/\\")


def _one(values: Mapping[str, Any], name: str) -> Recipe:
    keys = Keys(values, name)
    table = keys.section("table")
    split = split_of(table)
    time = time_of(keys.needed_section("time"))
    sections = {channel: keys.section(channel) for channel in _CHANNELS}
    clocks = {
        channel: clock
        for channel, section in sections.items()
        if section is not None and (clock := section.column("time"))
    }
    offsets = {
        channel: offset
        for channel, section in sections.items()
        if section is not None and (offset := section.number("clock_offset_s"))
    }
    named = named_of(keys.section("channels"))
    clocks |= {named_key(n): clock for n, (_, clock) in named.items() if clock is not None}
    recipe = Recipe(
        name=name,
        table=table_of(table),
        time=time,
        rows=rows_of(keys.section("rows")),
        pose=pose_of(sections["pose"]),
        position=scaled_of(sections["position"], (3,), "length"),
        orientation=orientation_of(sections["orientation"]),
        force=load_of(sections["force"], "force"),
        torque=load_of(sections["torque"], "torque"),
        wrench=wrench_of(keys.section("wrench")),
        joints=scaled_of(sections["joints"], range(1, _MAX_JOINTS + 1), "angle"),
        robot=robot_of(keys.section("robot"), Path(name).parent),
        joint_torques=joint_torques_of(sections["joint_torques"], range(1, _MAX_JOINTS + 1)),
        gripper=scaled_of(sections["gripper"], (1, 2), "opening"),
        named={name: column for name, (column, _) in named.items()},
        events=events_of(keys.section("events")),
        clocks=clocks,
        clock_offsets_s=offsets,
        split=split,
        wrench_file=wrench_file_of(keys.section("wrench_file")),
    )
    keys.finish()
    _refuse_contradictions(recipe)
    return recipe


def _refuse_contradictions(recipe: Recipe) -> None:
    _refuse_without_place(recipe)
    if recipe.pose is not None and recipe.position is not None:
        raise RecipeError(f"{recipe.name}: expected either [position] or [pose]; keep one of them.")
    if recipe.pose and recipe.orientation:
        raise RecipeError(
            f"{recipe.name}: [pose] holds the orientation already; leave [orientation] out."
        )
    loaded = recipe.force is not None or recipe.torque is not None
    if loaded != (recipe.wrench is not None):
        raise RecipeError(
            f"{recipe.name}: [wrench] with frame and sign must stand where [force] or [torque] do, "
            "and only there; add or remove it."
        )
    if recipe.wrench_file and (not loaded or recipe.clocks.keys() & {"force", "torque"}):
        raise RecipeError(
            f"{recipe.name}: [wrench_file] holds [force] or [torque] and their clock; add one of "
            "them, without time."
        )
    if recipe.wrench and recipe.wrench.frame == "tool" and not (recipe.pose or recipe.orientation):
        raise RecipeError(
            f"{recipe.name}: a wrench in the tool frame needs the orientation to be turned into "
            "the base frame; add [orientation]."
        )
    if recipe.table.decimal == recipe.table.separator:
        raise RecipeError(
            f"{recipe.name}: the comma cannot be both separator and decimal; change one of them."
        )


def _refuse_without_place(recipe: Recipe) -> None:
    placed = recipe.pose is not None or recipe.position is not None
    if not placed and recipe.robot is None:
        told = "; add one of them."
        if recipe.joints is not None:
            told = (
                ", which joint angles alone do not say; log it with them, or name your robot in "
                '[robot] urdf = "arm.urdf", tool_frame = "tool0".'
            )
        raise RecipeError(
            f"{recipe.name}: [position] or [pose] is missing: keyphase needs the place of the "
            f"tool{told}"
        )
    if recipe.robot is not None and recipe.joints is None:
        raise RecipeError(f"{recipe.name}: [robot] says where the tool is by [joints]; add them.")
    if not placed and recipe.orientation is not None:
        raise RecipeError(
            f"{recipe.name}: [robot] gives the orientation already; leave [orientation] out."
        )
    if recipe.joint_torques is None:
        return
    if recipe.robot is None or recipe.force is not None or recipe.torque is not None:
        raise RecipeError(
            f"{recipe.name}: [joint_torques] become a wrench by [robot], where none was measured; "
            "add [robot], or leave out either the torques or [force] and [torque]."
        )
