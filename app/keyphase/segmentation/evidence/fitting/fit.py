"""The fit of all weights: two lines for contact, one for motion, calibrated on families left out.

The line of steps is fitted first, without the slow events, and held; then the line of states
beside it. Every family counts the same, and every recording no more than its share of it.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.evidence.choice import spaced_scores
from keyphase.segmentation.evidence.contact_terms import breadth
from keyphase.segmentation.evidence.fitting.logistic import (
    CALIBRATED_AT,
    fitted_calibration,
    fitted_line,
)
from keyphase.segmentation.evidence.fitting.taught import Side, Taught, labels, right
from keyphase.segmentation.evidence.probability import (
    CONTACT_COLUMNS,
    MOTION_COLUMNS,
    Signature,
    contact_odds,
    distance_from,
    motion_odds,
    sigmoid,
    signature,
)
from keyphase.segmentation.evidence.weights import Calibration, Kinds, Line, Weights

STEP_SIGNS: Mapping[str, int] = {
    "over_quiet_side": 1,
    "over_busy_side": 1,
    "slow_over_quiet": 1,
    "stays": 1,
    "stays_long": 1,
    "stays_slow": 1,
    "echo": -1,
    "newton": 1,
    "strength": 1,
    "sharpness": 1,
    "dominance": 1,
    "vibration": 1,
    "stopping": 1,
    "near_rest": -1,
    "standing": -1,
    "over_core": 1,
    "over_wander": 1,
    "with_the_way": -1,
    "taken_back": -1,
    "inside_free": -1,
}
STATE_SIGNS: Mapping[str, int] = {
    "crossing": 1,
    "state": 1,
    "over_core": 1,
    "separation": 1,
    "contact_newton": 1,
    "strength": 1,
    "lasts": 1,
}
HELD: Mapping[str, float] = {"blurred": -3.0}
"""Weights in the line of states that are set beside those that are fitted: made recordings hold too
few wrenches that wander slowly and widely to show what believing them costs."""
MOTION_SIGNS: Mapping[str, int] = {
    "depth": 1,
    "dwell": 1,
    "crowded": -1,
    "turn": 1,
    "stroke_length": 1,
    "stroke_speed": 1,
    "small_stroke": 1,
    "rounds": -1,
    "bare_turn": 1,
    "kinds": 1,
    "stands": 1,
}
KIND_TERMS = (
    "stays_long",
    "over_busy_side",
    "echo",
    "newton",
    "sharpness",
    "stays_slow",
    "over_core",
    "separation",
    "near_rest",
    "vibration",
    "over_wander",
)

FAMILY_SHARE = 60.0
"""What the candidates of one family weigh together, beside the regularisation."""

FOLDS = 5
"""So many groups of families are left out in turn for the calibration."""

ROUNDS = 3
MIN_DISTANCE_S = 0.25
_MIN_CALIBRATED = -4.0
_CONTACT_AS_GOOD = 0.01
"""A line as low as costs this much F1: a contact change too many is seen and taken away, one that
is missing is not."""
_MOTION_AS_GOOD = 0.002
"""Where motion ends and begins anybody sees; here the best line counts: of those that are as good
the middle one, which a few other recordings would move least."""
_UNCALIBRATED = Calibration((-1.0, 1.0), (-1.0, 1.0), 0.5)
_NO_KINDS = Kinds((), (), np.zeros((1, 0)), np.zeros(0), 1.0)


def fit(recordings: Sequence[Taught], say: Callable[[str], None] = lambda _: None) -> Weights:
    """All weights from recordings of several families."""
    weights = fitted_lines(recordings)
    say("lines fitted")
    outside = scores_left_out(recordings, say)
    contact = _calibration(
        [(t.family, t.contact, s) for t, (s, _) in outside],
        lambda lines, worth: lowest_line(lines, with_neighbours(worth), _CONTACT_AS_GOOD),
    )
    motion = _calibration(
        [(t.family, t.motion, s) for t, (_, s) in outside],
        lambda lines, worth: middle_line(lines[worth >= worth.max() - _MOTION_AS_GOOD]),
    )
    return replace(
        weights,
        state=weights.state.holding(HELD),
        contact_calibration=contact,
        motion_calibration=motion,
        kinds=_kinds(recordings, weights),
    )


def fitted_lines(recordings: Sequence[Taught]) -> Weights:
    """The lines, not calibrated: labels from the likeliest candidates, in rounds."""
    touches, moves = [t.contact for t in recordings], [t.motion for t in recordings]
    families = [t.family for t in recordings]
    touch_odds = [_first_contact_odds(side.terms) for side in touches]
    move_odds = [side.terms[:, MOTION_COLUMNS["depth"]] - 1.0 for side in moves]
    weights = None
    for _ in range(ROUNDS):
        table = _Table(families, touches, touch_odds)
        step = table.line(CONTACT_COLUMNS, STEP_SIGNS, slow=False)
        beside = step.log_odds(table.terms, CONTACT_COLUMNS)
        state = table.line(CONTACT_COLUMNS, STATE_SIGNS, slow=True, beside=beside)
        moving = _Table(families, moves, move_odds)
        motion = moving.line(MOTION_COLUMNS, MOTION_SIGNS, slow=True)
        weights = Weights(step, state, motion, _UNCALIBRATED, _UNCALIBRATED, _NO_KINDS)
        touch_odds = [contact_odds(side.terms, weights) for side in touches]
        move_odds = [motion_odds(side.terms, weights) for side in moves]
    assert weights is not None
    return weights


def _first_contact_odds(terms: Array) -> Array:
    over, newton = CONTACT_COLUMNS["over_quiet_side"], CONTACT_COLUMNS["newton"]
    return terms[:, over] + 0.5 * terms[:, newton] - 1.0


class _Table:
    """All candidates of one kind whose labels are known, in one table."""

    def __init__(
        self, families: Sequence[str], sides: Sequence[Side], odds: Sequence[Array]
    ) -> None:
        found = [labels(side, z) for side, z in zip(sides, odds, strict=True)]
        self.terms = np.vstack([side.terms for side in sides])
        self.labels = np.concatenate(found)
        family = np.repeat(families, [len(each) for each in found])
        self.share = np.zeros(len(self.labels))
        for name in sorted(set(families)):
            known = (family == name) & (self.labels >= 0)
            self.share[known] = min(1.0, FAMILY_SHARE / max(known.sum(), 1))

    def line(
        self,
        columns: Mapping[str, int],
        signs: Mapping[str, int],
        *,
        slow: bool,
        beside: Array | None = None,
    ) -> Line:
        use = (self.labels >= 0) & (slow | (self.labels != 2))
        right_ = (self.labels[use] > 0).astype(float)
        held = None if beside is None else beside[use]
        return fitted_line(self.terms[use], columns, signs, right_, self.share[use], held)


def chosen_scores(recording: Taught, weights: Weights) -> tuple[Array, Array]:
    """Scores of the candidates for contact and for motion, after the choice, not calibrated."""
    touches, moves = recording.contact, recording.motion
    return (
        spaced_scores(
            touches.time_s,
            contact_odds(touches.terms, weights),
            MIN_DISTANCE_S,
            touches.seen_s,
            breadth(touches.terms),
        ),
        spaced_scores(moves.time_s, motion_odds(moves.terms, weights), MIN_DISTANCE_S),
    )


def scores_left_out(
    recordings: Sequence[Taught], say: Callable[[str], None] = lambda _: None
) -> list[tuple[Taught, tuple[Array, Array]]]:
    """Every recording with scores from lines that have not seen its family, nor a few others."""
    found = []
    names = sorted({t.family for t in recordings})
    for first in range(min(FOLDS, len(names))):
        out = set(names[first::FOLDS])
        weights = fitted_lines([t for t in recordings if t.family not in out])
        found += [(t, chosen_scores(t, weights)) for t in recordings if t.family in out]
        say(f"left out {', '.join(sorted(out))}")
    return found


def with_neighbours(worth: Array) -> Array:
    """What each line is worth (L,) together with those beside it: a single one that happens to be
    best, or worst, by a few recordings decides nothing."""
    padded = np.pad(worth, 1, mode="edge")
    return (padded[:-2] + padded[1:-1] + padded[2:]) / 3.0


def lowest_line(lines: Array, worth: Array, as_good: float) -> float:
    """The lowest of lines in their order that costs at most `as_good` of what the best is worth."""
    return float(lines[worth >= worth.max() - as_good][0])


def middle_line(lines: Array) -> float:
    """The middle one of lines in their order, the lower one of two."""
    return float(lines[(len(lines) - 1) // 2])


def _calibration(
    scored: Sequence[tuple[str, Side, Array]], chosen: Callable[[Array, Array], float]
) -> Calibration:
    """What scores are worth, and the automatic line, `chosen` by the mean F1 over the families."""
    families = np.concatenate([np.repeat(f, len(s)) for f, _, s in scored])
    scores = np.concatenate([s for _, _, s in scored])
    hits = np.concatenate([right(side, s) for _, side, s in scored])
    events = {f: sum(len(side.event_s) for g, side, _ in scored if g == f) for f in set(families)}
    known = (hits >= 0) & (scores >= _MIN_CALIBRATED)
    families, scores, hits = families[known], scores[known], hits[known].astype(float)
    share = np.zeros(len(scores))
    for family in sorted(set(families)):
        share[families == family] = FAMILY_SHARE / (families == family).sum()
    calibration = Calibration(CALIBRATED_AT, fitted_calibration(scores, hits, share), 0.5)
    probability = sigmoid(calibration.log_odds(scores))
    lines = np.round(np.arange(0.1, 0.9, 0.02), 2)
    worth = [_mean_f1(probability >= line, families, hits, events) for line in lines]
    return replace(calibration, line=chosen(lines, np.array(worth)))


def _mean_f1(given: Array, families: Array, hits: Array, events: Mapping[str, int]) -> float:
    """Mean over the families with events of 2 hits / (events + given)."""
    values = []
    for family in sorted(events):
        if events[family]:
            mine = given & (families == family)
            values.append(2.0 * hits[mine].sum() / (events[family] + mine.sum()))
    return float(np.mean(values))


def _kinds(recordings: Sequence[Taught], weights: Weights) -> Kinds:
    """Where each family lies in the terms of its likeliest candidates, and how far is usual."""
    seen: dict[str, list[Signature]] = {}
    for recording in recordings:
        terms = recording.contact.terms
        here = signature(terms, contact_odds(terms, weights), KIND_TERMS)
        if here is not None:
            seen.setdefault(recording.family, []).append(here)
    centre = np.array([_mean_known(seen[family]) for family in sorted(seen)])
    inside = [
        here.mean - middle
        for family, middle in zip(sorted(seen), centre, strict=True)
        for here in seen[family]
    ]
    spread = np.nanstd(inside, axis=0) + 0.05
    distances = [distance_from(here, centre, spread) for f in sorted(seen) for here in seen[f]]
    return Kinds(
        tuple(sorted(seen)), KIND_TERMS, centre, spread, float(np.quantile(distances, 0.9))
    )


def _mean_known(signatures: Sequence[Signature]) -> Array:
    """Mean (T,) of signatures; 0 for a term that is known of none."""
    known = np.ma.masked_invalid(np.array([each.mean for each in signatures]))
    return np.asarray(known.mean(axis=0).filled(0.0))
