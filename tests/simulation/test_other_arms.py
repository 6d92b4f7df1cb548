"""A recording replayed on another arm, in the world made from it."""

from pathlib import Path

import numpy as np
import pytest
from drawn_contact import its_plan, pressed_slide
from other_arms import seven_axis_mjcf, six_axis_urdf

from keyphase.errors import SimulationError
from keyphase.simulation.choosing import cell_for
from keyphase.simulation.replay.replay import run
from keyphase.skills.library import skills_of

ARMS = {6: (six_axis_urdf, "tool0"), 7: (seven_axis_mjcf, "grip")}


@pytest.mark.parametrize("axes", ARMS)
def test_an_arm_of_six_or_seven_axes_carries_the_plan_out(axes: int, tmp_path: Path) -> None:
    write, tool_frame = ARMS[axes]
    demonstration = pressed_slide()
    cell = cell_for(demonstration, robot=(write(tmp_path), tool_frame))
    skills = skills_of(cell.demonstration, its_plan())
    result = run(cell.build(), skills, cell.demonstration)
    assert result.succeeded, result.outcome()
    joints = result.demonstration.joints_rad
    assert joints is not None
    assert joints.shape[1] == axes
    assert np.ptp(joints, axis=0).max() > 0.05
    assert result.demonstration.metadata["joint_names"] == [f"axis_{n + 1}" for n in range(axes)]


def test_what_is_out_of_reach_is_refused(tmp_path: Path) -> None:
    far = pressed_slide()
    far = type(far)(far.name, far.time_s, 40.0 * far.position_m, far.orientation_wxyz, far.force_N)
    with pytest.raises(SimulationError, match="must reach all of the recording"):
        cell_for(far, robot=(six_axis_urdf(tmp_path), "tool0"))


@pytest.mark.parametrize(
    ("tool_frame", "said"), [("nowhere", "with --tool-frame"), ("link_3", "6 joints or more")]
)
def test_a_frame_that_cannot_be_the_tool_is_refused(
    tool_frame: str, said: str, tmp_path: Path
) -> None:
    with pytest.raises(SimulationError, match=said):
        cell_for(pressed_slide(), robot=(six_axis_urdf(tmp_path), tool_frame))


LOOKS = '<visual><geometry><mesh filename="package://arm/a.dae"/></geometry></visual>'
LIMIT = 'lower="-3" upper="3"'
ODD = {
    "limits the wrong way round": (LIMIT, 'lower="3" upper="-3"', "the limits of joint 'axis_1'"),
    "limits next to each other": (LIMIT, 'lower="0.1" upper="0.2"', "must reach all of the"),
    "millimetres": ("0 0 0.", "0 0 ", "lengths are in metres"),
    "no number": ("0 0 0.35", "0 0 nan", "reaches nan m"),
    "xacro": ('effort="50"', 'effort="${effort}"', "expanded by xacro"),
}


@pytest.mark.parametrize("what", ODD)
def test_an_odd_urdf_is_refused_with_what_is_odd(what: str, tmp_path: Path) -> None:
    path = six_axis_urdf(tmp_path)
    there, odd, said = ODD[what]
    path.write_text(path.read_text().replace(there, odd))
    with pytest.raises(SimulationError, match=said):
        cell_for(pressed_slide(), robot=(path, "tool0"))


def test_meshes_of_a_package_that_is_not_there_are_left_out(tmp_path: Path) -> None:
    path = six_axis_urdf(tmp_path)
    link = '<link name="link_2"/>'
    path.write_text(path.read_text().replace(link, f"{link[:-2]}>{LOOKS}</link>"))
    assert cell_for(pressed_slide(), robot=(path, "tool0")).arm is not None


def test_a_workcell_has_an_arm_of_its_own(tmp_path: Path) -> None:
    with pytest.raises(SimulationError, match="has an arm of its own"):
        cell_for(pressed_slide(), "setup1", (six_axis_urdf(tmp_path), "tool0"))
