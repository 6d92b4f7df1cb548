"""A world made from a recording: what was met is met again, and what is doubtful is not trusted."""

from dataclasses import replace

import numpy as np
import pytest
from drawn_contact import DOWN_S, PRESSED_N, its_plan, pressed_slide, reversed_force
from replaying import bundled

from keyphase.demonstration import Demonstration
from keyphase.doubtful_force import doubtful_force, power_share
from keyphase.errors import SimulationError
from keyphase.recorded_force import evenly, offset_while_moving
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, GripperEnd
from keyphase.simulation import Disturbance
from keyphase.simulation.choosing import cell_for, unfit
from keyphase.simulation.recorded.arising import Arising
from keyphase.simulation.recorded.cell import RecordedCell
from keyphase.simulation.recorded.meeting import Meeting
from keyphase.simulation.replay.margin_plans import as_one
from keyphase.simulation.replay.replay import run
from keyphase.skills.library import skills_of


def replayed(demonstration, disturbance=None, segments=None):
    cell = RecordedCell(demonstration)
    world = cell.build(disturbance or Disturbance())
    skills = skills_of(cell.demonstration, segments or its_plan())
    return run(world, skills, cell.demonstration), world


def test_the_plan_of_a_recording_meets_its_contact_again_and_succeeds() -> None:
    result, world = replayed(pressed_slide())
    assert result.succeeded, result.outcome()
    assert [each.outcome for each in result.results] == ["contact", "reached"]
    assert PRESSED_N < result.peak_force < 2.0 * PRESSED_N
    assert world.meeting.touched[0] == pytest.approx(DOWN_S - 0.25, abs=0.4)


@pytest.mark.parametrize("height_m", [0.008, -0.008])
def test_a_surface_that_lies_elsewhere_is_met_there(height_m) -> None:
    result, _ = replayed(pressed_slide(), Disturbance(part_height_m=height_m))
    met = result.results[0].ended_m[2]
    nominal = replayed(pressed_slide())[0].results[0].ended_m[2]
    assert met - nominal == pytest.approx(height_m, abs=1.5e-3)
    assert result.succeeded, result.outcome()


def test_a_surface_that_is_met_late_is_still_what_it_was_when_it_was_met() -> None:
    """The force turned aside soon after the contact: a tool that comes late is not led past it."""
    turning = pressed_slide()
    assert turning.force_N is not None
    after = np.clip((turning.time_s - DOWN_S + 0.1) / 0.05, 0.0, 1.0)
    force = turning.force_N + PRESSED_N * after[:, None] * np.array([0.0, 1.5, 0.0])
    down = [its_plan()[0]]
    result, _ = replayed(replace(turning, force_N=force), Disturbance(part_height_m=-0.01), down)
    assert [each.outcome for each in result.results] == ["contact"]
    assert result.results[0].ended_m[1] == pytest.approx(0.0, abs=2e-3)


def test_a_plan_that_skips_the_contact_does_not_succeed() -> None:
    stroke = replace(its_plan()[0], end_s=0.5, end_condition=its_plan()[1].end_condition)
    gives_up = ContactEnd((0.0, 0.0, 1.0), 3.0, offset_m=0.02)
    wrong = [stroke, replace(its_plan()[0], start_s=0.5, end_condition=gives_up)]
    result, _ = replayed(pressed_slide(), Disturbance(part_height_m=-0.03), wrong)
    assert not result.succeeded
    assert "plan carried out" in result.outcome()


@pytest.mark.parametrize(
    ("segments", "whole"),
    [
        (its_plan()[::-1], False),
        (its_plan()[1:], False),
        (its_plan()[:1], False),
        (2 * its_plan(), True),
    ],
    ids=["reversed", "the last skill only", "the first skill only", "twice"],
)
def test_a_plan_that_leaves_out_or_reorders_has_not_repeated_the_demonstration(
    segments, whole
) -> None:
    result, _ = replayed(pressed_slide(), segments=segments)
    assert result.checks["demonstration repeated"] == whole
    assert result.succeeded == whole, result.outcome()


def test_one_long_skill_may_press_no_harder_where_nothing_was_touched_than_a_short_one() -> None:
    """Met with 6 N, and pressed with 30 N later: so much was never its beginning."""
    later = pressed_slide()
    assert later.force_N is not None
    firmer = 1.0 + 4.0 * np.clip((later.time_s - DOWN_S - 0.7) / 0.2, 0.0, 1.0)
    shown = replace(later, force_N=later.force_N * firmer[:, None])
    nearer = Disturbance(part_height_m=0.005)
    assert replayed(shown, nearer)[0].succeeded
    result, _ = replayed(shown, nearer, [as_one(its_plan())])
    assert result.completed
    assert result.hardest.moment_s < DOWN_S + 0.7
    assert 15.0 < result.hardest.force_N < 2.0 * 30.0
    assert not result.checks["no force above twice the demonstrated"]


