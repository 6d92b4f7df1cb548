"""A primitive reproduces the path it was fitted to, and bends it sensibly."""

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

from keyphase.errors import ParameterError, SkillError
from keyphase.rotations import quaternions
from keyphase.skills.fitting import fit_primitive
from keyphase.skills.primitive import Constants
from keyphase.skills.rollout import rollout


def accelerations(position_m, h=H):
    return np.linalg.norm(np.diff(position_m, 2, axis=0), axis=1) / h**2


def test_a_stroke_is_reproduced_within_half_a_millimetre_and_a_tenth_of_a_degree():
    motion = rollout(fit_primitive(TIME_S, stroke(), turn(90.0)))
    assert millimetres_between(motion.position_m, stroke()).max() < 0.5
    assert degrees_between(motion.orientation_wxyz, turn(90.0)).max() < 0.1


@pytest.mark.parametrize("degrees", [170.0, 179.0, 181.0, 190.0, 220.0])
def test_turns_past_half_a_turn_are_followed_the_demonstrated_way(degrees):
    motion = rollout(fit_primitive(TIME_S, stroke(), turn(degrees)))
    assert degrees_between(motion.orientation_wxyz, turn(degrees)).max() < 0.15


def test_a_turn_about_a_wandering_axis_stays_within_half_a_degree_up_to_the_limit():
    motion = rollout(fit_primitive(TIME_S, stroke(), turn(215.0, wobble_rad=0.1)))
    assert degrees_between(motion.orientation_wxyz, turn(215.0, wobble_rad=0.1)).max() < 0.5


def test_a_turn_beyond_the_limit_is_refused():
    with pytest.raises(SkillError, match="split it in two"):
        fit_primitive(TIME_S, stroke(), turn(300.0))


def test_what_is_wiped_for_long_is_followed_as_near_as_what_is_wiped_briefly():
    time = np.arange(0.0, 9.0, H)
    wiped = np.c_[0.03 * np.cos(6.0 * time), 0.03 * np.sin(6.0 * time), 0.0 * time]
    from_rest = wiped * np.minimum(time, 1.0)[:, None]
    motion = rollout(fit_primitive(time, from_rest))
    assert millimetres_between(motion.position_m, from_rest).max() < 3.0


def test_the_start_does_not_jump():
    """Locally weighted regression, the paper's option, starts with a jerk; least squares not."""
    ours = rollout(fit_primitive(TIME_S, stroke())).position_m
    papers = rollout(fit_primitive(TIME_S, stroke(), fit="locally weighted")).position_m
    assert accelerations(ours)[0] < 1.3
    assert accelerations(papers)[0] > 5.0


def test_the_papers_fit_is_rougher_but_arrives():
    motion = rollout(fit_primitive(TIME_S, stroke(), fit="locally weighted"), run_s=3.0)
    error = millimetres_between(motion.position_m[:376], stroke())
    assert 2.0 < error.max() < 20.0
    assert millimetres_between(motion.position_m[-1], stroke()[-1]) < 1.0


def test_a_moved_goal_is_reached_and_the_shape_scales_with_it():
    primitive = fit_primitive(TIME_S, stroke()[:, :1] * [1.0, 0.0, 0.0])
    motion = rollout(primitive, goal_position_m=2.0 * primitive.goal_position_m)
    assert_allclose(motion.position_m, 2.0 * rollout(primitive).position_m, atol=1e-12)


def test_a_moved_goal_orientation_is_reached():
    primitive = fit_primitive(TIME_S, stroke(), turn(90.0))
    goal = quaternions.product(
        quaternions.from_rotation_vector(np.array([0.1, 0.05, 0.0])), turn(90.0)[-1]
    )
    motion = rollout(primitive, run_s=4.5, goal_orientation_wxyz=-goal)
    assert degrees_between(motion.orientation_wxyz[-1], goal) < 0.1


