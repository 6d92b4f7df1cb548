"""Rollouts against movement_primitives' compiled steps; stepping, fitting and monitoring alone.

Ratios are between medians taken within one run, on one core. A stroke of 1.5 s at 250 Hz, 25
basis functions per axis; "pose" is position and orientation.
"""

import statistics
import sys
from pathlib import Path
from timeit import repeat

import numpy as np
import pytest
from movement_primitives import dmp

sys.path.insert(0, str(Path(__file__).parents[1] / "skills"))
from strokes import DURATION_S, TIME_S, H, lowered, segment, stroke, turn

from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ContactEnd, end_condition_at
from keyphase.skills.coupling import Measured, start, step
from keyphase.skills.end_monitor import start_monitor
from keyphase.skills.fitting import fit_primitive
from keyphase.skills.library import skill_of
from keyphase.skills.rollout import rollout

BATCH = 1000


def median_s(function, rounds=20):
    return statistics.median(repeat(function, number=1, repeat=rounds))


@pytest.fixture(scope="module")
def primitive():
    return fit_primitive(TIME_S, stroke(), turn(90.0))


@pytest.fixture(scope="module")
def their_pose():
    model = dmp.CartesianDMP(DURATION_S, dt=H, n_weights_per_dim=25, int_dt=H)
    model.imitate(TIME_S, np.hstack([stroke(), turn(90.0)]))
    return model


@pytest.fixture(scope="module")
def their_position():
    model = dmp.DMP(3, DURATION_S, dt=H, n_weights_per_dim=25, int_dt=H)
    model.imitate(TIME_S, stroke())
    return model


def roll_their_pose(model, goal=None, steps="euler-cython"):
    """Their fastest way to a pose: compiled Euler steps for the position, compiled ones besides."""
    model.reset()
    if goal is not None:
        model.configure(goal_y=goal)
    return model.open_loop(step_function=steps, quaternion_step_function="cython")


def roll_their_position(model, steps):
    model.reset()
    return model.open_loop(step_function=steps)


def perturbed_goals(primitive):
    rng = np.random.default_rng(0)
    position = primitive.goal_position_m + 0.01 * rng.normal(size=(BATCH, 3))
    tilt = quaternions.from_rotation_vector(0.05 * rng.normal(size=(BATCH, 3)))
    return position, quaternions.product(tilt, primitive.goal_orientation_wxyz)


@pytest.mark.parametrize("steps", ["rk4-cython", "euler-cython"])
def test_one_pose_rollout(benchmark, primitive, their_pose, steps):
    benchmark.extra_info["times faster"] = ratio = median_s(
        lambda: roll_their_pose(their_pose, steps=steps)
    ) / median_s(lambda: rollout(primitive, H))
    benchmark(rollout, primitive, H)
    print(f"\none pose rollout: {ratio:.1f} times faster than {steps}")
    assert ratio >= 1.0


@pytest.mark.parametrize("steps", ["rk4-cython", "euler-cython"])
def test_one_position_rollout(benchmark, their_position, steps):
    primitive = fit_primitive(TIME_S, stroke())
    benchmark.extra_info["times faster"] = ratio = median_s(
        lambda: roll_their_position(their_position, steps)
    ) / median_s(lambda: rollout(primitive, H))
    benchmark(rollout, primitive, H)
    print(f"\none position rollout: {ratio:.1f} times faster than {steps}")
    assert ratio >= 1.0


@pytest.mark.parametrize("steps", ["rk4-cython", "euler-cython"])
def test_a_batch_of_perturbed_pose_rollouts(benchmark, primitive, their_pose, steps):
    position, wxyz = perturbed_goals(primitive)
    goals = iter(np.tile(np.hstack([position, wxyz]), (10, 1)))

    def ours():
        return rollout(primitive, H, goal_position_m=position, goal_orientation_wxyz=wxyz)

    theirs_s = median_s(lambda: roll_their_pose(their_pose, next(goals), steps), rounds=100)
    benchmark.extra_info["times faster each"] = ratio = theirs_s / (median_s(ours, 7) / BATCH)
    benchmark(ours)
    print(f"\n{BATCH} pose rollouts: {ratio:.0f} times faster each than {steps}")
    assert ratio >= 20.0


def test_a_batch_of_perturbed_position_rollouts(benchmark, their_position):
    primitive = fit_primitive(TIME_S, stroke())
    position, _ = perturbed_goals(primitive)

    def ours():
        return rollout(primitive, H, goal_position_m=position)

    theirs_s = median_s(lambda: roll_their_position(their_position, "euler-cython"), rounds=50)
    benchmark.extra_info["times faster each"] = ratio = theirs_s / (median_s(ours, 7) / BATCH)
    benchmark(ours)
    print(f"\n{BATCH} position rollouts: {ratio:.0f} times faster each than euler-cython")
    assert ratio >= 20.0


def test_one_coupled_step(benchmark, primitive):
    state = start(primitive)
    measured = Measured(state.position_m, state.orientation_wxyz, np.zeros(6))
    benchmark(step, primitive, state, measured, H)


def test_a_coupled_step_of_a_batch(benchmark, primitive):
    position, wxyz = perturbed_goals(primitive)
    state = start(primitive, goal_position_m=position, goal_orientation_wxyz=wxyz)
    measured = Measured(state.position_m, state.orientation_wxyz, np.zeros((BATCH, 6)))
    benchmark(step, primitive, state, measured, H)


def test_fitting_a_pose(benchmark):
    benchmark(fit_primitive, TIME_S, stroke(), turn(90.0))


def test_a_skill_of_a_segment(benchmark):
    demonstration = lowered()
    until = segment(0.0, 1.2, ContactEnd((0.0, 0.0, 1.0), 3.0))
    benchmark(skill_of, demonstration, until)


def test_one_step_of_the_end_monitor(benchmark):
    skill = skill_of(lowered(), segment(0.0, 1.2, ContactEnd((0.0, 0.0, 1.0), 3.0)))
    monitor = start_monitor(skill, np.zeros(3))
    wxyz, force = np.array(quaternions.IDENTITY), np.zeros(3)
    benchmark(monitor.step, skill.end_position_m, wxyz, force, 0.1, H)


def test_an_end_condition_on_a_million_samples(benchmark):
    demonstration = lowered(contact_s=3999.0)
    assert len(demonstration) == 1_000_000
    benchmark(end_condition_at, demonstration, 3000.0, 3999.0, True)