def test_a_contact_that_only_a_later_skill_meets_is_not_met() -> None:
    """By its pose alone the way down ends above the table, and the slide sinks onto it."""
    down, slide = its_plan()
    end_s = down.end_s + 0.15
    by_pose = [
        replace(down, end_s=end_s, end_condition=ConfigurationEnd()),
        replace(slide, start_s=end_s),
    ]
    lower = Disturbance(part_height_m=-0.004)
    result, world = replayed(pressed_slide(), lower, by_pose)
    assert result.completed
    assert world.meeting.touched
    assert "contacts met in order" in result.outcome()
    assert replayed(pressed_slide(), lower)[0].succeeded


@pytest.mark.parametrize(
    ("asked_N", "felt_N", "firm"), [(10, 4, False), (10, 6, True), (2, 0, True)]
)
def test_a_contact_is_repeated_if_it_is_pressed_with_half_of_what_was_demonstrated(
    asked_N, felt_N, firm
) -> None:
    (surface,) = RecordedCell(pressed_slide()).surfaces
    meeting = Meeting([replace(surface, force_N=np.full(len(surface.time_s), asked_N))], 0.0)
    meeting.repeat(surface.made_s + 0.1, (0.0, 3.0))
    for tick in range(50):
        meeting.press({0: float(felt_N)} if felt_N else {}, 0.004 * tick)
    assert meeting.firm == firm


def test_a_contact_that_a_recording_begins_in_was_met_by_nobody() -> None:
    """It rests on something at first; further away, that is not touched, and nothing is missed."""
    late = pressed_slide()
    assert late.force_N is not None
    rested = np.clip((0.2 - late.time_s) / 0.02, 0.0, 1.0)[:, None] * np.array([0.0, -2.0, 0.0])
    result, world = replayed(
        replace(late, force_N=late.force_N + rested), Disturbance(part_offset_m=(0.0, 0.004))
    )
    assert len(world.workcell.surfaces) == 2
    assert list(world.meeting.touched) == [1]
    assert result.succeeded, result.outcome()


def test_what_is_come_to_at_a_slant_may_be_met_further_along_the_way() -> None:
    """Down at 30° to the table: 8 mm lower is 16 mm further along the way."""
    straight = pressed_slide()
    down = 0.2 - straight.position_m[:, 2]
    aside = np.array([0.0, np.sqrt(3.0), 0.0])
    slanted = replace(straight, position_m=straight.position_m + down[:, None] * aside)
    (surface,) = RecordedCell(slanted).surfaces
    assert surface.slant == pytest.approx(2.0, abs=0.05)
    result, world = replayed(slanted, Disturbance(part_height_m=-0.008))
    assert world.furthest_m > 0.013
    assert result.succeeded, result.outcome()


def test_a_constant_offset_of_the_sensor_is_no_contact() -> None:
    resting = pressed_slide((0.0, 3.0, 14.0))
    assert resting.force_N is not None
    hold = np.arange(100) / 250
    still = replace(
        resting,
        time_s=np.r_[hold, resting.time_s + 0.4],
        position_m=np.r_[np.repeat(resting.position_m[:1], 100, 0), resting.position_m],
        orientation_wxyz=np.tile([1.0, 0.0, 0.0, 0.0], (len(resting) + 100, 1)),
        force_N=np.r_[np.repeat(resting.force_N[:1], 100, 0), resting.force_N],
    )
    assert offset_while_moving(evenly(still)) == pytest.approx([0.0, 3.0, 14.0], abs=0.1)
    assert len(RecordedCell(still).surfaces) == 1


def test_a_tool_that_was_not_tared_is_weighed_in_free_space_and_less_in_contact() -> None:
    """It rests under its weight, comes down, is carried by a table that it wipes, and goes up."""
    time = np.arange(2000) / 250
    up = np.interp(time, [0, 0.5, 1.5, 6, 7, 8], [0.1, 0.1, 0.0, 0.0, 0.1, 0.1])
    aside = 0.05 * np.sin(3.0 * (time - 1.5)) * ((time > 1.5) & (time < 6.0))
    carried = np.where(up > 0.0, 0.0, 8.0)
    force = np.c_[-0.1 * carried, 0 * time, carried - 9.0]
    wiped = Demonstration("wiped", time, np.c_[aside, 0 * time, up], None, force)
    assert offset_while_moving(evenly(wiped)) == pytest.approx([0.0, 0.0, -9.0], abs=0.1)


def test_a_surface_that_gave_way_gives_way_to_a_replay() -> None:
    """A body that was pushed along: a fast push is not damped as if it stood."""
    time = np.arange(1000) / 250
    place = np.interp(time, [0, 0.5, 2.5, 4.0], [0.0, 0.0, 0.4, 0.4])
    touches = (place > 0.1) & (place < 0.4)
    force = np.c_[-3.0 * touches, 0 * time, 0 * time]
    wxyz = np.tile([1.0, 0.0, 0.0, 0.0], (1000, 1))
    pushed = Demonstration("pushed", time, np.c_[place, 0 * time, 0 * time], wxyz, force)
    (surface,) = RecordedCell(pushed).surfaces
    plane = surface.plane(np.array([0.3, 0.0, 0.0]), 2.0)
    assert plane.closing_m_s == pytest.approx(-0.2, abs=0.01)
    assert plane.leaps == 1.0
    assert RecordedCell(pressed_slide()).surfaces[0].leaps.max() == 0.0


