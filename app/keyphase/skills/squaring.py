"""A part that is put on what it then carries along: how it is squared on it first.

A place with play takes a part in turned, and no force tells so. But what has sides turns flush with
the side that pushes it, whichever of the two gives way (Mason, Mechanics and planning of
manipulator pushing operations, 1986). So the part is lifted a little, moved from side to side, and
put down again.

What stands loosely turns about the side that pushes it: pushed above the table it leans that way,
and friction holds it there. Its middle moves along that side, one way if it is pushed from the one
side and the other way if from the other. So a stroke ends as soon as a side is felt, and both sides
turn it as much.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.rotations import quaternions


@dataclass(frozen=True)
class Squaring:
    """How a part is squared.

    normal     (3,) unit vector into the place, as the way that was slid on it tells
    along      (3,) unit vector across it, in which the last strokes go
    press_N    what it is pressed with, at the least, before and after
    lift_m     how far it is lifted meanwhile, in lift_s, as long as putting it down takes
    still_s    how long it then stands still: what the sensor reads there is no side
    reach_m    how far it is moved to either side, along both axes of the tool across the press
    speed_m_s  how fast, which it is after ramp_s; a stroke feels nothing before
    strokes    how many there are across `along`, and along it; the last of each comes back
    felt_N     a side is felt where it resists the stroke by so much
    felt_s     for so long
    flush_s    for so long by the `flushing` strokes before the last: what is left is turned flush;
               a side that resists by press_N stands firm, and is pushed no further
    sides      where so many strokes felt a side the last one comes back to the middle between both
               sides, and else to where the demonstration was
    smoothed   part of a new force that is taken in at a tick of 4 ms: single readings are noise
    forgets    the same of what is no side, while none is felt: a sensor drifts
    """

    normal: tuple[float, float, float]
    along: tuple[float, float, float]
    press_N: float = 6.0
    lift_m: float = 0.003
    lift_s: float = 0.4
    still_s: float = 0.3
    reach_m: float = 0.010
    speed_m_s: float = 0.030
    ramp_s: float = 0.15
    strokes: tuple[int, int] = (12, 4)
    felt_N: float = 0.14
    felt_s: float = 0.016
    flush_s: float = 0.25
    flushing: int = 2
    sides: int = 3
    smoothed: float = 0.08
    forgets: float = 0.004

    @property
    def duration_s(self) -> float:
        """After which it is given up; it takes less, as strokes end where a side is felt."""
        a_stroke_s = 2.0 * self.reach_m / self.speed_m_s + self.ramp_s
        return 3.0 * self.lift_s + self.still_s + sum(self.strokes) * a_stroke_s

    def axes(self) -> Iterator[tuple[Array, int]]:
        """Unit vectors (3,) in which the strokes go, and how many of them."""
        along = np.array(self.along)
        beside = np.asarray(np.cross(np.array(self.normal), along), dtype=np.float64)
        yield beside, self.strokes[0]
        yield along, self.strokes[1]


def squaring_at(normal: Array, wxyz: Array, carried: Array) -> Squaring:
    """How a part is squared that the tool holds in an orientation (4,), as it is gripped square.

    The last strokes go along the way (3,) that it is `carried` afterwards: the tool's x or y axis,
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
