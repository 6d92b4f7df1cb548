"""What a recipe can say about a table, and that what was done is said."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration
from keyphase.errors import DemonstrationError
from keyphase.readers import parse_recipe, read

TIME = '[time]\ncolumn = "t"\nunit = "s"\n'
POSITION = '[position]\ncolumns = ["x", "y", "z"]\nunit = "m"\n'
FORCE = '[force]\ncolumns = ["fx", "fy", "fz"]\nunit = "N"\n'
TORQUE = '[torque]\ncolumns = ["tx", "ty", "tz"]\nunit = "N m"\n'
BASE = '[wrench]\nframe = "base"\nsign = 1\n'


def table(folder: Path, text: str) -> Path:
    path = folder / "table.csv"
    path.write_text(text)
    return path


def read_columns(folder: Path, recipe: str, **columns: Any) -> Demonstration:
    """Read a table of these columns by a recipe."""
    names = [name for name, values in columns.items() for _ in np.atleast_2d(np.transpose(values))]
    seen: dict[str, int] = {}
    header = []
    for name in names:
        seen[name] = seen.get(name, -1) + 1
        header.append(f"{name}{seen[name]}" if names.count(name) > 1 else name)
    rows = np.column_stack(list(columns.values())).tolist()
    text = "\n".join([",".join(header), *(",".join(map(repr, row)) for row in rows)])
    return read(table(folder, text), parse_recipe(recipe, "recipe"))


def still(rows: int = 4) -> dict[str, Any]:
    """Columns of a recording in which nothing moves."""
    return {"t": np.arange(rows) / 10, **{axis: np.zeros(rows) for axis in "xyz"}}


def said(demonstration: Demonstration, words: str) -> bool:
    return any(words in notice for notice in demonstration.notices)


@pytest.mark.parametrize(
    ("form", "text"),
    [
        ("", "t,x,y,z\n0,1,2,3.5\n1,1,2,3.5"),
        ('separator = ";"\ndecimal = ","', "t;x;y;z\n0;1;2;3,5\n1;1;2;3,5"),
        ('separator = "tab"', "t\tx\ty\tz\n0\t1\t2\t3.5\n1\t1\t2\t3.5"),
        ('separator = "whitespace"', "t x   y z\n  0 1 2 \t3.5\n1 1 2 3.5"),
        ('separator = "whitespace"', '"t" x y z\n"0" 1 2 3.5\n1 1 2 3.5'),
        ("skip_lines = 2", "made by\na robot\nt,x,y,z\n0,1,2,3.5\n\n1,1,2,3.5"),
        ('encoding = "latin-1"', "t,x,y,z,\xfc\n0,1,2,3.5,0\n1,1,2,3.5,0"),
        ("", "t,x,y,z,\n0,1,2,3.5,\n1,1,2,3.5,"),
        ("", 't, x, y, z, note\n0, 1, 2, 3.5, "a, b"\n1, 1, 2, 3.5, ""'),
    ],
    ids=[
        "plain",
        "semicolon",
        "tab",
        "spaces",
        "quoted spaces",
        "skip",
        "latin",
        "trailing",
        "quoted",
    ],
)
def test_tables_are_laid_out_in_many_ways(tmp_path: Path, form: str, text: str) -> None:
    path = tmp_path / "table.txt"
    path.write_bytes(text.encode("latin-1"))
    demonstration = read(path, parse_recipe(f"[table]\n{form}\n{TIME}{POSITION}", "recipe"))
    np.testing.assert_array_equal(demonstration.position_m, [[1, 2, 3.5], [1, 2, 3.5]])


@pytest.mark.parametrize(
    "columns", ['["b.x", "b.y", "b.z"]', "[1, 2, 3]", '"b.?"', '["b.x", 2, "b.z"]', '"*b.*"']
)
def test_columns_are_chosen_by_name_index_or_pattern(tmp_path: Path, columns: str) -> None:
    recipe = f'{TIME}[position]\ncolumns = {columns}\nunit = "m"'
    path = table(tmp_path, "t,b.x,b.y,b.z,a.x\n0,1,2,3,4\n1,1,2,3,4")
    np.testing.assert_array_equal(
        read(path, parse_recipe(recipe, "recipe")).position_m[0], [1, 2, 3]
    )


def test_brackets_in_a_pattern_are_just_brackets(tmp_path: Path) -> None:
    recipe = f'{TIME}[position]\ncolumns = "p[*]"\nunit = "m"'
    path = table(tmp_path, "t,p[0],p[1],p[2],p0\n0,1,2,3,4\n1,1,2,3,4")
    np.testing.assert_array_equal(
        read(path, parse_recipe(recipe, "recipe")).position_m[0], [1, 2, 3]
    )


def test_a_table_without_header_is_read_by_index(tmp_path: Path) -> None:
    recipe = '[table]\nheader = false\n[time]\ncolumn = 3\nunit = "s"\n[position]\n'
    path = table(tmp_path, "1,2,3,0\n1,2,3,1")
    demonstration = read(path, parse_recipe(recipe + 'columns = [0, 1, 2]\nunit = "m"', "recipe"))
    np.testing.assert_array_equal(demonstration.position_m[0], [1, 2, 3])


@pytest.mark.parametrize(("unit", "metres"), [("m", 1), ("mm", 1e-3), ("cm", 0.01), ("in", 0.0254)])
def test_lengths_become_metres(tmp_path: Path, unit: str, metres: float) -> None:
    recipe = TIME + POSITION.replace('"m"', f'"{unit}"')
    demonstration = read_columns(tmp_path, recipe, **(still() | {"x": np.full(4, 2.0)}))
    np.testing.assert_allclose(demonstration.position_m[:, 0], 2 * metres)


@pytest.mark.parametrize(("unit", "seconds"), [("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)])
def test_times_become_seconds(tmp_path: Path, unit: str, seconds: float) -> None:
    recipe = TIME.replace('"s"', f'"{unit}"') + POSITION
    demonstration = read_columns(tmp_path, recipe, **(still() | {"t": np.arange(4) * 5}))
    np.testing.assert_allclose(demonstration.time_s, np.arange(4) * 5 * seconds)


@pytest.mark.parametrize("unit", ["N mm", "Nmm", "N·mm", "N*mm"])
def test_a_unit_of_torque_is_known_however_it_is_spaced(tmp_path: Path, unit: str) -> None:
    recipe = TIME + POSITION + TORQUE.replace('"N m"', f'"{unit}"') + BASE
    torque = {"tx": np.full(4, 500.0), "ty": np.zeros(4), "tz": np.zeros(4)}
    torque_Nm = read_columns(tmp_path, recipe, **still(), **torque).torque_Nm
    assert torque_Nm is not None
    np.testing.assert_allclose(torque_Nm[:, 0], 0.5)


def test_joints_in_degrees_become_radians(tmp_path: Path) -> None:
    recipe = TIME + POSITION + '[joints]\ncolumns = "q*"\nunit = "deg"'
    joints = read_columns(tmp_path, recipe, **still(), q=np.full((4, 7), 180.0)).joints_rad
    np.testing.assert_allclose(joints, np.full((4, 7), np.pi))


def test_rows_at_a_rate_need_no_time(tmp_path: Path) -> None:
    demonstration = read_columns(tmp_path, "[time]\nrate_hz = 50\n" + POSITION, **still())
    np.testing.assert_allclose(demonstration.time_s, [0, 0.02, 0.04, 0.06])
    assert said(demonstration, "no time: its rows are taken to be 0.02 s apart")


def test_time_from_zero_is_said(tmp_path: Path) -> None:
    columns = still() | {"t": [7.5, 8, 9, 10]}
    demonstration = read_columns(tmp_path, TIME + "from_zero = true\n" + POSITION, **columns)
    np.testing.assert_allclose(demonstration.time_s, [0, 0.5, 1.5, 2.5])
    assert said(demonstration, "which is at 7.5 s in the table")


@pytest.mark.parametrize(
    ("form", "stamps"),
    [
        ("iso", ("2024-05-01T10:00:00.25", "2024-05-01T10:00:01.5")),
        ("iso", ("2024-05-01 10:00:00.250Z", "2024-05-01 12:00:01.500+02:00")),
        ("%d/%m/%Y %H:%M:%S.%f", ("01/05/2024 10:00:00.25", "01/05/2024 10:00:01.5")),
    ],
)
def test_stamps_become_seconds(tmp_path: Path, form: str, stamps: tuple[str, str]) -> None:
    text = "t,x,y,z\n" + "\n".join(f"{stamp},0,0,0" for stamp in stamps)
    recipe = f'[time]\ncolumn = "t"\nformat = "{form}"\n{POSITION}'
    demonstration = read(table(tmp_path, text), parse_recipe(recipe, "recipe"))
    np.testing.assert_allclose(demonstration.time_s, [0, 1.25])


TURNS = Rotation.random(20, rng=1)
WAYS = {
    "quaternion w first": ('kind = "quaternion"\norder = "wxyz"',
                           TURNS.as_quat(scalar_first=True)),
    "quaternion w last": ('kind = "quaternion"\norder = "xyzw"', TURNS.as_quat()),
    "roll pitch yaw": ('kind = "euler"\nsequence = "xyz"\nunit = "rad"', TURNS.as_euler("xyz")),
    "turned axes": ('kind = "euler"\nsequence = "ZYX"\nunit = "deg"',
                    TURNS.as_euler("ZYX", degrees=True)),
    "rotation vector": ('kind = "rotation_vector"\nunit = "rad"', TURNS.as_rotvec()),
    "matrix by rows": ('kind = "matrix"\nlayout = "row_major"',
                       TURNS.as_matrix().reshape(-1, 9)),
    "matrix by columns": ('kind = "matrix"\nlayout = "column_major"',
                          TURNS.as_matrix().transpose(0, 2, 1).reshape(-1, 9)),
}  # fmt: skip


@pytest.mark.parametrize(("words", "values"), WAYS.values(), ids=WAYS.keys())
def test_every_way_to_write_an_orientation_gives_the_same(
    tmp_path: Path, words: str, values: np.ndarray
) -> None:
    recipe = f'{TIME}{POSITION}[orientation]\ncolumns = "q*"\n{words}'
    orientation = read_columns(tmp_path, recipe, **still(20), q=values).orientation_wxyz
    assert orientation is not None
    assert (
        TURNS * Rotation.from_quat(orientation, scalar_first=True).inv()
    ).magnitude().max() < 1e-9


@pytest.mark.parametrize("layout", ["row_major", "column_major"])
def test_a_pose_matrix_gives_position_and_orientation(tmp_path: Path, layout: str) -> None:
    matrices = np.tile(np.eye(4), (20, 1, 1))
    matrices[:, :3, :3] = TURNS.as_matrix()
    matrices[:, :3, 3] = np.arange(60).reshape(20, 3)
    flat = (matrices if layout == "row_major" else matrices.transpose(0, 2, 1)).reshape(20, 16)
    recipe = f'{TIME}[pose]\ncolumns = "m*"\nlayout = "{layout}"\nunit = "mm"'
    demonstration = read_columns(tmp_path, recipe, t=np.arange(20), m=flat)
    np.testing.assert_allclose(demonstration.position_m * 1e3, matrices[:, :3, 3])
    assert demonstration.orientation_wxyz is not None
    back = Rotation.from_quat(demonstration.orientation_wxyz, scalar_first=True)
    assert (TURNS * back.inv()).magnitude().max() < 1e-9


def test_a_pose_matrix_of_the_other_layout_is_refused(tmp_path: Path) -> None:
    matrix = np.eye(4)
    matrix[:3, 3] = 300
    recipe = f'{TIME}[pose]\ncolumns = "m*"\nlayout = "column_major"\nunit = "mm"'
    with pytest.raises(DemonstrationError, match=r"line 2, .*300, 300, 300, 1; .*row_major"):
        read_columns(tmp_path, recipe, t=np.arange(3), m=np.tile(matrix.ravel(), (3, 1)))


def test_a_matrix_that_mirrors_is_refused(tmp_path: Path) -> None:
    recipe = f'{TIME}{POSITION}[orientation]\ncolumns = "m*"\nkind = "matrix"\nlayout = "row_major"'
    mirror = np.tile(np.diag([1.0, 1, -1]).ravel(), (4, 1))
    with pytest.raises(DemonstrationError, match=r"line 2, .*expected a rotation matrix"):
        read_columns(tmp_path, recipe, **still(), m=mirror)


def test_quaternions_are_normalised_only_when_asked(tmp_path: Path) -> None:
    recipe = f'{TIME}{POSITION}[orientation]\ncolumns = "q*"\nkind = "quaternion"\norder = "wxyz"\n'
    columns = still() | {"q": np.tile([1.1, 0, 0, 0], (4, 1))}
    with pytest.raises(DemonstrationError, match=r"line 2, .*its norm is 1\.1; .*normalise"):
        read_columns(tmp_path, recipe, **columns)
    demonstration = read_columns(tmp_path, recipe + "normalise = true", **columns)
    assert said(demonstration, "the furthest had a norm 0.1 from one")


def test_the_sign_of_the_wrench_is_turned_and_said(tmp_path: Path) -> None:
    recipe = TIME + POSITION + FORCE + BASE.replace("1", "-1")
    force = {"fx": np.full(4, 5.0), "fy": np.zeros(4), "fz": np.zeros(4)}
    demonstration = read_columns(tmp_path, recipe, **still(), **force)
    assert demonstration.force_N is not None
    np.testing.assert_array_equal(demonstration.force_N[:, 0], -5.0)
    assert said(demonstration, "Turned the sign of force_N.")


def test_a_wrench_of_the_tool_is_turned_into_the_base_frame(tmp_path: Path) -> None:
    """A quarter turn about z takes the tool's x axis to the base's y axis."""
    quarter = Rotation.from_euler("z", 90, degrees=True).as_quat(scalar_first=True)
    recipe = (
        f'{TIME}{POSITION}{FORCE}{TORQUE}[wrench]\nframe = "tool"\nsign = 1\n'
        '[orientation]\nkind = "quaternion"\norder = "wxyz"\ncolumns = "q*"'
    )
    wrench = dict.fromkeys(("fx", "tx"), np.full(4, 5.0))
    wrench |= dict.fromkeys(("fy", "fz", "ty", "tz"), np.zeros(4))
    demonstration = read_columns(tmp_path, recipe, **still(), **wrench, q=np.tile(quarter, (4, 1)))
    for turned in (demonstration.force_N, demonstration.torque_Nm):
        np.testing.assert_allclose(turned, np.tile([0, 5, 0], (4, 1)), atol=1e-12)
    assert said(demonstration, "from the tool's frame into the base frame")


def test_a_given_offset_is_taken_out_in_the_unit_of_the_table(tmp_path: Path) -> None:
    recipe = TIME + POSITION + FORCE.replace('"N"', '"kN"') + "offset = [1, 2, 3]\n" + BASE
    force = {"fx": np.full(4, 1.5), "fy": np.full(4, 2.0), "fz": np.full(4, 3.0)}
    demonstration = read_columns(tmp_path, recipe, **still(), **force)
    assert demonstration.force_N is not None
    np.testing.assert_allclose(demonstration.force_N, np.tile([500.0, 0, 0], (4, 1)))
    assert said(demonstration, "Took the offset (1000, 2000, 3000) N out of force_N.")


def test_the_mean_of_the_first_seconds_is_taken_out(tmp_path: Path) -> None:
    recipe = TIME + POSITION + FORCE + "offset_from_first_s = 0.11\n" + BASE
    force = {"fx": [1.0, 3.0, 7.0, 7.0], "fy": np.zeros(4), "fz": np.zeros(4)}
    demonstration = read_columns(tmp_path, recipe, **still(), **force)
    assert demonstration.force_N is not None
    np.testing.assert_allclose(demonstration.force_N[:, 0], [-1, 1, 5, 5])
    assert said(demonstration, "Took the offset (2, 0, 0) N, the mean of the first 0.11 s out")


def test_the_offset_is_taken_out_before_sign_and_frame(tmp_path: Path) -> None:
    quarter = Rotation.from_euler("z", 90, degrees=True).as_quat(scalar_first=True)
    recipe = (
        f'{TIME}{POSITION}{FORCE}offset = [4, 0, 0]\n[wrench]\nframe = "tool"\nsign = -1\n'
        '[orientation]\nkind = "quaternion"\norder = "wxyz"\ncolumns = "q*"'
    )
    force = {"fx": np.full(4, 5.0), "fy": np.zeros(4), "fz": np.zeros(4)}
    demonstration = read_columns(tmp_path, recipe, **still(), **force, q=np.tile(quarter, (4, 1)))
    np.testing.assert_allclose(demonstration.force_N, np.tile([0, -1, 0], (4, 1)), atol=1e-12)


@pytest.mark.slow
@settings(max_examples=25)
@given(seed=st.integers(0, 2**32 - 1))
def test_turning_the_wrench_keeps_its_length(
    tmp_path_factory: pytest.TempPathFactory, seed: int
) -> None:
    recipe = (
        f'{TIME}{POSITION}[force]\ncolumns = "f*"\nunit = "N"\n[wrench]\nframe = "tool"\nsign = 1\n'
        '[orientation]\nkind = "quaternion"\norder = "wxyz"\ncolumns = "q*"'
    )
    force = np.random.default_rng(seed).normal(size=(8, 3))
    turns = Rotation.random(8, rng=seed).as_quat(scalar_first=True)
    folder = tmp_path_factory.mktemp("turned")
    turned = read_columns(folder, recipe, **still(8), f=force, q=turns).force_N
    assert turned is not None
    np.testing.assert_allclose(np.linalg.norm(turned, axis=1), np.linalg.norm(force, axis=1))
