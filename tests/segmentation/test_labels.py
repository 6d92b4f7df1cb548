"""What segments are proposed to be called."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import synthetic
from keyphase import segment
from keyphase.demonstration import Demonstration
from keyphase.segmentation.labels import Evidence, Proposal, proposed_label

TIME = np.arange(501) / 250.0
PART = synthetic.minimum_jerk(TIME / 2.0)[:, None]
NOISE = np.random.default_rng(0).normal(size=(501, 3))


def said(proposal: Proposal) -> str:
    """Name and measure, with a bar between them."""
    return " | ".join(filter(None, (proposal.label, proposal.measure)))


def label(travel=(0.0, 0.0, 0.0), turn=(0.0, 0.0, 0.0), force=None, contact=False) -> str:
    """Of two seconds from rest to rest."""
    rotation = Rotation.from_rotvec(PART * np.array(turn))
    whole = Demonstration(
        "one movement",
        TIME,
        np.array([0.3, 0.1, 0.2]) + PART * np.array(travel) + NOISE * 1e-5,
        rotation.as_quat(scalar_first=True),
        None if force is None else np.asarray(force) + NOISE * 0.05,
    )
    return said(proposed_label(Evidence.of(whole), 0.0, 2.0, contact))


@pytest.mark.parametrize(
    ("travel", "expected"),
    [
        ((0.171, 0.0, 0.0), "Move forward | 171 mm"),
        ((-0.05, 0.0, 0.001), "Move back | 50 mm"),
        ((0.0, 0.054, 0.0), "Move left | 54 mm"),
        ((0.0, -0.3, 0.02), "Move right | 301 mm"),
        ((0.0, 0.0, -0.042), "Move down | 42 mm"),
        ((0.0, 0.0, 2.04), "Move up | 2.04 m"),
        ((0.1, 0.0, -0.08), "Move forward and down | 128 mm"),
    ],
)
def test_a_movement_is_named_by_direction_and_distance(travel, expected):
    assert label(travel) == expected


@pytest.mark.parametrize(
    ("turn", "expected"),
    [
        ((0.0, 0.0, np.pi / 2), "Rotate about z | 90°"),
        ((0.0, -np.pi / 4, 0.0), "Rotate about y | −45°"),
        ((np.radians(220), 0.0, 0.0), "Rotate about x | 220°"),
    ],
)
def test_a_rotation_is_named_by_axis_and_angle(turn, expected):
    assert label(turn=turn) == expected


def test_a_rotation_on_the_way_of_a_long_movement_is_still_a_movement():
    assert label((0.4, 0.0, 0.0), (0.0, 0.0, 0.3)) == "Move forward | 400 mm"


def test_a_movement_of_a_few_millimetres_is_told_to_a_tenth():
    path = synthetic.minimum_jerk(TIME / 0.4)[:, None] * np.array([0.0, 0.0, -0.0032])
    short = Demonstration("short", TIME, path + NOISE * 1e-5)
    assert proposed_label(Evidence.of(short), 0.0, 0.4, False) == (
        "Move down",
        "3.2 mm",
        False,
    )


def test_standing_still_is_idle():
    assert label() == "idle"


def touching_from(fraction: float, force) -> np.ndarray:
    return np.where(TIME[:, None] >= 2.0 * fraction, np.array(force, float), 0.0)


def test_moving_in_contact_is_sliding():
    assert label((0.0, 0.054, 0.0), force=touching_from(0.1, (0, 0, 5))) == "Slide left | 54 mm"


def test_moving_against_the_force_is_pushing():
    assert label((0.0, 0.1, 0.0), force=touching_from(0.1, (0, -8, 1))) == "Push left | 100 mm"


def test_building_up_force_in_one_place_is_pushing_and_not_idle():
    pressed = synthetic.minimum_jerk(TIME / 2.0)[:, None] * np.array([0.0, 0.0, 20.0]) + 1.0
    assert label(force=pressed) == "Push | 20 N"
    assert label(force=np.full((501, 3), 4.0)) == "idle"


def test_resting_after_an_impact_is_idle():
    dying_down = 3.0 + 9.0 * np.exp(-np.clip(TIME - 0.4, 0.0, None) / 0.1)
    resting = np.where(TIME >= 0.4, dying_down, 0.0)[:, None] * np.array([0.0, 0.0, 1.0])
    whole = Demonstration("resting", TIME, NOISE * 1e-5, force_N=resting + NOISE * 0.05)
    assert proposed_label(Evidence.of(whole), 0.4, 2.0, False) == ("idle", "", True)


def contact_label(before, after, **movement) -> str:
    """Of the first of two seconds, free at first, with a contact change at its end."""
    force = np.where(TIME[:, None] < 1.0, np.array(before, float), np.array(after, float))
    force[TIME < 0.3] = 0.0
    whole = Demonstration(
        "contact change",
        TIME,
        synthetic.minimum_jerk(TIME)[:, None] * np.array([0.0, 0.0, -0.1]),
        force_N=force + NOISE * 0.05,
    )
    return proposed_label(Evidence.of(whole), 0.0, 1.0, True).label


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [
        ((0, 0, 0), (0, 0, 6), "Move down until contact"),
        ((0, 0, 6), (0, 0, 0), "Push down until contact is lost"),
        ((0, 0, 12), (0, 0, 5), "Push down until release"),
        ((0, 0, 6), (0, 6, 6), "Push down until contact changes"),
    ],
)
def test_what_becomes_of_the_contact_is_said(before, after, expected):
    assert contact_label(before, after) == expected


def test_the_weight_of_the_tool_is_no_contact():
    assert (
        label((0.0, 0.054, 0.0), force=np.tile([0.0, 0.0, 14.0], (501, 1))) == "Move left | 54 mm"
    )


def test_going_round_in_a_circle_is_neither_idle_nor_straight():
    angle = 2 * np.pi * TIME / 2.0
    circle = 0.1 * np.column_stack([np.cos(angle), np.sin(angle), np.zeros_like(angle)])
    whole = Demonstration("circle", TIME, circle)
    words, measure, idle = proposed_label(Evidence.of(whole), 0.0, 2.0, False)
    assert words == "Move around"
    assert measure.startswith("62")
    assert not idle


def test_a_movement_inside_a_gap_of_the_data_is_not_idle():
    before, after = np.arange(0.0, 1.0, 0.01), np.arange(2.5, 3.5, 0.01)
    place = np.where(np.concatenate([before, after])[:, None] < 2.0, 0.0, 0.198) * [1.0, 0.0, 0.0]
    whole = Demonstration("gap", np.concatenate([before, after]), place)
    words, measure, idle = proposed_label(Evidence.of(whole), 0.5, 2.5, False)
    assert (words, measure, idle) == ("Move forward", "198 mm", False)


def test_a_movement_beside_a_long_gap_of_the_data_is_not_idle():
    """Of 0.4 s of movement in half a minute without data the speed says nothing."""
    time = np.concatenate([np.arange(0.0, 1.0, 0.01), np.arange(31.0, 33.0, 0.01)])
    place = np.interp(time, [0.5, 1.0, 31.0, 31.4], [0.0, 0.1, 0.1, 0.18])
    whole = Demonstration("gap", time, place[:, None] * [1.0, 0.0, 0.0])
    evidence = Evidence.of(whole)
    assert proposed_label(evidence, 0.5, 12.0, False)[::2] == ("Move forward", False)
    assert proposed_label(evidence, 20.0, 31.5, False)[::2] == ("Move forward", False)


@pytest.mark.parametrize("rows", [1, 3])
def test_rows_in_which_the_recorder_read_nothing_make_no_segment(rows: int) -> None:
    time = np.arange(0.0, 8.0, 0.02)
    position = np.zeros((len(time), 3))
    position[:, 0] = np.interp(time, [1.0, 3.0], [0.3, 0.5])
    whole = segment(Demonstration("whole", time, position))
    position[250 : 250 + rows] = 0.0
    dropped = segment(Demonstration("dropped", time, position))
    assert [one.label for one in dropped.segments] == [one.label for one in whole.segments]
    assert [one.label for one in whole.segments] == ["idle", "Move forward", "idle"]


def test_an_estimated_force_that_wanders_at_rest_is_no_contact() -> None:
    """It rests above half a newton, as stiction leaves it; the one contact is a press of 6 N."""
    time = np.arange(0.0, 40.0, 0.02)
    went = np.clip(time - 10.0, 0.0, 2.0) / 2.0
    place = np.c_[0.2 * synthetic.minimum_jerk(went), np.zeros((len(time), 2))]
    steps = np.random.default_rng(3).choice([-0.25, 0.25], (40, 3)).cumsum(axis=0)
    force = np.clip(steps, -0.7, 0.7)[time.astype(int)]
    force[(time > 20.0) & (time < 30.0), 2] += 6.0
    noise = np.random.default_rng(4).normal(0.0, 0.02, force.shape)
    whole = Demonstration("wanders", time, place, force_N=force + noise)
    evidence = Evidence.of(whole)
    assert said(proposed_label(evidence, 0.0, 10.0, False)) == "idle"
    assert said(proposed_label(evidence, 10.0, 12.0, False)) == "Move forward | 200 mm"
    assert said(proposed_label(evidence, 12.0, 20.0, True)) == "idle until contact"
