"""How far the clock of a wrench is from that of the pose, by the contacts of one recording.

Where a tool meets something it stops, against the force that comes: the speed into the contact
falls at the very moment at which the force rises. So for each contact that the force shows, the
fall of the speed along the force is looked for at every offset; where most contacts find theirs at
one, that is the offset. It is proposed with how sure it is, and nothing is ever corrected by it.
"""

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter1d
from scipy.signal import find_peaks

from keyphase.demonstration import Array, Demonstration

RATE_HZ = 200.0
MOST_S = 1.0
"""So far apart clocks are looked for."""

LEAST_CONTACTS, LEAST_SCORE, MOST_ELSEWHERE = 5, 1.4, 0.6
"""An offset is sure with so many contacts, so high a mean fall of the speed (in its own root mean
square over all offsets), and no more than this part of it at any other offset."""

TOLD_S = 0.06
"""Filters of a sensor alone make the force this much later."""

_SMOOTHED_S, _STEP_S, _APART_S = 0.02, 0.06, 0.5
_LEAST_STEP_N, _NOISES = 1.0, 6.0
_LEAST_FALL_M_S = 0.005
_MEAN_STEP_S = 1.0
"""Of rows that are further apart on the average, be it by a gap of hours, nothing can be said: all
that lies between them would have to be made up."""
_NEAR_S = 0.15


@dataclass(frozen=True)
class ClockOffset:
    """An offset that is proposed.

    offset_s   to be added to the times of force and torque, as a recipe's `clock_offset_s`
    contacts   how many contacts it is by
    score      mean fall of the speed at it, in its root mean square over all offsets
    elsewhere  the highest score at an offset that is another one
    """

    offset_s: float
    contacts: int
    score: float
    elsewhere: float

    @property
    def is_sure(self) -> bool:
        """Whether enough contacts agree on this offset, and on no other."""
        agreed = self.score >= LEAST_SCORE and self.elsewhere <= MOST_ELSEWHERE * self.score
        return agreed and self.contacts >= LEAST_CONTACTS

    @property
    def text(self) -> str:
        """The proposal with its evidence, as a sentence; "" where there is nothing to propose."""
        if not self.is_sure or abs(self.offset_s) < TOLD_S:
            return ""
        later = "later" if self.offset_s < 0 else "earlier"
        return (
            f"the force seems {abs(self.offset_s):.2f} s {later} than the pose: at "
            f"{self.contacts} contacts the tool stops so far from where the force rises (score "
            f"{self.score:.1f}, at any other offset at most {self.elsewhere:.1f}); if their clocks "
            f"differ, say clock_offset_s = {self.offset_s:.2f} in [force] and [torque]."
        )


def clock_offset(demonstration: Demonstration) -> ClockOffset | None:
    """What the contacts of a recording say; None without a force, or without a contact in it."""
    if demonstration.force_N is None or demonstration.duration_s < 2.0 * MOST_S + 1.0:
        return None
    if demonstration.duration_s > _MEAN_STEP_S * len(demonstration):
        return None
    time = np.arange(demonstration.start_s, demonstration.end_s, 1.0 / RATE_HZ)
    smoothed = _SMOOTHED_S * RATE_HZ
    position = _at(time, demonstration.time_s, demonstration.position_m)
    velocity = gaussian_filter1d(position, smoothed, axis=0, order=1) * RATE_HZ
    force = _at(time, demonstration.time_s, demonstration.force_N)
    force = gaussian_filter1d(force, smoothed, axis=0)
    step = round(_STEP_S * RATE_HZ)
    lags = np.arange(-round(MOST_S * RATE_HZ), round(MOST_S * RATE_HZ) + 1)
    falls = [
        fall
        for row, direction in _contacts(force, step, int(lags[-1]) + 2 * step)
        if np.abs(fall := _fall(velocity @ -direction, row - lags, step)).max() >= _LEAST_FALL_M_S
    ]
    if not falls:
        return None
    scores = np.mean([fall / np.sqrt(np.mean(fall**2)) for fall in falls], axis=0)
    best = int(np.argmax(scores))
    other = np.abs(lags - lags[best]) > _NEAR_S * RATE_HZ
    offset_s = float(-lags[best] / RATE_HZ)
    return ClockOffset(offset_s, len(falls), float(scores[best]), float(scores[other].max()))


def _contacts(force_N: Array, step: int, margin: int) -> list[tuple[int, Array]]:
    """Rows at which the force (N, 3) rises, not nearer to the ends than `margin`, and its way."""
    changed = np.zeros_like(force_N)
    changed[step:-step] = force_N[2 * step :] - force_N[: -2 * step]
    size, level = np.linalg.norm(changed, axis=1), np.linalg.norm(force_N, axis=1)
    risen = np.zeros(len(level))
    risen[step:-step] = level[2 * step :] - level[: -2 * step]
    least = max(_NOISES * float(np.median(size)), _LEAST_STEP_N)
    rising = np.where(risen > 0.5 * size, size, 0.0)
    rows, _ = find_peaks(rising, height=least, distance=round(_APART_S * RATE_HZ))
    inside = [int(row) for row in rows if margin < row < len(size) - margin]
    return [(row, changed[row] / size[row]) for row in inside]


def _fall(speed: Array, rows: np.ndarray, step: int) -> Array:
    """By how much a speed into the contact (N,) falls around each row; moving away is none."""
    into = np.maximum(speed, 0.0)
    return into[rows - step] - into[rows + step]


def _at(time_s: Array, clock_s: Array, values: Array) -> Array:
    """Values (N, 3) on a clock (N,), at other times."""
    return np.column_stack([np.interp(time_s, clock_s, column) for column in values.T])
