"""What is odd about a recording is said, with its place; a good recording has nothing odd."""

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.oddities import oddities_of

RATE = 100.0
TIME = np.arange(1000) / RATE


def stroke(rows=1000):
    """A tool that goes 0.2 m there and back."""
    path = 0.1 * (1 - np.cos(2 * np.pi * np.arange(rows) / rows))
    return np.stack([0.4 + path, 0 * path, 0.3 + 0 * path], axis=1)


def pressing(rows=1000):
    """A force that resists the stroke, with noise."""
    noise = np.random.default_rng(0).normal(0, 0.05, (rows, 3))
    force = noise.copy()
    force[:, 0] -= 8 * np.sin(2 * np.pi * np.arange(rows) / rows)
    return force


def demonstration(time=TIME, position=None, **channels):
    return Demonstration(
        "odd", time, stroke(len(time)) if position is None else position, **channels
    )


def texts(demonstration, kind):
    return [odd.text for odd in oddities_of(demonstration) if odd.kind == kind]


def test_a_good_recording_has_nothing_odd():
    turn = np.tile([1.0, 0, 0, 0], (1000, 1))
    joints = np.linspace(0, 1, 7000).reshape(1000, 7)
    good = demonstration(force_N=pressing(), orientation_wxyz=turn, joints_rad=joints)
    assert oddities_of(good) == ()


def test_milliseconds_read_as_seconds_are_noticed():
    (text,) = texts(demonstration(TIME * 1000), "time")
    assert "milliseconds read as seconds" in text


def test_seconds_read_as_milliseconds_are_noticed():
    (text,) = texts(demonstration(TIME / 1000), "time")
    assert "seconds read as milliseconds" in text


def test_a_recording_too_short_for_boundaries_says_so():
    (text,) = texts(demonstration(TIME[:21]), "time")
    assert text.startswith("Only 0.2 s long")


def test_a_gap_is_told_with_its_place_and_how_far_the_tool_went():
    time = np.where(TIME < 3.0, TIME, TIME + 1.5)
    position = stroke() + np.where(TIME < 3.0, 0.0, 0.05)[:, None]
    odd = demonstration(time, position)
    (gap,) = [each for each in oddities_of(odd) if each.kind == "gap"]
    assert gap.span_s == pytest.approx((2.99, 4.5))
    assert "1.51 s without data at 2.99 s" in gap.text
    assert "mm further" in gap.text
    assert not texts(odd, "jump")
    assert odd.gaps_s == (gap.span_s,)


def test_uneven_steps_are_no_gaps():
    rng = np.random.default_rng(1)
    time = np.cumsum(rng.uniform(0.02, 0.3, 1000))
    assert demonstration(time).gaps_s == ()


def test_a_row_of_zeros_is_a_jump_there_and_back():
    position = stroke()
    position[500] = 0.0
    (text,) = texts(demonstration(position=position), "jump")
    assert "and back at 5.00 s (row 501)" in text
    assert texts(demonstration(position=position), "zero rows")


def test_a_tool_that_begins_at_the_origin_has_no_rows_of_zeros():
    assert not texts(demonstration(position=stroke() - [0.4, 0, 0.3]), "zero rows")


def test_many_jumps_are_told_a_few_at_a_time():
    position = stroke()
    position[100:900:40] += 0.5
    found = texts(demonstration(position=position), "jump")
    assert len(found) == 5
    assert "15 more" in found[-1]


def test_a_flip_of_the_orientation_is_noticed():
    turn = np.tile([1.0, 0, 0, 0], (1000, 1))
    turn[400] = [0, 1, 0, 0]
    (text,) = texts(demonstration(orientation_wxyz=turn), "jump")
    assert "turns by 180°" in text


def test_quaternions_that_seem_to_be_in_the_other_order_are_told():
    half = np.linspace(0.0, 0.5, 1000)
    xyzw = np.stack([0 * half, np.sin(half), 0 * half, np.cos(half)], axis=1)
    (text,) = texts(demonstration(orientation_wxyz=xyzw), "order")
    assert 'order = "xyzw"' in text
    assert not texts(demonstration(orientation_wxyz=np.roll(xyzw, 1, axis=1)), "order")


def test_a_pose_that_stands_while_joints_move_is_noticed():
    joints = np.linspace(0, 1, 1000)[:, None]
    still = np.tile([0.4, 0, 0.3], (1000, 1))
    (text,) = texts(demonstration(position=still, joints_rad=joints), "still pose")
    assert "joints_rad do" in text


@pytest.mark.parametrize(("factor", "said"), [(1000, "millimetres"), (1e-4, "metres read as mill")])
def test_a_reach_no_robot_has_is_noticed(factor, said):
    (text,) = texts(demonstration(position=stroke() * factor), "scale")
    assert said in text


@pytest.mark.parametrize(("factor", "said"), [(1000, "unit of force_N"), (1e-3, "kilonewtons")])
def test_a_force_no_contact_has_is_noticed(factor, said):
    (text,) = texts(demonstration(force_N=pressing() * factor), "scale")
    assert said in text


def test_a_component_that_never_changes_is_noticed():
    force = pressing()
    force[:, 1] = 2.5
    assert texts(demonstration(force_N=force), "constant") == [
        "force_N y never changes: was it measured?"
    ]


def test_a_sensor_at_its_limit_is_noticed():
    force = np.clip(pressing(), -6.0, 6.0)
    found = texts(demonstration(force_N=force), "saturated")
    assert len(found) == 2
    assert "6 N" in found[0]


def test_a_sensor_that_stopped_for_a_while_is_noticed():
    force = pressing()
    force[100:300] = force[100]
    (text,) = texts(demonstration(force_N=force), "frozen")
    assert "stands exactly still for" in text
    assert "(row 101)" in text


def test_no_force_where_nothing_is_touched_and_a_slow_sensor_have_not_stopped():
    force = pressing()
    force[100:300] = 0.0
    assert not texts(demonstration(force_N=force), "frozen")
    assert not texts(demonstration(force_N=np.repeat(pressing()[::10], 10, 0)), "frozen")


def test_a_force_that_wanders_at_rest_is_noticed():
    time = np.arange(2000) / RATE
    still = np.tile([0.4, 0, 0.3], (2000, 1)) + 1e-5 * np.sin(time)[:, None]
    force = np.random.default_rng(0).normal(0, 0.02, (2000, 3))
    force[:, 2] += 0.7 * np.round(np.sin(2 * np.pi * time / 7))
    (text,) = texts(demonstration(time, still, force_N=force), "wander")
    assert "wanders by" in text


def test_a_force_that_helps_the_motion_is_noticed():
    assert not texts(demonstration(force_N=pressing()), "sign")
    (text,) = texts(demonstration(force_N=-pressing()), "sign")
    assert "helps the motion" in text
