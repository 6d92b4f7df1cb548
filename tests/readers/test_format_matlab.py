"""MATLAB files and single NumPy arrays, written with scipy and numpy."""

from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from keyphase.errors import DemonstrationError
from keyphase.readers import parse_recipe, read

TABLE = np.column_stack([np.arange(50) / 10, np.arange(150).reshape(50, 3) / 100])


def test_variables_and_fields_of_a_matlab_file_are_columns(tmp_path: Path) -> None:
    path = tmp_path / "run.mat"
    savemat(path, {"t": TABLE[:, :1], "robot": {"tool": TABLE[:, 1:]}})
    recipe = parse_recipe(
        'time = {column = "t", unit = "s"}\nposition = {columns = "robot.tool[*]", unit = "m"}',
        "r",
    )
    demonstration = read(path, recipe)
    np.testing.assert_array_equal(demonstration.time_s, TABLE[:, 0])
    np.testing.assert_array_equal(demonstration.position_m, TABLE[:, 1:])


def test_an_array_is_read_by_the_numbers_of_its_columns(tmp_path: Path) -> None:
    path = tmp_path / "run.npy"
    np.save(path, TABLE)
    recipe = parse_recipe(
        'time = {column = 0, unit = "s"}\nposition = {columns = [1, 2, 3], unit = "m"}', "r"
    )
    np.testing.assert_array_equal(read(path, recipe).position_m, TABLE[:, 1:])


def test_objects_are_never_unpickled(tmp_path: Path) -> None:
    path = tmp_path / "run.npy"
    np.save(path, np.array([{"a": 1}], dtype=object), allow_pickle=True)
    with pytest.raises(DemonstrationError, match="pickled Python objects"):
        read(
            path,
            parse_recipe("time.rate_hz = 1\nposition = {columns = [0, 1, 2], unit = 'm'}", "r"),
        )


@pytest.mark.parametrize("name", ["run.mat", "run.npy"])
def test_a_cut_file_is_refused(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    savemat(path, {"t": TABLE}) if name == "run.mat" else np.save(path, TABLE)
    path.write_bytes(path.read_bytes()[:180])
    with pytest.raises(DemonstrationError, match=r"cannot be read|holds none"):
        read(
            path,
            parse_recipe("time.rate_hz = 1\nposition = {columns = [0, 1, 2], unit = 'm'}", "r"),
        )
