"""A skill is tried on its own demonstration when it is made."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from strokes import lowered, segment

from keyphase.demonstration import Demonstration
from keyphase.files.shipped import shipped
from keyphase.readers import read
from keyphase.segmentation import segment as segment_demonstration
from keyphase.segmentation.end_condition import (
    ConfigurationEnd,
    ContactEnd,
    agrees,
    end_condition_at,
)
from keyphase.segmentation.end_condition.agreement import OwnDemonstration
from keyphase.skills.agreement import outcome_on
from keyphase.skills.library import skill_of
from keyphase.skills.skill import describe

UP = (0.0, 0.0, 1.0)


@pytest.mark.parametrize("name", ["setup1", "setup2"])
def test_the_skills_of_a_bundled_recording_agree(name):
    demonstration = read(shipped("data") / f"{name}.npz")
    segments = segment_demonstration(demonstration).segments
    contacts = [s for s in segments if isinstance(s.end_condition, ContactEnd)]
    assert len(contacts) >= 2
    assert all(skill_of(demonstration, part).agrees for part in contacts)


@pytest.mark.parametrize("name", ["setup1", "setup2"])
@pytest.mark.parametrize("moved_s", [-0.2, -0.1, 0.1, 0.2])
def test_a_dragged_boundary_leaves_the_end_condition_with_its_contact(name, moved_s):
    demonstration = read(shipped("data") / f"{name}.npz")
    for part in segment_demonstration(demonstration).segments:
        there = part.end_s + moved_s
        if not isinstance(part.end_condition, ContactEnd) or there > demonstration.end_s:
            continue
        moved = end_condition_at(demonstration, part.start_s, there, contact_change=True)
        assert isinstance(moved, ContactEnd)
        cosine = np.dot(moved.direction, part.end_condition.direction)
        assert np.degrees(np.arccos(min(cosine, 1.0))) < 10.0
        assert moved.threshold_N == pytest.approx(part.end_condition.threshold_N, rel=0.2)
        assert moved.agrees


def test_a_skill_that_its_demonstration_does_not_end_says_so():
    end = ContactEnd(UP, 50.0)
    skill = skill_of(lowered(step_N=6.0), segment(0.0, 1.2, end))
    assert skill.agrees is False
    assert "its own demonstration does not end so" in describe(skill)
    assert not agrees(lowered(step_N=6.0), 0.0, 1.2, end)


@pytest.mark.parametrize(("step_N", "kind"), [(0.2, ConfigurationEnd), (0.6, ContactEnd)])
def test_what_changes_by_less_than_a_third_of_a_newton_ends_no_skill(step_N, kind):
    assert isinstance(end_condition_at(lowered(step_N=step_N), 0.0, 1.2, True), kind)


def test_a_skill_without_a_contact_has_nothing_to_agree_with():
    assert skill_of(lowered(), segment(0.0, 1.2)).agrees is None


def test_the_demonstration_ends_a_skill_when_it_met_its_contact():
    skill = skill_of(lowered(contact_s=1.2), segment(0.0, 1.2, ContactEnd(UP, 3.0)))
    outcome, time_s = outcome_on(skill, lowered(contact_s=1.2))
    assert outcome == "contact"
    assert time_s == pytest.approx(1.22, abs=0.01)


def test_a_condition_that_would_end_its_demonstration_early_is_mended():
    """The hand presses ever harder before the wall gives the step: half of it comes too soon."""
    time = np.arange(1000) / 250.0
    position = np.c_[0.05 * time, np.zeros((1000, 2))]
    force = np.zeros((1000, 3))
    force[:, 0] = -np.interp(time, [0.0, 2.0, 3.0, 3.01], [0.0, 0.0, 3.0, 6.0])
    pushed = Demonstration("pushed", time, position, force_N=force)
    end = end_condition_at(pushed, 0.0, 3.0, contact_change=True)
    assert isinstance(end, ContactEnd)
    assert end.agrees
    assert agrees(pushed, 0.0, 3.0, end)


def slid(press_N):
    """A tool that slides on a table until a wall; how hard it presses changes as it gets there."""
    time = np.arange(750) / 250.0
    position = np.zeros((750, 3))
    position[:, 1] = 0.05 * np.minimum(time, 2.0)
    force = np.zeros((750, 3))
    force[:, 2] = np.interp(time, [0.3, 0.4, 1.9, 2.1], [0.0, 4.0, 4.0, press_N])
    force[:, 1] = np.interp(time, [0.3, 0.4, 2.0, 2.01], [0.0, -1.0, -1.0, -5.0])
    return Demonstration("slid", time, position, force_N=force)


@pytest.mark.parametrize("press_N", [2.0, 4.0, 7.0])
def test_the_press_of_a_hand_does_not_tilt_the_wall(press_N):
    end = end_condition_at(slid(press_N), 0.0, 2.0, contact_change=True)
    assert isinstance(end, ContactEnd)
    assert np.allclose(end.direction, (0.0, -1.0, 0.0), atol=0.05)


def released(falls_to_N):
    time = np.arange(750) / 250.0
    position = np.c_[np.zeros((750, 2)), 0.05 * time]
    force = np.zeros((750, 3))
    force[:, 2] = np.interp(time, [0.3, 0.4, 2.0, 2.01], [0.0, -6.0, -6.0, falls_to_N])
    return Demonstration("released", time, position, force_N=force)


@pytest.mark.parametrize("falls_to_N", [0.0, -4.0])
def test_a_force_that_falls_along_the_way_is_a_release_and_not_gone_beyond(falls_to_N):
    demonstration = released(falls_to_N)
    end = end_condition_at(demonstration, 0.0, 2.0, contact_change=True)
    assert isinstance(end, ContactEnd)
    assert end.release
    skill = skill_of(demonstration, segment(0.0, 2.0, end))
    assert skill.offset_m == 0.0
    assert "falls by" in describe(skill)


def test_an_offset_of_ones_own_is_taken():
    end = ContactEnd(UP, 3.0, offset_m=0.005, timeout_s=7.0)
    skill = skill_of(lowered(), segment(0.0, 1.2, end))
    assert (skill.offset_m, skill.timeout_s) == (0.005, 7.0)


@given(
    seed=st.integers(0, 10_000),
    threshold_N=st.floats(0.1, 8.0),
    start_s=st.floats(0.0, 1.0),
    way_m=st.sampled_from([0.0, 0.005, 0.02, 0.1]),
)
def test_all_at_once_finds_what_the_monitor_finds_step_by_step(seed, threshold_N, start_s, way_m):
    rng = np.random.default_rng(seed)
    bare = lowered(depth_m=max(way_m, 1e-4))
    force = np.cumsum(rng.normal(size=(len(bare), 3)), axis=0) * 0.3
    shaken = replace(bare, force_N=force)
    end = ContactEnd(UP, threshold_N)
    own = OwnDemonstration.of(shaken, start_s, 1.2)
    at_once = own.ended_s(end)
    skill = skill_of(shaken, segment(start_s, 1.2, end))
    unlimited = replace(skill, force_limit_N=1e9, travel_limit_m=1e9)
    outcome, time_s = outcome_on(unlimited, shaken)
    if at_once is None:
        assert outcome is None
    else:
        assert outcome == "contact"
        assert time_s == pytest.approx(at_once, abs=1e-6)
