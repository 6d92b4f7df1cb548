"""A part that is put on what it then carries along is squared there, by strokes to its sides."""

from dataclasses import replace

import numpy as np
import pytest

from keyphase.files.shipped import shipped
from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.skills.execution.pressing import still
from keyphase.skills.execution.run import UNTURNED, SkillRun, Start
from keyphase.skills.execution.seeking import giving
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.execution.squared import Squared
from keyphase.skills.library import skills_of
from keyphase.skills.squaring import Squaring, squaring_at

DOWN = np.array([0.0, 0.0, -1.0])
SQUARING = Squaring((0.0, 0.0, -1.0), (1.0, 0.0, 0.0))


def way() -> np.ndarray:
    """All of it, at 250 Hz."""
    times = np.arange(0.0, SQUARING.strokes_s, 0.004)
    return np.array([SQUARING.away(time) for time in times])


def test_it_begins_and_ends_where_it_was_put_down() -> None:
    assert np.linalg.norm(way()[0]) == 0.0
    assert np.linalg.norm(SQUARING.away(SQUARING.strokes_s)) < 1e-12


def test_it_is_lifted_before_it_moves_aside_and_until_it_is_back() -> None:
    aside = np.linalg.norm(way()[:, :2], axis=1)
    assert aside.max() == pytest.approx(SQUARING.reach_m, rel=0.02)
    assert way()[aside > 1e-6, 2].min() == pytest.approx(SQUARING.lift_m)


def test_it_goes_to_both_sides_of_both_axes() -> None:
    for axis in range(2):
        assert way()[:, axis].max() > 0.99 * SQUARING.reach_m
        assert way()[:, axis].min() < -0.99 * SQUARING.reach_m


def test_nothing_jumps() -> None:
    speed = np.linalg.norm(np.diff(way(), axis=0), axis=1) / 0.004
    assert speed.max() < 0.15
    assert np.abs(np.diff(speed)).max() < 0.02


def test_the_sides_are_those_of_the_tool_first_along_the_way_it_is_carried() -> None:
    turn = np.radians(30.0)
    wxyz = np.array([0.0, np.cos(turn / 2), np.sin(turn / 2), 0.0])
    first = np.array(squaring_at(DOWN, wxyz, np.array([0.1, 0.0, 0.0])).along)
    other = np.array(squaring_at(DOWN, wxyz, np.array([0.0, 0.1, 0.0])).along)
    assert np.abs(first[:2]) == pytest.approx([np.cos(turn), np.sin(turn)])
    assert abs(first @ other) < 1e-12
    assert abs(first @ DOWN) < 1e-12


def test_it_stays_where_the_strokes_put_it_however_it_is_pushed_while_it_is_pressed() -> None:
    demonstration = read(shipped("data") / "setup2.npz")
    kept = [one for one in segment(demonstration).segments if not one.idle]
    (skill,) = [one for one in skills_of(demonstration, kept) if one.squaring]
    assert skill.press is not None
    upright = np.array([1.0, 0.0, 0.0, 0.0])
    aside = np.cross(skill.press.direction, [1.0, 0.0, 0.0])
    sensed = Sensed(0.002 * aside, upright, np.zeros(6), np.zeros(3))
    wanted = giving(still(np.zeros(3), upright), sensed, Squared(skill, 0.004), 0.0)
    assert np.linalg.norm(wanted.position_m) < 1e-9


def test_of_the_bundled_recordings_only_what_carries_is_squared() -> None:
    """It is put down at a slant there, and pressed square to the place."""
    squared, skills = {}, ()
    for name in ("setup1", "setup2"):
        demonstration = read(shipped("data") / f"{name}.npz")
        kept = [one for one in segment(demonstration).segments if not one.idle]
        skills = skills_of(demonstration, kept)
        squared[name] = [s.squaring is not None for s in skills]
    assert not any(squared["setup1"])
    assert squared["setup2"] == [False, True, False, False]
    press, squaring = skills[1].press, skills[1].squaring
    assert press is not None
    assert squaring is not None
    assert press.direction == pytest.approx(squaring.normal)


def test_what_leant_against_something_as_it_was_put_down_is_not_squared() -> None:
    """A wall pushes square to the way: what is carried along drags no more for it."""
    demonstration = read(shipped("data") / "setup2.npz")
    kept = [one for one in segment(demonstration).segments if not one.idle]
    force = demonstration.force_N
    assert force is not None
    leaning = force + np.outer(force[:, 2], [1.2, 0.0, 0.0])
    free, leant = (skills_of(replace(demonstration, force_N=f), kept) for f in (force, leaning))
    assert [one.squaring is not None for one in free] == [False, True, False, False]
    assert not any(one.squaring for one in leant)
    assert leant[-1].kept[0].carries == pytest.approx(free[-1].kept[0].carries, rel=0.05)


@pytest.mark.parametrize(("drags_N", "fastest_m_s"), [(5.0, 0.037), (11.0, 0.01)])
def test_what_drags_far_more_than_demonstrated_is_pushed_slowly(drags_N, fastest_m_s) -> None:
    """Twice what was demonstrated; a tool that follows its reference to the millimetre."""
    demonstration = read(shipped("data") / "setup2.npz")
    kept = [one for one in segment(demonstration).segments if not one.idle]
    skill = skills_of(demonstration, kept)[-1]
    at = still(skill.primitive.start_position_m, skill.primitive.start_orientation_wxyz)
    force, speeds = np.array([0.0, -drags_N, 3.0]), []
    sensed = Sensed(at.position_m, at.orientation_wxyz, np.zeros(6), force)
    run = SkillRun(skill, Start(sensed, at, np.zeros(6), np.zeros(3), UNTURNED), True, 2000.0)
    for _ in range(300):
        wanted = run.reference(sensed, 0.004)
        position = sensed.position_m + 0.004 * run.velocity[:3]
        sensed = Sensed(position, wanted.orientation_wxyz, run.velocity, force)
        speeds.append(np.linalg.norm(run.velocity[:2]))
    assert max(speeds[20:]) == pytest.approx(fastest_m_s, rel=0.1)
