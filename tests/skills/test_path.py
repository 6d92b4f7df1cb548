"""What a primitive is fitted to: a smoothed cut, and at a contact what lies beyond it."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from strokes import TIME_S, H, lowered, millimetres_between, segment, stroke

from keyphase.demonstration import Demonstration
from keyphase.errors import SkillError
from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.skills.library import skill_of
from keyphase.skills.path import Path, direction_of_travel, extended, path_of
from keyphase.skills.rollout import rollout

TABLE = ContactEnd((0.0, 0.0, 1.0), 3.0)
CONTACT_S = 1.2


def meeting_the_table(depth_m, beyond_contact):
    """When (s after the demonstrated time) and how fast (demonstrated: 1) it meets the table."""
    demonstration = lowered(depth_m)
    until = segment(0.0, CONTACT_S, TABLE)
    skill = skill_of(demonstration, until, beyond_contact=beyond_contact)
    height = rollout(skill.primitive, H, run_s=3.0).position_m[:, 2]
    meets = int(np.argmax(height <= 0.3 - depth_m + 1e-5))
    contact = demonstration.index_at(CONTACT_S)
    shown = demonstration.position_m[[contact - 5, contact], 2]
    speed = (height[meets - 5] - height[meets]) / (shown[0] - shown[1])
    return meets * H - CONTACT_S, speed


@pytest.mark.parametrize("depth_m", [0.05, 0.1, 0.2])
def test_an_extended_demonstration_meets_the_contact_on_time_and_as_fast_as_shown(depth_m):
    late_s, speed = meeting_the_table(depth_m, "extended demonstration")
    assert abs(late_s) < 0.009
    assert 0.95 < speed < 1.05


def test_the_papers_goal_shift_meets_it_early_and_fast():
    late_s, speed = meeting_the_table(0.05, "goal shift")
    assert late_s < -0.2
    assert speed > 2.0


@pytest.mark.parametrize("beyond_contact", ["extended demonstration", "goal shift"])
def test_both_end_the_offset_beyond_the_contact(beyond_contact):
    skill = skill_of(
        lowered(), segment(0.0, CONTACT_S, TABLE), offset_m=0.03, beyond_contact=beyond_contact
    )
    assert_allclose(skill.primitive.goal_position_m, [0.0, 0.0, 0.17], atol=2e-4)
    assert_allclose(skill.end_position_m, [0.0, 0.0, 0.2], atol=2e-4)


def test_the_brake_starts_with_the_speed_at_the_end_and_stops_without_overshoot():
    path = path_of(lowered(), 0.0, CONTACT_S)
    direction, speed = direction_of_travel(path, TABLE)
    longer = extended(path, direction, speed, 0.02)
    heights = longer.position_m[len(path.time_s) - 1 :, 2]
    assert (heights[0] - heights[1]) / H == pytest.approx(speed, rel=0.01)
    assert (np.diff(heights) <= 1e-12).all()
    assert heights[0] - heights[-1] == pytest.approx(0.02, abs=1e-6)


def test_a_tool_that_hardly_moves_is_sent_against_the_force():
    resting = Path(np.arange(300) * H, np.zeros((300, 3)), None)
    direction, speed = direction_of_travel(resting, ContactEnd((0.0, 0.6, 0.8), 1.0))
    assert_allclose(direction, [0.0, -0.6, -0.8])
    assert speed == 0.02


def test_a_turn_that_is_going_on_at_the_contact_is_braked_too():
    time = np.arange(300) * H
    way = np.c_[0 * time, 0 * time, -0.05 * time]
    wxyz = quaternions.from_rotation_vector(time[:, None] * [0.0, 0.0, 0.5])
    longer = extended(Path(time, way, wxyz), np.array([0.0, 0.0, -1.0]), 0.05, 0.02)
    assert longer.orientation_wxyz is not None
    on = quaternions.difference(longer.orientation_wxyz[-1], wxyz[-1])
    assert_allclose(on, [0.0, 0.0, 0.5 * 0.5 * 0.2], atol=1e-3)


def test_without_offset_nothing_is_added():
    path = path_of(lowered(), 0.0, CONTACT_S)
    assert extended(path, np.array([0.0, 0.0, -1.0]), 0.1, 0.0) is path


def test_half_a_millimetre_of_noise_costs_less_than_two():
    shown = lowered(0.2, noise_m=0.0)
    noisy = lowered(0.2, noise_m=0.0005)
    skill = skill_of(noisy, segment(0.0, 1.2))
    error = millimetres_between(rollout(skill.primitive).position_m, shown.position_m[:301])
    assert error.max() < 2.0


@pytest.mark.parametrize("rate_hz", [20.0, 60.0, 1000.0])
def test_any_rate_gives_the_same_motion(rate_hz):
    slow = skill_of(lowered(rate_hz=rate_hz), segment(0.0, 1.0))
    usual = skill_of(lowered(), segment(0.0, 1.0))
    apart = millimetres_between(
        rollout(slow.primitive).position_m, rollout(usual.primitive).position_m
    )
    assert apart.max() < 0.5


def test_uneven_samples_give_the_same_motion():
    rng = np.random.default_rng(2)
    time = np.sort(rng.uniform(0.0, 1.5, 600))
    at = np.arange(376) * H
    position = np.stack([np.interp(time, at, stroke()[:, k]) for k in range(3)], axis=1)
    uneven = Demonstration("uneven", time, position)
    skill = skill_of(uneven, segment(time[0], time[-1]))
    assert millimetres_between(rollout(skill.primitive).position_m[-1], position[-1]) < 0.2


@pytest.mark.parametrize(("start_s", "end_s"), [(1.0, 1.004), (1.0, 1.0), (1.0, 0.5), (9.0, 10.0)])
def test_a_segment_with_hardly_a_sample_is_refused(start_s, end_s):
    with pytest.raises(SkillError, match="at least 5 samples"):
        path_of(lowered(), start_s, end_s)


def test_a_way_nobody_showed_is_no_skill():
    missing = (TIME_S < 0.3) | (TIME_S > 0.9)
    gone = Demonstration("gone", TIME_S[missing], stroke()[missing])
    with pytest.raises(SkillError, match=r"without data at .* Split it at 0\.\d+ s"):
        path_of(gone, gone.start_s, gone.end_s)
