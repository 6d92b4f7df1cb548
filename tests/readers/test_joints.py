"""Position by joint angles and a robot description, wrench by joint torques."""

from pathlib import Path

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.errors import RecipeError
from keyphase.files.shipped import shipped
from keyphase.readers import find_recordings, read
from keyphase.robot.arm import Arm
from keyphase.robot.yumi import yumi

JOINTS = 7
URDF = shipped("static_robots") / "yumi" / "yumi.urdf"
RECIPE = f"""
time = {{column = "t", unit = "s"}}
joints = {{columns = "q?", unit = "rad"}}
robot = {{urdf = "{URDF.as_posix()}", tool_frame = "tcp_r"}}
"""
TORQUES = 'joint_torques = {columns = "tau?", unit = "Nm", sign = 1}\n'
PRESS = np.array([1.0, -2.0, 8.0, 0.1, 0.2, -0.3])


@pytest.fixture(scope="module")
def arm() -> Arm:
    return Arm(yumi("r"))


@pytest.fixture
def logged(tmp_path: Path, arm: Arm) -> tuple[Path, np.ndarray]:
    """A table of joints and of the torques that one wrench exerts on them."""
    joints = arm.robot.start_rad + 0.2 * np.sin(np.arange(20)[:, None] / 5 + np.arange(JOINTS))
    rows = [",".join(["t", *(f"q{i}" for i in range(7)), *(f"tau{i}" for i in range(7))])]
    for number, posture in enumerate(joints):
        torques = arm.jacobian(posture).T @ PRESS
        rows.append(",".join(map(repr, [number / 50, *posture.tolist(), *torques.tolist()])))
    (tmp_path / "run.csv").write_text("\n".join([*rows, ""]))
    return tmp_path / "run.csv", joints


def reading(path: Path, recipe: str) -> Demonstration:
    (path.parent / "recipe.toml").write_text(recipe)
    return read(path)


def test_the_pose_is_where_the_joints_put_the_tool(
    logged: tuple[Path, np.ndarray], arm: Arm
) -> None:
    path, joints = logged
    demonstration = reading(path, RECIPE)
    expected = np.array([arm.forward(posture)[:3, 3] for posture in joints])
    np.testing.assert_allclose(demonstration.position_m, expected, atol=1e-9)
    assert demonstration.orientation_wxyz is not None
    assert not demonstration.wrench_estimated


def test_the_wrench_is_what_explains_the_torques_and_is_marked(
    logged: tuple[Path, np.ndarray],
) -> None:
    demonstration = reading(logged[0], RECIPE + TORQUES)
    assert demonstration.force_N is not None
    assert demonstration.torque_Nm is not None
    loads = np.hstack([demonstration.force_N, demonstration.torque_Nm])
    np.testing.assert_allclose(loads, np.tile(PRESS, (20, 1)), atol=1e-6)
    assert demonstration.wrench_estimated
    assert any("estimated of joint torques" in notice for notice in demonstration.notices)


@pytest.mark.parametrize(
    ("recipe", "told"),
    [
        (RECIPE.replace("tcp_r", "tcp_x"), "has no link 'tcp_x'"),
        (RECIPE.replace('"q?"', '["q0", "q1"]'), "a column for each of the 7 joints"),
        (
            RECIPE.replace('joints = {columns = "q?", unit = "rad"}', ""),
            "says where the tool is by \\[joints\\]",
        ),
        (RECIPE[: RECIPE.index("robot")], r"name your robot in \[robot\] urdf"),
        (RECIPE[: RECIPE.index("robot")] + TORQUES, r"name your robot in \[robot\] urdf"),
    ],
)
def test_what_does_not_fit_is_refused_with_what_would(
    logged: tuple[Path, np.ndarray], recipe: str, told: str
) -> None:
    with pytest.raises(RecipeError, match=told):
        reading(logged[0], recipe)


def test_both_arms_of_an_aloha_file_are_recordings(tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "episode_0.hdf5", "w") as file:
        for name in ("observations/qpos", "observations/qvel", "action"):
            file[name] = np.zeros((20, 14), np.float32)
    names = [found.path.name for found in find_recordings([tmp_path])]
    assert names == ["episode_0.hdf5#left", "episode_0.hdf5#right"]
