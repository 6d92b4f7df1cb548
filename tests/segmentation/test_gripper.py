"""What the gripper does is a boundary: where closing ends, and where opening begins."""

from dataclasses import replace

import numpy as np
import pytest

from keyphase import Demonstration, Parameters, segment
from keyphase.segmentation import Segmenter
from keyphase.segmentation.end_condition import ConfigurationEnd, GripperEnd
from keyphase.segmentation.gripper import GripperEvent, gripper_events, with_gripper
from keyphase.segmentation.segmentation import Boundary
from keyphase.simulation.making.simulated import make_simulated

RATE_HZ = 100.0
WITHIN_S = 0.06


def with_opening(opening: np.ndarray) -> Demonstration:
    time = np.arange(len(opening)) / RATE_HZ
    return Demonstration("grasping", time, np.zeros((len(time), 3)), gripper=opening)


def stroke(from_s: float, to_s: float, low: float, high: float, end_s: float = 10.0) -> np.ndarray:
    time = np.arange(int(end_s * RATE_HZ)) / RATE_HZ
    return np.interp(time, [from_s, to_s], [high, low])


def test_a_grasp_is_where_closing_ends_and_a_release_where_opening_begins() -> None:
    closed = stroke(2.0, 2.6, 0.03, 0.08)
    opened = np.where(np.arange(len(closed)) / RATE_HZ < 7.0, closed, 0.03)
    opened[700:] += np.clip((np.arange(300) / RATE_HZ) / 0.4, 0.0, 1.0) * 0.05
    events = gripper_events(with_opening(opened))
    assert [event.change for event in events] == ["grasp", "release"]
    assert [event.time_s for event in events] == pytest.approx([2.6, 7.0], abs=0.03)


@pytest.mark.parametrize("scale", [1.0, 0.085, 255.0])
def test_a_command_of_zero_and_one_in_any_unit_serves_alike(scale: float) -> None:
    opening = scale * np.repeat([1.0, 0.0, 1.0], [300, 400, 300])
    events = gripper_events(with_opening(opening))
    assert [(event.change, event.time_s) for event in events] == [("grasp", 3.0), ("release", 7.0)]


def test_slack_and_noise_of_the_sensor_are_no_events() -> None:
    rng = np.random.default_rng(0)
    still = with_opening(0.04 + rng.normal(0.0, 2e-4, 1000))
    assert gripper_events(still) == ()
    moved = stroke(2.0, 2.5, 0.0, 0.08) + 0.004 * np.sin(np.arange(1000) / 30.0)
    noisy = gripper_events(with_opening(moved + rng.normal(0.0, 2e-4, 1000)))
    assert [event.change for event in noisy] == ["grasp"]


def test_fingers_that_spring_back_at_the_part_grasp_once() -> None:
    opening = np.repeat([0.08, 0.02], [300, 700])
    opening[300:306] = [0.06, 0.03, 0.012, 0.008, 0.012, 0.018]
    events = gripper_events(with_opening(opening))
    assert [event.change for event in events] == ["grasp"]
    assert events[0].time_s == pytest.approx(3.015, abs=0.02)


def test_boundaries_of_motion_give_way_and_contact_changes_become_the_grasp() -> None:
    found = Boundary(2.02, "force", (2.0, 2.1), 0.9, contact_change=True)
    moved = Boundary(7.1, "position", (7.0, 7.2), 0.8, contact_change=False)
    far = replace(moved, time_s=5.0)
    events = [GripperEvent(2.0, "grasp", 1.0), GripperEvent(7.0, "release", 1.0)]
    joined = with_gripper([found, far, moved], events)
    assert [(one.time_s, one.origin, one.gripper) for one in joined] == [
        (2.02, "force", "grasp"),
        (5.0, "position", ""),
        (7.0, "gripper", "release"),
    ]
    assert joined[-1].position_s == 7.1


@pytest.mark.slow
def test_of_a_simulated_pick_and_place_grasp_and_release_are_found_named_and_kept() -> None:
    made = make_simulated("simulated-pick-and-place", 3)
    segmentation = segment(made.demonstration)
    by_gripper = [one for one in segmentation.boundaries if one.gripper]
    assert [one.gripper for one in by_gripper] == [event.label for event in made.gripped]
    for boundary, event in zip(by_gripper, made.gripped, strict=True):
        assert abs(boundary.time_s - event.time_s) <= WITHIN_S
    ended = [one for one in segmentation.segments if one.label in ("Grasp", "Release")]
    assert len(ended) == 2
    assert not any(one.idle for one in ended)
    ends = [one.end_condition for one in ended]
    gripped = [end.gripper for end in ends if isinstance(end, ConfigurationEnd) and end.gripper]
    assert {one.change for one in gripped} <= {"grasp", "release"}


def test_a_segment_that_ends_as_the_gripper_acts_ends_with_what_it_did() -> None:
    demonstration = with_opening(0.08 * np.repeat([1.0, 0.25, 1.0], [300, 400, 300]))
    first, second, last = (one.end_condition for one in segment(demonstration).segments)
    assert isinstance(first, ConfigurationEnd)
    assert first.gripper is not None
    assert first.gripper.tolerance == pytest.approx(0.006, rel=0.01)
    grasp = GripperEnd("grasp", 0.02, first.gripper.tolerance)
    assert first.gripper == grasp
    assert second == ConfigurationEnd(gripper=replace(grasp, change="release"))
    assert last == ConfigurationEnd()


@pytest.mark.parametrize(("speed_m_s", "by_fingers"), [(0.0, True), (0.05, False)])
def test_what_the_fingers_touch_as_the_tool_stands_ends_with_the_grasp(
    speed_m_s: float, by_fingers: bool
) -> None:
    shown = with_opening(stroke(2.0, 2.6, 0.03, 0.08))
    way = speed_m_s * np.minimum(shown.time_s, 2.6)
    touched = replace(
        shown,
        position_m=np.c_[way, 0.0 * way, 0.0 * way],
        force_N=np.outer(shown.time_s > 2.6, [-3.0, 0.0, 0.0]),
    )
    end = Segmenter(touched).segment_between(0.0, 2.6, True).end_condition
    assert isinstance(end, ConfigurationEnd) == by_fingers


def test_the_paper_and_methods_of_ones_own_find_what_they_find() -> None:
    demonstration = with_opening(np.repeat([1.0, 0.0, 1.0], [300, 400, 300]))
    assert [one.gripper for one in segment(demonstration).boundaries] == ["grasp", "release"]
    published = segment(demonstration, Parameters(variant="paper"))
    assert not any(one.gripper for one in published.boundaries)


def test_no_number_over_a_line_is_told_where_it_would_be_wrong() -> None:
    moving = with_opening(np.repeat([1.0, 0.0, 1.0], [300, 400, 300]))
    assert segment(moving).line_counts == ()
    assert segment(replace(moving, gripper=None)).line_counts != ()
