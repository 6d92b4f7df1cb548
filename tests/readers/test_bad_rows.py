"""Rows that were never measured: dropped where a recipe says so; time that starts again is said."""

import numpy as np
import pytest

from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers import parse_recipe, read

RECIPE = """
[time]
column = "t"
unit = "s"
[position]
columns = ["x", "y", "z"]
unit = "m"
"""


def table(path, *, time=None, bad=()):
    """A stroke at 50 Hz, some of whose rows were not read."""
    time = np.arange(100) / 50 if time is None else time
    rows = [f"{t!r},{0.4 + 0.001 * i!r},0.1,0.3" for i, t in enumerate(time.tolist())]
    for row in bad:
        rows[row] = f"{time.tolist()[row]!r},0,0,0"
    path.write_text("\n".join(["t,x,y,z", *rows]) + "\n")
    return path


def test_rows_of_zeros_are_dropped_where_missing_is_zero(tmp_path):
    path = table(tmp_path / "a.csv", bad=[0, 40, 41])
    found = read(path, parse_recipe(f"{RECIPE}[rows]\nmissing = 0\n", "my"))
    assert len(found) == 97
    assert any("Dropped 3 rows whose place is 0, first line 2" in text for text in found.notices)


def test_rows_the_tool_jumped_to_and_back_are_dropped_on_request(tmp_path):
    path = table(tmp_path / "a.csv", bad=[40, 70, 71])
    found = read(path, parse_recipe(f'{RECIPE}[rows]\noutliers = "drop"\n', "my"))
    assert len(found) == 97
    assert np.ptp(found.position_m[:, 0]) == pytest.approx(0.099)
    assert any("first line 42" in text for text in found.notices)


def test_without_a_word_in_the_recipe_they_stay_and_are_told(tmp_path):
    found = read(table(tmp_path / "a.csv", bad=[40]), parse_recipe(RECIPE, "my"))
    assert len(found) == 100
    assert any("jumps" in text and "and back" in text for text in found.notices)


def test_a_table_of_nothing_but_missing_rows_is_refused(tmp_path):
    path = table(tmp_path / "a.csv", bad=range(99))
    with pytest.raises(DemonstrationError, match="only 1 were measured"):
        read(path, parse_recipe(f"{RECIPE}[rows]\nmissing = 0\n", "my"))


def test_time_that_starts_over_names_the_lines(tmp_path):
    time = np.tile(np.arange(40) / 50, 3)
    with pytest.raises(DemonstrationError, match=r"line 42.*line 82.*3 recordings"):
        read(table(tmp_path / "a.csv", time=time), parse_recipe(RECIPE, "my"))


def test_stamps_stand_with_all_their_digits(tmp_path):
    time = 1732862240.25 + np.arange(100) / 50
    time[50] = time[49]
    with pytest.raises(DemonstrationError, match=r"1732862241\.23 s comes after 1732862241\.23 s"):
        read(table(tmp_path / "a.csv", time=time), parse_recipe(RECIPE, "my"))


def test_a_column_of_whole_seconds_is_called_too_coarse(tmp_path):
    with pytest.raises(DemonstrationError, match="too coarse"):
        read(table(tmp_path / "a.csv", time=np.arange(100.0) // 50), parse_recipe(RECIPE, "my"))


def test_the_recipe_is_known_again_by_its_text(tmp_path):
    path = table(tmp_path / "a.csv")
    one, other = (read(path, parse_recipe(RECIPE + more, "my")).source for more in ("", "\n"))
    assert one is not None and other is not None and one.recipe == "my"  # noqa: PT018
    assert one.recipe_sha256 != other.recipe_sha256


@pytest.mark.parametrize(
    "text",
    [
        "a." * 20_000 + "b = 1",
        " . ".join("abcdefghijklmnop") + " = 1",
        f"[{'.'.join('a' * 100)}]",
        "x = 0x" + "f" * 60_000,
        "x = " + "[" * 30_000,
        "x = '" + "y" * 70_000 + "'",
        f"{RECIPE}[rows]\nirregular = 'resample'\nrate_hz = 1e6",
    ],
    ids=lambda text: text[:12],
)
def test_recipes_that_would_take_minutes_or_gigabytes_are_refused(tmp_path, text):
    with pytest.raises(RecipeError):
        read(table(tmp_path / "a.csv"), parse_recipe(text, "my"))


def test_a_device_is_no_recipe(tmp_path):
    with pytest.raises(RecipeError, match="no regular file"):
        read(table(tmp_path / "a.csv"), "/dev/zero")
