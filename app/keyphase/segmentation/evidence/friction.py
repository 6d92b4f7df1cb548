"""Friction that turns round with the motion: a step of the force that is no contact change.

Where a tool that rubs along something turns back, its friction does, too: the force steps along the
line of motion and stays, as if contact had changed. What tells it, without trusting the sign of a
wrench, is that the next turn takes it back. A contact that changes at a turn is not taken back.
"""

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.speed import Speed
from keyphase.segmentation.evidence.state_view import StateView
from keyphase.segmentation.evidence.windows import Sides, Windows

_BESIDE_S, _BACK, _SLOW = (0.15, 0.3), 0.5, 0.05
"""A turn: so long before and after it the velocities oppose each other by so much; less than this
part of the recording's own speed is rest."""
_GAP_S, _LENGTH_S = 0.04, 0.16
"""The step of the force at a turn is between two stretches of this length, so far from it."""
_NEXT_S, _NEAR_S, _TOUCHING_S = 4.0, 0.2, 0.5
"""The turn that takes it back comes by then; a candidate belongs to a turn so near; contact lasts
so long on both sides."""
_CLEAR = 0.4
"""Likeness of two steps below which chance is enough."""


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
    sides = Sides(windows, turns, round(_GAP_S * grid.rate_hz), grid.cells(_LENGTH_S))
    step = sides.jump[:, :3]
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
