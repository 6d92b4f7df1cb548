"""How a skill that runs comes to its end."""

import numpy as np
import pytest
from strokes import H, lowered, segment, turn

from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, GripperEnd
from keyphase.skills.end_monitor import start_monitor
from keyphase.skills.library import skill_of
from keyphase.skills.rollout import rollout

NO_FORCE = np.zeros(3)
UPRIGHT = np.array(quaternions.IDENTITY)


@pytest.fixture(scope="module")
def until_contact():
    """Down 100 mm until the force along z has risen by 3 N."""
    return skill_of(lowered(), segment(0.0, 1.2, ContactEnd((0.0, 0.0, 1.0), 3.0)))


@pytest.fixture(scope="module")
def until_configuration():
    return skill_of(lowered(), segment(0.0, 1.2))


def phases(skill, times_s):
    return np.exp(-3.0 * times_s / skill.primitive.duration_s)


def outcome_of(skill, force_at, shift_m=(0.0, 0.0, 0.0), run_s=None, position_at=None):
    """Outcome and time when the skill follows its own rollout under `force_at(time, height)`."""
    run_s = skill.primitive.duration_s + 1.1 * skill.timeout_s if run_s is None else run_s
    motion = rollout(skill.primitive, H, run_s=run_s)
    phase = phases(skill, motion.time_s)
    monitor = start_monitor(skill, force_at(0.0, 0.3 + shift_m[2]), shift_m)
    for k, time in enumerate(motion.time_s):
        position = motion.position_m[k] if position_at is None else position_at(time)
        position = position + np.asarray(shift_m)
        force = np.asarray(force_at(time, position[2]), float)
        monitor, outcome = monitor.step(position, UPRIGHT, force, phase[k], H)
        if outcome:
            return outcome, monitor.time_s
    return None, run_s


def table_at(height_m, stiffness=2000.0):
    return lambda _, height: (0.0, 0.0, max(0.0, stiffness * (height_m - height)))


def free(time, height):
    return NO_FORCE


def test_it_ends_at_the_contact(until_contact):
    outcome, time_s = outcome_of(until_contact, table_at(0.2))
    assert outcome == "contact"
    assert time_s == pytest.approx(1.25, abs=0.06)


@pytest.mark.parametrize("higher_m", [-0.01, -0.005, 0.01, 0.02])
def test_it_ends_at_a_table_that_is_higher_or_lower(until_contact, higher_m):
    outcome, _ = outcome_of(until_contact, table_at(0.2 + higher_m))
    assert outcome == "contact"


def test_it_ends_at_the_contact_when_everything_is_moved(until_contact):
    moved = (0.1, -0.2, 0.15)
    outcome, _ = outcome_of(until_contact, table_at(0.35), shift_m=moved)
    assert outcome == "contact"


def test_a_contact_that_is_already_there_does_not_count_again(until_contact):
    outcome, _ = outcome_of(until_contact, lambda *_: (0.0, 0.0, 8.0))
    assert outcome == "timeout"


def test_friction_that_starts_with_the_motion_is_no_contact(until_contact):
    outcome, time_s = outcome_of(
        until_contact,
        lambda time, height: (0.0, 0.0, 4.0 * (time > 0.1) + table_at(0.2)(time, height)[2]),
    )
    assert outcome == "contact"
    assert time_s > 1.2


def test_a_blip_shorter_than_the_debounce_is_no_contact(until_contact):
    blip = outcome_of(until_contact, lambda time, _: (0.0, 0.0, 9.0 * (1.1 < time < 1.115)))
    push = outcome_of(until_contact, lambda time, _: (0.0, 0.0, 9.0 * (1.1 < time < 1.15)))
    assert blip[0] == "timeout"
    assert push == ("contact", pytest.approx(1.124, abs=0.006))


def test_forces_across_the_direction_are_no_contact(until_contact):
    outcome, _ = outcome_of(until_contact, lambda time, _: (9.0 * (time > 1.0), 0.0, 0.0))
    assert outcome == "timeout"


def test_a_large_force_that_falls_away_is_none(until_configuration):
    """As after a contact that was pressed hard and is lost; what turns round is another contact."""
    pressed = 1.5 * until_configuration.force_limit_N
    fallen = outcome_of(until_configuration, lambda t, _: (0.0, 0.0, pressed if t < 0.1 else 1.0))
    assert fallen[0] == "reached"
    turned = outcome_of(until_configuration, lambda t, _: (0.0, 0.0, pressed * (1 - 2 * (t > 0.1))))
    assert turned[0] == "unexpected contact"


def test_a_large_force_from_anywhere_is_unexpected(until_contact, until_configuration):
    def bump(time, height):
        return (20.0 * (time > 0.4), 0.0, 0.0)

    for skill in (until_contact, until_configuration):
        outcome, time_s = outcome_of(skill, bump)
        assert outcome == "unexpected contact"
        assert time_s == pytest.approx(0.42, abs=0.01)


def test_without_contact_it_times_out_some_time_after_it_last_got_on(until_contact):
    outcome, time_s = outcome_of(until_contact, free)
    assert outcome == "timeout"
    done_s = until_contact.primitive.duration_s
    assert time_s == pytest.approx(done_s + until_contact.timeout_s, abs=0.05 * done_s)


