"""The wrist sensor: what it reads, what it forgets, and what it cannot feel."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration
from keyphase.errors import SimulationError
from keyphase.simulation import Disturbance, Reference, Simulation, record
from keyphase.simulation.workcells.setup1 import SETUP1
from keyphase.simulation.workcells.setup2 import SETUP2
from keyphase.simulation.wrist_sensor import SensorModel, WristSensor, estimated_load

FREE_N = 0.3
both = pytest.mark.parametrize("cell", [SETUP1, SETUP2], ids=lambda cell: cell.name)


def held_still(simulation: Simulation, seconds: float) -> tuple[np.ndarray, np.ndarray]:
    here = simulation.here()
    samples = [simulation.step(here) for _ in range(round(seconds * 250))]
    return np.array([s.force_N for s in samples]), np.array([s.torque_Nm for s in samples])


def means_over_20ms(force: np.ndarray) -> np.ndarray:
    return force[: len(force) // 5 * 5].reshape(-1, 5, 3).mean(axis=1)


def before_anything_is_near(demonstration: Demonstration) -> np.ndarray:
    """Until the tool is 10 mm above where it touches: a rim is met before what it surrounds."""
    onsets = demonstration.metadata["ground_truth"]["contact_onsets_s"]
    height = demonstration.position_m[:, 2]
    touched = height[demonstration.index_at(min(onsets.values()))]
    return np.arange(len(height)) < np.argmax(height < touched + 0.01)


@both
@pytest.mark.parametrize("force", [(0.0, 0.0, 10.0), (6.0, -4.0, 3.0), (-8.0, 0.0, -5.0)])
def test_a_known_push_on_the_part_is_read_back_within_two_percent(cell, force) -> None:
    simulation = cell.build(seed=5)
    _, resting = held_still(simulation, 0.5)
    simulation.push("held", force)
    held_still(simulation, 0.8)
    read, torque = (values.mean(axis=0) for values in held_still(simulation, 1.0))
    strength = float(np.linalg.norm(force))
    assert np.linalg.norm(read - force) < 0.02 * strength
    arm = simulation.data.body("held").xipos - simulation.here().position_m
    expected = np.cross(arm, force)
    assert np.allclose(torque - resting.mean(axis=0), expected, atol=0.02 * strength * 0.06)


@both
def test_the_hand_upstream_of_the_sensor_does_not_show(cell) -> None:
    simulation = cell.build(seed=6)
    here = simulation.here()
    simulation.push("yumi_link_7_r", (10.0, 5.0, -8.0))
    moved = [simulation.step(here) for _ in range(500)]
    assert np.linalg.norm(moved[-1].position_m - here.position_m) > 0.005, "the hand did push"
    force = means_over_20ms(np.array([s.force_N for s in moved[250:]]))
    assert np.linalg.norm(force, axis=1).max() < FREE_N


@pytest.mark.parametrize("name", ["setup1", "setup2"])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_free_space_reads_under_three_tenths_of_a_newton(recorded, name, seed) -> None:
    demonstration = recorded(name, seed)
    free = before_anything_is_near(demonstration)
    assert free.sum() > 500
    force = means_over_20ms(demonstration.force_N[free])
    assert np.linalg.norm(force, axis=1).max() < FREE_N


@pytest.mark.parametrize("name", ["setup1", "setup2"])
def test_without_noise_every_free_sample_is_under_three_tenths_of_a_newton(name) -> None:
    demonstration = record(name, seed=0, disturbance=Disturbance(sensor_noise=0))
    free = before_anything_is_near(demonstration)
    assert demonstration.force_N is not None
    assert free.sum() > 500
    assert np.linalg.norm(demonstration.force_N[free], axis=1).max() < FREE_N


@both
def test_tilting_the_tool_does_not_bring_its_weight_back(cell) -> None:
    simulation = cell.build(seed=8)
    start = simulation.here()
    first = Rotation.from_quat(start.orientation_wxyz, scalar_first=True)
    for angle in np.linspace(0.0, 0.35, 250):
        turned = (Rotation.from_rotvec([angle, angle / 2, 0.0]) * first).as_quat(scalar_first=True)
        simulation.step(Reference(start.position_m, turned))
    force, torque = held_still(simulation, 1.0)
    assert np.linalg.norm(force[125:].mean(axis=0)) < 0.1
    assert np.linalg.norm(torque[125:].mean(axis=0)) < 0.01


def test_the_load_is_estimated_not_looked_up() -> None:
    simulation = SETUP1.build(seed=9)
    model = simulation.model
    below = {model.body("ft_r").id}
    for body in range(model.nbody):
        if int(model.body_parentid[body]) in below:
            below.add(body)
    weight = 9.81 * sum(float(model.body_mass[body]) for body in below)
    assert simulation.load.weight_N == pytest.approx(weight, rel=0.05)
    assert simulation.load.weight_N != pytest.approx(weight, rel=1e-6)


@given(
    weight=st.floats(0.5, 20.0),
    centre=st.tuples(*[st.floats(-0.1, 0.1)] * 3),
    bias=st.tuples(*[st.floats(-2.0, 2.0)] * 6),
    tilt=st.floats(0.2, 1.0),
)
def test_any_load_and_bias_are_told_apart_by_tilted_poses(weight, centre, bias, tilt) -> None:
    turns = [(0, 0, 0), (tilt, 0, 0), (-tilt, 0, 0), (0, tilt, 0), (0, -tilt, 0)]
    rotations = Rotation.from_rotvec(np.array(turns, dtype=float)).as_matrix()
    downs = rotations.transpose(0, 2, 1) @ [0.0, 0.0, -1.0]
    forces, torques = weight * downs, np.cross(weight * np.array(centre), downs)
    readings = np.concatenate([forces, torques], axis=1) + bias
    load = estimated_load(readings, rotations)
    assert load.weight_N == pytest.approx(weight, abs=1e-6)
    for reading, rotation in zip(readings, rotations, strict=True):
        assert np.allclose(load.compensated(reading, rotation), 0.0, atol=1e-6)


def test_poses_that_do_not_tell_weight_from_bias_are_refused() -> None:
    with pytest.raises(SimulationError, match="tilt the wrist more"):
        estimated_load(np.ones((3, 6)), np.repeat(np.eye(3)[None], 3, axis=0))


def readings(model: SensorModel, wrench: np.ndarray, count: int, seed: int = 0) -> np.ndarray:
    sensor = WristSensor(model, 0.004, seed)
    return np.array([sensor.read(wrench) for _ in range(count)])


def test_noise_has_the_stated_deviation() -> None:
    spread = readings(SensorModel(bias_walk=(0.0, 0.0)), np.zeros(6), 4000).std(axis=0)
    assert spread[:3] == pytest.approx([0.1] * 3, rel=0.06)
    assert spread[3:] == pytest.approx([0.002] * 3, rel=0.06)


def test_readings_are_whole_steps_of_the_resolution() -> None:
    steps = readings(SensorModel(), np.ones(6), 50) / [0.02, 0.02, 0.02, 5e-4, 5e-4, 5e-4]
    assert np.allclose(steps, np.round(steps), atol=1e-6)


def test_the_bias_wanders_slowly() -> None:
    model = SensorModel(noise=(0.0, 0.0), resolution=(1e-9, 1e-9))
    wandering = readings(model, np.zeros(6), 15000)
    assert 0.0 < np.abs(wandering[250] - wandering[0]).max() < 0.02
    assert np.ptp(wandering[:, 0]) > np.ptp(wandering[:250, 0])


def test_the_bias_never_jumps() -> None:
    model = SensorModel(noise=(0.0, 0.0), resolution=(1e-12, 1e-12))
    steps = np.abs(np.diff(readings(model, np.zeros(6), 2000), axis=0)).max(axis=0)
    deviation = np.repeat(model.bias_walk, 3) * np.sqrt(0.004)
    assert np.all(steps > 2.0 * deviation), "it does wander"
    assert np.all(steps < 6.0 * deviation)


def test_the_low_pass_delays_a_step_by_its_time_constant() -> None:
    quiet = SensorModel((0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (1e-9, 1e-9), cutoff_hz=10.0)
    sensor = WristSensor(quiet, 0.004, 0)
    sensor.read(np.zeros(6))
    response = np.array([sensor.read(np.ones(6))[0] for _ in range(50)])
    reached = int(np.argmax(response > 1.0 - np.exp(-1.0))) * 0.004
    assert reached == pytest.approx(1.0 / (2.0 * np.pi * 10.0), abs=0.004)


def test_the_same_seed_reads_the_same() -> None:
    assert np.array_equal(
        readings(SensorModel(), np.ones(6), 20, seed=3), readings(SensorModel(), np.ones(6), 20, 3)
    )
