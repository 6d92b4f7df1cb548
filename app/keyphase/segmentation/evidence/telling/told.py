"""Candidates told as values: boundaries with their reasons, and what would let the others in."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
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
from keyphase.segmentation.evidence.telling.counts import LOWEST
from keyphase.segmentation.evidence.weights import Line, Weights
from keyphase.segmentation.kept import Kept, Values
from keyphase.segmentation.segmentation import Boundary, Candidate, CandidateKind, Change, Reason

MAX_TOLD = 2000
"""No more candidates than this are told, the likeliest ones."""

CROWDED = "a likelier boundary close by"
UNLIKE = "unlike the recordings the weights were fitted on"
NONE_CLEAR = "no contact change of this recording is clear"


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
        self._reasons: dict[tuple[CandidateKind, int], tuple[Reason, ...]] = {}
        self._contacts = Kept(len(evidence.contact_s), 1, self._contact)
        self._motions = Kept(len(evidence.motion_s), 2, self._motion)
        self._told: list[tuple[CandidateKind, int]] = self._worth_telling()
        self._of_contact = np.array([kind == "contact" for kind, _ in self._told], dtype=bool)
        self._index = np.array([index for _, index in self._told], dtype=np.intp)
        self._candidates = Kept(len(self._told), 1, self._candidate)
        self._known: dict[tuple[int, int], Candidate] = {}

    def contacts(self, candidates: Indices, moved_s: Array) -> Values:
        """The boundaries at contact candidates (B,); `moved_s` (B,) is where motion alone would put
        each, infinite where the motion does not change."""
        return self._contacts.of(candidates, moved_s[:, None])

    def motions(self, candidates: Indices, intervals_s: Array) -> Values:
        """The boundaries at candidates of motion (B,), in the intervals (B, 2) of their
        Gaussians."""
        return self._motions.of(candidates, intervals_s)

    def _contact(self, candidate: int, moved: list[float]) -> Boundary:
        grid, at = self._evidence.grid, self._evidence.contact
        first, last = grid.time_s[at.interval[candidate]].tolist()
        time, moved_s = float(self._evidence.contact_s[candidate]), moved[0]
        alone = moved_s == np.inf
        return Boundary(
            time_s=time,
            origin="force" if alone else "both",
            interval_s=(first, last),
            confidence=self._probabilities["contact"][candidate],
            contact_change=True,
            position_s=None if alone else moved_s,
            reasons=self.reasons("contact", candidate),
            change=self._change_at(time),
        )

    def _motion(self, candidate: int, interval_s: list[float]) -> Boundary:
        time, (low, high) = float(self._evidence.motion_s[candidate]), interval_s
        return Boundary(
            time_s=time,
            origin="position",
            interval_s=(low, high),
            confidence=self._probabilities["motion"][candidate],
            contact_change=False,
            position_s=time,
            reasons=self.reasons("motion", candidate),
        )

    def candidates(self, selection: Selection) -> tuple[Candidate, ...]:
        """The likeliest candidates of both kinds in time order, given or not."""
        codes = np.empty(len(self._told))
        codes[self._of_contact] = selection.contact[self._index[self._of_contact]]
        codes[~self._of_contact] = selection.motion[self._index[~self._of_contact]]
        every = np.arange(len(codes))
        return tuple(self._candidates.of(every, codes[:, None]).tolist())

    def reasons(self, kind: CandidateKind, index: int) -> tuple[Reason, ...]:
        """The terms of a candidate's probability, the strongest first; of the likelier line."""
        key = kind, index
        if key not in self._reasons:
            self._reasons[key] = self._summed_up(kind, index)
        return self._reasons[key]

    def _candidate(self, place: int, codes: list[float]) -> Candidate:
        key = place, int(codes[0])
        if key not in self._known:
            self._known[key] = self._told_as(*key)
        return self._known[key]

    def _told_as(self, place: int, code: int) -> Candidate:
        kind, index = self._told[place]
        given = code in (GIVEN, CONTACT)
        probability = self._probabilities[kind][index]
        why = "" if given else _why_not(code, probability)
        step = tuple(self._evidence.force_step_N[index].tolist()) if kind == "contact" else None
        reasons = self.reasons(kind, index)
        times = self._evidence.contact_s if kind == "contact" else self._evidence.motion_s
        return Candidate(float(times[index]), kind, probability, given, why, reasons, step)

    @cached_property
    def _probabilities(self) -> dict[CandidateKind, list[float]]:
        """Of all candidates; of those too close to likelier ones as if nothing were beside them."""
        scores = self._scores
        sides: tuple[tuple[CandidateKind, Array, Array], ...] = (
            ("contact", scores.contact, self._contact_alone),
            ("motion", scores.motion, self._motion_alone),
        )
        return {
            kind: sigmoid(np.where(np.isneginf(own), alone, own)).tolist()
            for kind, own, alone in sides
        }

    def _alone(self, kind: CandidateKind, index: int) -> float:
        """Calibrated log-odds of a candidate as if nothing were beside it."""
        return float((self._contact_alone if kind == "contact" else self._motion_alone)[index])

    @cached_property
    def _contact_alone(self) -> Array:
        return self._weights.contact_calibration.log_odds(self._evidence.contact_odds)

    @cached_property
    def _motion_alone(self) -> Array:
        return self._weights.motion_calibration.log_odds(self._evidence.motion_odds)

    def _worth_telling(self) -> list[tuple[CandidateKind, int]]:
        """Kind and index of what is told, in time order."""
        scores = self._scores
        sides: tuple[tuple[CandidateKind, Array, Array], ...] = (
            ("contact", scores.contact, self._evidence.contact_s),
            ("motion", scores.motion, self._evidence.motion_s),
        )
        worth: list[tuple[float, float, CandidateKind, int]] = [
            (float(score), float(times[index]), kind, index)
            for kind, values, times in sides
            for index, score in enumerate(values.tolist())
            if score >= log_odds(LOWEST)
        ]
        worth.sort(key=lambda each: (-each[0], each[1]))
        told: list[tuple[float, CandidateKind, int]] = [
            (time, kind, index) for _, time, kind, index in worth[:MAX_TOLD]
        ]
        told.sort()
        return [(kind, index) for _, kind, index in told]

    def _summed_up(self, kind: CandidateKind, index: int) -> tuple[Reason, ...]:
        evidence = self._evidence
        if kind == "contact":
            by_state = self._state_odds[index] > self._step_odds[index]
            added = self._added["state" if by_state else "step"]
            row, columns = evidence.contact.terms[index], CONTACT_COLUMNS
        else:
            added, row, columns = (
                self._added["motion"],
                evidence.motion.terms[index],
                MOTION_COLUMNS,
            )
        values = row.tolist()
        reasons = [
            Reason(words, values[columns[name]], value)
            for (name, words), value in zip(added.terms, added.odds[index].tolist(), strict=True)
        ]
        score = (self._scores.contact if kind == "contact" else self._scores.motion)[index]
        lost = float(score) - self._alone(kind, index) if np.isfinite(score) else 0.0
        if kind == "contact" and np.isfinite(score) and self._scores.doubt > 0.05:
            reasons.append(Reason(NONE_CLEAR, self._scores.doubt, -self._scores.doubt))
            lost += self._scores.doubt
        if abs(lost) > 0.05:
            unlike = kind == "contact" and evidence.unlike > 0.0
            value = evidence.unlike if unlike else 0.0
            reasons.append(Reason(UNLIKE if unlike else CROWDED, value, lost))
        return tuple(sorted(reasons, key=lambda reason: -abs(reason.contribution)))

    @cached_property
    def _step_odds(self) -> Array:
        return self._weights.step.log_odds(self._evidence.contact.terms, CONTACT_COLUMNS)

    @cached_property
    def _state_odds(self) -> Array:
        return self._weights.state.log_odds(self._evidence.contact.terms, CONTACT_COLUMNS)

    @cached_property
    def _added(self) -> dict[str, "_Added"]:
        weights, evidence = self._weights, self._evidence
        contact = weights.contact_calibration.slope(evidence.contact_odds)
        motion = weights.motion_calibration.slope(evidence.motion_odds)
        touches, moves = evidence.contact.terms, evidence.motion.terms
        return {
            "step": _Added.of(weights.step, touches, CONTACT_COLUMNS, CONTACT_TERMS, contact),
            "state": _Added.of(weights.state, touches, CONTACT_COLUMNS, CONTACT_TERMS, contact),
            "motion": _Added.of(weights.motion, moves, MOTION_COLUMNS, MOTION_TERMS, motion),
        }


@dataclass(frozen=True, eq=False)
class _Added:
    """What each term of a line with weight adds to the calibrated log-odds (C, U).

    terms (U,): name of each and what it says
    """

    terms: list[tuple[str, str]]
    odds: Array

    @classmethod
    def of(
        cls,
        line: Line,
        table: Array,
        columns: Mapping[str, int],
        words: Mapping[str, str],
        slope: Array,
    ) -> "_Added":
        use = np.flatnonzero(line.weight)
        odds = slope[:, None] * line.contributions(table, columns)[:, use]
        return cls([(line.names[i], words[line.names[i]]) for i in use], odds)


def _why_not(code: int, probability: float) -> str:
    match code:
        case _ if code == BELOW:
            return f"A line at {probability:.{2 if probability >= 0.01 else 4}f} would let it in."
        case _ if code == CLOSE:
            return "A likelier boundary is too close; a smaller minimal distance would let it in."
        case _ if code == SMALL:
            return "Its force step is too small; a lower least force step would let it in."
        case _ if code == TURN:
            return "A turn without a rest beside a force; turns: all would let it in."
    return ""
