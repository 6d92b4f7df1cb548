"""Any URDF with a named tool frame can be used, and what cannot is refused in plain words."""

import numpy as np
import pytest
import trimesh

from keyphase.errors import RobotError
from keyphase.robot.arm import Arm
from keyphase.robot.description import load_description
from keyphase.robot.link_frames import link_frames


def test_a_small_robot_is_read_with_its_limits(urdf):
    robot = load_description(urdf(), "tool")

    assert robot.name == "small"
    assert (robot.root, robot.links) == ("base", ("base", "tool"))
    assert robot.joint_names == ("hinge",)
    assert (robot.lower_rad, robot.upper_rad, robot.speed_rad_s) == ([-1], [2], [3])
    assert robot.start_rad == [0.5]


def test_a_continuous_joint_turns_without_limits(urdf, hinge):
    joint = hinge.replace("revolute", "continuous").replace(
        '<limit lower="-1" upper="2" velocity="3" effort="4"/>', ""
    )
    robot = load_description(urdf(joint), "tool")

    assert robot.upper_rad == [np.inf]
    turned = Arm(robot).forward([2.5])
    assert turned[:3, 0] == pytest.approx([np.cos(2.5), 0, -np.sin(2.5)])
    assert link_frames(robot, [2.5])["tool"] == pytest.approx(turned)


def test_a_sliding_joint_slides(urdf, hinge):
    robot = load_description(urdf(hinge.replace("revolute", "prismatic")), "tool")

    assert Arm(robot).forward([0.3])[:3, 3] == pytest.approx([0, 0.3, 1])


def test_a_mimicking_joint_follows(urdf, hinge):
    follower = (
        hinge.replace('"hinge"', '"follower"')
        .replace('"tool"', '"other"')
        .replace("</joint>", '<mimic joint="hinge" multiplier="-2" offset="0.1"/></joint>')
    )
    robot = load_description(urdf(hinge, more=f'<link name="other"/>{follower}'), "tool")

    other = link_frames(robot, [0.4])["other"]

    assert robot.joint_names == ("hinge",)
    assert np.arctan2(other[0, 2], other[0, 0]) == pytest.approx(-0.7)


def test_shapes_lie_where_the_description_puts_them(urdf, tmp_path):
    trimesh.creation.box((0.2, 0.4, 0.6)).export(tmp_path / "box.stl")
    visual = (
        '<visual><origin xyz="0 0 0.5"/><geometry><mesh filename="box.stl" scale="1 1 2"/>'
        "</geometry></visual>"
    )
    (shape,) = load_description(urdf(visual=visual), "tool").shapes

    assert shape.link == "tool"
    corners = trimesh.transform_points(shape.mesh.vertices, shape.origin)
    assert np.ptp(corners, axis=0) == pytest.approx([0.2, 0.4, 1.2])
    assert corners[:, 2].min() == pytest.approx(-0.1)


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(RobotError, match="no such file"):
        load_description(tmp_path / "none.urdf", "tool")


@pytest.mark.parametrize("content", ["", "hello", "\x00\x01", "<robot name='x'>"])
def test_what_is_no_xml_is_refused(tmp_path, content):
    path = tmp_path / "robot.urdf"
    path.write_text(content)
    with pytest.raises(RobotError, match="no XML"):
        load_description(path, "tool")


@pytest.mark.parametrize("content", ["<mujoco/>", '<robot name="x"/>', "<robot><link/></robot>"])
def test_xml_that_is_no_urdf_is_refused(tmp_path, content):
    path = tmp_path / "robot.urdf"
    path.write_text(content)
    with pytest.raises(RobotError, match="expected a URDF"):
        load_description(path, "tool")


def test_an_unknown_frame_is_refused_with_the_frames_there_are(urdf):
    with pytest.raises(RobotError, match=r"none named 'hand'.*choose one of base, tool"):
        load_description(urdf(), "hand")


def test_a_frame_that_no_joint_moves_is_refused(urdf, hinge):
    with pytest.raises(RobotError, match="rigidly connected to 'base'"):
        load_description(urdf(), "base")
    with pytest.raises(RobotError, match="rigidly connected"):
        load_description(urdf(hinge.replace("revolute", "fixed")), "tool")


def test_a_missing_mesh_is_refused_by_name(urdf):
    visual = '<visual><geometry><mesh filename="none.stl"/></geometry></visual>'
    with pytest.raises(RobotError, match=r"mesh 'none\.stl' is missing"):
        load_description(urdf(visual=visual), "tool")


def test_a_mesh_without_a_surface_is_refused_by_name(urdf, tmp_path):
    (tmp_path / "broken.stl").write_bytes(b"no mesh")
    visual = '<visual><geometry><mesh filename="broken.stl"/></geometry></visual>'
    with pytest.raises(RobotError, match=r"mesh 'broken\.stl' of link 'tool'"):
        load_description(urdf(visual=visual), "tool")


@pytest.mark.parametrize(
    ("was", "becomes", "reason"),
    [
        ('type="revolute"', 'type="hinge"', "must be one of revolute"),
        ('type="revolute"', 'type="planar"', "'hinge' is a planar joint"),
        ('type="revolute"', 'type="floating"', "'hinge' is a floating joint"),
        ('parent link="base"', 'parent link="floor"', "its parent is 'floor'"),
        ('child link="tool"', 'child link="hand"', "its child is 'hand'"),
        ('lower="-1"', 'lower="3"', r"has \[3, 2\]; swap"),
        ('lower="-1"', 'lower="2"', "must leave it a range"),
        ('upper="2"', 'upper="nan"', "numbers for upper"),
        (' velocity="3"', "", "but velocity is missing; add what the robot's data sheet says"),
        ('xyz="0 1 0"', 'xyz="0 0 0"', "axis is zero"),
        ('<limit lower="-1" upper="2" velocity="3" effort="4"/>', "", "must have a <limit>"),
        ("</joint>", '<mimic joint="none"/></joint>', "mimics 'none'"),
        ('origin xyz="0 0 1"', 'origin xyz="0 0 x"', "must have 3 numbers"),
    ],
)
def test_a_bad_joint_is_refused_by_name(urdf, hinge, was, becomes, reason):
    with pytest.raises(RobotError, match=reason):
        load_description(urdf(hinge.replace(was, becomes)), "tool")


@pytest.mark.parametrize(
    ("more", "reason"),
    [
        ('<link name="tool"/>', "'tool' is the name of 2"),
        ('<link name="island"/>', r"2 roots \(base, island\)"),
        (
            '<joint name="back" type="fixed"><parent link="tool"/><child link="base"/></joint>',
            "loops",
        ),
    ],
)
def test_links_that_form_no_tree_are_refused(urdf, more, reason):
    with pytest.raises(RobotError, match=reason):
        load_description(urdf(more=more), "tool")


def test_a_start_posture_must_fit_the_joints(urdf):
    robot = load_description(urdf(), "tool")

    assert robot.starting_at([1.5]).start_rad == [1.5]
    with pytest.raises(RobotError, match="1 joint values"):
        robot.starting_at([1.0, 2.0])
    with pytest.raises(RobotError, match="hinge must start within"):
        robot.starting_at([2.5])


def test_a_description_cannot_be_changed(robot):
    with pytest.raises(ValueError, match="read-only"):
        robot.start_rad[0] = 0.0
    with pytest.raises(TypeError):
        robot.rest["gripper_r_joint"] = 0.0
