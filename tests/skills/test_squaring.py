"""A part that is put on what it then carries along is squared there, by strokes to its sides."""

import numpy as np
import pytest

from keyphase.files.shipped import shipped
from keyphase.readers import read
from keyphase.segmentation import segment
from keyphase.skills.execution.pressing import still
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
