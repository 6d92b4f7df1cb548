"""All that is known of a demonstration before any line is drawn; computed once and kept."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.evidence.contact_terms import ContactCandidates, contact_candidates
from keyphase.segmentation.evidence.grid import Grid, grid_of
from keyphase.segmentation.evidence.motion_terms import MotionCandidates, motion_candidates
from keyphase.segmentation.evidence.probability import contact_odds, motion_odds, unlike
from keyphase.segmentation.evidence.speed import speed_of
from keyphase.segmentation.evidence.tool import without_tool
from keyphase.segmentation.evidence.weights import Weights
from keyphase.segmentation.motion import Motion


@dataclass(frozen=True, eq=False)
class Evidence:
    """Candidates of both kinds with their log-odds before calibration and before the choice.

    contact_s (C,), motion_s (M,)       their times, ascending
    seen_s (C,)                         where contact changes were seen, see `ContactCandidates`
    contact_odds (C,), motion_odds (M,)
    force_step_N (C, 3)                 mean force after minus before each contact candidate
    least_step_N                        smaller steps are what the force does of itself
    unlike                              distance from all that was fitted on, see `probability`
    """

    grid: Grid
    contact: ContactCandidates
    motion: MotionCandidates
    contact_s: Array
    seen_s: Array
    motion_s: Array
    contact_odds: Array
    motion_odds: Array
    force_step_N: Array
    least_step_N: float
    unlike: float


def evidence_of(demonstration: Demonstration, motion: Motion, weights: Weights) -> Evidence:
    """Look at every place where a boundary could be."""
    grid = grid_of(demonstration, motion)
    speed = speed_of(grid)
    grid = without_tool(grid, speed)
    contact, moves = contact_candidates(grid, speed), motion_candidates(grid, speed)
    contact = _in_order(contact)
    cells = np.arange(len(grid))
    touch_odds = contact_odds(contact.terms, weights)
    return Evidence(
        grid,
        contact,
        moves,
        grid.time_s[contact.cell],
        grid.time_s[contact.seen],
        np.interp(moves.cell, cells, grid.time_s),
        touch_odds,
        motion_odds(moves.terms, weights),
        contact.step * grid.size_N,
        contact.least_step * grid.size_N,
        unlike(contact.terms, touch_odds, weights.kinds),
    )


def _in_order(found: ContactCandidates) -> ContactCandidates:
    order = np.argsort(found.cell, kind="stable")
    return ContactCandidates(
        cell=found.cell[order],
        seen=found.seen[order],
        interval=found.interval[order],
        terms=found.terms[order],
        step=found.step[order],
        least_step=found.least_step,
    )
