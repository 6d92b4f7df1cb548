"""What a skill follows of a recorded force, and what it does not."""

import numpy as np
import pytest

from keyphase.demonstration import Demonstration
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, EndCondition
from keyphase.skills.library import Cut, skills_of
from keyphase.skills.skill import Skill

PRESSED_N, FRICTION_N, LENGTH_M, DURATION_S = 8.0, 2.0, 0.08, 2.0


def pressed(offset_N: float = 0.0, rises_N: float = 0.0) -> Demonstration:
    """A slide along x that presses a table from its start on, and harder in its last 0.1 s."""
    time = np.arange(round(DURATION_S * 250) + 51) / 250
    along = np.clip(time / DURATION_S, 0.0, 1.0)
    position = np.c_[LENGTH_M * along, np.zeros((len(time), 2))]
    up = PRESSED_N + rises_N * np.clip((time - DURATION_S + 0.1) / 0.02, 0.0, 1.0) + offset_N
    force = np.c_[np.full_like(time, -FRICTION_N), np.zeros_like(time), up]
    return Demonstration("pressed", time, position, np.tile([1.0, 0, 0, 0], (len(time), 1)), force)


def skill(demonstration: Demonstration, end: EndCondition | None = None) -> Skill:
    end = end or ConfigurationEnd(0.005, 0.05)
    return skills_of(demonstration, [Cut(0.0, DURATION_S, "slide", end)])[0]


def test_a_force_that_was_pressed_from_the_start_on_is_followed_as_a_whole() -> None:
    """It is no offset of the sensor, though the recording never is in free space."""
    (kept,) = skill(pressed()).kept
    direction, force = kept.at(0.5) or pytest.fail("nothing is followed")
    assert direction == pytest.approx([0.0, 0.0, -1.0], abs=1e-6)
    assert force == pytest.approx(PRESSED_N, rel=0.01)


def test_friction_is_pushed_along_the_way() -> None:
    (kept,) = skill(pressed()).kept
    assert kept.pushed_at(0.5) == pytest.approx([FRICTION_N, 0.0, 0.0], abs=0.05)


def test_the_contact_that_ends_a_skill_is_not_followed() -> None:
    """Held at what it was, its force would never rise to its end."""
    rising = pressed(rises_N=12.0)
    (kept,) = skill(rising, ContactEnd((0.0, 0.0, 1.0), 6.0)).kept
    assert kept.at(0.5) is not None
    assert kept.at(1.0) is None
    assert kept.pushed_at(1.0) == pytest.approx(np.zeros(3))


def test_another_contact_is_followed_to_the_end_of_a_skill() -> None:
    (kept,) = skill(pressed(), ContactEnd((-1.0, 0.0, 0.0), 3.0)).kept
    assert kept.at(1.0) is not None
