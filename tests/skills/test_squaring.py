"""A part that is put on what it then carries along is squared there, by strokes to its sides."""

from dataclasses import replace
from functools import cache

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
from keyphase.skills.skill import Skill
from keyphase.skills.squaring import squaring_at

DOWN = np.array([0.0, 0.0, -1.0])
UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])
ACROSS, ALONG = 1, 0


@cache
def squared_skill() -> Skill:
    """The skill of the bundled recording that is squared, put down at the origin along x and y."""
    demonstration = read(shipped("data") / "setup2.npz")
    kept = [one for one in segment(demonstration).segments if not one.idle]
    (skill,) = [one for one in skills_of(demonstration, kept) if one.squaring]
    assert skill.squaring is not None
    squaring = replace(skill.squaring, normal=(0.0, 0.0, -1.0), along=(1.0, 0.0, 0.0))
    return replace(skill, squaring=squaring, end_position_m=np.zeros(3))


def way(
    sides_m: tuple[float, float] = (-1.0, 1.0),
    reads_N: float = 0.0,
    begin_m: float = 0.0,
    stands: bool = False,
) -> np.ndarray:
    """All of it (N, 4), of a tool between two sides across the way, and how far these moved.

    They go along and resist with 0.5 N, or stand firm.
    """
    squaring = squared_skill().squaring
    assert squaring is not None
    noise, places, low, high = np.random.default_rng(0), [], *sides_m
    begin = np.array([0.0, begin_m, 0.0])
    sensed = Sensed(begin, UPRIGHT, np.zeros(6), np.zeros(3))
    squared = Squared(squared_skill(), sensed, 0.004)
    squared.again(sensed, np.zeros(3))
    while not squared.is_in(sensed):
        at = squared.moving(still(begin, UPRIGHT), sensed, 0.0).position_m
        beyond = max(at[ACROSS] - high, 0.0) + min(at[ACROSS] - low, 0.0)
        resists = 2000.0 * beyond if stands else 0.5 * np.sign(beyond)
        force = reads_N + noise.normal(0.0, 0.1, 3) - [0.0, resists, 0.0]
        here = at - [0.0, beyond if stands else 0.0, 0.0]
        sensed = Sensed(here, UPRIGHT, np.zeros(6), force)
        squared.watch(sensed, False)
        low, high = (low, high) if stands else (low + beyond, high + beyond)
        places.append([*at, low - sides_m[0]])
    assert 0.004 * len(places) < squaring.duration_s
    return np.array(places)


def test_it_begins_where_it_was_put_down_and_ends_where_the_demonstration_was() -> None:
    assert way(begin_m=0.004)[0, :3] == pytest.approx([0.0, 0.004, 0.0])
    assert way(begin_m=0.004)[-1, :3] == pytest.approx(np.zeros(3), abs=2e-4)


def test_it_is_lifted_before_it_moves_aside_and_until_it_is_back() -> None:
    aside = np.linalg.norm(way()[:, :2], axis=1)
    assert way()[aside > 2e-4, 2].min() == pytest.approx(0.003)


def test_where_nothing_is_felt_it_goes_as_far_to_both_sides_of_both_axes() -> None:
    """Whatever the sensor reads too much: that is no side."""
    for axis in range(2):
        assert way(reads_N=2.0)[:, axis].max() == pytest.approx(0.01, abs=3e-4)
        assert way(reads_N=2.0)[:, axis].min() == pytest.approx(-0.01, abs=3e-4)


def test_a_stroke_ends_where_a_side_is_felt_and_the_last_between_both() -> None:
    """So that what stands loosely is turned as much from either side, by 1 mm at a time."""
    *_, moved = between = way((-0.003, 0.006)).T
    steps = np.diff(moved[np.r_[0, np.flatnonzero(np.diff(np.sign(np.diff(moved))) < 0)]])
    pushed = np.abs(np.diff(moved[np.r_[True, np.abs(np.diff(moved)) > 0]])).sum()
    assert len(steps) > 4
    assert pushed < 0.030
    assert between[ACROSS, -1] - moved[-1] == pytest.approx(0.0015, abs=0.001)


def test_a_side_that_stands_firm_is_not_pressed_harder_than_the_part_is() -> None:
    firm = way((-0.003, 0.006), stands=True)[:, ACROSS]
    assert 0.006 < firm.max() < 0.011
    assert firm[-1] == pytest.approx(0.0015, abs=0.001)


def test_nothing_jumps() -> None:
    speed = np.linalg.norm(np.diff(way((-0.003, 0.006))[:, :3], axis=0), axis=1) / 0.004
    assert speed.max() < 0.032


def test_the_sides_are_those_of_the_tool_last_along_the_way_it_is_carried() -> None:
    turn = np.radians(30.0)
    wxyz = np.array([0.0, np.cos(turn / 2), np.sin(turn / 2), 0.0])
    first = np.array(squaring_at(DOWN, wxyz, np.array([0.1, 0.0, 0.0])).along)
    other = np.array(squaring_at(DOWN, wxyz, np.array([0.0, 0.1, 0.0])).along)
    assert np.abs(first[:2]) == pytest.approx([np.cos(turn), np.sin(turn)])
    assert abs(first @ other) < 1e-12
    assert abs(first @ DOWN) < 1e-12


def test_it_stays_where_the_strokes_put_it_however_it_is_pushed_while_it_is_pressed() -> None:
    skill = squared_skill()
    assert skill.press is not None
    aside = np.cross(skill.press.direction, [1.0, 0.0, 0.0])
    sensed = Sensed(0.002 * aside, UPRIGHT, np.zeros(6), np.zeros(3))
    squared = Squared(skill, sensed, 0.004)
    wanted = giving(still(np.zeros(3), UPRIGHT), sensed, squared, 0.0)
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
