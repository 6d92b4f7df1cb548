"""A recipe that does not say how to read a table is refused, with the word that would."""

from pathlib import Path

import pytest

from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers import load_recipe, parse_recipe, read

TIME = '[time]\ncolumn = "t"\nunit = "s"\n'
POSITION = '[position]\ncolumns = ["x", "y", "z"]\nunit = "m"\n'
TURN = '[orientation]\ncolumns = ["a", "b", "c"]\n'
FORCE = '[force]\ncolumns = ["a", "b", "c"]\nunit = "N"\n'
BASE = '[wrench]\nframe = "base"\nsign = 1\n'
SOUND = TIME + POSITION

REFUSED = {
    "no TOML": ("[time", "the recipe must be TOML"),
    "unknown section": (SOUND + "[positions]", r"'positions' is not a word .*mean 'position'\?"),
    "unknown key": (
        TIME + "form_zero = true\n" + POSITION,
        r"\[time\]: 'form_zero' .*'from_zero'\?",
    ),
    "unknown choice": (
        SOUND + '[rows]\nirregular = "resampel"',
        r"\[rows\]: irregular must be one of 'leave', 'refuse', 'resample', .*mean 'resample'\?",
    ),
    "unknown unit": (
        TIME + POSITION.replace('"m"', '"milimeter"'),
        r"\[position\]: expected a unit of length \(m, .*but found 'milimeter'",
    ),
    "unit of another quantity": (
        SOUND + FORCE.replace('"N"', '"Nm"') + BASE,
        r"\[force\]: expected a unit of force \(N, .*'Nm'; did you mean N\?",
    ),
    "no unit": ('[time]\ncolumn = "t"\n' + POSITION, r"\[time\]: the key 'unit' is missing"),
    "no time": (POSITION, r"the section \[time\] is missing"),
    "time twice": (TIME + "rate_hz = 5\n" + POSITION, "either column or rate_hz"),
    "rate zero": ("[time]\nrate_hz = 0\n" + POSITION, "rate_hz must be a positive number, but"),
    "rate infinite": ("[time]\nrate_hz = inf\n" + POSITION, "rate_hz must be a positive number"),
    "no position": (TIME, r"\[position\] or \[pose\] is missing"),
    "joints only": (
        TIME + '[joints]\ncolumns = ["a"]\nunit = "rad"',
        "joint angles alone do not say",
    ),
    "position twice": (
        SOUND + '[pose]\ncolumns = "m*"\nunit = "m"\nlayout = "row_major"',
        r"either \[position\] or \[pose\]",
    ),
    "orientation twice": (
        TIME + '[pose]\ncolumns = "m*"\nunit = "m"\nlayout = "row_major"\n'
        + TURN + 'kind = "euler"\nsequence = "xyz"\nunit = "rad"',
        r"\[pose\] holds the orientation already",
    ),
    "section is no section": ("time = 5\n" + POSITION, r"time must be a section, but is 5"),
    "column is a number with a point": (
        TIME + POSITION.replace('"x"', "1.5"), "columns must be a list of names or indices"
    ),
    "no columns": (TIME + '[position]\ncolumns = []\nunit = "m"', "columns must be a list"),
    "order unknown": (SOUND + TURN + 'kind = "quaternion"\norder = "wxzy"', "'wxyz', 'xyzw'"),
    "order not said": (SOUND + TURN + 'kind = "quaternion"', "is missing, which is one of 'wxyz'"),
    "sequence impossible": (
        SOUND + TURN + 'kind = "euler"\nsequence = "xxy"\nunit = "rad"',
        "sequence must be three axes",
    ),
    "sequence mixed": (
        SOUND + TURN + 'kind = "euler"\nsequence = "xYz"\nunit = "rad"',
        "sequence must be three axes",
    ),
    "word of another kind": (
        SOUND + TURN + 'kind = "euler"\nsequence = "xyz"\nunit = "rad"\norder = "wxyz"',
        r"\[orientation\]: 'order' is not a word that can stand here",
    ),
    "wrench not described": (SOUND + FORCE, r"\[wrench\] with frame and sign must stand"),
    "wrench alone": (SOUND + BASE, r"\[wrench\] with frame and sign must stand"),
    "sign": (SOUND + FORCE + BASE.replace("1", "2"), r"sign must be 1 .* or -1 .* but is 2"),
    "sign as truth": (SOUND + FORCE + BASE.replace("1", "true"), "but is True"),
    "tool without orientation": (
        SOUND + FORCE + '[wrench]\nframe = "tool"\nsign = 1',
        r"needs the orientation.*add \[orientation\]",
    ),
    "offset of two": (SOUND + FORCE + "offset = [1, 2]\n" + BASE, "offset must be three numbers"),
    "two offsets": (
        SOUND + FORCE + "offset = [1, 2, 3]\noffset_from_first_s = 1\n" + BASE,
        "offset or offset_from_first_s, not both",
    ),
    "resampling to what": (SOUND + '[rows]\nirregular = "resample"', "give both or neither"),
    "rate without resampling": (SOUND + "[rows]\nrate_hz = 5", "give both or neither"),
    "comma twice": ('[table]\ndecimal = ","\n' + SOUND, "cannot be both separator and decimal"),
    "negative lines": ("[table]\nskip_lines = -1\n" + SOUND, "a whole number from 0, but is -1"),
    "format": (
        '[time]\ncolumn = "t"\nformat = "%Q"\n' + POSITION, r"format must be 'iso' or a format"
    ),
}  # fmt: skip


