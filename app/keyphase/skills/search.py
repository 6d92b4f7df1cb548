"""What tells a seat from a rim: how far a part goes in after its first touch, and a search for it.

A force alone cannot tell them apart. Where the demonstration met a resistance that gave way, as a
detent does, and went on into it, a skill looks for the same depth; where it is missing it presses
and circles outwards, until the part goes in.
"""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.windows import AFTER_S
from keyphase.skills.pressed import Press

TOUCH_N = 0.8
"""A force above this, counted from the level before, is a touch."""

SMOOTHED = 0.35
"""Part of a new force that is taken in at a tick of 4 ms: single readings are noise."""

BOUNCE_TICKS = 15
"""A touch that is lost for no longer, 0.06 s, is a bounce: what is met fast springs off once."""

LOOKED_BEFORE_S = 0.5
DEPTHS_M = (0.0015, 0.006)
GAVE_WAY_N = 1.0
"""A demonstration shows a detent if it went in so far, and the force fell by this meanwhile."""

FALL_S, FALL_SHARE = 0.2, 0.8
"""A part has gone in once it went this part of the demonstrated depth within so long: a seat takes
it at once, on a rim or a chamfer it creeps."""

FELL_SHARE = 0.9
"""So deep a part that fell has to be: met faster than demonstrated, its touch is told later."""

CREPT_SHARE = 2.0
"""So many times the demonstrated depth has only a part that is in, though it crept: a tilted one
touches early and goes in one edge after the other."""

SINKING = ((0.5, 0.0001), (1.5, 0.001))
"""Within so long so far: a part that still goes in as far at the end of a press, not rocked any
more, or has come so far since it went in, is wedged: it tilts yet, and is pressed and rocked once
more."""

MAX_PRESSES = 4
"""So often it is pressed at the most."""

YIELDS = 0.8
"""Largest force aside, as a part of the press, that a search exerts: more than friction resists
means that the part has been caught, and the spiral gives way to where it is."""

RETURNS_1_S = 1.0
"""While nothing is caught the spiral comes back to its middle, at this rate: what only dragged has
moved it away from where the seat is looked for."""


@dataclass(frozen=True)
class Search:
    """How a seat is told, and sought where it is missing.

    depth_m     how far a part goes in after its first touch, at the least
    press_N     what is pressed with, at the least, until it is in
    radius_m    of the spiral at half its time; it grows with the square root of time, and shrinks
                likewise. Friction holds the tool back by up to 2.4 mm of it
    turns       until then
    duration_s  after which it is given up
    """

    depth_m: float
    press_N: float = 6.0
    radius_m: float = 0.009
    turns: float = 4.0
    duration_s: float = 8.0

    def aside(self, direction: Array, time_s: float) -> Array:
        """How far aside (3,) of the press along `direction` (3,) the reference is by now [m]."""
        done = min(2.0 * time_s / self.duration_s, 2.0)
        share = (1.0 - abs(1.0 - done)) ** 0.5
        first, second = across(direction)
        angle = 2.0 * np.pi * self.turns * (share if done < 1.0 else 2.0 - share)
        return self.radius_m * share * (np.cos(angle) * first + np.sin(angle) * second)


def across(direction: Array) -> tuple[Array, Array]:
    """Two unit vectors (3,) at right angles to a direction (3,) and to each other."""
    beside = np.eye(3)[int(np.abs(direction).argmin())]
    first = np.asarray(np.cross(direction, beside), dtype=np.float64)
    first = first / np.linalg.norm(first)
    return first, np.asarray(np.cross(direction, first), dtype=np.float64)


@dataclass(frozen=True, eq=False)
class Touch:
    """Where a tool first touched something; a value, `step` returns the next one.

    level_N    force against the press before anything is touched
    force_N    the same now, smoothed
    touched_m  place along the press, the highest since; None while nothing is touched
    lost       for how many ticks it has touched nothing since
    """

    direction: Array
    level_N: float
    force_N: float
    touched_m: float | None = None
    lost: int = 0

    def step(self, position_m: Array, force_N: Array, lasts: bool = False) -> "Touch":
        """Take in a position (3,) and a force (3,), 4 ms after the ones before.

        A touch that `lasts` is not over while the part falls through what resisted.
        """
        pressed = -float(force_N.dot(self.direction))
        force = self.force_N + SMOOTHED * (pressed - self.force_N)
        lost = self.lost + 1 if force - self.level_N < TOUCH_N else 0
        if lost and (self.touched_m is None or (lost > BOUNCE_TICKS and not lasts)):
            return Touch(self.direction, self.level_N, force)
        here = float(position_m.dot(self.direction))
        touched = here if self.touched_m is None else min(self.touched_m, here)
        return Touch(self.direction, self.level_N, force, touched, lost)

    def depth_m(self, position_m: Array) -> float:
        """How far in a tool at `position_m` (3,) is since it touched."""
        if self.touched_m is None:
            return 0.0
        return float(position_m.dot(self.direction)) - self.touched_m


def before_touch(direction: Array, force_N: Array) -> Touch:
    """A tool that touches nothing, under a force (3,)."""
    level = -float(force_N.dot(direction))
    return Touch(direction, level, level)


def search_for(demonstration: Demonstration, end_s: float, press: Press | None) -> Search | None:
    """The search of a skill whose demonstrated contact at `end_s` gave way; None for all others."""
    if press is None or demonstration.force_N is None:
        return None
    time = np.arange(end_s - LOOKED_BEFORE_S, min(end_s + AFTER_S[1], demonstration.end_s), 0.004)
    position = _at(time, demonstration.time_s, demonstration.position_m)
    force = _at(time, demonstration.time_s, demonstration.force_N)
    quiet = force[: max(1, round(0.4 * LOOKED_BEFORE_S / 0.004))].mean(axis=0)
    touch, pressed, depth = before_touch(press.direction, quiet), [], 0.0
    for here, now in zip(position, force, strict=True):
        touch = touch.step(here, now)
        if touch.lost:
            # A hand shakes on its way down: what was lost there was no touch that sprang off.
            touch = Touch(touch.direction, touch.level_N, touch.force_N)
        if touch.touched_m is None:
            pressed = []
        else:
            pressed.append(touch.force_N)
            depth = touch.depth_m(here)
    if not pressed or not DEPTHS_M[0] <= depth <= DEPTHS_M[1]:
        return None
    fell = float((np.maximum.accumulate(pressed) - np.array(pressed)).max())
    return Search(depth) if fell >= GAVE_WAY_N else None


def _at(time: Array, time_s: Array, values: Array) -> Array:
    return np.stack([np.interp(time, time_s, column) for column in values.T], axis=1)
