"""Rows repeated, uneven in time or held from a lower rate: left or mended as asked, and said."""

from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration
from keyphase.errors import DemonstrationError
from keyphase.readers import parse_recipe, read, save_npz

RECIPE = '[time]\ncolumn = 0\nunit = "s"\n[position]\ncolumns = [1, 2, 3]\nunit = "m"\n[rows]\n'
TURNS = '[orientation]\nkind = "quaternion"\norder = "wxyz"\ncolumns = [4, 5, 6, 7]\n'


def read_rows(folder: Path, rows: np.ndarray, rule: str, more: str = "") -> Demonstration:
    path = folder / "rows.txt"
    np.savetxt(path, rows, delimiter=",", fmt="%.17g")
    recipe = "[table]\nheader = false\n" + RECIPE + rule + "\n" + more
    return read(path, parse_recipe(recipe, "rows.toml"))


def moving(time_s: np.ndarray) -> np.ndarray:
    return np.column_stack([time_s, time_s, 2 * time_s, -time_s])


REPEATED = np.array([0, 0.1, 0.1, 0.2, 0.3, 0.3, 0.4])


def test_repeated_rows_are_refused_by_default(tmp_path: Path) -> None:
    with pytest.raises(DemonstrationError, match="line 3, column 0: expected time to increase"):
        read_rows(tmp_path, moving(REPEATED), "")


def test_repeated_rows_are_dropped_when_asked_and_said(tmp_path: Path) -> None:
    demonstration = read_rows(tmp_path, moving(REPEATED), 'repeated = "drop"')
    np.testing.assert_allclose(demonstration.time_s, [0, 0.1, 0.2, 0.3, 0.4])
    assert "Dropped 2 rows with the time of the row before, first line 3." in demonstration.notices


def test_time_that_returns_is_refused_even_so_and_by_its_line_in_the_file(tmp_path: Path) -> None:
    rows = moving(np.array([0, 0.1, 0.1, 0.2, 0.15]))
    with pytest.raises(
        DemonstrationError, match=r"line 5, column 0: .* 0\.15 s comes after 0\.2 s"
    ):
        read_rows(tmp_path, rows, 'repeated = "drop"')


def test_a_single_row_is_refused(tmp_path: Path) -> None:
    with pytest.raises(DemonstrationError, match="at least two rows at different times"):
        read_rows(tmp_path, moving(np.array([0.5, 0.5])), 'repeated = "drop"')


UNEVEN = np.cumsum(np.tile([0.01, 0.03], 20))


def test_uneven_rows_are_left_and_said_by_default(tmp_path: Path) -> None:
    demonstration = read_rows(tmp_path, moving(UNEVEN), "")
    np.testing.assert_allclose(demonstration.time_s, UNEVEN)
    (_, notice) = demonstration.notices
    assert notice == (
        "The rows are irregular in time: steps from 0.01 to 0.03 s, median 0.03 s; "
        "left as they came."
    )


def test_uneven_rows_are_refused_when_asked(tmp_path: Path) -> None:
    with pytest.raises(DemonstrationError, match=r"rows\.txt: expected evenly spaced rows"):
        read_rows(tmp_path, moving(UNEVEN), 'irregular = "refuse"')


def test_even_rows_with_a_little_jitter_are_not_called_irregular(tmp_path: Path) -> None:
    time = np.arange(80) / 100 + np.random.default_rng(0).uniform(-1e-3, 1e-3, 80)
    assert len(read_rows(tmp_path, moving(time), 'irregular = "refuse"').notices) == 1


def test_uneven_rows_are_resampled_along_straight_lines(tmp_path: Path) -> None:
    rule = 'irregular = "resample"\nrate_hz = 100'
    demonstration = read_rows(tmp_path, moving(UNEVEN), rule)
    np.testing.assert_allclose(np.diff(demonstration.time_s), 0.01)
    assert demonstration.end_s == pytest.approx(UNEVEN[-1])
    time = demonstration.time_s
    np.testing.assert_allclose(demonstration.position_m, np.column_stack([time, 2 * time, -time]))
    assert "Resampled 40 rows to 80 at 100 Hz." in demonstration.notices


