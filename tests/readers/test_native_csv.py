"""The native table: what is saved comes back, and what it refuses, by line and column."""

from pathlib import Path

import numpy as np
import pytest
from demonstration_strategies import demonstrations
from hypothesis import HealthCheck, given, settings

from keyphase.demonstration import Demonstration
from keyphase.errors import DemonstrationError
from keyphase.readers import read, save_csv

CHANNELS = ("time_s", "position_m", "force_N", "torque_Nm", "joints_rad")
HEADER = "time_s,position_x_m,position_y_m,position_z_m"
ROWS = ("0,1,2,3", "0.1,1,2,3", "0.2,1,2,3")


def write(folder: Path, *lines: str, newline: str = "\n", encoding: str = "utf-8") -> Path:
    path = folder / "recording.csv"
    path.write_bytes(newline.join([*lines, ""]).encode(encoding))
    return path


@pytest.mark.slow
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(demonstration=demonstrations())
def test_what_is_saved_is_read_back(tmp_path: Path, demonstration: Demonstration) -> None:
    save_csv(demonstration, tmp_path / "recording.csv")
    back = read(tmp_path / "recording.csv")
    for channel in CHANNELS:
        np.testing.assert_array_equal(getattr(back, channel), getattr(demonstration, channel))
    if demonstration.orientation_wxyz is not None:
        np.testing.assert_allclose(
            back.orientation_wxyz, demonstration.orientation_wxyz, rtol=0, atol=1e-15
        )
    assert (back.orientation_wxyz is None) == (demonstration.orientation_wxyz is None)
    assert back.channels.keys() == demonstration.channels.keys()
    for name, values in demonstration.channels.items():
        np.testing.assert_array_equal(back.channels[name], values)


def test_the_same_demonstration_gives_the_same_bytes(tmp_path: Path) -> None:
    demonstration = read(write(tmp_path, HEADER, *ROWS))
    save_csv(demonstration, tmp_path / "one.csv")
    save_csv(demonstration, tmp_path / "other.csv")
    assert (tmp_path / "one.csv").read_bytes() == (tmp_path / "other.csv").read_bytes()


def test_the_header_of_a_saved_table_names_every_column_with_its_unit(tmp_path: Path) -> None:
    zeros = np.zeros((2, 3))
    turned = np.tile([1.0, 0, 0, 0], (2, 1))
    full = Demonstration("full", [0, 1], zeros, turned, zeros, zeros, zeros[:, :2])
    save_csv(full, tmp_path / "full.csv")
    header = (tmp_path / "full.csv").read_text().splitlines()[0]
    assert header == (
        "time_s,position_x_m,position_y_m,position_z_m,"
        "orientation_w,orientation_x,orientation_y,orientation_z,"
        "force_x_N,force_y_N,force_z_N,torque_x_Nm,torque_y_Nm,torque_z_Nm,"
        "joint_1_rad,joint_2_rad"
    )


def test_columns_may_stand_in_any_order(tmp_path: Path) -> None:
    header = "position_z_m,time_s,position_x_m,position_y_m"
    demonstration = read(write(tmp_path, header, "3,0,1,2", "3,1,1,2"))
    np.testing.assert_array_equal(demonstration.position_m, [[1, 2, 3], [1, 2, 3]])


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
def test_every_newline_is_read(tmp_path: Path, newline: str) -> None:
    assert len(read(write(tmp_path, HEADER, *ROWS, newline=newline))) == 3


def test_a_byte_order_mark_and_spaces_are_read(tmp_path: Path) -> None:
    spaced = HEADER.replace(",", " , ")
    assert len(read(write(tmp_path, spaced, "0, 1, 2, 3", "1, 1, 2, 3", encoding="utf-8-sig"))) == 2


def test_quoted_cells_are_read(tmp_path: Path) -> None:
    path = write(tmp_path, '"time_s","position_x_m","position_y_m","position_z_m"', *ROWS[:2],
                 '"0.2","1","2","3"')  # fmt: skip
    assert read(path).end_s == 0.2


def test_a_column_that_is_no_channel_is_left_out_and_said(tmp_path: Path) -> None:
    path = write(tmp_path, f"{HEADER},label", *(f"{row},move" for row in ROWS))
    assert read(path).notices == ("Left out columns that are no channel: column 'label'.",)


FORCES = f"{HEADER},force_x_N,force_y_N,force_z_N"
TURNS = f"{HEADER},orientation_w,orientation_x,orientation_y,orientation_z"

