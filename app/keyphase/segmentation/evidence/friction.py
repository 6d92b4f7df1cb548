"""Friction that turns with the motion: steps of the force that are no contact change.

Where a tool that rubs along something sets off, stops or turns, its friction does, too: the force
steps and stays, as if contact had changed; and an estimate from joint currents does the same with
the friction of the joints while nothing is touched. Neither is told by the sign of a wrench, nor by
its axes, which are not to be trusted. What tells it is the rest of the recording (`with_the_way`):
if elsewhere the force went with the direction of motion in the same way, it does here; and, where
the way turns back, that the next turn takes the step back (`taken_back`). A contact that changes as
the motion does is neither gone with elsewhere nor taken back.
"""

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.speed import Speed
from keyphase.segmentation.evidence.state_view import StateView
from keyphase.segmentation.evidence.windows import Sides, Windows
from keyphase.segmentation.order_statistics import quantile

_SLOW = 0.05
"""Less than this part of the recording's own speed is rest, and has no direction."""
_GAP_S = 0.04
"""A step is between two stretches so far from its place."""

_TURN_LENGTH_S = 0.16
_BESIDE_S, _BACK = (0.15, 0.3), 0.5
"""The step at a turn is between two stretches of that length; a turn: so long before and after it
the velocities oppose each other by so much."""
_NEXT_S, _NEAR_S, _TOUCHING_S = 4.0, 0.2, 0.5
"""The turn that takes it back comes by then; a candidate belongs to a turn so near; contact lasts
so long on both sides."""
_CLEAR = 0.4
"""Likeness of two steps below which chance is enough."""

_LENGTH_S = 0.2
_EVERY_S, _ASIDE_S = 0.1, 2.0
"""How force and direction change between two stretches of that length is compared so often, but for
what is nearer than this to a candidate."""
_FREE, _TOUCHING, _NEITHER = range(3)
_STATE_S, _LASTS = 0.3, 0.9
"""Contact, or free space, is there for this part of so long on both sides."""
_LEAST_PLACES = 20
_USUAL = 0.8
"""Changes of force larger than this part of all count less: contact changes are among them."""
_RIDGE = 1.0
"""So many full turns are needed before the map is believed by half."""


def with_the_way(grid: Grid, speed: Speed, windows: Windows, view: StateView, at: Indices) -> Array:
    """How much of the step at each candidate (C,) the change of direction explains, 0 to 1.

    Where contact lasts on both sides the rest of the time in contact tells, where free space does
    the rest of that; where one goes over into the other nothing is explained.
    """
    found = np.zeros(len(at))
    if speed.fast_m_s <= 0.0 or not len(at):
        return found
    margin = grid.cells(_LENGTH_S)
    places = np.arange(margin, len(grid) - margin, max(1, round(_EVERY_S * grid.rate_hz)))
    both, count = np.concatenate([places, at]), len(places)
    way = _changes(grid, Windows(_directions(grid, speed)), both)
    step, state = _changes(grid, windows, both), _lasting(grid, view, both)
    reach = _ASIDE_S * grid.rate_hz
    first = np.searchsorted(places, at - reach)
    last = np.searchsorted(places, at + reach, side="right")
    for each in (_FREE, _TOUCHING):
        known, mine = state[:count] == each, state[count:] == each
        if known.sum() < _LEAST_PLACES or not mine.any():
            continue
        maps = _Sums(way[:count], step[:count], known).maps(first[mine], last[mine])
        here = step[count:][mine]
        explained = np.einsum("ci,cij->cj", way[count:][mine], maps)
        along = (explained * here).sum(axis=1) / (np.square(here).sum(axis=1) + 1e-12)
        found[mine] = np.clip(along, 0.0, 1.0)
    return found


def _directions(grid: Grid, speed: Speed) -> Array:
    """The direction of motion (n, 3), of length one, and less where the tool is slow."""
    velocity = np.gradient(speed.pose_m[:, :3], 1.0 / grid.rate_hz, axis=0)
    fast = np.linalg.norm(velocity, axis=1, keepdims=True)
    return velocity / (fast + _SLOW * speed.fast_m_s)


def _changes(grid: Grid, windows: Windows, at: Indices, length_s: float = _LENGTH_S) -> Array:
    """Mean right after minus mean right before cells (C, D)."""
    return Sides(windows, at, round(_GAP_S * grid.rate_hz), grid.cells(length_s)).jump


