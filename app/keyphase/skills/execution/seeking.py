"""While a skill runs: has the part gone into its seat, and if not, where is it?"""

from collections import deque
from collections.abc import Iterator
from itertools import islice
from math import sqrt

import numpy as np

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.skills.changed import changed
from keyphase.skills.coupling import Reference
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.execution.squared import FLATTENING, Squared
from keyphase.skills.search import (
    CREPT_SHARE,
    FALL_S,
    FALL_SHARE,
    FELL_SHARE,
    MAX_PRESSES,
    RETURNS_1_S,
    SINKING,
    SMOOTHED,
    YIELDS,
    across,
    before_touch,
)
from keyphase.skills.skill import Skill

GIVING = 0.15
"""Part of the stiffness sideways that is left while a part is pressed in.

A seat that lies aside or is turned, and a held part that sits tilted, align the tool themselves.
"""

TURNING = 0.3
"""The same in rotation: a tool that turns more easily tips over the edge that it touches first."""

SEATING_S = 2.0
"""How long a part is pressed into a seat: a tilted one goes in at one edge first."""

ROCKING_RAD = np.radians(1.0)
ROCKING_HZ = 2.0
"""Meanwhile the tool rocks all around, so that a part that is wedged comes free and goes in."""

CALM_S = 0.65
"""Before the end the tool is still, so that the part comes to lie flat, for which its damping takes
some tenths of a second; it begins and ends to rock within `FADED_S`."""

FADED_S = 0.2


class Seeking:
    """Of one skill that has a search; `watch` is told every tick."""

    giving = GIVING

    def __init__(self, skill: Skill, sensed: Sensed, step_s: float) -> None:
        assert skill.search is not None
        assert skill.press is not None
        self.search, self.press = skill.search, skill.press
        self.searched, self._fell = False, False
        self._free_N = self._felt_N = sensed.force_N
        self._touch = before_touch(self.press.direction, self._free_N)
        self._places: deque[float] = deque(
            maxlen=max(2, round(max(within_s for within_s, _ in SINKING) / step_s))
        )
        self._presses, self._step_s = 1, step_s
        self._yielded = np.zeros(3)

    @property
    def turning(self) -> float:
        """Part of the stiffness in rotation that is left while the part is pressed in.

        Once it fell, or was found, it cannot tip over an edge; tilted in the hand, it has to come
        to lie flat.
        """
        return FLATTENING if self._fell or self.searched else TURNING

    def watch(self, sensed: Sensed, lasts: bool) -> None:
        """Take in what was sensed at the end of a tick; a touch `lasts` once a contact was met."""
        self._felt_N = self._felt_N + SMOOTHED * (sensed.force_N - self._felt_N)
        self._touch = self._touch.step(sensed.position_m, sensed.force_N, lasts)
        if self._touch.touched_m is None:
            self._places.clear()
            self._fell = False
            return
        place = float(sensed.position_m.dot(self.press.direction))
        self._places.append(place)
        fell_m = place - min(self._lately(FALL_S))
        self._fell = self._fell or fell_m >= FALL_SHARE * self.search.depth_m

    def is_in(self, sensed: Sensed) -> bool:
        """Whether the part went in as deep as the demonstration after its touch, and at once.

        One that crept has to be deeper, as a rim may give way, too.
        """
        least = FELL_SHARE if self._fell else CREPT_SHARE
        return self._touch.depth_m(sensed.position_m) >= least * self.search.depth_m

    def presses_on(self) -> bool:
        """Asked once a press is over: whether the part goes in still, and is pressed once more."""
        place = self._places[-1]
        sinks = any(place - next(self._lately(within_s)) >= far_m for within_s, far_m in SINKING)
        if sinks:
            self._presses += 1
        return sinks and self._presses <= MAX_PRESSES

    def _lately(self, within_s: float) -> Iterator[float]:
        """The places of so long, the newest last."""
        count = max(1, round(within_s / self._step_s))
        return islice(self._places, max(0, len(self._places) - count), None)

    def again(self, _sensed: Sensed, _shift_m: Array) -> None:
        """A search begins, around where the tool is."""
        self._yielded = np.zeros(3)

    def moving(self, reference: Reference, sensed: Sensed, time_s: float) -> Reference:
        """The reference on its spiral, `time_s` after the search began.

        A part that is caught is not torn along: the spiral's middle gives way to it. What was
        felt before the skill began is the sensor's, and catches nothing; nor do single readings,
        each of which would leave the middle a little further off. It comes back where nothing is.
        """
        reference = turned_easily(reference, sensed, TURNING)
        direction = self.press.direction
        aside = self.search.aside(direction, time_s) - self._yielded
        wanted = reference.position_m + aside
        resists_N = self._felt_N - self._free_N
        off, felt = (_aside(v, direction) for v in (wanted - sensed.position_m, resists_N))
        size, most = sqrt(felt.dot(felt)), YIELDS * self.search.press_N
        if size > most:
            beyond = (1.0 - most / size) * off
            self._yielded = self._yielded + beyond
            wanted = wanted - beyond
        else:
            self._yielded = (1.0 - RETURNS_1_S * self._step_s) * self._yielded
        return changed(reference, position_m=wanted)


