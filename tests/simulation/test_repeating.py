"""A recording is repeated whole and in its order; pauses of its own size may be left out."""

from dataclasses import replace

import numpy as np
import pytest
from drawn_contact import DOWN_S, PRESS_S, its_plan, pressed_slide
from test_recorded import replayed

from keyphase.recorded_force import Even
from keyphase.simulation.recorded.repeating import Repeating

DOWN, AND_PRESS, UP = (0.0, 1.0), (1.0, 2.0), (2.0, 3.0)


def recorded(moved_m: float = 0.001) -> Even:
    """0.1 m down within a second, `moved_m` aside within the next, and up again."""
    time = np.arange(0.0, 3.0, 0.005)
    height = np.interp(time, [0.0, 1.0, 2.0, 3.0], [0.1, 0.0, 0.0, 0.1])
    aside = np.interp(time, [1.25, 1.75], [0.0, moved_m])
    wxyz = np.tile([1.0, 0.0, 0.0, 0.0], (len(time), 1))
    return Even(time, np.c_[aside, 0 * time, height], wxyz, np.zeros((len(time), 3)))


def is_whole(even: Even, *spans, gripper=None) -> bool:
    repeating = Repeating(even, gripper)
    for span in spans:
        repeating.begin(span)
    return repeating.whole


@pytest.mark.parametrize(
    ("spans", "whole"),
    [
        ([DOWN, AND_PRESS, UP], True),
        ([DOWN, DOWN, AND_PRESS, DOWN, UP], True),
        ([DOWN, UP, AND_PRESS], False),
        ([AND_PRESS, DOWN, UP], False),
        ([DOWN, UP], True),
        ([(0.0, 0.8), (1.2, 2.0), UP], True),
        ([DOWN, AND_PRESS, (2.6, 3.0)], False),
    ],
)
def test_skills_come_in_their_order_however_little_they_move(spans, whole) -> None:
    assert is_whole(recorded(), *spans) == whole


@pytest.mark.parametrize(("moved_m", "whole"), [(0.002, True), (0.008, False)])
def test_what_is_a_pause_is_told_by_how_far_the_recording_goes(moved_m, whole) -> None:
    assert is_whole(recorded(moved_m), DOWN, UP) == whole
    assert is_whole(recorded(moved_m), DOWN, AND_PRESS, UP)


def test_a_stretch_in_which_the_gripper_closes_is_no_pause() -> None:
    closing = np.interp(recorded().time_s, [1.3, 1.5], [0.08, 0.02])
    assert not is_whole(recorded(), DOWN, UP, gripper=closing)
    assert is_whole(recorded(), DOWN, AND_PRESS, UP, gripper=closing)


def test_two_neighbours_that_were_swapped_are_no_success_though_one_hardly_moves() -> None:
    """The press in place comes last: the tool ends where the slide began."""
    down, slide = its_plan()
    until_s = DOWN_S + PRESS_S
    press, slide = replace(slide, end_s=until_s, label="press"), replace(slide, start_s=until_s)
    right, world = replayed(pressed_slide(), segments=[down, press, slide])
    swapped, elsewhere = replayed(pressed_slide(), segments=[down, slide, press])
    end_m = pressed_slide().position_m[-1]
    assert np.linalg.norm(world.body.position_m - end_m) < 0.005
    assert np.linalg.norm(elsewhere.body.position_m - end_m) > 0.03
    assert right.succeeded, right.outcome()
    assert "demonstration repeated" in swapped.outcome()
