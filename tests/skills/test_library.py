"""From the plan's segments to skills, with connecting moves where needed."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from strokes import H, degrees_between, lowered, millimetres_between, segment, turn

from keyphase.demonstration import Demonstration
from keyphase.errors import ParameterError, SkillError
from keyphase.readers import read
from keyphase.rotations import quaternions
from keyphase.rotations.courses import angular_velocity
from keyphase.segmentation import segment as segment_demonstration
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.skills.connecting import PEAK_SPEED_M_S, PEAK_TURN_RAD_S, connecting_skill
from keyphase.skills.execution.shift import shift_after
from keyphase.skills.library import skill_of, skills_of
from keyphase.skills.path import path_of
from keyphase.skills.rollout import rollout
from keyphase.skills.skill import describe, drawn

CONTACT = ContactEnd((0.0, 0.0, 1.0), 3.0)
DOWN = segment(0.0, 1.2, CONTACT, "down until contact")
REST = segment(1.2, 2.0, label="press")
UPRIGHT = np.array(quaternions.IDENTITY)
UP = np.array([0.0, 0.0, 1.0])


def test_segments_that_follow_each_other_need_no_connecting_move():
    skills = skills_of(lowered(), [DOWN, REST])
    assert [s.label for s in skills] == ["down until contact", "press"]


def test_a_repeated_segment_is_connected_from_its_end_to_its_start():
    first, move, second = skills_of(lowered(), [DOWN, DOWN])
    assert move.connecting
    assert move.label == "connect to down until contact"
    assert_allclose(move.primitive.start_position_m, first.end_position_m)
    assert_allclose(move.end_position_m, second.primitive.start_position_m)


def test_connecting_can_be_left_to_the_caller():
    assert len(skills_of(lowered(), [DOWN, DOWN], connect=False)) == 2


def test_an_empty_plan_has_no_skills():
    assert skills_of(lowered(), []) == ()


def test_a_connecting_move_is_minimum_jerk_and_keeps_its_speeds():
    there = quaternions.from_rotation_vector(np.array([0.0, 0.0, 2.0]))
    move = connecting_skill(np.zeros(3), UPRIGHT, np.array([0.1, 0.2, 0.0]), there)
    motion = rollout(move.primitive, H)
    speed = np.linalg.norm(np.diff(motion.position_m, axis=0), axis=1) / H
    turning = np.linalg.norm(angular_velocity(motion.time_s, motion.orientation_wxyz), axis=1)
    assert speed.max() < 1.01 * PEAK_SPEED_M_S
    assert turning.max() < 1.01 * PEAK_TURN_RAD_S
    assert max(speed[0], speed[-1]) < 2e-3
    assert millimetres_between(motion.position_m[-1], [0.1, 0.2, 0.0]) < 0.2
    assert degrees_between(motion.orientation_wxyz[-1], there) < 0.1


def test_a_connecting_move_turns_the_shorter_way():
    move = connecting_skill(np.zeros(3), UPRIGHT, np.zeros(3), -turn(10.0)[-1])
    left = move.primitive.displacement[3:]
    assert np.linalg.norm(left) < np.pi


def test_a_contact_skill_knows_its_way_and_its_limits():
    skill = skill_of(lowered(), DOWN)
    assert_allclose(skill.travel_direction, [0.0, 0.0, -1.0], atol=1e-6)
    assert skill.offset_m == 0.02
    assert skill.travel_limit_m == pytest.approx(0.042)
    assert skill.timeout_s == pytest.approx(2.0 * skill.primitive.duration_s)
    assert skill.demonstrated_s == (0.0, 1.2)


def test_forces_that_were_demonstrated_are_not_unexpected():
    assert skill_of(lowered(step_N=6.0), DOWN).force_limit_N == 15.0
    assert skill_of(lowered(step_N=20.0), DOWN).force_limit_N == 40.0


def test_recordings_without_force_or_orientation_become_skills():
    full = lowered()
    bare = Demonstration("bare", full.time_s, full.position_m)
    down, move, _ = skills_of(bare, [segment(0.0, 1.2)] * 2)
    assert not down.primitive.oriented
    assert not move.primitive.oriented
    assert down.force_limit_N == 15.0


def test_the_same_segment_gives_the_same_skill():
    one, other = (skill_of(lowered(), DOWN).primitive for _ in range(2))
    assert (one.weights == other.weights).all()


def test_a_segment_too_short_is_refused_by_name():
    with pytest.raises(SkillError, match=r"lowered: .* from 1\.000 s"):
        skills_of(lowered(), [segment(1.0, 1.005)])


def test_a_negative_offset_is_refused():
    with pytest.raises(ParameterError, match="offset"):
        skill_of(lowered(), DOWN, offset_m=-0.01)


def test_a_skill_is_drawn_from_its_start_to_its_goal():
    path = drawn(skill_of(lowered(), DOWN), points=30)
    assert path.position_m.shape == (30, 3)
    assert_allclose(path.position_m[[0, -1], 2], [0.3, 0.18], atol=1e-3)


def test_a_skill_is_printed_in_a_line():
    assert describe(skill_of(lowered(), DOWN)) == (
        "down until contact, 1.94 s, until the force along (0.00, 0.00, 1.00) rises by 3.00 N"
    )
    assert "until within 5 mm and 3 deg of (0, 0, 200) mm" in describe(skill_of(lowered(), REST))


def test_what_follows_a_contact_is_shifted_to_where_it_was_met():
    down, rest = skills_of(lowered(), [DOWN, REST])
    met = down.end_position_m + np.array([0.002, 0.0, 0.008])
    shift = shift_after(down, met, np.zeros(3))
    assert_allclose(shift, [0.0, 0.0, 0.008], atol=1e-6)
    assert_allclose(shift_after(rest, met, shift), shift)


def test_between_its_contact_and_where_it_was_cut_nothing_was_met_elsewhere():
    """A hand that does not stop at a contact is 10 mm beyond it when it is cut."""
    down = skill_of(lowered(), DOWN)
    there = down.end_position_m
    down = replace(down, met_m=there + 0.01 * UP)
    assert_allclose(shift_after(down, there + 0.007 * UP, np.zeros(3)), np.zeros(3))
    higher = shift_after(down, there + 0.012 * UP, np.zeros(3))
    assert_allclose(higher, [0.0, 0.0, 0.002], atol=1e-6)


def test_shifts_add_up():
    down, _ = skills_of(lowered(), [DOWN, REST])
    before = np.array([0.01, 0.0, 0.02])
    met = down.end_position_m + before + np.array([0.0, 0.0, -0.005])
    assert_allclose(shift_after(down, met, before), [0.01, 0.0, 0.015], atol=1e-6)


def test_real_segments_become_skills_that_follow_them(real_data):
    """Snap assemblies and contour followings; most of the error is a start that was not at rest."""
    errors = []
    for folder in ("hiro_snap_assembly", "kuleuven_contour"):
        for file in sorted((real_data / folder).glob("*.npz"))[:3]:
            demonstration = read(file)
            for moving in (s for s in segment_demonstration(demonstration).segments if not s.idle):
                skill = skill_of(demonstration, moving)
                path = path_of(demonstration, moving.start_s, moving.end_s)
                step_s = path.duration_s / (len(path.time_s) - 1)
                motion = rollout(skill.primitive, step_s, run_s=path.duration_s)
                errors.append(millimetres_between(motion.position_m, path.position_m).max())
    assert len(errors) > 10
    assert np.median(errors) < 1.0
    assert max(errors) < 4.0
