"""The YuMi's description: published figures, and one robot in Pinocchio, MuJoCo and yourdfpy."""

import mujoco
import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from yourdfpy import URDF

from keyphase.robot.arm import Arm
from keyphase.robot.link_frames import link_frames
from keyphase.robot.shapes import link_glb
from keyphase.robot.yumi import joint_names, yumi

RANGES_DEG = {
    "1": (-168.5, 168.5),
    "2": (-143.5, 43.5),
    "7": (-168.5, 168.5),
    "3": (-123.5, 80.0),
    "4": (-290.0, 290.0),
    "5": (-88.0, 138.0),
    "6": (-229.0, 229.0),
}
SPEEDS_DEG_S = {"1": 180, "2": 180, "7": 180, "3": 180, "4": 400, "5": 400, "6": 400}
ARM_KG, ROBOT_KG, GRIPPER_KG, SENSOR_KG = 9.5, 38.0, 0.23, 0.05


@pytest.fixture(scope="module")
def in_mujoco(robot):
    model = mujoco.MjSpec.from_file(str(robot.path)).compile()
    return model, mujoco.MjData(model)


@pytest.fixture(scope="module")
def in_yourdfpy(robot):
    return URDF.load(str(robot.path), load_meshes=False)


def _share(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_nan=False)


ANGLES = st.fixed_dictionaries(
    {
        **{
            name: _share(*np.radians(RANGES_DEG[name.split("_")[2]]))
            for side in ("r", "l")
            for name in joint_names(side)
        },
        "gripper_r_joint": _share(0, 0.025),
        "gripper_l_joint": _share(0, 0.025),
    }
)


@given(angles=ANGLES)
def test_every_link_is_at_one_place_in_all_three_libraries(robot, in_mujoco, in_yourdfpy, angles):
    frames = link_frames(robot, others=angles)

    # It keeps a transform that changes by less than about 1e-8, so it comes from far away.
    in_yourdfpy.update_cfg(dict.fromkeys(angles, 0.7))
    in_yourdfpy.update_cfg(angles)
    model, data = in_mujoco
    for name, value in angles.items():
        data.joint(name).qpos = value
    for side in "rl":
        data.joint(f"gripper_{side}_joint_m").qpos = angles[f"gripper_{side}_joint"]
    mujoco.mj_kinematics(model, data)

    for link, frame in frames.items():
        assert in_yourdfpy.get_transform(link) == pytest.approx(frame, abs=1e-9)
        body = data.body(link)
        assert body.xpos == pytest.approx(frame[:3, 3], abs=1e-9)
        assert body.xmat.reshape(3, 3) == pytest.approx(frame[:3, :3], abs=1e-9)


@pytest.mark.parametrize("side", ["r", "l"])
def test_joint_ranges_and_speeds_are_the_published_ones(side):
    robot = yumi(side)

    assert robot.joint_names == joint_names(side)
    for number, axis in enumerate(("1", "2", "7", "3", "4", "5", "6")):
        lower, upper = np.radians(RANGES_DEG[axis])
        assert robot.lower_rad[number] == pytest.approx(lower)
        assert robot.upper_rad[number] == pytest.approx(upper)
        assert robot.speed_rad_s[number] == pytest.approx(np.radians(SPEEDS_DEG_S[axis]))


def test_arms_and_robot_weigh_what_is_published(in_mujoco):
    model, _ = in_mujoco
    mass = {model.body(i).name: model.body_mass[i] for i in range(model.nbody)}

    for side in "rl":
        arm = sum(mass[f"yumi_link_{number}_{side}"] for number in range(1, 8))
        fingers = mass[f"gripper_{side}_finger_r"] + mass[f"gripper_{side}_finger_l"]
        assert arm == pytest.approx(ARM_KG)
        assert mass[f"gripper_{side}_base"] + fingers == pytest.approx(GRIPPER_KG)
        assert mass[f"tool0_{side}"] + mass[f"ft_{side}"] == pytest.approx(SENSOR_KG)
    assert model.body_mass.sum() == pytest.approx(ROBOT_KG + 2 * (GRIPPER_KG + SENSOR_KG))


def test_sensor_and_tool_point_stay_bodies_of_their_own_in_mujoco(in_mujoco):
    model, _ = in_mujoco
    names = {model.body(i).name for i in range(model.nbody)}

    assert {f"{kind}_{side}" for kind in ("ft", "tcp", "tool0") for side in "rl"} <= names
    assert model.body("ft_r").parentid == model.body("tool0_r").id


def test_the_arms_mirror_each_other():
    right, left = yumi("r"), yumi("l")
    mirror = np.diag([1.0, -1.0, 1.0, 1.0])

    right_tool = Arm(right).forward(right.start_rad)
    left_tool = Arm(left).forward(left.start_rad)

    assert mirror @ right_tool @ mirror == pytest.approx(left_tool, abs=1e-9)


def test_at_the_start_the_tool_points_down_in_front_of_the_body(robot, arm):
    tool = arm.forward(robot.start_rad)

    assert tool[:3, 2] == pytest.approx([0, 0, -1], abs=0.01)
    assert tool[:3, 3] == pytest.approx([0.40, -0.15, 0.12], abs=0.01)


def test_the_fingertips_enclose_the_tool_point(robot):
    frames = link_frames(robot, others={"gripper_r_joint": 0.01})
    tool = np.linalg.inv(frames["tcp_r"])
    for finger, side in (("gripper_r_finger_r", -1), ("gripper_r_finger_l", 1)):
        meshes = [shape for shape in robot.shapes if shape.link == finger]
        points = np.vstack(
            [trimesh.transform_points(s.mesh.vertices, frames[finger] @ s.origin) for s in meshes]
        )
        tips = trimesh.transform_points(points, tool)
        tips = tips[tips[:, 2] > -0.01]
        assert np.abs(tips[:, 0]).min() == pytest.approx(0.01, abs=0.001)
        assert (np.sign(tips[:, 0]) == side).all()
        assert tips[:, 1].mean() == pytest.approx(0, abs=0.002)


def test_no_shell_reaches_below_the_table_or_out_of_its_link(robot):
    frames = link_frames(robot)
    for shape in robot.shapes:
        points = trimesh.transform_points(shape.mesh.vertices, frames[shape.link] @ shape.origin)
        assert points[:, 2].min() > -0.0005


def test_shells_are_smooth_coloured_and_light(robot):
    files = list((robot.path.parent / "shells").glob("*.glb"))

    assert sum(file.stat().st_size for file in files) < 1.3e6
    for link in {shape.link for shape in robot.shapes}:
        shapes = [shape for shape in robot.shapes if shape.link == link]
        again = trimesh.load_scene(trimesh.util.wrap_as_stream(link_glb(shapes)), file_type="glb")
        assert len(again.geometry) == len(shapes)
        for mesh in again.geometry.values():
            assert "vertex_normals" in mesh._cache
            assert mesh.visual.material.baseColorFactor is not None
