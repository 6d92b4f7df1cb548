"""Habits of people who write recordings: each file is read by the recipe proposed for it.

What only a person knows is answered as the file was made; then all values are compared.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import scipy.io
import zarr
from scipy.spatial.transform import Rotation

from keyphase.errors import DemonstrationError
from keyphase.readers import parse_recipe, read
from keyphase.readers.finding import parts_of
from keyphase.readers.proposing.answered import recipe_text
from keyphase.readers.proposing.answers import answers_to
from keyphase.readers.proposing.proposal import propose

ROWS, RATE_HZ = 60, 125
TIME = np.arange(ROWS) / RATE_HZ
POSITION = np.stack([0.4 + 0.1 * TIME, 0.1 * np.sin(9 * TIME), 0.3 - 0.1 * TIME], axis=1)
TURNS = Rotation.from_euler("xyz", np.stack([3 - TIME, 0.2 * TIME, 0.4 * TIME], axis=1))
XYZW, ROTVEC = TURNS.as_quat(), TURNS.as_rotvec()
FORCE = np.stack([0.1 * TIME, -2 * TIME, 9 * TIME], axis=1)
MATRICES = np.tile(np.eye(4), (ROWS, 1, 1))
MATRICES[:, :3, :3], MATRICES[:, :3, 3] = TURNS.as_matrix(), POSITION
FLAT = np.column_stack([TIME, POSITION, XYZW, FORCE])
NAMES = ["t", "x", "y", "z", "qx", "qy", "qz", "qw", "fx", "fy", "fz"]


@dataclass(frozen=True)
class Habit:
    """Writes a file into a folder; whether force and orientation are in it, how angles turn."""

    write: Callable[[Path], Path]
    force: bool = True
    turned: bool = True
    kind: str = "rotation_vector"


def table(name: str, head: list[str], rows: np.ndarray, separator: str = ",") -> Callable:
    def write(folder: Path) -> Path:
        body = [separator.join(f"{cell:.9g}" for cell in row) for row in rows]
        (folder / name).write_text("\n".join([*head, *body]) + "\n")
        return folder / name

    return write


def lists(form: Callable[[np.ndarray], str]) -> Callable[[Path], Path]:
    def write(folder: Path) -> Path:
        rows = [
            f"{t},{form(np.r_[p, q])},{form(f)}"
            for t, p, q, f in zip(TIME, POSITION, XYZW, FORCE, strict=True)
        ]
        (folder / "lists.csv").write_text("\n".join(["t,tcp_pose,force", *rows]) + "\n")
        return folder / "lists.csv"

    return write


def optitrack(folder: Path) -> Path:
    head = [
        "Format Version,1.23,Take Name,Take 3,Export Frame Rate,125.000000,Total Frames,60",
        "",
        ",Type" + ",Rigid Body" * 8,
        ",Name" + ",tool" * 8,
        ",ID" + ",1" * 8,
        "," + ",Rotation" * 4 + ",Position" * 3 + ",Mean Marker Error",
        "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,",
    ]
    rows = np.column_stack([np.arange(ROWS), TIME, XYZW, POSITION, 0 * TIME])
    return table("take.csv", head, rows)(folder)


def kuka(folder: Path) -> Path:
    names = "IPOC;RIst_X;RIst_Y;RIst_Z;RIst_A;RIst_B;RIst_C;Fx;Fy;Fz"
    angles = TURNS.as_euler("ZYX", degrees=True)
    stamps = 4_208_163 + 8 * np.arange(ROWS)
    rows = np.column_stack([stamps, 1000 * POSITION, angles, FORCE])
    return table("rsi.csv", [names], rows, ";")(folder)


def franka_of_rostopic(folder: Path) -> Path:
    """Many numbered fields beside each other, the matrix column by column, forces turned."""
    vectors = {"q": np.tile(TIME, (7, 1)).T, "K_F_ext_hat_K": np.tile(FORCE, 2)}
    vectors |= {"O_F_ext_hat_K": np.hstack([FORCE, 0 * FORCE])}
    vectors |= {"O_T_EE": MATRICES.transpose(0, 2, 1).reshape(ROWS, 16)}
    names = [f"field.{name}{i}" for name, v in vectors.items() for i in range(v.shape[1])]
    rows = np.column_stack([np.round(1e9 * TIME), *vectors.values()])
    return table("franka.csv", [",".join(["%time", *names])], rows)(folder)


def hdf5(**arrays: np.ndarray) -> Callable[[Path], Path]:
    def write(folder: Path) -> Path:
        with h5py.File(folder / "run.h5", "w") as file:
            for name, values in arrays.items():
                file[name.replace("__", "/")] = values
            if "log" in arrays:
                file["log"].attrs["columns"] = NAMES
        return folder / "run.h5"

    return write


def demonstrations_beside_a_mask(folder: Path) -> Path:
    path = hdf5(demo_0__pos=POSITION, demo_0__quat=XYZW, demo_0__force=FORCE, demo_0__t=TIME)(
        folder
    )
    with h5py.File(path, "a") as file:
        file.copy("demo_0", "demo_1")
        file["mask/train"] = np.arange(2)
    return path


def groups_of_zarr(folder: Path) -> Path:
    store = zarr.open_group(folder / "run.zarr", mode="w", zarr_format=2)
    for number in range(2):
        group = store.create_group(f"episode_{number}")
        arrays = {"tcp_pose": np.hstack([POSITION, ROTVEC]), "ft": np.hstack([FORCE, 0 * FORCE])}
        for name, values in {**arrays, "timestamp": TIME}.items():
            group.create_array(name, data=values)
    return folder / "run.zarr"


def cells_of_matlab(folder: Path) -> Path:
    cells = np.empty((1, 2), dtype=object)
    cells[0, 0] = cells[0, 1] = {"t": TIME, "pos": POSITION, "quat": XYZW, "F": FORCE}
    scipy.io.savemat(folder / "run.mat", {"demos": cells})
    return folder / "run.mat"


def named_columns_of_matlab(folder: Path) -> Path:
    words = np.array(NAMES, dtype=object)
    scipy.io.savemat(folder / "run.mat", {"data": FLAT, "labels": words})
    return folder / "run.mat"


def records_of_parquet(folder: Path) -> Path:
    def records(values: np.ndarray) -> list[dict[str, float]]:
        return [dict(zip("xyz", row.tolist(), strict=True)) for row in values]

    columns = {"time_s": TIME, "pos": records(POSITION), "quat": list(XYZW)}
    pq.write_table(pa.table({**columns, "force": records(FORCE)}), folder / "run.parquet")
    return folder / "run.parquet"


TUM = np.column_stack([TIME, POSITION, XYZW])
T_AND_R = "stamp,TX,TY,TZ,RX_rad,RY_rad,RZ_rad"
T_AND_R_ROWS = np.column_stack([1000 * TIME, 1000 * POSITION, ROTVEC, FORCE])
VICON = ["Trajectories", str(RATE_HZ), ",,Tool:Tool,,", "Frame,Sub Frame,X,Y,Z", ",,mm,mm,mm"]
COUNTED = np.column_stack([1 + np.arange(ROWS), 0 * TIME])
OBJECTS = [*VICON[:2], ",,Tool,,,,,", "Frame,Sub Frame,RX,RY,RZ,TX,TY,TZ", ",,rad,rad,rad,mm,mm,mm"]
EXTERNAL = ["time,ee_pos_x,ee_pos_y,ee_pos_z,f_ext_x,f_ext_y,f_ext_z"]
WHOLE = np.array([[1.7e9 + t // 1, round(1e9 * (t % 1))] for t in TIME])


def echoed(folder: Path) -> Path:
    """As `ros2 topic echo --csv` writes a pose: no names, seconds and nanoseconds apart."""
    rows = [
        f"{s:.0f},{n:.0f},base," + ",".join(f"{v:.9g}" for v in (*p, *q))
        for (s, n), p, q in zip(WHOLE, POSITION, XYZW, strict=True)
    ]
    (folder / "pose.csv").write_text("\n".join(rows) + "\n")
    return folder / "pose.csv"


def behind_each_other(folder: Path) -> Path:
    arrays = {"t": TIME, "T": MATRICES.transpose(1, 2, 0), "wrench": np.tile(FORCE, 2).T}
    scipy.io.savemat(folder / "run.mat", arrays)
    return folder / "run.mat"


def encoded(name: str, encoding: str, head: str) -> Callable[[Path], Path]:
    """Milliseconds, millimetres and newtons under names of a country."""

    def write(folder: Path) -> Path:
        path = table(name, [head], np.column_stack([1000 * TIME, 1000 * POSITION, FORCE]))(folder)
        path.write_bytes(path.read_text().encode(encoding))
        return path

    return write


JAPANESE = "時刻[ms],位置X[mm],位置Y[mm],位置Z[mm],力X[N],力Y[N],力Z[N]"
CHINESE = "时间(ms),位置x(mm),位置y(mm),位置z(mm),力x(N),力y(N),力z(N)"
FRENCH = "temps écoulé (ms),pos_x (mm),pos_y (mm),pos_z (mm),effort_x,effort_y,effort_z"
GRID = [f"T{row}{column}" for row in range(4) for column in range(4)]

HABITS = {
    "Japanese": Habit(encoded("j.csv", "shift_jis", JAPANESE), turned=False),
    "Chinese": Habit(encoded("c.csv", "gb18030", CHINESE), turned=False),
    "French": Habit(encoded("f.csv", "latin-1", FRENCH), turned=False),
    "a matrix by row and column": Habit(
        table(
            "m.csv",
            [",".join(["t", *GRID])],
            np.column_stack([TIME, MATRICES.reshape(ROWS, 16)]),
        ),
        force=False,
    ),
    "echoed without names": Habit(echoed, force=False),
    "matrices behind each other": Habit(behind_each_other),
    "external forces": Habit(
        table("f.csv", EXTERNAL, np.column_stack([TIME, POSITION, FORCE])), turned=False
    ),
    "lists in quotes": Habit(lists(lambda row: f'"{row.tolist()}"')),
    "arrays as numpy shows them": Habit(lists(lambda row: str(row).replace("\n", ""))),
    "KITTI": Habit(table("poses.txt", [], MATRICES[:, :3].reshape(ROWS, 12), " "), force=False),
    "TUM": Habit(table("t.txt", ["# timestamp tx ty tz qx qy qz qw"], TUM, " "), force=False),
    "Vicon, a marker": Habit(
        table("v.csv", VICON, np.hstack([COUNTED, 1000 * POSITION])), force=False, turned=False
    ),
    "Vicon, an object": Habit(
        table("o.csv", OBJECTS, np.hstack([COUNTED, ROTVEC, 1000 * POSITION])), force=False
    ),
    "T and R beside loads": Habit(
        table("l.csv", [f"{T_AND_R},load_a,load_b,load_c"], T_AND_R_ROWS), force=False
    ),
    "T and R beside a force": Habit(table("f.csv", [f"{T_AND_R},Fx,Fy,Fz"], T_AND_R_ROWS)),
    "OptiTrack": Habit(optitrack, force=False),
    "KUKA RSI": Habit(kuka),
    "Franka by rostopic": Habit(franka_of_rostopic),
    "a matrix called O_T_EE": Habit(
        hdf5(robot__O_T_EE=MATRICES, robot__F_ext=np.hstack([FORCE, 0 * FORCE]), robot__stamp=TIME)
    ),
    "arrays on their side": Habit(
        hdf5(time=TIME[None], position=POSITION.T, orientation=XYZW.T, force=FORCE.T)
    ),
    "columns named by an attribute": Habit(hdf5(log=FLAT)),
    "a frame of pandas": Habit(
        hdf5(df__block0_values=FLAT, df__block0_items=np.array(NAMES, dtype="S"))
    ),
    "demonstrations beside a mask": Habit(demonstrations_beside_a_mask),
    "a group of Zarr each": Habit(groups_of_zarr),
    "cells of MATLAB": Habit(cells_of_matlab),
    "names in another variable": Habit(named_columns_of_matlab),
    "records of Parquet": Habit(records_of_parquet),
}


def completed(text: str, kind: str) -> str:
    said = {"order": '"xyzw"', "kind": f'"{kind}"', "frame": '"base"', "sign": "1"}
    said |= {"rate_hz": str(RATE_HZ), "sequence": '"ZYX"', "layout": '"row_major"'}
    for key, value in said.items():
        text = re.sub(rf"^# {key} =.*$", f"{key} = {value}", text, flags=re.M)
    return text


@pytest.mark.parametrize("habit", HABITS.values(), ids=HABITS.keys())
def test_what_a_stranger_wrote_is_read_as_proposed(tmp_path: Path, habit: Habit) -> None:
    path = habit.write(tmp_path)
    parts = parts_of(path)
    first = path.with_name(f"{path.name}#{parts[0]}") if parts else path
    recipe = parse_recipe(completed(propose(first).recipe_text(), habit.kind), "completed")

    found = read(first, recipe)

    assert len(parts) in (0, 2)
    np.testing.assert_allclose(found.time_s - found.start_s, TIME, atol=1e-6)
    np.testing.assert_allclose(found.position_m, POSITION, atol=1e-6)
    assert (found.force_N is not None) == habit.force
    if found.force_N is not None:
        np.testing.assert_allclose(found.force_N, FORCE, atol=1e-6)
    assert (found.orientation_wxyz is not None) == habit.turned
    if found.orientation_wxyz is not None:
        turned = Rotation.from_quat(found.orientation_wxyz, scalar_first=True)
        np.testing.assert_allclose((turned.inv() * TURNS).magnitude(), 0, atol=1e-5)


def test_the_rate_above_the_names_is_asked_about_and_not_taken(tmp_path: Path) -> None:
    path = HABITS["Vicon, a marker"].write(tmp_path)

    text = propose(path).recipe_text()

    assert "# rate_hz = 125    # no column rises like a time; a line above the names" in text


def test_a_pickle_is_named_and_not_proposed_for(tmp_path: Path) -> None:
    path = tmp_path / "demo.pkl"
    path.write_bytes(b"\x80\x04\x95\x10\x00\x00\x00\x00\x00\x00\x00")

    with pytest.raises(DemonstrationError, match="pickle"):
        propose(path)


def test_numbers_without_names_behind_a_pose_are_asked_about(tmp_path: Path) -> None:
    np.save(tmp_path / "run.npy", FLAT)

    text = propose(tmp_path / "run.npy").recipe_text()

    assert '# columns = ["array[8]", "array[9]", "array[10]"]' in text
    assert "\n[force]" not in text


@pytest.mark.parametrize(
    ("one", "other", "called"),
    [
        ("L_", "R_", ("left", "right")),
        ("links_", "rechts_", ("left", "right")),
        ("robot1_", "robot2_", ("first", "second")),
        ("arm_0_", "arm_1_", ("first", "second")),
    ],
)
def test_two_arms_are_told_apart_as_people_call_them(
    one: str, other: str, called: tuple[str, str], tmp_path: Path
) -> None:
    head = ",".join(["t", *(f"{side}{axis}" for side in (one, other) for axis in "xyz")])
    path = table("arms.csv", [head], np.column_stack([TIME, POSITION, POSITION + 1]))(tmp_path)
    recipe = parse_recipe(propose(path).recipe_text(), "proposed")
    assert parts_of(path, recipe) == called
    second = read(path.with_name(f"arms.csv#{called[1]}"), recipe)
    np.testing.assert_allclose(second.position_m, POSITION + 1, atol=1e-6)


def test_a_clock_that_was_set_back_is_told_and_is_no_second_demonstration(tmp_path: Path) -> None:
    seconds = TIME - 0.1 * (TIME > 0.3)
    path = table("ntp.csv", ["t,x,y,z"], np.column_stack([seconds, POSITION]))(tmp_path)
    proposal = propose(path).recipe_text()
    assert "# the clock was set back 1 times" in proposal
    with pytest.raises(DemonstrationError, match=r"set back by 0\.092 s at line 40, "):
        read(path, parse_recipe(proposal, "proposed"))


def test_rows_with_the_time_of_the_row_before_are_proposed_to_be_dropped(tmp_path: Path) -> None:
    repeated = np.column_stack([TIME, POSITION])[[0, 1, 1, *range(2, ROWS)]]
    path = table("twice.csv", ["t,x,y,z"], repeated)(tmp_path)
    proposal = propose(path)
    for text in (
        proposal.recipe_text(),
        recipe_text(answers_to(proposal), proposal.names),
    ):
        np.testing.assert_allclose(read(path, parse_recipe(text, "r")).time_s, TIME, atol=1e-6)
    assert "# 1 of the rows looked at" in proposal.recipe_text()
