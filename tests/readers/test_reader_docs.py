"""The documents on formats and recipes miss nothing and show nothing that does not work."""

import re
from pathlib import Path

import pytest

from keyphase.errors import RecipeError
from keyphase.readers import native_csv, native_npz, parse_recipe
from keyphase.readers.recipes import units

DOCS = Path(__file__).parents[2] / "docs"
RECIPES = (DOCS / "recipes.md").read_text()
FORMATS = (DOCS / "formats.md").read_text()

SOUND = {
    "table": "",
    "time": 'column = "t"\nunit = "s"\n',
    "rows": "",
    "position": 'columns = ["x", "y", "z"]\nunit = "m"\n',
    "pose": 'columns = "m*"\nunit = "m"\nlayout = "row_major"\n',
    "orientation": 'kind = "quaternion"\norder = "wxyz"\ncolumns = "q*"\n',
    "force": 'columns = "f*"\nunit = "N"\n',
    "torque": 'columns = "t*"\nunit = "Nm"\n',
    "wrench": 'frame = "base"\nsign = 1\n',
    "gripper": 'columns = "g*"\nunit = "m"\n',
    "joints": 'columns = "j*"\nunit = "rad"\n',
    "joint_torques": 'columns = "t*"\nunit = "Nm"\nsign = 1\n',
    "robot": 'urdf = "arm.urdf"\ntool_frame = "tool0"\n',
    "events": 'column = "w"\n',
    "wrench_file": 'path = "ft.csv"\ncolumn = "t"\nunit = "s"\n',
}
ANY_NAME = ["channels"]
"""Sections in which any name can stand."""


def known_words(recipe: str) -> list[str]:
    with pytest.raises(RecipeError, match="is not a word that can stand here") as refusal:
        parse_recipe(recipe, "recipe")
    listed = re.search(r"which are (.*);", str(refusal.value))
    assert listed is not None
    return listed[1].split(", ")


def test_the_sections_of_a_recipe_are_those_that_are_tested_here() -> None:
    recipe = "surprise = 1\n[time]\nrate_hz = 1\n"
    assert sorted(known_words(recipe)) == sorted([*SOUND, *ANY_NAME])


@pytest.mark.parametrize(("section", "keys"), SOUND.items(), ids=SOUND.keys())
def test_every_word_of_a_section_is_described(section: str, keys: str) -> None:
    time = "" if section == "time" else "[time]\nrate_hz = 1\n"
    words = known_words(f"{time}[{section}]\n{keys}surprise = 1\n")
    assert f"`[{section}]`" in RECIPES
    for word in words:
        assert f"`{word}" in RECIPES, f"docs/recipes.md does not describe {word} in [{section}]"


def test_every_unit_is_listed() -> None:
    for sizes in units._SIZES.values():
        for unit in sizes:
            assert f"`{unit}`" in RECIPES


def test_every_recipe_shown_is_sound() -> None:
    shown = re.findall(r"```toml\n(.*?)```", RECIPES, re.DOTALL)
    assert len(shown) > 3
    for recipe in shown:
        parse_recipe(recipe, "docs/recipes.md")


def test_every_native_name_is_described() -> None:
    for name in native_npz._KNOWN:
        assert f"`{name}`" in FORMATS
    for names in native_csv._GROUPS.values():
        for name in names:
            assert f"`{name}`" in FORMATS


def test_the_tables_of_formats_and_presets_are_those_of_the_code() -> None:
    from keyphase.readers.formats.documented import formats_table, presets_table

    text = (DOCS / "formats.md").read_text()
    assert formats_table() in text
    assert presets_table() in text
