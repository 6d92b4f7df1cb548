"""Surfaces out of a recording: one compliant surface for each stretch in contact.

The normal of a surface is the recorded force itself, friction and all: at the recorded pose it
gives the recorded force by construction, without splitting it into what the data do not tell.
With n = F/|F|, f = |F| and stiffness k the unloaded surface lies at p = x + n f/k.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.recorded_force import RATE_HZ, Even, running_mean
from keyphase.segmentation.end_condition.travel import last_way
from keyphase.simulation.recorded.stops import Stop, stops_of

STIFFNESS_N_M = 4000.0
"""Of a surface. Harder ones turn a millimetre of tracking error into 20 N."""

ON_N, ON_SHARE, OFF_SHARE = 0.8, 0.04, 0.6
"""In contact from this force, or this part of the 98 % force; out of it below this part of that."""

MIN_DURATION_S, GAP_S = 0.08, 0.06
"""Contacts shorter than this are none, gaps shorter than this neither."""

BEFORE_M = 0.002
"""A surface stands from the last moment at which the tool was this far behind it."""

NEAR_M, NEAR_S, WITHIN_S = 0.003, 0.15, 0.6
"""What counts as near in space and in time, and what is too far in time to count at all."""

SLIPS, STICKS = 0.02, 0.3
"""Friction besides what is in the normal: where the tool slid, and where it stood."""

STANDS_M_S = 0.003
"""A tool slower than this stood."""

BREAKS_OFF_S = 0.1

LEAPS_M_S, LEAPS_FOR_S = (0.05, 0.15), 0.2
"""A surface that moved faster than the first under the recorded tool for so long is in part, and
above the second wholly, a body on its way: an impact is over before."""

MOST_SLANTED = 3.0
"""A tool that comes at a more slanted way passes by: where it meets is not told by its way."""


@dataclass(frozen=True, eq=False)
class Plane:
    """The tangent plane of a surface: a point (3,) of it and its normal (3,), base frame.

    friction     besides what is in the normal
    closing_m_s  how fast the recorded tool moved along the normal there
    force_N      with which force it pressed
    leaps        how much of a body on its way it is, 0 to 1
    """

    point_m: Array
    normal: Array
    friction: float
    closing_m_s: float
    force_N: float
    leaps: float


@dataclass(frozen=True, eq=False)
class Surface:
    """One contact of the recording.

    made_s, lost_s  when it was made and lost; infinite where the recording breaks off in it
    alive_s         from when on the surface stands in the way
    time_s (N,), position_m (N, 3) of the tool, point_m (N, 3) of the unloaded surface,
    normal (N, 3), closing_m_s (N,) of the tool along it, force_N (N,), friction (N,)
    leaps (N,)      how much of a body on its way it is there, 0 to 1
    stops           where a slide on it ended
    slant           way that the tool goes on for each metre that the surface lies further away
    """

    made_s: float
    lost_s: float
    alive_s: float
    time_s: Array
    position_m: Array
    point_m: Array
    normal: Array
    closing_m_s: Array
    force_N: Array
    friction: Array
    leaps: Array
    stops: tuple[Stop, ...] = ()
    slant: float = 1.0

    def stands(self, moment_s: float) -> bool:
        """Whether it is there at a moment of the demonstration."""
        return self.alive_s <= moment_s <= self.lost_s + 1e-6

    def pressed_with(self, moment_s: float) -> float:
        """With which force it was pressed at a moment; zero outside of the contact."""
        return float(np.interp(moment_s, self.time_s, self.force_N, left=0.0, right=0.0))

    def plane(self, position_m: Array, moment_s: float) -> Plane:
        """The tangent plane near a place (3,) and a moment.

        Nearest in space alone is ill-posed where the force changes without motion, the moment
        alone would be a mere playback which a surface that lies higher cannot meet early.
        """
        moment = min(max(moment_s, float(self.time_s[0])), float(self.time_s[-1]))
        rows = slice(*np.searchsorted(self.time_s, (moment - WITHIN_S, moment + WITHIN_S)).tolist())
        away = self.position_m[rows] - position_m
        cost = np.einsum("ij,ij->i", away, away) / NEAR_M**2
        cost += ((self.time_s[rows] - moment) / NEAR_S) ** 2
        weight = np.exp(-2.0 * (cost - cost.min()))
        weight /= weight.sum()
        normal = weight.dot(self.normal[rows])
        normal /= np.sqrt(normal.dot(normal))
        return Plane(
            point_m=weight.dot(self.point_m[rows]),
            normal=normal,
            friction=float(weight.dot(self.friction[rows])),
            closing_m_s=float(weight.dot(self.closing_m_s[rows])),
            force_N=float(weight.dot(self.force_N[rows])),
            leaps=float(weight.dot(self.leaps[rows])),
        )


def surfaces_of(even: Even) -> tuple[Surface, ...]:
    """The surfaces of a recording whose force has no offset any more, in the order of contact."""
    spans = contact_spans(even.force_N)
    ends = [0, *(last - 1 for _, last in spans)]
    return tuple(
        _surface(even, slice(*span), before)
        for span, before in zip(spans, ends[: len(spans)], strict=True)
    )


def contact_spans(force_N: Array) -> list[tuple[int, int]]:
    """Rows [first, last) of the stretches in contact."""
    size = np.linalg.norm(running_mean(force_N, 0.03), axis=1)
    on = max(ON_N, ON_SHARE * float(np.percentile(size, 98)))
    inside = _with_hysteresis(size, on, OFF_SHARE * on)
    edges = np.flatnonzero(np.diff(np.concatenate([[0], inside.astype(int), [0]])))
    spans: list[tuple[int, int]] = []
    for first, last in edges.reshape(-1, 2).tolist():
        if spans and first - spans[-1][1] < GAP_S * RATE_HZ:
            spans[-1] = (spans[-1][0], last)
        else:
            spans.append((first, last))
    return [(first, last) for first, last in spans if last - first > MIN_DURATION_S * RATE_HZ]


def _with_hysteresis(size: Array, on: float, off: float) -> NDArray[np.bool_]:
    """True from above `on` until below `off`."""
    marks = np.where(size > on, 1, np.where(size < off, -1, 0))
    last = np.maximum.accumulate(np.where(marks != 0, np.arange(len(marks)), 0))
    return marks[last] > 0


def _surface(even: Even, rows: slice, before: int) -> Surface:
    time, position = even.time_s[rows], even.position_m[rows]
    force = running_mean(even.force_N[rows], 0.04)
    size = np.linalg.norm(force, axis=1)
    velocity = even.velocity(0.1)[rows]
    speed = np.linalg.norm(velocity, axis=1)
    normal = running_mean(force, 0.06)
    normal = normal / (np.linalg.norm(normal, axis=1)[:, None] + 1e-12)
    first = normal[: max(2, min(10, len(normal)))].mean(axis=0)
    first /= np.linalg.norm(first)
    # From the last moment at which the way there was behind the first tangent plane.
    ahead = (even.position_m[before : rows.start] - position[0]) @ first
    behind = np.flatnonzero(ahead <= -BEFORE_M)
    alive = before if not len(behind) else before + int(behind[-1])
    return Surface(
        made_s=float(time[0]),
        lost_s=np.inf if time[-1] > even.time_s[-1] - BREAKS_OFF_S else float(time[-1]),
        alive_s=float(even.time_s[alive]),
        time_s=time,
        position_m=position,
        point_m=position + normal * (size / STIFFNESS_N_M)[:, None],
        normal=normal,
        closing_m_s=(velocity * normal).sum(axis=1),
        force_N=size,
        friction=np.where(speed < STANDS_M_S, STICKS, SLIPS),
        leaps=_leaps(even, rows, normal),
        stops=stops_of(even, rows.start, rows.stop),
        slant=_slant(even.position_m[before : rows.start + 1], first),
    )


def _leaps(even: Even, rows: slice, normal: Array) -> Array:
    """How much of a body on its way a surface is, (N,), by how far it then gave way."""
    then = np.minimum(
        np.arange(rows.start, rows.stop) + round(LEAPS_FOR_S * RATE_HZ), len(even.time_s) - 1
    )
    gave_m = -((even.position_m[then] - even.position_m[rows]) * normal).sum(axis=1)
    least, most = LEAPS_M_S
    return np.clip((gave_m / LEAPS_FOR_S - least) / (most - least), 0.0, 1.0)


def _slant(path_m: Array, normal: Array) -> float:
    """How slanted the last 10 mm of a path (N, 3) come to a surface: 1 is straight."""
    way = last_way(path_m)
    return 1.0 if way is None else 1.0 / max(abs(float(way[0] @ normal)), 1.0 / MOST_SLANTED)
