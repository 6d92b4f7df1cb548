"""How many boundaries come of each place of a line, and what else holds candidates back."""

from collections.abc import Callable
from dataclasses import replace
from typing import Literal

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.evidence.probability import log_odds, sigmoid
from keyphase.segmentation.evidence.selection import (
    GIVEN,
    Scores,
    Selection,
    contact_reach_s,
    select,
    uncounted_turns,
)
from keyphase.segmentation.evidence.stage import Evidence
from keyphase.segmentation.evidence.weights import Weights
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.recent import Recent
from keyphase.segmentation.segmentation import HeldBack, LineCounts

LOWEST, HIGHEST = 0.00015, 0.99985
"""The ends of the way of a line: clear contacts lie above 0.99, and a faint one below 0.01.
Candidates that no line reaches are not told."""

MAX_STEPS = 400
"""With more steps than this only some of them are told, so that a long recording costs little."""


class Counts:
    """Numbers of boundaries over both lines, of one recording's candidates and scores.

    A candidate of motion is no boundary of its own where a contact change is taken beside it: it
    comes as the force line rises above the likeliest of those.
    """

    def __init__(self, evidence: Evidence, scores: Scores, parameters: Parameters) -> None:
        self._inside = _inside(evidence, evidence.contact_s)
        counted = _inside(evidence, evidence.motion_s) & ~uncounted_turns(evidence, parameters)
        self._contact, motion = scores.contact[self._inside], scores.motion[counted]
        contact_s, motion_s = evidence.contact_s[self._inside], evidence.motion_s[counted]
        reach = contact_reach_s(parameters)
        beside = _likeliest_beside(motion_s, contact_s, self._contact, reach)
        order = np.argsort(motion, kind="stable")
        self._motion, self._beside = motion[order], beside[order]
        self._of_force: Recent[tuple[LineCounts, ...]] = Recent(2)

    def over_lines(self, selection: Selection) -> tuple[LineCounts, ...]:
        """The number of boundaries over each line, while the other stays where it is."""
        free = self._motion[self._beside < log_odds(selection.contact_line)]
        given = int(np.count_nonzero(selection.contact[self._inside] == GIVEN))
        line = selection.motion_line
        force = self._of_force.get(line, lambda: self._over_force_line(line))
        return (*force, _counts("motion_threshold", given, free))

    def _over_force_line(self, motion_line: float) -> tuple[LineCounts, ...]:
        if not len(self._contact):
            return ()
        above = self._beside[self._motion >= log_odds(motion_line)]
        alone = int(np.isneginf(above).sum())
        coming = above[np.isfinite(above)]
        return (_counts("force_threshold", alone, self._contact, coming),)


def held_back(
    evidence: Evidence,
    scores: Scores,
    scored: Callable[[Parameters], Scores],
    weights: Weights,
    parameters: Parameters,
    selection: Selection,
) -> tuple[HeldBack, ...]:
    """How many boundaries more there would be, were a filter let go.

    `scored` gives scores under another least step.
    """
    found = []
    if parameters.least_step_N != 0.0 and scores.small.any():
        freed = replace(parameters, least_step_N=0.0)
        more = select(evidence, scored(freed), weights, freed)
        now = len(selection.contacts) + len(selection.motions)
        count = len(more.contacts) + len(more.motions) - now
        found.append(HeldBack("least_step_N", count, 0.0))
    if parameters.turns != "all":
        found.append(HeldBack("turns", selection.turns_apart, "all"))
    return tuple(each for each in found if each.count > 0)


def _inside(evidence: Evidence, time_s: Array) -> np.ndarray:
    times = evidence.grid.time_s
    return (time_s > times[0]) & (time_s < times[-1])


def _likeliest_beside(motion_s: Array, contact_s: Array, contact: Array, reach_s: float) -> Array:
    """Log-odds (M,) of the likeliest contact change nearer than `reach_s`; -inf without any."""
    first = np.searchsorted(contact_s, motion_s - reach_s, side="right")
    last = np.searchsorted(contact_s, motion_s + reach_s, side="left")
    best = np.full(len(motion_s), -np.inf)
    some = last > first
    if some.any():
        # Every other stretch of reduceat is one that was asked for.
        edges = np.stack([first[some], last[some]], axis=1).ravel()
        best[some] = np.maximum.reduceat(np.append(contact, -np.inf), edges)[::2]
    return best


def _counts(
    parameter: Literal["force_threshold", "motion_threshold"],
    always: int,
    going: Array,
    coming: Array | None = None,
) -> LineCounts:
    """A line that rises above a score loses those `going` and gains those `coming`."""
    coming = np.empty(0) if coming is None else coming
    going = going[np.isfinite(going)]
    at = np.concatenate([going, coming])
    change = np.concatenate([np.full(len(going), -1), np.full(len(coming), 1)])
    steps, which = np.unique(at, return_inverse=True)
    changes = np.bincount(which, weights=change, minlength=len(steps)).astype(int)
    counts = always + len(going) + np.concatenate([[0], np.cumsum(changes)])
    inside = (steps >= log_odds(LOWEST)) & (steps <= log_odds(HIGHEST)) & (changes != 0)
    kept = np.flatnonzero(inside)
    if len(kept) > MAX_STEPS:
        kept = kept[np.linspace(0, len(kept) - 1, MAX_STEPS).round().astype(int)]
    # Before the first step that is told the count is that just below it.
    before = counts[kept[0]] if len(kept) else counts[np.searchsorted(steps, log_odds(LOWEST))]
    told = (int(before), *counts[kept + 1].tolist())
    return LineCounts(parameter, tuple(sigmoid(steps[kept]).tolist()), told)
