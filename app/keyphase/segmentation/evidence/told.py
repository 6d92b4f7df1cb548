"""Candidates told as values: boundaries with their reasons, and what would let the others in."""

from collections.abc import Callable

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.evidence.contact_terms import CONTACT_TERMS
from keyphase.segmentation.evidence.motion_terms import MOTION_TERMS
from keyphase.segmentation.evidence.probability import (
    CONTACT_COLUMNS,
    MOTION_COLUMNS,
    log_odds,
    sigmoid,
)
from keyphase.segmentation.evidence.selection import (
    BELOW,
    CLOSE,
    CONTACT,
    GIVEN,
    SMALL,
    TURN,
    Scores,
    Selection,
)
from keyphase.segmentation.evidence.stage import Evidence
from keyphase.segmentation.evidence.weights import Line, Weights
from keyphase.segmentation.segmentation import Boundary, Candidate, CandidateKind, Change, Reason

MOST_TOLD = 2000
"""No more candidates than this are told, the likeliest ones."""

LEAST_TOLD = 0.03
"""Candidates less likely than this are not told."""

CROWDED = "a likelier boundary close by"
UNLIKE = "unlike the recordings the weights were fitted on"


class Told:
    """Makes values of one recording's candidates when they are first asked for."""

    def __init__(
        self,
        evidence: Evidence,
        scores: Scores,
        weights: Weights,
        change_at: Callable[[float], Change],
    ) -> None:
        self._evidence = evidence
        self._scores = scores
        self._weights = weights
        self._change_at = change_at
        self._boundaries: dict[tuple[int, float | None], Boundary] = {}
        self._reasons: dict[tuple[CandidateKind, int], tuple[Reason, ...]] = {}
        self._known: dict[tuple[CandidateKind, int, str], Candidate] = {}
        self._told: list[tuple[float, CandidateKind, int]] = self._worth_telling()

    def contact(self, candidate: int, moved_s: float | None) -> Boundary:
        """The boundary at a contact candidate; `moved_s` where motion alone would put it."""
        key = candidate, moved_s
        if key not in self._boundaries:
            grid, at = self._evidence.grid, self._evidence.contact
            first, last = grid.time_s[at.interval[candidate]].tolist()
            time = float(self._evidence.contact_s[candidate])
            self._boundaries[key] = Boundary(
                time_s=time,
                origin="force" if moved_s is None else "both",
                interval_s=(first, last),
                confidence=float(sigmoid(self._scores.contact[candidate])),
                contact_change=True,
                position_s=moved_s,
                reasons=self.reasons("contact", candidate),
                change=self._change_at(time),
            )
        return self._boundaries[key]

    def motion(self, candidate: int, interval_s: tuple[float, float]) -> Boundary:
        """The boundary at a candidate of motion, in the interval its Gaussians leave it."""
        time = float(self._evidence.motion_s[candidate])
        return Boundary(
            time_s=time,
            origin="position",
            interval_s=interval_s,
            confidence=float(sigmoid(self._scores.motion[candidate])),
            contact_change=False,
            position_s=time,
            reasons=self.reasons("motion", candidate),
        )

    def candidates(self, selection: Selection) -> tuple[Candidate, ...]:
        """The likeliest candidates of both kinds in time order, given or not."""
        found = []
        for time, kind, index in self._told:
            codes = selection.contact if kind == "contact" else selection.motion
            line = selection.contact_line if kind == "contact" else selection.motion_line
            found.append(self._candidate(time, kind, index, int(codes[index]), line))
        return tuple(found)

    def reasons(self, kind: CandidateKind, index: int) -> tuple[Reason, ...]:
        """The terms of a candidate's probability, the strongest first; of the likelier line."""
        key = kind, index
        if key not in self._reasons:
            self._reasons[key] = self._summed_up(kind, index)
        return self._reasons[key]

    def _candidate(
        self, time_s: float, kind: CandidateKind, index: int, code: int, line: float
    ) -> Candidate:
        given = code in (GIVEN, CONTACT)
        probability = self._probability(kind, index)
        why = "" if given else _why_not(code, probability, line)
        key = kind, index, why
        if key not in self._known:
            step = tuple(self._evidence.force_step_N[index].tolist()) if kind == "contact" else None
            reasons = self.reasons(kind, index)
            self._known[key] = Candidate(time_s, kind, probability, given, why, reasons, step)
        return self._known[key]

    def _probability(self, kind: CandidateKind, index: int) -> float:
        contact = kind == "contact"
        score = (self._scores.contact if contact else self._scores.motion)[index]
        if np.isneginf(score):
            score = self._alone(kind, index)
        return float(sigmoid(score))

    def _alone(self, kind: CandidateKind, index: int) -> float:
        """Calibrated log-odds of a candidate as if nothing were beside it."""
        contact = kind == "contact"
        weights = self._weights
        calibration = weights.contact_calibration if contact else weights.motion_calibration
        odds = (self._evidence.contact_odds if contact else self._evidence.motion_odds)[index]
        return float(calibration.slope * odds + calibration.offset)

    def _worth_telling(self) -> list[tuple[float, CandidateKind, int]]:
        scores = self._scores
        sides: tuple[tuple[CandidateKind, Array, Array], ...] = (
            ("contact", scores.contact, self._evidence.contact_s),
            ("motion", scores.motion, self._evidence.motion_s),
        )
        worth = [
            (float(score), float(times[index]), kind, index)
            for kind, values, times in sides
            for index, score in enumerate(values.tolist())
            if score >= log_odds(LEAST_TOLD)
        ]
        worth.sort(key=lambda each: (-each[0], each[1]))
        return sorted((time, kind, index) for _, time, kind, index in worth[:MOST_TOLD])

    def _summed_up(self, kind: CandidateKind, index: int) -> tuple[Reason, ...]:
        weights, evidence = self._weights, self._evidence
        if kind == "contact":
            row, names, columns = evidence.contact.terms[index], CONTACT_TERMS, CONTACT_COLUMNS
            lines = (weights.step, weights.state)
            line = max(lines, key=lambda each: float(each.log_odds(row[None], columns)[0]))
            slope = weights.contact_calibration.slope
        else:
            row, names, columns = evidence.motion.terms[index], MOTION_TERMS, MOTION_COLUMNS
            line, slope = weights.motion, weights.motion_calibration.slope
        reasons = [
            Reason(names[name], float(row[columns[name]]), value)
            for name, value in _added(line, row, columns, slope)
        ]
        score = (self._scores.contact if kind == "contact" else self._scores.motion)[index]
        lost = float(score) - self._alone(kind, index) if np.isfinite(score) else 0.0
        if abs(lost) > 0.05:
            unlike = kind == "contact" and evidence.unlike > 0.0
            value = evidence.unlike if unlike else 0.0
            reasons.append(Reason(UNLIKE if unlike else CROWDED, value, lost))
        return tuple(sorted(reasons, key=lambda reason: -abs(reason.contribution)))


def _added(
    line: Line, row: Array, columns: dict[str, int], slope: float
) -> list[tuple[str, float]]:
    """What each term adds to the calibrated log-odds; terms without weight left out."""
    added = slope * line.contributions(row[None], columns)[0]
    pairs = zip(line.names, added.tolist(), line.weight.tolist(), strict=True)
    return [(name, value) for name, value, weight in pairs if weight != 0.0]


def _why_not(code: int, probability: float, line: float) -> str:
    match code:
        case _ if code == BELOW:
            return f"A line at {max(probability, 0.01):.2f} would let it in (now {line:.2f})."
        case _ if code == CLOSE:
            return "A likelier boundary is too close; a smaller minimal distance would let it in."
        case _ if code == SMALL:
            return "Its force step is too small; a lower least force step would let it in."
        case _ if code == TURN:
            return "A turn without a rest beside a force; turns: all would let it in."
    return ""
