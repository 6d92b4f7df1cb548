"""Where the demonstrations of a skill lay apart, the robot follows it softly."""

from dataclasses import replace

import numpy as np
import pytest
from point_mass import PointMass, executed
from strokes import lowered, segment

from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.skills import Executor, Sensed
from keyphase.skills.coupling import Reference
from keyphase.skills.execution.softly import softly
from keyphase.skills.library import skills_of
from keyphase.skills.spread import SOFTEST, TIGHT_M, WIDE_M, Spread

UPRIGHT = np.array(quaternions.IDENTITY)
WIDE = Spread(10, np.full(21, WIDE_M))
WANTED = Reference(np.full(3, 0.01), UPRIGHT, np.full(6, 0.2), np.zeros(6))
AT_REST = Sensed(np.zeros(3), UPRIGHT, np.zeros(6), np.zeros(3))
DOWN = np.array([0.0, 0.0, -1.0])


def skills(spread):
    """Down until a contact, then a press, both with the same spread."""
    down = segment(0.0, 1.2, ContactEnd((0.0, 0.0, 1.0), 3.0), "down until contact")
    made = skills_of(lowered(), [down, segment(1.2, 2.0, label="press")])
    return tuple(replace(skill, spread=spread) for skill in made)


def test_a_part_of_stiffness_and_damping_is_left_where_demonstrations_lay_apart():
    free = replace(skills(WIDE)[0], travel_direction=None)
    soft = softly(WANTED, AT_REST, (), free, 0.5)
    np.testing.assert_allclose(soft.position_m, SOFTEST * WANTED.position_m)
    np.testing.assert_allclose(soft.velocity[:3], np.sqrt(SOFTEST) * WANTED.velocity[:3])
    np.testing.assert_array_equal(soft.velocity[3:], WANTED.velocity[3:])


def test_the_way_into_a_contact_and_what_is_pressed_stay_stiff():
    aside = np.array([0.6, 0.0, 0.8])
    soft = softly(WANTED, AT_REST, [(aside, 5.0)], skills(WIDE)[0], 0.5)
    for firm in (DOWN, aside):
        assert soft.position_m @ firm == pytest.approx(WANTED.position_m @ firm)
        assert soft.velocity[:3] @ firm == pytest.approx(WANTED.velocity[:3] @ firm)
    assert soft.position_m[1] == pytest.approx(SOFTEST * WANTED.position_m[1])


@pytest.mark.parametrize("spread", [None, Spread(3, np.full(21, TIGHT_M))])
def test_a_skill_of_one_demonstration_or_of_such_that_agree_is_followed_as_it_is(spread):
    assert softly(WANTED, AT_REST, (), skills(spread)[0], 0.5) is WANTED


def test_the_softness_follows_the_spread_along_the_skill():
    narrowing = Spread(10, np.array([WIDE_M, TIGHT_M]))
    assert [narrowing.stiffness_at(part) for part in (0.0, 0.5, 1.0)] == [
        SOFTEST,
        (1.0 + SOFTEST) / 2.0,
        1.0,
    ]


class Pushed(PointMass):
    """A tool that is pushed aside with 4 N."""

    def force(self):
        return super().force() + np.array([4.0, 0.0, 0.0])


def test_a_soft_plan_gives_way_aside_and_presses_as_hard():
    given_m = list[float]()
    for spread in (None, WIDE):
        robot = Pushed((0.0, 0.0, 0.3), 0.2)
        aside = list[float]()
        executor = Executor(skills(spread), robot.sense())
        executed(executor, robot, each_tick=lambda sensed, a=aside: a.append(sensed.position_m[0]))
        assert [result.outcome for result in executor.results] == ["contact", "reached"]
        assert robot.force()[2] == pytest.approx(6.0, abs=0.5)
        given_m.append(max(aside[:200]))
    assert given_m[1] > 1.3 * given_m[0]
