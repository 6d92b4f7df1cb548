"""Where a slide ended against something, the world made from the recording stops it again."""

from dataclasses import replace

import numpy as np
import pytest
from drawn_contact import DOWN_S, PRESS_S, SLID_M, SLIDE_S, pressed_slide
from replaying import Drawn

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.simulation.impedance import Reference
from keyphase.simulation.recorded.cell import RecordedCell
from keyphase.simulation.replay.replay import run
from keyphase.skills.contacts import kept_force
from keyphase.skills.library import skill_of, skills_of

WALL_N, STOOD_S, MET_S = 5.0, 1.0, DOWN_S + PRESS_S + SLIDE_S
PUSHED_S = 0.1
"""So long before its end the slide runs up against the wall."""


def slid_against(wall_N: float, swayed_N_m: float = 0.0) -> Demonstration:
    """A slide on a table whose end stands for a second, against a wall or nothing.

    It sways there by 0.3 mm, with a force that rises so steeply with the place.
    """
    slide = pressed_slide()
    assert slide.force_N is not None
    stood = round(STOOD_S * 250)
    time = np.r_[slide.time_s, MET_S + np.arange(1, stood + 1) / 250]
    position = np.r_[slide.position_m, np.repeat(slide.position_m[-1:], stood, axis=0)]
    force = np.r_[slide.force_N, np.repeat(slide.force_N[-1:], stood, axis=0)]
    force[:, 0] -= wall_N * np.clip((time - MET_S + PUSHED_S) / 0.02, 0.0, 1.0)
    sway_m = 0.0003 * np.sin(2 * np.pi * 5.0 * (time - MET_S)) * (time > MET_S) * (swayed_N_m > 0)
    position[:, 0] += sway_m
    force[:, 0] -= swayed_N_m * sway_m
    wxyz = np.tile([1.0, 0.0, 0.0, 0.0], (len(time), 1))
    return Demonstration("slide to a wall", time, position, wxyz, force)


def plan() -> list[Drawn]:
    touched_s = DOWN_S - 0.25
    wall = ContactEnd((-1.0, 0.0, 0.0), 0.6 * WALL_N)
    return [
        Drawn(0.0, touched_s, "down until contact", ContactEnd((0.0, 0.0, 1.0), 3.0)),
        Drawn(touched_s, MET_S - PUSHED_S, "slide until contact", wall),
    ]


def test_a_slide_against_a_wall_leaves_a_stop_where_it_stood() -> None:
    demonstration = slid_against(WALL_N)
    stop, table = RecordedCell(demonstration).surfaces[0].stops
    assert stop.normal == pytest.approx([-1.0, 0.0, 0.0], abs=0.05)
    assert stop.point_m[0] == pytest.approx(0.4 + SLID_M, abs=1e-3)
    assert stop.from_s < MET_S < stop.to_s
    assert table.normal == pytest.approx([0.0, 0.0, 1.0], abs=0.05)
    assert table.point_m[2] == pytest.approx(demonstration.position_m[-1, 2], abs=1e-3)
    assert table.to_s == stop.to_s


@pytest.mark.parametrize(("recorded", "is_as"), [(8e3, 8e3), (1e3, 4e3), (5e4, 12e3)])
def test_a_stop_is_as_stiff_as_the_force_rose_there(recorded: float, is_as: float) -> None:
    stop, _ = RecordedCell(slid_against(WALL_N, recorded)).surfaces[0].stops
    assert stop.stiffness_N_m == pytest.approx(is_as, rel=0.1)


def test_a_slide_that_only_comes_to_rest_leaves_none() -> None:
    assert RecordedCell(slid_against(0.0)).surfaces[0].stops == ()


def test_the_wall_stops_a_replay_that_presses_on() -> None:
    cell = RecordedCell(slid_against(WALL_N))
    result = run(cell.build(), skills_of(cell.demonstration, plan()), cell.demonstration)
    assert result.succeeded, result.outcome()
    assert result.results[-1].outcome == "contact"


def moved_beyond(wall_N: float, stops: int, beyond_m: tuple[float, float, float]) -> Array:
    """How far (3,) a tool gets that is pulled beyond where it stood, with so many of the stops."""
    demonstration = slid_against(wall_N)
    cell = RecordedCell(demonstration)
    cell.surfaces = tuple(replace(one, stops=one.stops[:stops]) for one in cell.surfaces)
    world, stood_m = cell.build(), demonstration.position_m[-1]
    world.body.position_m = stood_m.copy()
    pulled = Reference(stood_m + np.array(beyond_m), world.body.orientation_wxyz)
    for _ in range(250):
        world.be_at(MET_S + 0.5, (DOWN_S, MET_S + STOOD_S))
        world.step(pulled)
    return world.body.position_m - stood_m


@pytest.mark.parametrize(("stops", "slides_on"), [(2, False), (0, True)])
def test_the_wall_stops_a_tool_that_presses_on(stops, slides_on) -> None:
    beyond_m = moved_beyond(WALL_N, stops, (0.02, 0.0, -0.003))
    assert (beyond_m[0] > 0.006) == slides_on


@pytest.mark.parametrize(("stops", "sinks"), [(2, False), (1, True)])
def test_what_it_slid_on_holds_a_tool_that_presses_down_at_the_wall(stops, sinks) -> None:
    """The wall turns the recorded force aside: the tool would slip down between both."""
    beyond_m = moved_beyond(3.0 * WALL_N, stops, (0.005, 0.0, -0.006))
    assert (beyond_m[2] < -0.003) == sinks


def test_the_wall_that_ends_a_slide_is_not_dragged_along() -> None:
    demonstration = slid_against(3.0 * WALL_N)
    stretch = Drawn(MET_S - 0.6, MET_S, "slide", ContactEnd((-1.0, 0.0, 0.0), WALL_N))
    ends_at_wall = skill_of(demonstration, stretch)
    by_pose = skill_of(demonstration, replace(stretch, end_condition=ConfigurationEnd()))
    down = np.array([0.0, 0.0, -1.0])
    slid, dragged = (kept_force(demonstration, skill, down) for skill in (ends_at_wall, by_pose))
    assert slid is not None
    assert dragged is not None
    assert slid.carries is None
    assert dragged.carries is not None