def test_orientations_are_resampled_along_the_great_arc(tmp_path: Path) -> None:
    """Half way through a quarter turn is an eighth of a turn."""
    turns = Rotation.from_euler("z", [[0], [90]], degrees=True).as_quat(scalar_first=True)
    rows = np.column_stack([moving(np.array([0.0, 1.0])), turns])
    rule = 'irregular = "resample"\nrate_hz = 2'
    orientation = read_rows(tmp_path, rows, rule, TURNS).orientation_wxyz
    assert orientation is not None
    angles = Rotation.from_quat(orientation, scalar_first=True).as_euler("zyx", degrees=True)[:, 0]
    np.testing.assert_allclose(angles, [0, 45, 90])


def held_rows() -> np.ndarray:
    """Position at 25 Hz in rows at 100 Hz."""
    time = np.arange(100) / 100
    rows = moving(time)
    rows[:, 1:] = rows[(np.arange(100) // 4) * 4, 1:]
    return rows


def test_a_held_channel_is_left_and_said_by_default(tmp_path: Path) -> None:
    demonstration = read_rows(tmp_path, held_rows(), "")
    np.testing.assert_array_equal(demonstration.position_m, held_rows()[:, 1:])
    assert (
        "position_m changes in only 25 of 100 rows (about 25 Hz) and repeats its last value in "
        "between; left as it came."
    ) in demonstration.notices


def test_a_held_channel_is_said_of_a_native_archive_too(tmp_path: Path) -> None:
    rows = held_rows()
    save_npz(Demonstration("held", rows[:, 0], rows[:, 1:]), tmp_path / "held.npz")
    assert "position_m changes in only 25 of 100 rows" in read(tmp_path / "held.npz").notices[0]


def test_a_held_channel_is_interpolated_between_its_changes_when_asked(tmp_path: Path) -> None:
    demonstration = read_rows(tmp_path, held_rows(), 'held = "interpolate"')
    np.testing.assert_allclose(demonstration.position_m[:97], moving(np.arange(97) / 100)[:, 1:])
    np.testing.assert_allclose(demonstration.position_m[97:], held_rows()[97:, 1:])
    assert (
        "Interpolated position_m between the 25 of 100 rows at which it changed (about 25 Hz)."
    ) in demonstration.notices


def test_a_robot_that_rests_is_not_called_held(tmp_path: Path) -> None:
    time = np.arange(300) / 100
    moves = np.clip(time, 0.5, 1.0) + np.clip(time, 1.5, 2.0)
    demonstration = read_rows(tmp_path, np.column_stack([time, moves, moves, moves]), "")
    assert len(demonstration.notices) == 1


def test_a_force_that_came_late_is_moved_to_when_it_was_felt(tmp_path: Path) -> None:
    time = np.arange(200) / 100
    rows = [f"{t:.2f},{t:.4f},0,0,{5.0 * (t > 1.045)},0,0" for t in time]
    (tmp_path / "late.csv").write_text("\n".join(["t,x,y,z,fx,fy,fz", *rows, ""]))
    recipe = parse_recipe(
        'time = {column = "t", unit = "s"}\nposition = {columns = ["x", "y", "z"], unit = "m"}\n'
        'force = {columns = ["fx", "fy", "fz"], unit = "N", clock_offset_s = -0.04}\n'
        'wrench = {frame = "base", sign = 1}\n',
        "late",
    )
    found = read(tmp_path / "late.csv", recipe)
    assert found.force_N is not None
    assert found.time_s[np.argmax(found.force_N[:, 0] > 2)] == pytest.approx(1.01)
    assert "Moved the clock of force by -0.04 s." in found.notices