def test_time_scales_and_the_path_stays():
    primitive = fit_primitive(TIME_S, stroke(), turn(120.0))
    slow = rollout(primitive, H, duration_s=3.0 * DURATION_S)
    assert millimetres_between(slow.position_m[::3], stroke()).max() < 0.7
    assert degrees_between(slow.orientation_wxyz[::3], turn(120.0)).max() < 0.15


def test_an_axis_without_net_displacement_is_not_magnified_by_a_moved_goal():
    """50 mm out and back, 0.2 mm net: scaling by the net would swing metres."""
    path = stroke()
    path[:, 1] = 0.05 * np.sin(np.pi * TIME_S / DURATION_S) ** 2 + 0.0002 * TIME_S / DURATION_S
    primitive = fit_primitive(TIME_S, path)
    goal = primitive.goal_position_m + np.array([0.0, 0.01, 0.0])
    moved = rollout(primitive, goal_position_m=goal, run_s=3.0).position_m
    assert np.abs(moved[:376, 1] - path[:, 1]).max() < 0.0105
    assert millimetres_between(moved[-1], goal) < 0.5


def test_an_axis_that_swings_wider_than_its_net_displacement_is_not_scaled_either():
    """50 mm out and back, 3 mm net: a goal 10 mm off must not swing 150 mm."""
    path = stroke()
    path[:, 1] = 0.05 * np.sin(np.pi * TIME_S / DURATION_S) ** 2 + 0.003 * TIME_S / DURATION_S
    primitive = fit_primitive(TIME_S, path)
    assert primitive.scaled.tolist()[:3] == [True, False, True]
    goal = primitive.goal_position_m + np.array([0.0, 0.01, 0.0])
    assert np.abs(rollout(primitive, goal_position_m=goal).position_m[:, 1]).max() < 0.07


def test_a_moved_goal_does_not_jerk_an_axis_that_is_not_scaled():
    primitive = fit_primitive(TIME_S, stroke())
    goal = primitive.goal_position_m + np.array([0.0, 0.01, 0.0])
    as_demonstrated = accelerations(rollout(primitive).position_m)
    moved = accelerations(rollout(primitive, goal_position_m=goal).position_m)
    assert moved.max() < as_demonstrated.max() + 0.3


def test_an_idle_segment_stays_where_it_is():
    primitive = fit_primitive(TIME_S, np.tile([0.1, 0.2, 0.3], (376, 1)))
    assert_allclose(rollout(primitive).position_m, np.tile([0.1, 0.2, 0.3], (376, 1)), atol=1e-12)


@pytest.mark.parametrize("duration_s", [0.05, 0.1, 0.3])
def test_short_motions_stay_stable_at_a_slow_rate(duration_s):
    """At 0.1 s and 50 Hz, alpha_z h / tau is 15; unsplit steps blow up above 1.66."""
    primitive = replace(fit_primitive(TIME_S, stroke(), turn(90.0)), duration_s=duration_s)
    motion = rollout(primitive, 0.02, run_s=20 * duration_s)
    assert np.abs(motion.position_m).max() < 0.4
    assert millimetres_between(motion.position_m[-1], stroke()[-1]) < 0.1
    assert degrees_between(motion.orientation_wxyz[-1], turn(90.0)[-1]) < 0.1


def test_without_orientation_the_one_it_starts_with_is_kept():
    held = quaternions.from_rotation_vector(0.7 * AXIS)
    motion = rollout(fit_primitive(TIME_S, stroke()), start_orientation_wxyz=held)
    assert_allclose(motion.orientation_wxyz, np.tile(held, (376, 1)), atol=1e-12)


def test_a_path_of_a_few_samples_is_refused():
    with pytest.raises(SkillError, match="at least 5 samples"):
        fit_primitive(TIME_S[:4], stroke()[:4])


def test_one_basis_function_is_refused():
    with pytest.raises(ParameterError, match="at least 2"):
        fit_primitive(TIME_S, stroke(), basis_count=1)


@pytest.mark.parametrize("name", ["alpha_z", "k_p", "rotation_weight_m"])
def test_constants_must_be_positive(name):
    with pytest.raises(ParameterError, match=name):
        Constants(**{name: 0.0})
