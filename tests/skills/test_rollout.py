"""The closed rollout is the stepped one, and a batch is its members."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from strokes import TIME_S, H, stroke, turn

from keyphase.errors import SkillError
from keyphase.rotations import quaternions
from keyphase.skills.coupling import Measured, start, step
from keyphase.skills.fitting import fit_primitive
from keyphase.skills.rollout import rollout


@pytest.fixture(scope="module")
def primitive():
    return fit_primitive(TIME_S, stroke(), turn(100.0))


def stepped(primitive, steps, h, **where):
    """Poses of a primitive that always measures itself where it wants to be."""
    state = start(primitive, **where)
    positions, orientations = [state.position_m], [state.orientation_wxyz]
    for _ in range(steps):
        own = Measured(state.position_m, state.orientation_wxyz, state.z / state.tau[..., None])
        state, _ = step(primitive, state, own, h)
        positions.append(state.position_m)
        orientations.append(state.orientation_wxyz)
    return np.stack(positions, axis=-2), np.stack(orientations, axis=-2)


@pytest.mark.parametrize("duration_s", [1.5, 0.6, 4.0])
def test_it_gives_the_numbers_of_stepping_without_coupling(primitive, duration_s):
    positions, orientations = stepped(primitive, 200, H, duration_s=duration_s)
    motion = rollout(primitive, H, run_s=200 * H, duration_s=duration_s)
    assert_allclose(motion.position_m, positions, atol=1e-12)
    assert_allclose(motion.orientation_wxyz, orientations, atol=1e-12)


def test_split_steps_give_the_numbers_of_stepping(primitive):
    """At 50 Hz, alpha_z h / tau is 1: every step is done in two halves, measured once."""
    single = rollout(primitive, 0.02)
    fine = rollout(primitive, 0.01)
    assert_allclose(single.position_m, fine.position_m[::2], atol=1e-12)
    assert_allclose(single.orientation_wxyz, fine.orientation_wxyz[::2], atol=1e-12)


def perturbed(primitive, count=20, seed=1):
    rng = np.random.default_rng(seed)
    return {
        "start_position_m": primitive.start_position_m + 0.01 * rng.normal(size=(count, 3)),
        "goal_position_m": primitive.goal_position_m + 0.02 * rng.normal(size=(count, 3)),
        "goal_orientation_wxyz": quaternions.product(
            quaternions.from_rotation_vector(0.1 * rng.normal(size=(count, 3))),
            primitive.goal_orientation_wxyz,
        ),
    }


def test_a_batch_of_rollouts_equals_single_ones(primitive):
    where = perturbed(primitive)
    batch = rollout(primitive, **where)
    assert batch.position_m.shape == (20, 376, 3)
    for k in (0, 7, 19):
        single = rollout(primitive, **{name: values[k] for name, values in where.items()})
        assert_allclose(batch.position_m[k], single.position_m, atol=1e-13)
        assert_allclose(batch.orientation_wxyz[k], single.orientation_wxyz, atol=1e-13)


def test_a_batch_equals_stepping_the_batch(primitive):
    where = perturbed(primitive, 5)
    positions, orientations = stepped(
        primitive,
        100,
        H,
        position_m=where["start_position_m"],
        goal_position_m=where["goal_position_m"],
        goal_orientation_wxyz=where["goal_orientation_wxyz"],
    )
    batch = rollout(primitive, run_s=100 * H, **where)
    assert_allclose(batch.position_m, positions, atol=1e-12)
    assert_allclose(batch.orientation_wxyz, orientations, atol=1e-12)


def test_arguments_are_broadcast_against_each_other(primitive):
    starts = primitive.start_position_m + np.array([[[0.01]], [[0.02]]])
    goals = primitive.goal_position_m + np.array([[0.0], [0.01], [0.02]])
    motion = rollout(primitive, start_position_m=starts, goal_position_m=goals)
    assert motion.position_m.shape == (2, 3, 376, 3)
    assert motion.orientation_wxyz.shape == (2, 3, 376, 4)


@pytest.mark.parametrize("duration_s", [0.0, -1.0, np.nan])
def test_a_duration_that_is_not_positive_is_refused(primitive, duration_s):
    with pytest.raises(SkillError, match="above zero"):
        rollout(primitive, duration_s=duration_s)
