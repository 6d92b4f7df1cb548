"""Held and released: the primitive waits for the robot and goes on where it is."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from strokes import (
    AXIS,
    DURATION_S,
    TIME_S,
    H,
    degrees_between,
    millimetres_between,
    stroke,
    turn,
)

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.skills.coupling import REFERENCE_REACH, Measured, start, step
from keyphase.skills.fitting import fit_primitive
from keyphase.skills.rollout import rollout

HOLD_S = (0.6, 1.6)
MASS_KG, STIFFNESS, DAMPING = 2.0, 2000.0, 180.0
TURN_INERTIA, TURN_STIFFNESS, TURN_DAMPING = 0.02, 40.0, 3.0


def robot(primitive, run_s, hold_s=None):
    """A body on the impedance controller's springs at 1 kHz, stopped dead while it is held.

    Yields after each control step: time, position, orientation, state, reference.
    """
    position, wxyz, velocity = stroke()[0], primitive.start_orientation_wxyz, np.zeros(6)
    state = start(primitive)
    for k in range(round(run_s / H)):
        state, reference = step(primitive, state, Measured(position, wxyz, velocity), H)
        held = hold_s is not None and hold_s[0] <= k * H < hold_s[1]
        for _ in range(4):
            velocity = (
                0.0 * velocity
                if held
                else velocity + H / 4 * pull(reference, position, wxyz, velocity)
            )
            position = position + H / 4 * velocity[:3]
            turned = quaternions.from_rotation_vector(H / 4 * velocity[3:])
            wxyz = quaternions.normalised(quaternions.product(turned, wxyz))
        yield k * H, position, wxyz, state, reference


def pull(reference, position, wxyz, velocity):
    """Acceleration (6,) of the body by the impedance towards the reference."""
    off = reference.velocity - velocity
    left = quaternions.product(reference.orientation_wxyz, quaternions.conjugate(wxyz))
    force = STIFFNESS * (reference.position_m - position) + DAMPING * off[:3]
    torque = TURN_STIFFNESS * quaternions.shortest_rotation_vector(left) + TURN_DAMPING * off[3:]
    return np.concatenate([force / MASS_KG, torque / TURN_INERTIA])


def off_the_path(primitive, positions):
    """Largest distance from the demonstrated path, whenever it is passed [mm]."""
    path = rollout(primitive, H / 4).position_m
    return max(millimetres_between(path, p).min() for p in positions)


def uncoupled(primitive):
    return replace(primitive, constants=replace(primitive.constants, k_c=0.0))


@pytest.fixture(scope="module")
def primitive():
    return fit_primitive(TIME_S, stroke(), turn(90.0))


def test_undisturbed_it_follows_the_demonstration_in_its_time(primitive):
    at = list(robot(primitive, DURATION_S))
    followed = np.array([position for _, position, *_ in at])
    turned = np.array([wxyz for _, _, wxyz, *_ in at])
    assert millimetres_between(followed[:-1], stroke()[1:-1]).max() < 1.0
    assert degrees_between(turned[:-1], turn(90.0)[1:-1]).max() < 0.5


def test_held_for_a_second_it_waits_and_comes_back_within_five_millimetres(primitive):
    at = list(robot(primitive, 5.0, HOLD_S))
    assert off_the_path(primitive, [position for _, position, *_ in at]) < 4.5
    after = [r.acceleration[:3] for t, *_, r in at if t >= HOLD_S[1]]
    assert np.linalg.norm(after, axis=1).max() < 2.0
    assert millimetres_between(at[-1][1], stroke()[-1]) < 0.1
    assert degrees_between(at[-1][2], turn(90.0)[-1]) < 0.1


def test_without_coupling_it_cuts_the_corner(primitive):
    at = list(robot(uncoupled(primitive), 5.0, HOLD_S))
    assert off_the_path(primitive, [position for _, position, *_ in at]) > 20.0
    after = [r.acceleration[:3] for t, *_, r in at if t >= HOLD_S[1]]
    assert np.linalg.norm(after, axis=1).max() > 4.0


def test_while_it_is_held_the_phase_all_but_stands_still(primitive):
    phases = {round(t, 3): state.phase for t, _, _, state, _ in robot(primitive, 2.0, HOLD_S)}
    assert phases[0.796] / phases[1.596] < 1.1
    assert phases[0.0] / phases[0.6] > 3.0


def test_a_turn_alone_that_is_held_waits_too():
    still = np.tile(stroke()[0], (376, 1))
    primitive = fit_primitive(TIME_S, still, turn(90.0))
    at = list(robot(primitive, 4.0, HOLD_S))
    phases = {round(t, 3): state.phase for t, _, _, state, _ in at}
    assert phases[0.796] / phases[1.596] < 1.1
    assert degrees_between(at[-1][2], turn(90.0)[-1]) < 0.2


def test_a_brief_motion_that_begins_at_once_sets_off_without_a_kick():
    """2 mm within 60 ms, most of it in the first 20: a tool that stood does not overshoot."""
    time = np.arange(16, dtype=np.float64) * H
    path: Array = 2e-3 * (1.0 - np.exp(-time / 0.015))
    primitive = fit_primitive(time, path[:, None] * AXIS)
    state, at, velocity = start(primitive), np.zeros(3), np.zeros(6)
    for _ in time:
        here = Measured(at, state.orientation_wxyz, velocity)
        state, reference = step(primitive, state, here, H)
        assert np.linalg.norm(reference.velocity) < 0.13
        at, velocity = 0.5 * (at + reference.position_m), 0.5 * reference.velocity
    assert np.linalg.norm(at - path[-1] * AXIS) < 1e-3


def test_the_reference_stays_within_reach_of_a_robot_that_is_held(primitive):
    for _, position, wxyz, _, reference in robot(primitive, 1.6, (0.3, 1.6)):
        assert np.linalg.norm(reference.position_m - position) < REFERENCE_REACH[0] + 2e-3
        assert (
            degrees_between(reference.orientation_wxyz, wxyz) < np.degrees(REFERENCE_REACH[1]) + 1
        )


def test_a_clamped_reference_takes_the_measured_velocity(primitive):
    far = Measured(stroke()[0] + 0.05, primitive.start_orientation_wxyz, np.full(6, 0.25))
    _, reference = step(primitive, start(primitive), far, H)
    assert_allclose(reference.velocity[:3], far.velocity[:3])
    away = np.linalg.norm(reference.position_m - far.position_m)
    assert away == pytest.approx(REFERENCE_REACH[0])


def test_a_quaternion_measured_with_the_other_sign_changes_nothing(primitive):
    state = start(primitive)
    pose = quaternions.product(quaternions.from_rotation_vector(0.01 * AXIS), turn(90.0)[0])
    one = step(primitive, state, Measured(stroke()[0], pose, np.zeros(6)), H)
    other = step(primitive, state, Measured(stroke()[0], -pose, np.zeros(6)), H)
    assert_allclose(one[1].acceleration, other[1].acceleration, atol=1e-12)
    assert_allclose(one[0].error_m, other[0].error_m, atol=1e-15)


def test_a_batch_steps_like_its_members(primitive):
    rng = np.random.default_rng(5)
    off = 0.01 * rng.normal(size=(6, 3))
    batch = start(primitive, primitive.start_position_m + off)
    singles = [start(primitive, primitive.start_position_m + one) for one in off]
    for k in range(50):
        nudge = 0.002 * np.sin(0.3 * k + np.arange(18.0)).reshape(6, 3)
        pose = quaternions.product(quaternions.from_rotation_vector(nudge), turn(90.0)[k])
        seen = Measured(stroke()[k] + nudge, pose, np.tile(nudge, (1, 2)))
        batch, reference = step(primitive, batch, seen, H)
        for n, single in enumerate(singles):
            own = Measured(seen.position_m[n], seen.orientation_wxyz[n], seen.velocity[n])
            singles[n], alone = step(primitive, single, own, H)
            assert_allclose(reference.position_m[n], alone.position_m, atol=1e-13)
            assert_allclose(reference.orientation_wxyz[n], alone.orientation_wxyz, atol=1e-13)
            assert_allclose(reference.acceleration[n], alone.acceleration, atol=1e-10)
    assert_allclose(batch.phase, [single.phase for single in singles], atol=1e-15)
