"""The Cartesian impedance: a spring and damper at the tool point, inside the joint limits."""

import numpy as np
import pytest

from keyphase.errors import SimulationError
from keyphase.simulation import Gains, Reference, Simulation
from keyphase.simulation.demonstrating.follower import MAX_AHEAD_M, Follower
from keyphase.simulation.impedance import CartesianImpedance
from keyphase.simulation.workcells.setup1 import SETUP1


def settle(simulation: Simulation, reference: Reference, seconds: float) -> None:
    for _ in range(round(seconds * 250)):
        simulation.step(reference)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_push_is_met_with_the_stated_stiffness(axis) -> None:
    simulation = SETUP1.build()
    here = simulation.here()
    force = np.zeros(3)
    force[axis] = 6.0
    simulation.push("held", force)
    settle(simulation, here, 1.5)
    moved = simulation.here().position_m - here.position_m
    assert moved[axis] == pytest.approx(6.0 / Gains().stiffness_N_m, rel=0.02)


def test_the_tool_carries_its_own_weight() -> None:
    simulation = SETUP1.build()
    here = simulation.here()
    settle(simulation, here, 1.0)
    assert np.allclose(simulation.here().position_m, here.position_m, atol=2e-5)


def test_a_moving_reference_is_followed() -> None:
    simulation = SETUP1.build()
    start = simulation.here()
    velocity = np.array([0.05, 0.0, 0.02])
    furthest = 0.0
    for tick in range(250):
        goal = start.position_m + velocity * tick / 250
        simulation.step(Reference(goal, start.orientation_wxyz, velocity))
        if tick > 125:
            furthest = max(furthest, float(np.linalg.norm(simulation.here().position_m - goal)))
    assert furthest < 0.002


@pytest.mark.parametrize(
    "goal", [(0.4, -0.9, 0.3), (1.5, -0.2, 0.2), (-0.3, -0.2, 0.6), (0.3, 0.6, 0.2)]
)
def test_joint_limits_hold_however_far_the_reference(goal) -> None:
    simulation = SETUP1.build()
    start = simulation.here()
    follower = Follower(start)
    low, high = simulation.model.jnt_range[:7].T
    for _ in range(1500):
        far = Reference(np.array(goal), start.orientation_wxyz)
        simulation.step(follower.towards(far, simulation.here()))
        assert (simulation.joints_rad() > low - 0.01).all()
        assert (simulation.joints_rad() < high + 0.01).all()


def test_a_far_reference_pulls_with_a_bounded_force() -> None:
    simulation = SETUP1.build()
    start = simulation.here()
    simulation.push("held", [0.0, 0.0, -Gains().greatest_force_N - 5.0])
    settle(
        simulation, Reference(start.position_m + np.array([0, 0, 0.5]), start.orientation_wxyz), 0.2
    )
    assert simulation.here().position_m[2] < start.position_m[2]


def test_a_following_reference_reaches_its_target_smoothly() -> None:
    start = Reference(np.zeros(3), np.array([1.0, 0.0, 0.0, 0.0]))
    goal = Reference(np.array([0.05, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0]))
    follower, here = Follower(start), start
    speeds = []
    for _ in range(1000):
        here = follower.towards(goal, here)
        speeds.append(float(np.linalg.norm(here.velocity_m_s)))
    assert here.position_m == pytest.approx(goal.position_m, abs=1e-6)
    assert abs(float(here.orientation_wxyz @ goal.orientation_wxyz)) == pytest.approx(1.0)
    assert max(speeds) <= 0.25 + 1e-9
    assert np.abs(np.diff(speeds)).max() < 0.15


def test_a_following_reference_waits_for_a_tool_that_is_held() -> None:
    start = Reference(np.zeros(3), np.array([1.0, 0.0, 0.0, 0.0]))
    goal = Reference(np.array([0.0, 0.0, -0.2]), start.orientation_wxyz)
    follower = Follower(start)
    for _ in range(500):
        ahead = follower.towards(goal, start)
    assert np.linalg.norm(ahead.position_m) <= MAX_AHEAD_M + 1e-9


def test_joints_that_are_no_chain_are_refused() -> None:
    simulation = SETUP1.build()
    with pytest.raises(SimulationError, match="side by side"):
        CartesianImpedance(simulation.model, 0, np.array([0, 2, 3]), Gains())
