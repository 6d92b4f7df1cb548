"""How a hand gets from here to there: progress from 0 to 1 over the samples of one stroke.

Every profile begins and ends at rest. Minimum jerk is the textbook's hand; the others are what
recordings show beside it: a machine's trapezoid, early and late peaks, a hand that hesitates.
"""

import numpy as np
from scipy.special import betainc

from keyphase.making.draws import Array, chance

MIN_SAMPLES = 6
"""Samples of the shortest stroke."""

_CUT = 0.93


def minimum_jerk(part: Array) -> Array:
    """Share of the way after a part of the time (Flash and Hogan 1985)."""
    part = np.clip(part, 0.0, 1.0)
    return part**3 * (10.0 - 15.0 * part + 6.0 * part**2)


def progress(rng: np.random.Generator, count: int, hesitation: float = 0.2) -> Array:
    """Progress (count,) of a stroke that begins and ends at rest, in one of four manners.

    In this share of strokes (`hesitation`) the hand slows down by a tenth to a half on the way:
    that is no boundary.
    """
    part = np.linspace(0.0, 1.0, count)
    manner = rng.integers(4)
    if manner == 0:
        along = minimum_jerk(part)
    elif manner == 1:
        ramp = rng.uniform(0.15, 0.45)
        along = _travelled(np.clip(np.minimum(part, 1.0 - part) / ramp, 0.0, 1.0))
    elif manner == 2:
        along = np.asarray(betainc(rng.uniform(2.0, 5.0), rng.uniform(2.0, 5.0), part))
    else:
        skewed = np.sin(np.pi * part) + rng.uniform(-0.3, 0.3) * np.sin(2.0 * np.pi * part)
        along = _travelled(np.maximum(skewed, 0.0))
    return _hesitating(rng, part, along) if chance(rng, hesitation) else along


def progress_into_contact(rng: np.random.Generator, count: int) -> tuple[Array, float]:
    """Progress (count,) of a stroke that something stops, and the part of its time at which.

    Minimum jerk, cut while it still moves; what is left of its speed dies out in the last
    samples.
    """
    part = np.linspace(0.0, 1.0, count)
    reached = rng.uniform(0.75, 1.0)
    speed = (np.clip(reached * part, 0.0, 1.0) * (1.0 - np.clip(reached * part, 0.0, 1.0))) ** 2
    dying = np.clip((1.0 - part) / (1.0 - _CUT), 0.0, 1.0)
    return _travelled(speed * np.where(part > _CUT, dying**2, 1.0)), _CUT


def _hesitating(rng: np.random.Generator, part: Array, along: Array) -> Array:
    speed = np.diff(along, prepend=0.0)
    dip = (part - rng.uniform(0.25, 0.75)) / rng.uniform(0.05, 0.15)
    return _travelled(speed * (1.0 - rng.uniform(0.1, 0.5) * np.exp(-(dip**2))))


def _travelled(speed: Array) -> Array:
    way = np.cumsum(speed)
    return way / way[-1]
