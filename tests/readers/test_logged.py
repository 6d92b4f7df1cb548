"""What a log holds beside pose and wrench: further channels and events in words."""

from pathlib import Path

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.errors import DemonstrationError, RecipeError
from keyphase.logged import Event
from keyphase.readers import read

RECIPE = """
time = {column = "t", unit = "s"}
position = {columns = ["x", "y", "z"], unit = "m"}
events.column = "note"
[channels]
"motor current" = "i1"
button = "di_0"
"""


def table(folder: Path, recipe: str = RECIPE) -> Path:
    notes = {10: "start", 20: "", 30: "part found"}
    rows, note = ["t,x,y,z,i1,di_0,note"], ""
    for i in range(50):
        note = notes.get(i, note)
        rows.append(f"{i / 50},{i},0,0,{i / 10},{int(15 <= i < 25)},{note}")
    (folder / "run.csv").write_text("\n".join([*rows, ""]))
    (folder / "recipe.toml").write_text(recipe)
    return folder / "run.csv"


def test_further_columns_are_channels_by_name(tmp_path: Path) -> None:
    demonstration = read(table(tmp_path))
    np.testing.assert_allclose(demonstration.channels["motor current"], np.arange(50) / 10)
    assert demonstration.channels["button"].sum() == 10


def test_a_column_of_words_is_events_where_it_changes(tmp_path: Path) -> None:
    assert read(table(tmp_path)).events == (Event(0.2, "start"), Event(0.6, "part found"))


def test_a_button_says_when_it_was_pressed(tmp_path: Path) -> None:
    said = [(one.time_s, one.text) for one in read(table(tmp_path)).happenings]
    assert said == [(0.2, "start"), (0.3, "button on"), (0.5, "button off"), (0.6, "part found")]


def test_a_channel_keeps_its_last_value_between_its_own_times(tmp_path: Path) -> None:
    time = np.arange(40) / 20
    arrays = {"t": time, "p": np.zeros((40, 3)), "tb": np.array([0.0, 0.33, 1.95]), "b": [0, 1, 0]}
    zarr = pytest.importorskip("zarr")
    store = zarr.open_group(tmp_path / "run.zarr", mode="w")
    for name, values in arrays.items():
        store[name] = np.asarray(values)
    (tmp_path / "recipe.toml").write_text(
        'time = {column = "t", unit = "s"}\nposition = {columns = "p[*]", unit = "m"}\n'
        'channels.button = {column = "b", time = "tb"}\n'
    )
    button = read(tmp_path / "run.zarr").channels["button"]
    np.testing.assert_array_equal(button, (time >= 0.33) & (time < 1.95))


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ('channels."a/b" = "i1"', "without a slash"),
        ("channels.current = true", "must be a name or an index"),
        ('channels.current = {time = "t"}', "'column' is missing"),
        ('channels.current = "i2"', "no column 'i2'"),
        ("events.colum = 'note'", "'column' is missing"),
    ],
)
def test_a_wrong_word_is_refused_with_what_is_right(tmp_path: Path, line: str, told: str) -> None:
    plain = RECIPE[: RECIPE.index("events")]
    with pytest.raises(RecipeError, match=told):
        read(table(tmp_path, plain + line))


@pytest.mark.parametrize(
    ("given", "told"),
    [
        ({"channels": {"i": np.zeros(3)}}, r"'i' must have shape \(5,\)"),
        ({"channels": {"i": [0, 1, np.nan, 3, 4]}}, "'i' must be finite, but row 2"),
        ({"channels": {" i": np.zeros(5)}}, "a channel's name must be"),
        ({"events": (Event(0.0, "two\nlines"),)}, "printable characters"),
        ({"events": (Event(np.inf, "late"),)}, "finite time"),
    ],
)
def test_what_cannot_be_logged_is_refused(given: dict, told: str) -> None:
    with pytest.raises(DemonstrationError, match=told):
        Demonstration("run", np.arange(5), np.zeros((5, 3)), **given)