def _lasting(grid: Grid, view: StateView, at: Indices) -> Indices:
    """Which state lasts on both sides of cells (C,): _FREE, _TOUCHING, or neither."""
    sides = Sides(Windows(view.contact.astype(float)), at, 0, grid.cells(_STATE_S))
    before, after = sides.mean_before[:, 0], sides.mean_after[:, 0]
    touching, free = np.minimum(before, after) > _LASTS, np.maximum(before, after) < 1.0 - _LASTS
    return np.where(touching, _TOUCHING, np.where(free, _FREE, _NEITHER))


class _Sums:
    """What a least-squares map from changes of direction (P, 3) to changes of the wrench (P, D)
    needs, summed up to each place."""

    def __init__(self, way: Array, wrench: Array, known: NDArray[np.bool_]) -> None:
        size = np.linalg.norm(wrench, axis=1)
        usual = quantile(size[known], _USUAL) + 1e-9
        weight = known * np.square(np.minimum(1.0, usual / (size + 1e-9)))
        self._ways = _running(np.einsum("p,pi,pj->pij", weight, way, way))
        self._both = _running(np.einsum("p,pi,pj->pij", weight, way, wrench))

    def maps(self, first: Indices, last: Indices) -> Array:
        """The maps (C, 3, D) that the places outside [first, last) give."""
        ways = self._ways[-1] - (self._ways[last] - self._ways[first])
        both = self._both[-1] - (self._both[last] - self._both[first])
        return np.linalg.solve(ways + _RIDGE * np.eye(3), both)


def _running(values: Array) -> Array:
    return np.concatenate([np.zeros((1, *values.shape[1:])), np.cumsum(values, axis=0)])


def taken_back(grid: Grid, speed: Speed, windows: Windows, view: StateView, at: Indices) -> Array:
    """How much of the step at each candidate (C,) is friction that turned round, 0 to 1.

    Only where contact as a state lasts on both sides: where it is made and lost the tool turns
    back, too.
    """
    if speed.fast_m_s <= 0.0 or not len(at):
        return np.zeros(len(at))
    turns, line = _turns(grid, speed)
    if len(turns) < 2:
        return np.zeros(len(at))
    step = _changes(grid, windows, turns, _TURN_LENGTH_S)[:, :3]
    size = np.linalg.norm(step, axis=1) + 1e-9
    along = np.abs((step * line).sum(axis=1)) / size
    # Against each other, and of like size: the hand does not press alike at both.
    opposed = np.clip(-(step[1:] * step[:-1]).sum(axis=1) / (size[1:] * size[:-1]), 0.0, 1.0)
    undone = opposed * np.sqrt(np.minimum(size[1:], size[:-1]) / np.maximum(size[1:], size[:-1]))
    undone[np.diff(turns) > _NEXT_S * grid.rate_hz] = 0.0
    friction = along * np.maximum(np.append(undone, 0.0), np.append(0.0, undone))
    after = np.searchsorted(turns, at)
    found = np.zeros(len(at))
    for beside in (np.maximum(after - 1, 0), np.minimum(after, len(turns) - 1)):
        away = (at - turns[beside]) / grid.rate_hz
        found = np.maximum(found, friction[beside] * np.exp(-np.square(away / _NEAR_S)))
    touching = Sides(Windows(view.contact.astype(float)), at, 0, grid.cells(_TOUCHING_S))
    found *= np.minimum(touching.mean_before[:, 0], touching.mean_after[:, 0])
    return np.maximum(found - _CLEAR, 0.0) / (1.0 - _CLEAR)


def _turns(grid: Grid, speed: Speed) -> tuple[Indices, Array]:
    """Cells (T,) at which the way turns back, and the line (T, 3) along which it does."""
    from scipy.signal import find_peaks

    velocity = np.gradient(speed.pose_m[:, :3], 1.0 / grid.rate_hz, axis=0)
    slow = _SLOW * speed.fast_m_s
    back, change = np.full(len(grid), -1.0), np.zeros((len(grid), 3))
    cell, last = np.arange(len(grid)), len(grid) - 1
    for beside_s in _BESIDE_S:
        reach = grid.cells(beside_s)
        before = velocity[np.maximum(cell - reach, 0)]
        after = velocity[np.minimum(cell + reach, last)]
        norms = (np.linalg.norm(before, axis=1) + slow) * (np.linalg.norm(after, axis=1) + slow)
        turned = -(before * after).sum(axis=1) / norms
        more = turned > back
        back = np.where(more, turned, back)
        change[more] = (after - before)[more]
    distance = grid.cells(_BESIDE_S[0])
    turns = find_peaks(back, height=_BACK, distance=distance)[0].astype(np.intp)
    line = change[turns]
    return turns, line / (np.linalg.norm(line, axis=1, keepdims=True) + 1e-12)
