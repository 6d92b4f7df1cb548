"""Friction that turns with the motion, and contact that changes as the motion does."""

import numpy as np
import pytest

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.evidence.contact_terms import CONTACT_TERMS, contact_candidates
from keyphase.segmentation.evidence.grid import grid_of
from keyphase.segmentation.evidence.speed import speed_of
from keyphase.segmentation.motion import motion_of

TIME_S = np.arange(0.0, 20.0, 0.02)
TURNS_S = np.array([5.0, 7.0, 9.0, 11.0, 13.0])
TO_AND_FRO = np.sin(np.pi * (TIME_S - 3.0)) * ((TIME_S > 4.0) & (TIME_S < 14.0))
"""Velocity, over 0.1 m/s."""
STOPS_S = np.array([5.9, 7.9, 9.9, 11.9])
ON_AND_ON = np.clip(2.0 * np.sin(np.pi * TIME_S), 0.0, 1.0) * (TIME_S % 2.0 < 1.0)
"""For a second it goes, and for one it stands."""


def explained(
    term: str, velocity: Array, drag_N: Array, pressed_s: tuple[float, float] = (3.0, 17.0)
) -> tuple[Array, Array]:
    """When the candidates are, and this term of each, where the tool moves along a line, is pressed
    with 8 N for a while, and a drag (n,) acts along its line."""
    force = np.random.default_rng(0).normal(0.0, 0.05, (len(TIME_S), 3))
    force[:, 0] += drag_N
    force[:, 2] += 8.0 * ((pressed_s[0] < TIME_S) & (pressed_s[1] > TIME_S))
    way = np.cumsum(0.1 * velocity) * 0.02
    position = np.column_stack([way, 0.0 * TIME_S, 0.0 * TIME_S])
    recorded = Demonstration("wipe", TIME_S, position, force_N=force)
    grid = grid_of(recorded, motion_of(recorded))
    found = contact_candidates(grid, speed_of(grid))
    return grid.time_s[found.seen], found.terms[:, list(CONTACT_TERMS).index(term)]


def at_the(time_s: float, at: Array, share: Array) -> float:
    near = np.abs(at - time_s) < 0.15
    assert near.any()
    return float(share[near].max())


TERMS = pytest.mark.parametrize("term", ["taken_back", "with_the_way"])


@TERMS
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_friction_that_turns_round_is_told_with_either_sign(term: str, sign: float) -> None:
    at, share = explained(term, TO_AND_FRO, 3.0 * sign * np.sign(TO_AND_FRO))
    assert min(at_the(turn, at, share) for turn in TURNS_S) > 0.5


def test_friction_that_goes_as_the_tool_stops_is_told() -> None:
    at, share = explained("with_the_way", ON_AND_ON, 3.0 * np.sign(ON_AND_ON))
    assert min(at_the(stop, at, share) for stop in STOPS_S) > 0.5


def test_friction_of_joints_in_an_estimate_is_told_where_nothing_is_touched() -> None:
    drag = 0.8 * np.sign(ON_AND_ON)
    at, share = explained("with_the_way", ON_AND_ON, drag, pressed_s=(14.0, 17.0))
    assert min(at_the(stop, at, share) for stop in STOPS_S) > 0.5


@TERMS
def test_contact_made_and_lost_is_no_friction(term: str) -> None:
    at, share = explained(term, TO_AND_FRO, 3.0 * np.sign(TO_AND_FRO))
    assert max(at_the(3.0, at, share), at_the(17.0, at, share)) == 0.0


@TERMS
@pytest.mark.parametrize(("velocity", "time_s"), [(TO_AND_FRO, 9.0), (ON_AND_ON, 9.9)])
def test_a_contact_that_changes_once_as_the_motion_does_is_no_friction(
    term: str, velocity: Array, time_s: float
) -> None:
    at, share = explained(term, velocity, np.where(time_s < TIME_S, 3.0, 0.0))
    assert at_the(time_s, at, share) < 0.1