REFUSED = {
    "column missing": (
        ["time_s,position_x_m,position_y_m,x", *ROWS],
        "column position_z_m is missing from the header in line 1.*recipe",
    ),
    "channel incomplete": (
        [f"{HEADER},force_x_N,force_z_N", "0,1,2,3,4,5"],
        "column force_y_N is missing",
    ),
    "joint skipped": ([f"{HEADER},joint_2_rad", "0,1,2,3,4"], "column joint_1_rad is missing"),
    "column doubled": ([f"{HEADER},time_s", "0,1,2,3,4"], "names 'time_s' more than once"),
    "header alone": ([HEADER], "expected rows of numbers after line 1, but there are none"),
    "one row": ([HEADER, ROWS[0]], "at least two samples"),
    "word": (
        [HEADER, *ROWS[:2], "0.2,1,two,3"],
        "line 4, column 'position_y_m': expected a number, but found 'two'",
    ),
    "number with underscore": ([HEADER, ROWS[0], "1,1_0,2,3"], "line 3, .*found '1_0'"),
    "cell empty": (
        [HEADER, ROWS[0], "0.1,,2,3"],
        "line 3, column 'position_x_m': expected a number, but the cell is empty",
    ),
    "NaN": (
        [HEADER, ROWS[0], "", "0.1,1,2,NaN"],
        "line 4, column 'position_z_m': expected a finite number, but found nan",
    ),
    "infinity": ([HEADER, ROWS[0], "0.1,1,-inf,3"], "line 3, .*but found -inf"),
    "row short": ([HEADER, *ROWS, "0.3,1,2"], "line 5 has 3 cells, but the first row, line 2, has"),
    "row long": ([HEADER, *ROWS, "0.3,1,2,3,4"], "line 5 has 5 cells"),
    "header short": ([HEADER, "a,0,1,2,3"], "header names 4 columns, but the rows have 5"),
    "time stands": (
        [HEADER, *ROWS, "0.2,1,2,3"],
        "line 5, column 'time_s': expected time to increase, but 0.2 s comes after 0.2 s",
    ),
    "time returns": ([HEADER, *ROWS, "0.1,1,2,3"], "line 5, .*0.1 s comes after 0.2 s"),
    "not unit": (
        [TURNS, "0,1,2,3,1,0,0,0", "1,1,2,3,1,1,0,0"],
        "line 3, .*'orientation_w'.*expected a unit quaternion, but its norm is 1.41421",
    ),
    "binary": ([HEADER, "0,1,\0,3"], "the file is binary"),
    "long line": ([HEADER, "0" * 200_000], "line 2 has 200000 characters"),
}  # fmt: skip


@pytest.mark.parametrize(("lines", "reason"), REFUSED.values(), ids=REFUSED.keys())
def test_it_is_refused(tmp_path: Path, lines: list[str], reason: str) -> None:
    with pytest.raises(DemonstrationError, match=rf"recording\.csv: .*{reason}"):
        read(write(tmp_path, *lines))


def test_another_encoding_is_refused(tmp_path: Path) -> None:
    path = write(tmp_path, f"{HEADER},Kraft für x", "0,1,2,3,4", "1,1,2,3,4", encoding="latin-1")
    with pytest.raises(DemonstrationError, match=r"recording\.csv: expected text in utf-8"):
        read(path)


def test_too_many_lines_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DemonstrationError, match="may have 500 lines, but this one has 1001"):
        read(write(tmp_path, HEADER, *["1,1,1,1"] * 1000), limit_bytes=100_000)


def test_too_many_bytes_are_refused(tmp_path: Path) -> None:
    with pytest.raises(DemonstrationError, match=r"larger than the limit of 100 bytes"):
        read(write(tmp_path, HEADER, *ROWS * 10), limit_bytes=100)


@pytest.mark.parametrize(
    ("name", "reason"),
    [("empty.csv", "the file is empty"), ("folder", "is a folder"), ("none.csv", "no such file")],
)
def test_a_path_without_a_recording_is_refused(tmp_path: Path, name: str, reason: str) -> None:
    (tmp_path / "empty.csv").touch()
    (tmp_path / "folder").mkdir()
    with pytest.raises(DemonstrationError, match=f"{name}: .*{reason}"):
        read(tmp_path / name)


@pytest.mark.parametrize("name", ["n" * 300, "no\0name", "blocked/recording.csv"])
def test_a_path_that_cannot_be_looked_at_is_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / "blocked").mkdir(mode=0)
    with pytest.raises(DemonstrationError, match="no such file"):
        read(tmp_path / name)


def test_the_longest_possible_name_is_read_and_saved(tmp_path: Path) -> None:
    path = tmp_path / f"{'n' * 251}.csv"
    save_csv(read(write(tmp_path, HEADER, *ROWS)), path)
    assert len(read(path)) == 3


def test_forces_read_as_forces(tmp_path: Path) -> None:
    demonstration = read(write(tmp_path, FORCES, "0,1,2,3,4,5,6", "1,1,2,3,4,5,6"))
    assert demonstration.force_N is not None
    np.testing.assert_array_equal(demonstration.force_N[0], [4, 5, 6])


def test_a_last_line_without_an_end_is_told_and_one_with_missing_cells_left_out(
    tmp_path: Path,
) -> None:
    path = tmp_path / "cut.csv"
    whole = "\n".join([HEADER, *ROWS])
    path.write_text(whole)
    assert "The last line, 4, has no line end" in read(path).notices[0]
    path.write_text(whole[: whole.rindex(",")])
    cut = read(path)
    assert len(cut) == 2
    assert "The file ends within line 4, which was left out" in cut.notices[0]