def giving(
    reference: Reference, sensed: Sensed, seeking: Seeking | Squared, time_s: float
) -> Reference:
    """The reference sideways and in orientation near where the seat has moved the tool.

    It rocks, `time_s` after the pressing began.
    """
    direction, off = seeking.press.direction, reference.position_m - sensed.position_m
    along = float(off.dot(direction)) * direction
    position = sensed.position_m + along + seeking.giving * (off - along)
    turned = turned_easily(reference, sensed, seeking.turning)
    rock = quaternions.from_rotation_vector(rocked(direction, time_s))
    wxyz = quaternions.product(rock, turned.orientation_wxyz)
    return changed(turned, position_m=position, orientation_wxyz=wxyz)


def rocked(direction: Array, time_s: float) -> Array:
    """Rotation vector (3,) by which the tool is tilted: its axis goes around the press."""
    share = min(1.0, time_s / FADED_S, max(0.0, SEATING_S - CALM_S - time_s) / FADED_S)
    first, second = across(direction)
    angle = 2.0 * np.pi * ROCKING_HZ * time_s
    return share * ROCKING_RAD * (np.cos(angle) * first + np.sin(angle) * second)


def turned_easily(reference: Reference, sensed: Sensed, left: float) -> Reference:
    """The reference with an orientation that the seat can turn: a part of the stiffness is left."""
    back = quaternions.conjugate(sensed.orientation_wxyz)
    way = quaternions.shortest_rotation_vector(
        quaternions.product(reference.orientation_wxyz, back)
    )
    turn = quaternions.from_rotation_vector(left * way)
    wxyz = quaternions.product(turn, sensed.orientation_wxyz)
    return changed(reference, orientation_wxyz=wxyz)


def turned_by(sensed: Sensed, demonstrated_wxyz: Array) -> Array:
    """How the seat turned the tool against the demonstrated orientation, as a quaternion (4,)."""
    back = quaternions.conjugate(demonstrated_wxyz)
    turn = quaternions.product(sensed.orientation_wxyz, back)
    return turn / np.linalg.norm(turn)


def _aside(vector: Array, direction: Array) -> Array:
    """The part of a vector (3,) at right angles to a direction (3,)."""
    return vector - float(vector.dot(direction)) * direction


def seeking_of(skill: Skill, sensed: Sensed, step_s: float) -> Seeking | Squared | None:
    """What watches a skill; None for one that neither seeks nor squares."""
    if skill.press is None:
        return None
    if skill.search is not None:
        return Seeking(skill, sensed, step_s)
    return None if skill.squaring is None else Squared(skill, sensed, step_s)
