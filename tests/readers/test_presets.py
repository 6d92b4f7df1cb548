"""Every preset reads a file as its recorder lays it out, written by that format's own library."""

import json
from collections.abc import Callable, Mapping
from pathlib import Path

import h5py
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import zarr
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array
from keyphase.files.shipped import shipped
from keyphase.readers import parse_recipe, read
from keyphase.readers.recipes.presets import left_open, preset_names
from keyphase.robot.arm import Arm
from keyphase.robot.yumi import yumi

ROWS = 60
TIME = np.arange(ROWS) / 50
POSITION = np.stack([0.4 + 0.1 * TIME, 0.1 * np.sin(TIME), 0.3 - 0.1 * TIME], axis=1)
TURNS = Rotation.from_euler("xyz", np.stack([3 + 0 * TIME, 0.1 * TIME, 0.4 * TIME], axis=1))
XYZW, MATRICES = TURNS.as_quat(), TURNS.as_matrix()
WXYZ, VECTORS = XYZW[:, [3, 0, 1, 2]], TURNS.as_rotvec()
FORCE = np.stack([0.1 * TIME, -2 * TIME, 9 * TIME], axis=1)
TORQUE = 0.01 * FORCE
WRENCH = np.hstack([FORCE, TORQUE])
JOINTS = yumi("r").start_rad + 0.1 * np.sin(TIME[:, None] + np.arange(7))

YUMI = (shipped("static_robots") / "yumi" / "yumi.urdf").as_posix()
ROBOT = f'robot = {{urdf = "{YUMI}", tool_frame = "%s"}}\n'
SIGN = "wrench.sign = 1\n"

SIX_JOINTS = (
    '<robot name="six"><link name="l0"/>'
    + "".join(
        f'<link name="l{i + 1}"/><joint name="j{i}" type="revolute"><parent link="l{i}"/>'
        f'<child link="l{i + 1}"/><origin xyz="0.1 0 0.05"/><axis xyz="0 {i % 2} {1 - i % 2}"/>'
        '<limit lower="-3" upper="3" effort="1" velocity="1"/></joint>'
        for i in range(6)
    )
    + "</robot>"
)


def numbered(name: str, values: Array, form: str = "{}_{}") -> dict[str, Array]:
    return {form.format(name, i): values[:, i] for i in range(values.shape[1])}


def table(path: Path, columns: Mapping[str, Array]) -> Path:
    values = np.stack(list(columns.values()), axis=1)
    np.savetxt(path, values, "%.12g", ",", header=",".join(columns), comments="")
    return path


def buffer(path: Path, arrays: Mapping[str, Array]) -> Path:
    """A replay buffer of two episodes, Zarr 2 as its authors write it."""
    store = zarr.open_group(str(path), mode="w", zarr_format=2)
    store.create_array("meta/episode_ends", data=np.array([ROWS, 2 * ROWS]))
    for name, values in arrays.items():
        store.create_array(f"data/{name}", data=np.concatenate([0 * values, values]))
    return Path(f"{path}#episode_1")


def abb_egm(folder: Path) -> Path:
    columns = {"header.tm": np.round(1000 * TIME) + 5000}
    columns |= {f"feedBack.cartesian.pos.{a}": 1000 * POSITION[:, i] for i, a in enumerate("xyz")}
    columns |= numbered("feedBack.cartesian.orient.u", WXYZ, "{}{}")
    return table(folder / "egm.csv", columns)


def ur_rtde(folder: Path) -> Path:
    columns = {"timestamp": 1e5 + TIME, **numbered("actual_q", JOINTS[:, :6])}
    columns |= numbered("actual_TCP_pose", np.hstack([POSITION, VECTORS]))
    return table(folder / "robot.csv", columns | numbered("actual_TCP_force", WRENCH))


def franka(folder: Path) -> Path:
    poses = np.tile(np.eye(4), (ROWS, 1, 1))
    poses[:, :3, :3], poses[:, :3, 3] = MATRICES, POSITION
    flat = poses.transpose(0, 2, 1).reshape(ROWS, 16)
    columns = {"time": TIME, **numbered("O_T_EE", flat, "{}[{}]")}
    return table(folder / "state.csv", columns | numbered("O_F_ext_hat_K", -WRENCH, "{}[{}]"))


def franka_log(folder: Path) -> Path:
    arm = Arm(yumi("r"))
    torques = np.array([arm.jacobian(q).T @ w for q, w in zip(JOINTS, WRENCH, strict=True)])
    columns = {"duration": np.round(1000 * TIME), **numbered("q", JOINTS, "{}[{}]")}
    columns |= numbered("tau_ext_hat_filtered", torques, "{}[{}]")
    return table(folder / "log.csv", columns)


def robomimic(folder: Path) -> Path:
    with h5py.File(folder / "low_dim.hdf5", "w") as file:
        group = file.create_group("data")
        group.attrs["env_args"] = json.dumps({"env_kwargs": {"control_freq": 50}})
        for number in (0, 1):
            group[f"demo_{number}/obs/robot0_eef_pos"] = number * POSITION
            group[f"demo_{number}/obs/robot0_eef_quat"] = XYZW
    return folder / "low_dim.hdf5#demo_1"


def reassemble(folder: Path, torque: str = "compensated_base_torque") -> Path:
    with h5py.File(folder / "run.h5", "w") as file:
        state = {"pose": np.hstack([POSITION, WXYZ]), "compensated_base_force": FORCE}
        for name, values in (state | {torque: TORQUE}).items():
            file[f"robot_state/{name}"] = values
            file[f"timestamps/{name}"] = 1.7e9 + TIME
    return folder / "run.h5"


