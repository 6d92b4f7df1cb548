"""A success is one: what the predicate says is held against the true poses of the parts."""

from dataclasses import replace

import numpy as np
import pytest
from replaying import NAMES, bundled, plan

from keyphase.simulation import NOMINAL, Disturbance, Simulation, workcell
from keyphase.simulation.replay.allowed_force import Hardest
from keyphase.simulation.replay.replay import run
from keyphase.simulation.replay.result import ReplayResult
from keyphase.simulation.workcells.seating import lie_of
from keyphase.simulation.workcells.setup2 import FITS
from keyphase.skills.library import skills_of


def replayed(name, segments, disturbance=NOMINAL) -> tuple[ReplayResult, Simulation]:
    demonstration = bundled(name)[0]
    simulation = workcell(name).build(disturbance)
    return run(simulation, skills_of(demonstration, segments), demonstration), simulation


def truly_done(name: str, simulation: Simulation) -> bool:
    """Read from the poses alone: the cap lies flat in its housing, and both are where they go."""
    poses = simulation.part_poses()
    way = poses["held"][0] - poses["housing"][0]
    beside = np.hypot(*way[:2]) > 0.009
    floating = abs(way[2] - 0.026) > 0.002
    moved = poses["housing"][0] - simulation.start_parts["housing"][0]
    return not (beside or floating) and np.hypot(*moved[:2]) > 0.05


def merged(name: str) -> list:
    """The whole demonstration as one single segment."""
    segments = bundled(name)[2].segments
    first = plan(name)[0]
    last = segments[-1]
    return [replace(first, end_s=last.end_s, end_condition=last.end_condition)]


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(
    "disturbance",
    [
        Disturbance(part_offset_m=(0.02, 0.0)),
        Disturbance(part_offset_m=(0.0, -0.02)),
        Disturbance(friction=1.2, part_turn_rad=0.3),
        Disturbance(mass=10.0, part_offset_m=(0.006, 0.0)),
    ],
    ids=["20 mm aside", "20 mm before", "rough and twisted", "ten times the mass"],
)
def test_in_a_world_it_was_not_made_for_no_plan_succeeds_wrongly(name, disturbance) -> None:
    result, simulation = replayed(name, plan(name), disturbance)
    assert truly_done(name, simulation) or not result.succeeded, result.outcome()
    assert result.succeeded or result.outcome().startswith("failed, not ")


@pytest.mark.parametrize("name", NAMES)
def test_a_part_20_mm_aside_is_no_success(name) -> None:
    result, _ = replayed(name, plan(name), Disturbance(part_offset_m=(0.02, 0.0)))
    assert not result.succeeded


@pytest.mark.parametrize("name", NAMES)
def test_a_reversed_plan_is_no_success(name) -> None:
    assert not replayed(name, plan(name)[::-1])[0].succeeded


@pytest.mark.parametrize("name", NAMES)
def test_the_last_skill_alone_succeeds_only_if_its_connecting_move_does_the_rest(name) -> None:
    result, simulation = replayed(name, plan(name)[-1:])
    assert truly_done(name, simulation) or not result.succeeded, result.outcome()


@pytest.mark.parametrize("name", NAMES)
def test_one_single_skill_succeeds_only_if_the_parts_say_so(name) -> None:
    result, simulation = replayed(name, merged(name))
    assert truly_done(name, simulation) or not result.succeeded, result.outcome()


def test_a_success_needs_the_plan_carried_out_and_gentle_forces() -> None:
    result, _ = replayed("setup1", plan("setup1"))
    assert result.succeeded
    assert not replace(result, results=result.results[:-1]).succeeded
    assert not replace(result, stopped=True).succeeded
    rough = replace(result, hardest=Hardest(16.0, 15.0, 2.5))
    assert not rough.succeeded
    assert rough.outcome().startswith("failed, not no force above twice the demonstrated: ")
    assert rough.outcome().endswith("16 N at 2.5 s of the demonstration, where 15 N are allowed")


def test_what_happened_in_another_order_does_not_count() -> None:
    cell = replace(workcell("setup1"), events=workcell("setup1").events[::-1])
    demonstration = bundled("setup1")[0]
    result = run(cell.build(), skills_of(demonstration, plan("setup1")), demonstration)
    assert result.completed
    assert result.checks["wall reached"]
    assert not result.checks["slid together"]
    assert not result.checks["snapped on"]


@pytest.mark.parametrize("aside_m", [(0.005, -0.005), (-0.004, 0.003)])
def test_a_cap_that_meets_the_rim_is_sought_in(aside_m) -> None:
    result, simulation = replayed("setup1", plan("setup1"), Disturbance(part_offset_m=aside_m))
    assert result.succeeded, result.outcome()
    assert truly_done("setup1", simulation)
    assert any(state.stage == "searching" for state in result.states)


def test_a_turned_housing_turns_the_cap() -> None:
    result, _ = replayed("setup1", plan("setup1"), Disturbance(part_turn_rad=np.radians(5.0)))
    assert result.succeeded, result.outcome()


@pytest.mark.parametrize(("turn_deg", "tilt_deg"), [(-5.0, 0.0), (5.0, -1.8)])
def test_a_housing_with_play_is_squared_before_it_is_carried_along(turn_deg, tilt_deg) -> None:
    """A cap that is tilted in the hand lies flat then, and does not turn its housing."""
    turn, tilt = np.radians([turn_deg, tilt_deg])
    world = Disturbance(part_turn_rad=turn, tilt_rad=tilt, part_offset_m=(0.003, 0.002))
    result, simulation = replayed("setup2", plan("setup2"), world)
    assert result.succeeded, result.outcome()
    assert np.degrees(lie_of(simulation, FITS).angle_rad) < 0.6