@pytest.mark.parametrize(("recipe", "reason"), REFUSED.values(), ids=REFUSED.keys())
def test_a_recipe_is_refused(recipe: str, reason: str) -> None:
    with pytest.raises(RecipeError, match=rf"^my\.toml: (.*: )?.*{reason}"):
        parse_recipe(recipe, "my.toml")


def test_a_recipe_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(RecipeError, match=r"no\.toml: the recipe cannot be read"):
        load_recipe(tmp_path / "no.toml")


def test_a_recipe_that_is_no_text_is_refused(tmp_path: Path) -> None:
    (tmp_path / "odd.toml").write_bytes(b"\xff\xfe")
    with pytest.raises(RecipeError, match=r"odd\.toml: a recipe must be UTF-8"):
        load_recipe(tmp_path / "odd.toml")


MISFITS = {
    "name": (SOUND.replace('"z"', '"zed"'), r"\[position\]: .*'zed'; did you mean 'zd'\?"),
    "name doubled": (SOUND.replace('"z"', '"w"'), "names 'w' 2 times; choose the column by its"),
    "index": (SOUND.replace('"z"', "9"), "column indices from 0 to 6 .* but found 9"),
    "negative index": (SOUND.replace('"z"', "-1"), "column indices from 0 to 6 .* but found -1"),
    "same column twice": (SOUND.replace('"z"', '"x"'), "expected 3 different columns"),
    "pattern matches too few": (
        SOUND.replace('["x", "y", "z"]', '"x*"'), r"3 different columns .* 'x\*' gives 1"
    ),
    "names without header": ("[table]\nheader = false\n" + SOUND, "only where the table has a"),
}  # fmt: skip


@pytest.mark.parametrize(("recipe", "reason"), MISFITS.values(), ids=MISFITS.keys())
def test_a_recipe_that_does_not_fit_the_table_is_refused(
    tmp_path: Path, recipe: str, reason: str
) -> None:
    path = tmp_path / "table.csv"
    path.write_text("t,x,y,z,zd,w,w\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n")
    with pytest.raises(RecipeError, match=rf"^my\.toml: .*{reason}"):
        read(path, parse_recipe(recipe, "my.toml"))


def test_a_stamp_that_is_none_is_refused_with_its_line(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_text("t,x,y,z\n2024-05-01T10:00,1,2,3\nlater,1,2,3\n")
    recipe = parse_recipe('[time]\ncolumn = "t"\nformat = "iso"\n' + POSITION, "my.toml")
    with pytest.raises(
        DemonstrationError,
        match=r"table\.csv: line 3, column 't': expected a date and time .*'later'",
    ):
        read(path, recipe)


def test_resampling_beyond_the_limit_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_text("t,x,y,z\n0,1,2,3\n1,1,2,3\n")
    text = SOUND + '[rows]\nirregular = "resample"\nrate_hz = 1e15'
    with pytest.raises(RecipeError, match="more samples than the limit allows"):
        read(path, parse_recipe(text, "my.toml"))
