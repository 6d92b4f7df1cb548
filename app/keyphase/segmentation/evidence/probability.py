"""From evidence to one calibrated probability for every candidate."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.evidence.contact_terms import CONTACT_TERMS
from keyphase.segmentation.evidence.motion_terms import MOTION_TERMS
from keyphase.segmentation.evidence.weights import Calibration, Kinds, Weights

CONTACT_COLUMNS = {name: column for column, name in enumerate(CONTACT_TERMS)}
MOTION_COLUMNS = {name: column for column, name in enumerate(MOTION_TERMS)}

MAX_ODDS = 9.0
"""No probability is surer than this many nats: what was fitted on says no more."""

FAR = 0.2
"""A recording further than this from all that was fitted on is called unlike it."""

CLEAR, _DOUBTED = 0.8, 0.5
"""Who touches something does so clearly once: where no contact change is as likely as CLEAR, all
of them lose half of the nats by which the likeliest one falls short."""

_BLURRED = 0.1
"""So much less clear of free space than contact ought to stand, in nats, for all of that doubt: a
contact that is weak but stands clear is none of a wrench's own wander."""

_LIKELIEST = 12
_OF_FREE_SPACE = ("over_core", "separation")
_FADES = 2.0


def sigmoid(z: Array | float) -> Array:
    """Probability of log-odds."""
    return 1.0 / (1.0 + np.exp(-np.clip(z, -50.0, 50.0)))


def log_odds(probability: float) -> float:
    """Log-odds of a probability, at most 50 nats."""
    kept = min(max(probability, 1e-20), 1.0 - 1e-12)
    return float(np.log(kept / (1.0 - kept)))


def either(first: Array, second: Array) -> Array:
    """Log-odds (C,) that one of two reasons holds: p = 1 - (1 - p1) (1 - p2)."""
    return np.logaddexp(np.logaddexp(first, second), first + second)


def contact_odds(terms: Array, weights: Weights) -> Array:
    """Log-odds (C,) of a contact change before calibration, from its step or its state."""
    step = weights.step.log_odds(terms, CONTACT_COLUMNS)
    return either(step, weights.state.log_odds(terms, CONTACT_COLUMNS))


def motion_odds(terms: Array, weights: Weights) -> Array:
    """Log-odds (C,) of a boundary of motion before calibration."""
    return weights.motion.log_odds(terms, MOTION_COLUMNS)


def doubt(odds: Array, calibration: Calibration, blurred: float) -> float:
    """How many nats contact changes of these log-odds (C,) lose because none of them is clear, in a
    recording whose contact and free space run into one another by so much."""
    if not len(odds):
        return 0.0
    likeliest = float(calibration.log_odds(odds).max())
    short = max(0.0, log_odds(CLEAR) - likeliest)
    return _DOUBTED * short * min(1.0, blurred / _BLURRED)


def calibrated(odds: Array, calibration: Calibration, unlike: float, doubted: float = 0.0) -> Array:
    """Log-odds (C,) that hold in the mean over recordings like those that were fitted on, less
    what is doubted.

    For recordings unlike those they are drawn towards the automatic line: what is given stays
    given, but with less confidence.
    """
    z = np.clip(calibration.log_odds(odds) - doubted, -MAX_ODDS, MAX_ODDS)
    line = log_odds(calibration.line)
    return line + (z - line) / (1.0 + _FADES * unlike)


@dataclass(frozen=True, eq=False)
class Signature:
    """What a recording looks like: the mean (T,) of some terms over `count` likeliest candidates.

    NaN for terms that compare with free space, where there is no view of contact as a state.
    """

    mean: Array
    count: int


def signature(terms: Array, odds: Array, names: tuple[str, ...]) -> Signature | None:
    """The signature of a recording; None where there are too few candidates."""
    if len(odds) < 4:
        return None
    likeliest = terms[np.argsort(-odds, kind="stable")[:_LIKELIEST]]
    mean = likeliest[:, [CONTACT_COLUMNS[name] for name in names]].mean(axis=0)
    if not likeliest[:, CONTACT_COLUMNS["separation"]].any():
        mean[np.isin(names, _OF_FREE_SPACE)] = np.nan
    return Signature(mean, len(likeliest))


def distance_from(here: Signature, centre: Array, spread: Array) -> float:
    """From the nearest of some families (K, T), over the terms that are known, in spreads (T,) of
    a mean over all the candidates that are looked at: one over fewer lies further off by chance.
    """
    apart = np.nanmean(np.square((centre - here.mean) / spread), axis=1).min()
    return float(np.sqrt(apart * here.count / _LIKELIEST))


def unlike(terms: Array, odds: Array, kinds: Kinds) -> float:
    """How far a recording is from every family fitted on: 0 within what is usual, else ln."""
    here = signature(terms, odds, kinds.names)
    if here is None:
        return 0.0
    distance = distance_from(here, kinds.centre, kinds.spread)
    return max(0.0, float(np.log(max(distance, 1e-9) / kinds.usual)))
