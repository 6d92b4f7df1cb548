"""A part that is put on what it then carries along: how it is squared on it first.

A place with play takes a part in turned, and no force tells so. But what has sides turns flush with
the side that pushes it, whichever of the two gives way (Mason, Mechanics and planning of
manipulator pushing operations, 1986). So the part is lifted a little, moved from side to side, and
put down again.
"""

from dataclasses import dataclass
from math import cos, pi, sin

import numpy as np

from keyphase.demonstration import Array
from keyphase.rotations import quaternions

_STROKES = 8
"""Four along either axis; lifting and putting down take as long as one each."""


@dataclass(frozen=True)
class Squaring:
    """How a part is squared.

    normal    (3,) unit vector into the place, as the way that was slid on it tells
    along     (3,) unit vector across it, in which the first strokes go
    press_N   what it is pressed with, at the least, before and after
    lift_m    how far it is lifted meanwhile
    reach_m   how far it is moved to either side, along both axes of the tool across the press
    last_m    the same of the last stroke, which leaves it away from the sides
    stroke_s  how long a stroke takes, of four along each axis
    shake_m, shake_hz  meanwhile it is shaken along the side it is moved to: friction there would
              drag the other part along, one that slides to and fro drags it nowhere
    """

    normal: tuple[float, float, float]
    along: tuple[float, float, float]
    press_N: float = 6.0
    lift_m: float = 0.003
    reach_m: float = 0.010
    last_m: float = 0.008
    stroke_s: float = 0.6
    shake_m: float = 0.0015
    shake_hz: float = 5.5

    @property
    def strokes_s(self) -> float:
        """How long it takes, lifting and putting down included."""
        return (_STROKES + 2.0) * self.stroke_s

    @property
    def duration_s(self) -> float:
        """After which it is given up."""
        return self.strokes_s + self.stroke_s

    def away(self, time_s: float) -> Array:
        """How far (3,) the part is to be moved by now [m]."""
        normal, along = np.array(self.normal), np.array(self.along)
        stroke = time_s / self.stroke_s - 1.0
        lifted = -self.lift_m * self.lifted(time_s) * normal
        if not 0.0 < stroke < _STROKES:
            return lifted
        beside = np.asarray(np.cross(normal, along), dtype=np.float64)
        if stroke >= _STROKES / 2:
            along, beside, stroke = beside, along, stroke - _STROKES / 2
        fade = _eased(min(2.0 * stroke, 2.0 * (_STROKES / 2 - stroke), 1.0))
        shaken = fade * self.shake_m * sin(2.0 * pi * self.shake_hz * time_s)
        return lifted + self._place(stroke) * along + shaken * beside

    def lifted(self, time_s: float) -> float:
        """How much of the lift is done by now, 0 to 1."""
        strokes = time_s / self.stroke_s
        return _eased(max(min(strokes, _STROKES + 2.0 - strokes, 1.0), 0.0))

    def approached(self, time_s: float) -> float:
        """How much of the way to where the strokes go around is done by now, 0 to 1."""
        return self.lifted(min(time_s, self.stroke_s))

    def _place(self, stroke: float) -> float:
        """How far along its axis the part is by a number of strokes, 0 to 4 [m]."""
        places = 0.0, self.reach_m, -self.reach_m, self.last_m, 0.0
        at = int(stroke)
        return places[at] + _eased(stroke - at) * (places[at + 1] - places[at])


def squaring_at(normal: Array, wxyz: Array, carried: Array) -> Squaring:
    """How a part is squared that the tool holds in an orientation (4,), as it is gripped square.

    The first strokes go along the way (3,) that it is `carried` afterwards: the tool's x or y axis,
    made square to the normal (3,).
    """
    axes = (_turned(wxyz, axis) for axis in np.eye(3)[:2])
    beside = min(axes, key=lambda axis: abs(float(axis.dot(normal))))
    first = beside - float(beside.dot(normal)) * normal
    first = first / np.linalg.norm(first)
    second = np.asarray(np.cross(normal, first), dtype=np.float64)
    along = max((first, second), key=lambda axis: abs(float(axis.dot(carried))))
    return Squaring(_triple(normal), _triple(along))


def _triple(vector: Array) -> tuple[float, float, float]:
    x, y, z = vector.tolist()
    return x, y, z


def _turned(wxyz: Array, vector: Array) -> Array:
    turned = quaternions.product(wxyz, np.concatenate([[0.0], vector]))
    return quaternions.product(turned, quaternions.conjugate(wxyz))[1:]


def _eased(share: float) -> float:
    """From 0 to 1 as `share` goes from 0 to 1, at rest at both ends."""
    return 0.5 - 0.5 * cos(pi * share)