def reassemble_misspelt(folder: Path) -> Path:
    return reassemble(folder, "compenseted_base_torque")


def umi(folder: Path) -> Path:
    arrays = {"robot0_eef_pos": POSITION, "robot0_eef_rot_axis_angle": VECTORS}
    return buffer(folder / "dataset.zarr", arrays)


def diffusion_policy(folder: Path) -> Path:
    pose = np.hstack([POSITION, VECTORS])
    arrays = {"timestamp": 1.7e9 + TIME, "robot_eef_pose": pose, "robot_joint": JOINTS[:, :6]}
    return buffer(folder / "real.zarr", arrays)


def rdp(folder: Path) -> Path:
    pose = np.hstack([POSITION, MATRICES[:, :, 0], MATRICES[:, :, 1]])
    wrench = np.hstack([TURNS.inv().apply(FORCE), TURNS.inv().apply(TORQUE)])
    arrays = {"left_robot_tcp_pose": pose, "left_robot_tcp_wrench": wrench}
    return buffer(folder / "peeling.zarr", arrays | {"timestamp": 1.7e9 + TIME})


def aloha(folder: Path) -> Path:
    (folder / "six.urdf").write_text(SIX_JOINTS)
    both = np.hstack([0 * JOINTS, JOINTS])
    with h5py.File(folder / "episode_0.hdf5", "w") as file:
        file["observations/qpos"], file["observations/qvel"] = both, 0 * both
    return folder / "episode_0.hdf5#right"


def lerobot_aloha(folder: Path) -> Path:
    (folder / "six.urdf").write_text(SIX_JOINTS)
    motors = ("waist", "shoulder", "elbow", "forearm_roll", "wrist_angle", "wrist_rotate")
    names = [f"{side}_{one}" for side in ("left", "right") for one in (*motors, "gripper")]
    path = folder / "aloha"
    (path / "meta").mkdir(parents=True)
    (path / "data/chunk-000").mkdir(parents=True)
    features = {"timestamp": {"shape": [1]}}
    features["observation.state"] = {"shape": [14], "names": {"motors": names}}  # type: ignore[dict-item]
    pattern = "data/chunk-{episode_chunk:03d}/episode_{episode_index:06d}.parquet"
    info = {"codebase_version": "v2.1", "total_episodes": 1, "data_path": pattern}
    (path / "meta/info.json").write_text(json.dumps(info | {"features": features}))
    state = list(np.hstack([0 * JOINTS, JOINTS]))
    columns = {"timestamp": TIME, "observation.state": state, "episode_index": [0] * ROWS}
    pq.write_table(pa.table(columns), path / "data/chunk-000/episode_000000.parquet")
    return folder / "aloha#episode_0+right"


WRITERS: dict[str, tuple[Callable[[Path], Path], str]] = {
    "abb_egm": (abb_egm, ""),
    "aloha": (aloha, 'time.rate_hz = 50\nrobot = {urdf = "six.urdf", tool_frame = "l6"}\n'),
    "diffusion_policy": (diffusion_policy, ""),
    "franka": (franka, ""),
    "franka_log": (franka_log, ROBOT % "tcp_r" + "joint_torques.sign = 1\n"),
    "lerobot_aloha": (lerobot_aloha, 'robot = {urdf = "six.urdf", tool_frame = "l6"}\n'),
    "rdp": (rdp, SIGN),
    "reassemble": (reassemble, SIGN),
    "reassemble_misspelt": (reassemble_misspelt, SIGN),
    "robomimic": (robomimic, ""),
    "umi": (umi, "time.rate_hz = 50\n"),
    "ur_rtde": (ur_rtde, SIGN),
}


def test_each_preset_is_here() -> None:
    assert set(WRITERS) == set(preset_names())


@pytest.mark.parametrize("name", WRITERS)
def test_a_preset_reads_what_its_recorder_writes(tmp_path: Path, name: str) -> None:
    write, said = WRITERS[name]
    path = write(tmp_path)
    assert bool(said) == bool(left_open(name))
    recipe = parse_recipe(f'preset = "{name}"\n{said}', str(tmp_path / "r.toml")) if said else None
    found = read(path, recipe)
    np.testing.assert_allclose(found.time_s - found.time_s[0], TIME, atol=1e-6)
    if found.joints_rad is None or name == "diffusion_policy":
        np.testing.assert_allclose(found.position_m, POSITION, atol=1e-8)
        assert found.orientation_wxyz is not None
        turned = Rotation.from_quat(found.orientation_wxyz, scalar_first=True)
        np.testing.assert_allclose((turned.inv() * TURNS).magnitude(), 0, atol=1e-6)
    else:
        count = found.joints_rad.shape[1]
        np.testing.assert_allclose(found.joints_rad, JOINTS[:, :count], atol=1e-9)
    if found.force_N is not None:
        np.testing.assert_allclose(found.force_N, FORCE, atol=1e-6)


@pytest.mark.parametrize("name", [name for name in WRITERS if not left_open(name)])
def test_a_folders_recipe_for_other_columns_is_passed_over_and_told(
    name: str, tmp_path: Path
) -> None:
    path = WRITERS[name][0](tmp_path)
    other = (
        'time = {column = "t", unit = "s"}\nposition = {columns = ["a", "b", "c"], unit = "m"}\n'
    )
    (tmp_path / "recipe.toml").write_text(other)
    found = read(path)
    assert found.source is not None
    assert found.source.recipe == f"preset {name}"
    assert "The folder's recipe.toml names other columns and was passed over." in found.notices
    (tmp_path / "recipe.toml").write_text(f'preset = "{name}"\n')
    assert read(path).source != found.source
