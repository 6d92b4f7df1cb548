"""Contacts in a replay: met gently, pressed as demonstrated, and what follows moves along."""

import numpy as np
import pytest
from replaying import NAMES, bundled, nominal, plan, replayed

from keyphase.demonstration import Demonstration
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.simulation import Disturbance
from keyphase.simulation.replay.contact import (
    KeptContact,
    after_contact,
    kept_contact,
    pressing_direction,
    square,
)
from keyphase.simulation.replay.guard import SPEED_M_S, guard_of
from keyphase.skills.library import skill_of, skills_of

DOWN = np.array([0.0, 0.0, -1.0])


def first_contact(name):
    segments = plan(name)
    index = next(i for i, s in enumerate(segments) if isinstance(s.end_condition, ContactEnd))
    demonstration = bundled(name)[0]
    return tuple(skill_of(demonstration, each) for each in segments[index : index + 2])


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("height_m", [-0.01, 0.01])
def test_what_follows_a_contact_met_elsewhere_moves_along(name, height_m) -> None:
    result = replayed(name, disturbance=Disturbance(part_height_m=height_m))
    assert result.succeeded
    met = next(each for each in result.results if each.outcome == "contact")
    after = result.results[met.skill + 1]
    assert after.shift_m[2] == pytest.approx(height_m, abs=0.0005)


@pytest.mark.parametrize("name", NAMES)
def test_a_part_that_is_met_early_is_not_hit_hard(name) -> None:
    result = replayed(name, disturbance=Disturbance(part_height_m=0.01))
    met = next(each for each in result.results if each.outcome == "contact")
    assert met.peak_force_N < 12.0


@pytest.mark.parametrize("name", NAMES)
def test_the_contact_is_pressed_as_demonstrated_while_the_next_skill_runs(name) -> None:
    demonstration, result = bundled(name)[0], nominal(name)
    met = next(each for each in result.results if each.outcome == "contact")
    following = result.skills[met.skill + 1]
    start_s, end_s = following.demonstrated_s
    inside = (demonstration.time_s >= start_s) & (demonstration.time_s < end_s)
    _, force = result.profile(met.skill + 1)
    demonstrated = np.median(demonstration.force_N[inside, 2])
    assert np.median(force[:, 2]) == pytest.approx(demonstrated, abs=0.5)


def test_only_contact_terminated_skills_are_guarded() -> None:
    demonstration = bundled("setup1")[0]
    for skill in skills_of(demonstration, plan("setup1")):
        guard = guard_of(skill, np.zeros(3))
        assert (guard is not None) == isinstance(skill.end_condition, ContactEnd)
        if guard is not None:
            assert SPEED_M_S[0] <= guard.speed_m_s <= SPEED_M_S[1]


def test_a_guard_moves_with_its_skill() -> None:
    down, _ = first_contact("setup1")
    shift = np.array([0.001, 0.002, 0.003])
    here, there = guard_of(down, np.zeros(3)), guard_of(down, shift)
    assert here is not None
    assert there is not None
    assert np.allclose(there.contact_m - here.contact_m, shift)


@pytest.mark.parametrize("name", NAMES)
def test_the_demonstration_stayed_in_its_first_contact_and_kept_it(name) -> None:
    down, following = first_contact(name)
    after = after_contact(bundled(name)[0], down)
    assert after.stayed
    assert after.direction @ DOWN > 0.99
    kept = kept_contact(after.kept(), bundled(name)[0], following)
    assert kept is not None
    assert kept.force_N.min() > 1.0


def test_a_push_that_goes_on_does_not_stay_in_its_contact() -> None:
    demonstration = bundled("setup2")[0]
    contacts = [s for s in plan("setup2") if isinstance(s.end_condition, ContactEnd)]
    assert not after_contact(demonstration, skill_of(demonstration, contacts[1])).stayed


def test_a_demonstration_that_leaves_a_contact_does_not_keep_it() -> None:
    demonstration = bundled("setup1")[0]
    down, _ = first_contact("setup1")
    contact = after_contact(demonstration, down).kept()
    forward = skill_of(demonstration, plan("setup1")[0])
    assert kept_contact(contact, demonstration, forward) is None


def test_travel_that_does_not_go_against_the_force_is_not_pressed_along() -> None:
    time = np.arange(500) / 250.0
    aside = Demonstration(
        "aside", time, np.outer(time, (0.05, 0.0, 0.0)), force_N=np.zeros((500, 3))
    )
    segment = plan("setup1")[0]
    values = {**vars(segment), "start_s": 0.0, "end_s": 1.5}
    end = ContactEnd((0.0, 0.0, 1.0), 1.0)
    sliding = skill_of(aside, type(segment)(**{**values, "end_condition": end}))
    assert np.allclose(pressing_direction(sliding), DOWN)


def test_contacts_are_kept_at_right_angles() -> None:
    floor = KeptContact(DOWN, np.array([2.0]))
    tilted = np.array([0.0, 0.96, -0.28])
    wall = square(KeptContact(tilted, np.array([3.0])), (floor,))
    assert wall is not None
    assert np.allclose(wall.direction, (0.0, 1.0, 0.0))
    assert square(floor, (floor,)) is None


def test_a_contact_that_is_gone_is_not_followed_far() -> None:
    contact = KeptContact(DOWN, np.array([4.0]))
    fallen, path = np.array([0.0, 0.0, 0.05]), np.array([0.0, 0.0, 0.1])
    assert -contact.pressed_m(fallen, path, 0.5, 2000.0) == pytest.approx(0.1 - 0.01)


def test_the_way_that_is_slid_tells_the_surface() -> None:
    demonstration = bundled("setup1")[0]
    _, slide = first_contact("setup1")
    tilted = np.array([0.0, 0.25, -np.sqrt(1 - 0.25**2)])
    kept = kept_contact(KeptContact(tilted, np.array([2.0])), demonstration, slide)
    assert kept is not None
    assert kept.direction @ DOWN > 0.999


def test_without_force_conditions_nothing_is_pressed() -> None:
    segments = [
        type(each)(**{**vars(each), "end_condition": ConfigurationEnd()}) for each in plan("setup2")
    ]
    result = replayed("setup2", segments)
    assert all(state.stage != "pressing" for state in result.states)
    assert all(not np.any(each.shift_m) for each in result.results)
