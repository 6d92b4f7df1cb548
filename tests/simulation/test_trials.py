"""Trials: replays in disturbed worlds, counted honestly and the same for everybody."""

from xml.etree import ElementTree

import numpy as np
import pytest
from replaying import NAMES, bundled, plan

from keyphase.errors import ParameterError, SimulationError
from keyphase.simulation import Disturbance
from keyphase.simulation.replay.ranges import Range, range_of
from keyphase.simulation.replay.trials import (
    Trial,
    Trials,
    World,
    Worlds,
    drawn_worlds,
    run_trials,
    wilson_interval,
)
from keyphase.simulation.replay.trials_picture import trials_svg
from keyphase.skills.library import skills_of

DISTURBED = Worlds(
    part_height_m=Range(-0.01, 0.01),
    part_offset_m=Range(-0.005, 0.005),
    friction=Range(0.2, 0.6),
    sensor_noise=Range(2.0, 2.0),
)


def trials(name, count, jobs=1):
    demonstration = bundled(name)[0]
    skills = skills_of(demonstration, plan(name))
    return run_trials(name, demonstration, skills, drawn_worlds(DISTURBED, count, 3), jobs=jobs)


def some(*successes: bool, label: str = "move") -> Trials:
    """Trials that were not run."""
    worlds = drawn_worlds(DISTURBED, len(successes), 0)
    return Trials(
        (label,),
        tuple(
            Trial(world, ("contact" if done else "timeout",), (("seated", done),), 8.0, 5.0)
            for world, done in zip(worlds, successes, strict=True)
        ),
    )


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_disturbed_worlds_succeed_gently(name) -> None:
    result = trials(name, 3)
    assert result.successes == 3
    assert result.peak_forces().max() < 25.0


def test_the_results_do_not_depend_on_how_many_run_at_once() -> None:
    assert trials("setup1", 2, jobs=1) == trials("setup1", 2, jobs=2)


def test_more_worlds_begin_with_the_same_ones() -> None:
    assert drawn_worlds(DISTURBED, 20, 5)[:7] == drawn_worlds(DISTURBED, 7, 5)
    assert drawn_worlds(DISTURBED, 7, 6) != drawn_worlds(DISTURBED, 7, 5)


def test_worlds_vary_within_their_spreads_and_nowhere_else() -> None:
    worlds = [world.disturbance for world in drawn_worlds(DISTURBED, 200, 0)]
    heights = np.array([world.part_height_m for world in worlds])
    assert -0.01 <= heights.min() < -0.009
    assert 0.009 < heights.max() <= 0.01
    x, y = np.array([world.part_offset_m for world in worlds]).T
    assert abs(np.corrcoef(x, y)[0, 1]) < 0.2
    assert {world.sensor_noise for world in worlds} == {2.0}
    assert {world.disturbance for world in drawn_worlds(Worlds(), 9, 0)} == {Disturbance()}


@pytest.mark.parametrize(
    ("successes", "of", "low", "high"),
    [(0, 10, 0.0, 0.2775), (10, 10, 0.7225, 1.0), (196, 200, 0.9497, 0.9922)],
)
def test_the_interval_is_wilsons(successes, of, low, high) -> None:
    assert wilson_interval(successes, of) == pytest.approx((low, high), abs=1e-4)


def test_outcomes_are_counted_for_each_skill() -> None:
    result = some(True, True, False)
    assert result.outcomes(0) == {"contact": 2, "timeout": 1}
    assert result.rate == pytest.approx(2 / 3)


def test_a_simulation_that_diverged_is_a_failure() -> None:
    world = World(Disturbance(), 0)
    assert not Trial(world, (), (), 0.0, 0.0, error="setup1 diverged").succeeded


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [("10mm", 0.01, 0.01), ("-1cm..2cm", -0.01, 0.02), ("0.2..0.6", 0.2, 0.6), ("3", 3.0, 3.0)],
)
def test_spreads_are_read_as_people_write_them(text, low, high) -> None:
    spread = range_of(text, "--part-height")
    assert (spread.low, spread.high) == pytest.approx((low, high))


def test_a_single_value_may_stand_for_plus_or_minus() -> None:
    assert range_of("10mm", "--part-height", symmetric=True) == Range(-0.01, 0.01)


@pytest.mark.parametrize("text", ["", "ten", "5 miles", "0.6..0.2", "1..", "nan", "1..2..3"])
def test_what_is_no_spread_is_refused(text) -> None:
    with pytest.raises(ParameterError, match="--friction"):
        range_of(text, "--friction")


def test_an_unknown_workcell_is_refused_before_any_work() -> None:
    demonstration = bundled("setup1")[0]
    with pytest.raises(SimulationError, match="setup9"):
        run_trials("setup9", demonstration, (), drawn_worlds(Worlds(), 1, 0))


def test_the_picture_has_one_mark_for_each_world() -> None:
    root = ElementTree.fromstring(trials_svg(some(True, False, True), "setup1"))
    marks = [each for each in root.iter() if each.tag.endswith("circle")]
    assert len(marks) == 3
    assert len({mark.attrib["fill"] for mark in marks}) == 2


def test_a_label_cannot_break_the_picture() -> None:
    hostile = '</text><script>alert("1")</script>\x00&'
    root = ElementTree.fromstring(trials_svg(some(True, label=hostile), hostile))
    assert not any(each.tag.endswith("script") for each in root.iter())
