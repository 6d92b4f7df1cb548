"""Several demonstrations in one table: one below the other, or side by side."""

from pathlib import Path

import numpy as np
import pytest

from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers import find_recordings, read

BELOW = "episode,t,x,y,z\n" + "".join(
    f"{name},{i / 25:.2f},{i + 100 * n},0,0\n" for n, name in enumerate("abc") for i in range(20)
)
PLAIN = 'time = {column = "t", unit = "s"}\nposition = {columns = ["x", "y", "z"], unit = "mm"}\n'
ARMS = "t,lx,ly,lz,rx,ry,rz\n" + "".join(f"{i / 50},0,{i},0,1,0,{2 * i}\n" for i in range(20))
BOTH = """
time = {column = "t", unit = "s"}
[[demonstration]]
name = "left"
position = {columns = ["lx", "ly", "lz"], unit = "mm"}
[[demonstration]]
name = "right"
position = {columns = ["rx", "ry", "rz"], unit = "mm"}
"""


def table(folder: Path, text: str, recipe: str) -> Path:
    (folder / "recipe.toml").write_text(recipe)
    (folder / "run.csv").write_text(text)
    return folder / "run.csv"


@pytest.mark.parametrize(
    ("told", "names"),
    [('demonstration = "episode"', ["a", "b", "c"]), ("time_starts_again = true", ["0", "1", "2"])],
)
def test_rows_one_below_the_other_are_recordings_of_their_own(
    tmp_path: Path, told: str, names: list[str]
) -> None:
    path = table(tmp_path, BELOW, f"table.{told}\n{PLAIN}")
    assert [f.path.name for f in find_recordings([tmp_path])] == [f"run.csv#{n}" for n in names]
    second = read(f"{path}#{names[1]}")
    assert second.name == f"run#{names[1]}"
    np.testing.assert_allclose(second.position_m[:, 0], (np.arange(20) + 100) / 1000)


def test_two_arms_side_by_side_are_two_recordings(tmp_path: Path) -> None:
    path = table(tmp_path, ARMS, BOTH)
    assert [f.path.name for f in find_recordings([tmp_path])] == ["run.csv#left", "run.csv#right"]
    left, right = read(f"{path}#left"), read(f"{path}#right")
    np.testing.assert_allclose(left.position_m[:, 1], np.arange(20) / 1000)
    np.testing.assert_allclose(right.position_m[:, 2], 2 * np.arange(20) / 1000)


def test_a_table_of_several_is_not_read_as_one(tmp_path: Path) -> None:
    path = table(tmp_path, ARMS, BOTH)
    with pytest.raises(DemonstrationError, match=r"left, right; none .* run\.csv#left"):
        read(path)


def test_a_name_in_a_file_of_one_recording_is_refused(tmp_path: Path) -> None:
    native = tmp_path / "run.csv"
    rows = "".join(f"{i / 50},0,{i},0\n" for i in range(20))
    native.write_text(f"time_s,position_x_m,position_y_m,position_z_m\n{rows}")
    np.savez(tmp_path / "run.npz", time_s=np.arange(20) / 50, position_m=np.eye(20)[:, :3])
    for name in ("run.csv", "run.npz"):
        with pytest.raises(DemonstrationError, match=r"one recording; name it without #left"):
            read(tmp_path / f"{name}#left")


def test_demonstrations_that_would_have_one_name_are_not_taken_for_one(tmp_path: Path) -> None:
    recipe = f'table.demonstration = "episode"\n{PLAIN}'
    path = table(tmp_path, BELOW.replace("a,", "pick/1,").replace("b,", "pick_1,"), recipe)
    with pytest.raises(RecipeError, match="'pick/1' and 'pick_1' would both be called"):
        read(f"{path}#pick_1")


def test_a_demonstration_without_a_name_can_be_named(tmp_path: Path) -> None:
    recipe = f'table.demonstration = "episode"\n{PLAIN}'
    path = table(tmp_path, BELOW.replace("\nb,", "\n,"), recipe)
    found = [found.path.name for found in find_recordings([tmp_path])]
    assert found == ["run.csv#a", "run.csv#nameless", "run.csv#c"]
    assert len(read(f"{path}#nameless")) == 20


def test_two_of_one_name_are_refused(tmp_path: Path) -> None:
    path = table(tmp_path, ARMS, BOTH.replace('"right"', '"left"'))
    with pytest.raises(RecipeError, match="needs a name of its own"):
        read(path)


def test_seconds_and_nanoseconds_in_two_columns_keep_all_digits(tmp_path: Path) -> None:
    rows = "".join(f"1700000000,{i * 20_000_000},{i},0,0\n" for i in range(30))
    recipe = PLAIN.replace('column = "t", unit = "s"', 'seconds = "sec", nanoseconds = "nanosec"')
    path = table(tmp_path, f"sec,nanosec,x,y,z\n{rows}", recipe)
    demonstration = read(path)
    np.testing.assert_allclose(demonstration.time_s, np.arange(30) / 50, atol=1e-12)
    assert "stamped 1700000000.000000000 s" in " ".join(demonstration.notices)


def test_a_header_behind_a_comment_mark_names_the_columns(tmp_path: Path) -> None:
    recipe = PLAIN + 'table.separator = "whitespace"\n'
    path = table(tmp_path, "# t x y z\n0 1 2 3\n1 2 3 4\n", recipe)
    np.testing.assert_allclose(read(path).position_m[1], [0.002, 0.003, 0.004])
