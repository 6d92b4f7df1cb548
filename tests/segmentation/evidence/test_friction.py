"""Friction that turns round with the motion, and contact that changes at a turn."""

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.evidence.contact_terms import CONTACT_TERMS, contact_candidates
from keyphase.segmentation.evidence.grid import grid_of
from keyphase.segmentation.evidence.speed import speed_of
from keyphase.segmentation.motion import motion_of

TIME_S = np.arange(0.0, 20.0, 0.02)
TURNS_S = np.array([5.0, 7.0, 9.0, 11.0, 13.0])


def taken_back(drag_N: Array) -> tuple[Array, Array]:
    """When the candidates are, and how much of each is friction, of a wipe to and fro pressed with
    8 N from 3 to 17 s under a drag (n,) along its line."""
    moving = (TIME_S > 4.0) & (TIME_S < 14.0)
    velocity = np.where(moving, 0.1 * np.sin(np.pi * (TIME_S - 3.0)), 0.0)
    across = np.cumsum(velocity) * 0.02
    pressed = (TIME_S > 3.0) & (TIME_S < 17.0)
    force = np.random.default_rng(0).normal(0.0, 0.05, (len(TIME_S), 3))
    force[:, 0] += drag_N * pressed
    force[:, 2] += 8.0 * pressed
    position = np.column_stack([across, 0.0 * TIME_S, 0.0 * TIME_S])
    recorded = Demonstration("wipe", TIME_S, position, force_N=force)
    grid = grid_of(recorded, motion_of(recorded))
    found = contact_candidates(grid, speed_of(grid))
    return grid.time_s[found.seen], found.terms[:, list(CONTACT_TERMS).index("taken_back")]


def at_the(turn_s: float, at: Array, friction: Array) -> float:
    return float(friction[np.abs(at - turn_s) < 0.15].max(initial=0.0))


def test_a_step_that_the_next_turn_takes_back_is_friction_with_either_sign():
    direction = np.sign(np.sin(np.pi * (TIME_S - 3.0))) * ((TIME_S > 4.0) & (TIME_S < 14.0))
    for sign in (1.0, -1.0):
        at, friction = taken_back(np.asarray(3.0 * sign * direction))
        assert min(at_the(turn, at, friction) for turn in TURNS_S) > 0.5


def test_contact_made_and_lost_is_no_friction():
    direction = np.sign(np.sin(np.pi * (TIME_S - 3.0))) * ((TIME_S > 4.0) & (TIME_S < 14.0))
    at, friction = taken_back(3.0 * direction)
    assert max(at_the(3.0, at, friction), at_the(17.0, at, friction)) == 0.0


def test_a_contact_that_changes_at_a_turn_and_stays_changed_is_no_friction():
    at, friction = taken_back(np.where(TIME_S > 9.0, 3.0, 0.0))
    assert len(at[np.abs(at - 9.0) < 0.15])
    assert at_the(9.0, at, friction) == 0.0