def test_a_body_that_is_pushed_further_than_it_went_moves_on() -> None:
    time = np.arange(1000) / 250
    place = np.interp(time, [0, 0.5, 2.5, 4.0], [0.0, 0.0, 0.4, 0.4])
    force = np.c_[-3.0 * ((place > 0.1) & (place < 0.3)), 0 * time, 0 * time]
    pushed = Demonstration("pushed", time, np.c_[place, 0 * time, 0 * time], None, force)
    world, felt = RecordedCell(pushed).build(), list[float]()
    for moment_s, at_m in ((1.02, 0.101), *20 * ((1.98, 0.31),)):
        world.body.position_m = np.array([at_m, 0.0, 0.0])
        world.body.velocity_m_s = np.zeros(3)
        world.be_at(moment_s, (0.5, 2.5))
        felt.append(float(world.step(world.here()).force_N[0]))
    assert -1.5 * 3.0 < felt[-1] < -1.0


def test_a_surface_that_comes_to_stand_around_the_tool_stands_before_it() -> None:
    arising = Arising()
    found, coming_out, going_in = (arising.back_m(0, m, 0.001) for m in (0.009, 0.005, 0.012))
    assert (found, coming_out, going_in) == pytest.approx((0.008, 0.004, 0.004))
    arising.absent(0)
    assert arising.back_m(0, 0.012, 0.001) == pytest.approx(0.011)


def test_the_surroundings_take_energy_and_a_force_that_gives_is_doubted() -> None:
    right, wrong = pressed_slide(), reversed_force(pressed_slide())
    found = power_share(evenly(right))
    assert found is not None
    assert found[0] < -0.1
    assert doubtful_force(right) is None
    assert "helps the motion" in str(doubtful_force(wrong))


def test_a_world_made_from_a_doubtful_force_is_never_a_success() -> None:
    result, _ = replayed(reversed_force(pressed_slide()))
    assert not result.succeeded
    assert "a force to be trusted" in result.outcome()


@pytest.mark.parametrize(("closes", "outcome"), [(True, "reached"), (False, "timeout")])
def test_a_grasp_is_over_once_the_gripper_has_closed_as_recorded(closes, outcome) -> None:
    """It closes while the skill ends and a little after; one that is stuck open never has."""
    gripped_s = DOWN_S + 1.0
    opening = np.interp(pressed_slide().time_s, (gripped_s - 0.1, gripped_s + 0.2), (0.08, 0.02))
    shown = replace(pressed_slide(), gripper=opening)
    end = ConfigurationEnd(gripper=GripperEnd("grasp", 0.02, 0.006))
    skills = skills_of(
        shown, [its_plan()[0], replace(its_plan()[1], end_s=gripped_s, end_condition=end)]
    )
    found = replace(shown, gripper=opening if closes else np.full(len(shown), 0.08))
    result = run(RecordedCell(found).build(), skills, found)
    assert result.results[-1].outcome == outcome
    assert result.demonstration.gripper is not None
    assert result.demonstration.gripper[-1] == pytest.approx(0.02 if closes else 0.08, abs=0.006)


def test_without_force_no_world_can_be_made() -> None:
    with pytest.raises(SimulationError, match="has none"):
        RecordedCell(replace(pressed_slide(), force_N=None))


def test_a_recording_of_a_workcell_is_replayed_there_and_a_strangers_in_its_own_world() -> None:
    assert cell_for(bundled("setup2")[0]).name == "setup2"
    assert cell_for(pressed_slide()).name == "recording"
    assert cell_for(bundled("setup2")[0], "recording").name == "recording"


def test_a_strangers_recording_is_refused_in_a_workcell_it_does_not_fit() -> None:
    with pytest.raises(SimulationError, match="does not fit setup1"):
        cell_for(pressed_slide(), "setup1")
    assert unfit(bundled("setup1")[0], cell_for(bundled("setup1")[0])) is None


def test_the_recording_of_its_replay_has_no_joints() -> None:
    again = replayed(pressed_slide())[0].demonstration
    assert again.joints_rad is None
    assert again.torque_Nm is None
    assert again.metadata["workcell"] == "recording"


def test_the_same_seed_gives_the_same_replay() -> None:
    first, second = (replayed(pressed_slide())[0].demonstration for _ in range(2))
    np.testing.assert_array_equal(np.asarray(first.force_N), np.asarray(second.force_N))
    assert np.array_equal(first.position_m, second.position_m)


def test_its_parts_can_be_drawn() -> None:
    cell = RecordedCell(pressed_slide())
    world = cell.build()
    assert world.bodies == ("held", "surface_1")
    assert [shape.body for shape in world.shapes()] == ["held", "surface_1"]
    assert world.frame()[0].shape == (2, 3)
