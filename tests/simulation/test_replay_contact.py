"""Contacts in a replay: met gently, pressed as demonstrated, and what follows moves along."""

import numpy as np
import pytest
from replaying import NAMES, bundled, nominal, plan, replayed

from keyphase.demonstration import Demonstration
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.simulation import Disturbance
from keyphase.skills.connecting import connecting_skill
from keyphase.skills.contacts import (
    kept_force,
    press_after,
    pressing_direction,
    shift_beyond,
    square,
)
from keyphase.skills.coupling import Reference
from keyphase.skills.execution.guard import SPEED_M_S, guard_of
from keyphase.skills.execution.pressing import pressing
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
    press = press_after(bundled(name)[0], down)
    assert press is not None
    assert press.direction @ DOWN > 0.99
    kept = kept_force(bundled(name)[0], following, press.direction)
    assert kept is not None
    assert kept.force_N.min() > 1.0


def test_a_push_that_goes_on_does_not_stay_in_its_contact() -> None:
    demonstration = bundled("setup2")[0]
    contacts = [s for s in plan("setup2") if isinstance(s.end_condition, ContactEnd)]
    assert press_after(demonstration, skill_of(demonstration, contacts[1])) is None


def test_a_demonstration_that_leaves_a_contact_does_not_keep_it() -> None:
    demonstration = bundled("setup1")[0]
    down, _ = first_contact("setup1")
    press = press_after(demonstration, down)
    assert press is not None
    forward = skill_of(demonstration, plan("setup1")[0])
    assert kept_force(demonstration, forward, press.direction) is None


def test_a_plan_knows_what_it_presses_without_its_demonstration() -> None:
    skills = skills_of(bundled("setup1")[0], plan("setup1"))
    down = next(k for k, skill in enumerate(skills) if skill.press is not None)
    assert skills[down].kept == ()
    assert [force.met for force in skills[down + 1].kept] == [True]


def aside() -> tuple[Demonstration, object]:
    time = np.arange(500) / 250.0
    path = np.outer(time, (0.05, 0.0, 0.0))
    segment = plan("setup1")[0]
    values = {**vars(segment), "start_s": 0.0, "end_s": 1.5}
    values["end_condition"] = ContactEnd((0.0, 0.0, 1.0), 1.0)
    moved = Demonstration("aside", time, path, force_N=np.zeros((500, 3)))
    return moved, type(segment)(**values)


def test_travel_that_does_not_go_against_the_force_is_not_pressed_along() -> None:
    assert np.allclose(pressing_direction(skill_of(*aside())), DOWN)


def test_contacts_are_kept_at_right_angles() -> None:
    wall = square(np.array([0.0, 0.96, -0.28]), (DOWN,))
    assert wall is not None
    assert np.allclose(wall, (0.0, 1.0, 0.0))
    assert square(DOWN, (DOWN,)) is None


def test_a_press_is_no_harder_than_what_lies_in_its_own_direction() -> None:
    """Into a wall, a little downwards, on a table that is pressed with 20 N meanwhile."""
    time = np.arange(500) / 250.0
    path = np.outer(np.minimum(time, 1.5), (0.05, 0.0, -0.02))
    force = np.tile((-3.0, 0.0, 20.0), (500, 1))
    demonstration = Demonstration("to a wall", time, path, force_N=force)
    segment = type(plan("setup1")[0])(
        **{
            **vars(plan("setup1")[0]),
            "start_s": 0.0,
            "end_s": 1.5,
            "end_condition": ContactEnd((-0.8, 0.0, 0.6), 1.0),
        }
    )
    press = press_after(demonstration, skill_of(demonstration, segment), (DOWN,))
    assert press is not None
    assert press.direction == pytest.approx([1.0, 0.0, 0.0], abs=1e-6)
    assert press.force_N == pytest.approx(3.0)


def test_a_contact_that_is_gone_is_not_followed_far() -> None:
    path = Reference(np.array([0.0, 0.0, 0.1]), np.array([1.0, 0, 0, 0]), np.zeros(6), np.zeros(6))
    fallen = np.array([0.0, 0.0, 0.05])
    reference = pressing(path, fallen, [(DOWN, 4.0)], 2000.0)
    assert reference.position_m[2] == pytest.approx(0.1 - 0.01)


def test_the_way_that_is_slid_tells_the_surface() -> None:
    demonstration = bundled("setup1")[0]
    _, slide = first_contact("setup1")
    tilted = np.array([0.0, 0.25, -np.sqrt(1 - 0.25**2)])
    kept = kept_force(demonstration, slide, tilted)
    assert kept is not None
    assert kept.direction[0] @ DOWN > 0.999


def pushed_into(stiffness_N_m: float) -> tuple[Demonstration, object]:
    """A tool that comes down at 50 mm/s and sinks in until 6 N, from 0.3 s of nothing on."""
    time = np.arange(500) / 250.0
    depth = np.minimum(0.05 * time, 0.075 + 6.0 / stiffness_N_m)
    force = np.maximum(depth - 0.075, 0.0) * stiffness_N_m
    path = np.outer(depth, DOWN)
    segment = plan("setup1")[0]
    values = {**vars(segment), "start_s": 0.0, "end_s": 1.55}
    values["end_condition"] = ContactEnd((0.0, 0.0, 1.0), 3.0)
    sunk = Demonstration("sunk", time, path, force_N=np.outer(force, -DOWN))
    return sunk, type(segment)(**values)


def test_only_a_stiff_contact_tells_to_a_tenth_where_it_is() -> None:
    hard, soft = pushed_into(20_000.0), pushed_into(600.0)
    assert shift_beyond(hard[0], skill_of(*hard), np.zeros(3)) == 0.0
    # A slower tool sinks in as far again as the force took to rise, 10 mm here.
    assert shift_beyond(soft[0], skill_of(*soft), np.zeros(3)) == pytest.approx(0.01, rel=0.1)


def test_a_connecting_move_presses_nothing() -> None:
    here, there = np.zeros(3), np.array([0.1, 0.0, 0.0])
    move = connecting_skill(here, np.array([1.0, 0, 0, 0]), there, np.array([1.0, 0, 0, 0]))
    assert kept_force(bundled("setup1")[0], move, DOWN) is None


def test_without_force_conditions_nothing_is_pressed() -> None:
    segments = [
        type(each)(**{**vars(each), "end_condition": ConfigurationEnd()}) for each in plan("setup2")
    ]
    result = replayed("setup2", segments)
    assert all(state.stage != "pressing" for state in result.states)
    assert all(not np.any(each.shift_m) for each in result.results)