def test_a_skill_that_is_slow_but_gets_on_does_not_time_out(until_contact):
    """Ten times as slow: longer than duration and timeout together."""
    monitor, outcome = start_monitor(until_contact, NO_FORCE), None
    slow_s = 10.0 * until_contact.primitive.duration_s
    for time in np.arange(0.0, slow_s, H):
        phase = float(phases(until_contact, time / 10.0))
        monitor, outcome = monitor.step(
            until_contact.primitive.start_position_m, UPRIGHT, NO_FORCE, phase, H
        )
        assert outcome is None
    assert slow_s > until_contact.primitive.duration_s + until_contact.timeout_s


def test_further_than_offset_and_margin_is_too_far(until_contact):
    outcome, time_s = outcome_of(
        until_contact, free, position_at=lambda time: np.array([0.0, 0.0, 0.3 - 0.1 * time])
    )
    assert outcome == "too far"
    assert time_s == pytest.approx(1.42, abs=0.02)


def test_a_configuration_is_reached_within_its_tolerances(until_configuration):
    outcome, time_s = outcome_of(until_configuration, free)
    assert outcome == "reached"
    assert 0.8 * 1.2 < time_s <= 1.21


def test_a_configuration_in_the_wrong_orientation_is_not_reached(until_configuration):
    monitor = start_monitor(until_configuration, NO_FORCE)
    tilted = quaternions.from_rotation_vector(np.array([np.radians(4.0), 0.0, 0.0]))
    end = until_configuration.end_position_m
    assert monitor.step(end, tilted, NO_FORCE, 0.05, H)[1] is None
    assert monitor.step(end, UPRIGHT, NO_FORCE, 0.05, H)[1] == "reached"
    assert monitor.step(end, -UPRIGHT, NO_FORCE, 0.05, H)[1] == "reached"


def test_a_path_that_starts_at_its_goal_is_not_reached_at_once(until_configuration):
    monitor = start_monitor(until_configuration, NO_FORCE)
    end = until_configuration.end_position_m
    assert monitor.step(end, UPRIGHT, NO_FORCE, 1.0, H)[1] is None


def test_where_no_orientation_was_recorded_none_is_asked_for():
    bare = lowered()
    bare = type(bare)("bare", bare.time_s, bare.position_m)
    skill = skill_of(bare, segment(0.0, 1.2))
    monitor = start_monitor(skill, NO_FORCE)
    assert monitor.step(skill.end_position_m, turn(90.0)[-1], NO_FORCE, 0.05, H)[1] == "reached"


def test_a_monitor_is_a_value(until_contact):
    monitor = start_monitor(until_contact, NO_FORCE)
    monitor.step(np.array([0.0, 0.0, 0.2]), UPRIGHT, np.array([0.0, 0.0, 9.0]), 0.1, H)
    assert monitor.time_s == 0.0
    assert not monitor.armed


GRASP = GripperEnd("grasp", 0.02, 0.004)


def at_the_goal(end, openings):
    """How many samples of the gripper's opening it takes until a skill at its goal is over."""
    skill = skill_of(lowered(), segment(0.0, 1.2, ConfigurationEnd(gripper=end)))
    monitor = start_monitor(skill, NO_FORCE)
    for count, opening in enumerate(openings, start=1):
        monitor, outcome = monitor.step(skill.end_position_m, UPRIGHT, NO_FORCE, 0.05, H, opening)
        if outcome:
            return count, outcome
    return None


def test_at_a_grasp_it_is_over_where_the_gripper_is_as_far_closed_as_demonstrated():
    assert at_the_goal(GRASP, np.linspace(0.0805, 0.0005, 81)) == (58, "reached")


def test_a_grasp_of_something_wider_is_over_once_the_gripper_has_stalled():
    closing = np.r_[np.linspace(0.08, 0.05, 31), np.full(200, 0.05)]
    ended = at_the_goal(GRASP, closing)
    assert ended is not None
    count, outcome = ended
    assert outcome == "reached"
    assert (count - 31) * H == pytest.approx(GRASP.stalled_s, abs=0.05)


def test_a_gripper_that_never_moved_has_not_grasped():
    assert at_the_goal(GRASP, np.full(200, 0.08)) is None


def test_a_release_has_begun_once_the_gripper_opens():
    end = GripperEnd("release", 0.02, 0.004)
    assert at_the_goal(end, np.linspace(0.02, 0.08, 61)) == (6, "reached")


def test_of_whom_nobody_measures_no_gripper_is_asked():
    assert at_the_goal(GRASP, [None]) == (1, "reached")


@pytest.mark.parametrize(("left_N", "outcome"), [(0.0, "contact"), (1.0, "timeout")])
def test_a_release_is_over_with_the_motion_where_nothing_presses_any_more(left_N, outcome):
    """A robot may press less than the hand did: what falls is then less than the threshold."""
    skill = skill_of(lowered(), segment(0.0, 1.2, ContactEnd((0.0, 0.0, -1.0), 3.0, release=True)))
    ended, time_s = outcome_of(skill, lambda time, _: (0.0, 0.0, 2.0 if time < 0.5 else left_N))
    assert ended == outcome
    assert time_s > 1.19
