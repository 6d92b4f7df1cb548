"""A plan executed on a robot of one mass: no simulator, no demonstration at hand."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from point_mass import PointMass, executed
from strokes import lowered, segment

from keyphase.demonstration import Demonstration
from keyphase.errors import SkillError
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, GripperEnd
from keyphase.skills import Executor
from keyphase.skills.connecting import minimum_jerk
from keyphase.skills.gains import gains_for
from keyphase.skills.library import skills_of

DOWN = segment(0.0, 1.2, ContactEnd((0.0, 0.0, 1.0), 3.0), "down until contact")


def plan():
    return skills_of(lowered(), [DOWN, segment(1.2, 2.0, label="press")])


def begun(floor_m, skills=None):
    robot = PointMass((0.0, 0.0, 0.3), floor_m)
    return Executor(plan() if skills is None else skills, robot.sense()), robot


@pytest.mark.parametrize("floor_m", [0.171, 0.19, 0.2, 0.21, 0.229])
def test_a_plan_ends_as_planned_where_the_floor_is(floor_m):
    """The lowest lies where the demonstration, extended by 20 mm, never came."""
    executor, robot = begun(floor_m)
    executed(executor, robot)
    assert [result.outcome for result in executor.results] == ["contact", "reached"]
    assert executor.results[1].shift_m[2] == pytest.approx(floor_m - 0.2, abs=0.001)


def test_it_presses_as_the_demonstration_did():
    executor, robot = begun(0.2)
    executed(executor, robot)
    assert robot.force()[2] == pytest.approx(6.0, abs=0.5)


@pytest.mark.slow
def test_without_a_floor_the_plan_stops_and_says_so():
    executor, robot = begun(-1.0)
    executed(executor, robot)
    assert [result.outcome for result in executor.results] == ["timeout"]


def test_a_tool_that_is_held_has_not_failed():
    executor, robot = begun(0.2)
    sensed = robot.sense()
    for _ in range(5000):
        executor.step(sensed, waits=True)
    assert not executor.results


def test_stopped_it_says_which_skill_it_was_in():
    executor, robot = begun(0.2)
    executor.step(robot.follow(executor.reference))
    executor.stop()
    assert executor.over
    assert [result.outcome for result in executor.results] == [None]


def test_a_plan_without_skills_is_refused():
    with pytest.raises(SkillError, match="at least one skill"):
        Executor((), PointMass((0.0, 0.0, 0.3)).sense())


@pytest.mark.slow
def test_it_needs_no_simulator():
    program = (
        "import sys; from keyphase.skills import Executor; "
        "assert not {'mujoco', 'pinocchio', 'viser', 'yourdfpy'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", program], check=True)


def wiped(peak_N=8.0):
    """A tool that rests pressing on a table, then slides 0.1 m and presses on all the time."""
    time = np.arange(1000) / 250.0
    way = minimum_jerk(np.clip((time - 1.5) / 2.0, 0.0, 1.0))
    force = np.zeros((1000, 3))
    force[:, 2] = np.interp(time, [0.9, 1.0], [0.0, peak_N])
    wxyz = np.tile([1.0, 0.0, 0.0, 0.0], (1000, 1))
    position = np.c_[0.1 * way, np.zeros(1000), np.full(1000, 0.3)]
    return Demonstration("wiped", time, position, wxyz, force)


def test_a_skill_that_starts_in_a_contact_loads_it_first_and_follows_its_force():
    """No contact-terminated skill came before: the pause in which it was made is dropped."""
    skills = skills_of(wiped(), [segment(1.5, 3.5, label="wipe")])
    executor, robot = begun(0.3, skills)
    forces, stages = [], set()

    def note(sensed):
        stages.add(executor.stage)
        if executor.stage == "moving":
            forces.append(sensed.force_N[2])

    executed(executor, robot, each_tick=note)
    assert executor.results[0].outcome == "reached"
    assert "loading" in stages
    assert np.median(forces) == pytest.approx(8.0, abs=0.5)
    assert min(forces) > 5.0


def test_a_harder_demonstration_gets_a_stiffer_impedance():
    assert gains_for(wiped(peak_N=8.0)).stiffness_N_m == 2000.0
    harder = gains_for(wiped(peak_N=40.0))
    assert harder.stiffness_N_m == pytest.approx(6000.0)
    assert gains_for(wiped(peak_N=400.0)).stiffness_N_m == 8000.0
    assert harder.damping_Ns_m == pytest.approx(180.0 * np.sqrt(3.0))


@pytest.mark.parametrize(("closes", "outcomes"), [(True, ["reached"] * 2), (False, ["timeout"])])
def test_a_plan_goes_on_from_a_grasp_once_the_gripper_has_closed(closes, outcomes):
    grasp = ConfigurationEnd(gripper=GripperEnd("grasp", 0.02, 0.004))
    skills = skills_of(lowered(step_N=0.0), [segment(0.0, 1.2, grasp), segment(1.2, 2.0)])
    executor, robot = begun(-1.0, skills)
    while not executor.over:
        robot.follow(executor.reference)
        closed = closes and executor.elapsed_s > 2.0
        executor.step(replace(robot.sense(), gripper=0.02 if closed else 0.08))
    assert [result.outcome for result in executor.results] == outcomes
    assert executor.results[0].end_s > 2.0
