"""Which candidates the lines let in."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.choice import distance_to, spaced_scores
from keyphase.segmentation.evidence.contact_terms import breadth
from keyphase.segmentation.evidence.probability import (
    CONTACT_COLUMNS,
    MOTION_COLUMNS,
    calibrated,
    doubt,
    log_odds,
)
from keyphase.segmentation.evidence.stage import Evidence
from keyphase.segmentation.evidence.weights import Calibration, Weights
from keyphase.segmentation.parameters import Parameters

CLEAR_DEPTH = float(np.log(10.0))
"""Beside a force, a turn without a rest is clear if the speed falls to a tenth of the slower
stroke's."""

STANDS = float(np.log(1.5))
"""Edges of a stop of half a second within a millimetre and a degree are given with 0.6 at least,
however short the stroke to the next stop is."""

Reasons = NDArray[np.int8]
GIVEN, BELOW, CLOSE, SMALL, TURN, CONTACT = range(6)
"""Why a candidate is or is not given: below its line, too close to a likelier one, a force step
that is too small, a turn that does not count, motion that a contact change beside it explains."""


@dataclass(frozen=True, eq=False)
class Scores:
    """Log-odds of all candidates after the choice, whatever the lines; -inf for those too close.

    `doubt` is what contact changes lost because none of them is clear, see `probability`.
    """

    contact: Array
    motion: Array
    small: NDArray[np.bool_]
    doubt: float = 0.0


@dataclass(frozen=True, eq=False)
class Selection:
    """What becomes of each candidate: codes (C,) and (M,), and the lines in force.

    `turns_apart` is how many turns that do not count would be boundaries if they did.
    """

    contact: Reasons
    motion: Reasons
    contact_line: float
    motion_line: float
    turns_apart: int = 0

    @cached_property
    def contacts(self) -> Indices:
        """Contact candidates that are given."""
        return np.flatnonzero(self.contact == GIVEN)

    @cached_property
    def motions(self) -> Indices:
        """Motion candidates that are given as boundaries of their own."""
        return np.flatnonzero(self.motion == GIVEN)


def scores_of(evidence: Evidence, weights: Weights, parameters: Parameters) -> Scores:
    """Scores under the minimal distance and the least force step."""
    step = np.linalg.norm(evidence.force_step_N, axis=1)
    least = parameters.least_step_N
    small = step < (evidence.least_step_N if least is None else least)
    touch = np.where(small, -np.inf, evidence.contact_odds)
    distance = parameters.min_distance_s
    broad = breadth(evidence.contact.terms)
    contact = spaced_scores(evidence.contact_s, touch, distance, evidence.seen_s, broad)
    motion = spaced_scores(evidence.motion_s, evidence.motion_odds, distance)
    blurred = evidence.contact.terms[:, CONTACT_COLUMNS["blurred"]].max(initial=0.0)
    doubted = doubt(contact[np.isfinite(contact)], weights.contact_calibration, float(blurred))
    return Scores(
        _calibrated(contact, weights.contact_calibration, evidence.unlike, doubted),
        # Motion knows nothing of kinds of force.
        _stands(evidence, _calibrated(motion, weights.motion_calibration, 0.0, 0.0)),
        small,
        doubted,
    )


def _stands(evidence: Evidence, motion: Array) -> Array:
    stands = evidence.motion.terms[:, MOTION_COLUMNS["stands"]] > 0.0
    return np.where(stands & np.isfinite(motion), np.maximum(motion, STANDS), motion)


def _calibrated(scores: Array, calibration: Calibration, unlike: float, doubted: float) -> Array:
    with_none = np.where(np.isfinite(scores), scores, 0.0)
    odds = calibrated(with_none, calibration, unlike, doubted)
    return np.where(np.isfinite(scores), odds, -np.inf)


def select(
    evidence: Evidence, scores: Scores, weights: Weights, parameters: Parameters
) -> Selection:
    """Compare every score with its line; nothing is computed anew."""
    contact_line = _line(parameters.force_threshold, weights.contact_calibration.line)
    motion_line = _line(parameters.motion_threshold, weights.motion_calibration.line)
    contact = np.where(scores.contact >= log_odds(contact_line), GIVEN, BELOW).astype(np.int8)
    contact[np.isneginf(scores.contact)] = CLOSE
    contact[scores.small] = SMALL
    motion = np.where(scores.motion >= log_odds(motion_line), GIVEN, BELOW).astype(np.int8)
    motion[np.isneginf(scores.motion)] = CLOSE
    motion[(motion == GIVEN) & uncounted_turns(evidence, parameters)] = TURN
    touching = evidence.contact_s[contact == GIVEN]
    apart = distance_to(evidence.motion_s, touching) >= contact_reach_s(parameters)
    motion[(motion == GIVEN) & ~apart] = CONTACT
    turns = int(np.count_nonzero((motion == TURN) & apart))
    return Selection(contact, motion, contact_line, motion_line, turns)


def uncounted_turns(evidence: Evidence, parameters: Parameters) -> NDArray[np.bool_]:
    """Candidates of motion (M,) that are turns which do not count, whatever their score."""
    if evidence.grid.wrench is None or parameters.turns == "all":
        return np.zeros(len(evidence.motion_s), dtype=bool)
    depth = evidence.motion.terms[:, MOTION_COLUMNS["depth"]]
    clear = (depth >= CLEAR_DEPTH) & (parameters.turns == "clear")
    return ~evidence.motion.rest & ~clear


def contact_reach_s(parameters: Parameters) -> float:
    """A change of motion nearer than this to a contact change is part of it."""
    return max(parameters.merge_tolerance_s, min(parameters.min_distance_s, 0.1))


def _line(given: float | None, automatic: float) -> float:
    return automatic if given is None else min(given, 1.0)
