"""What the force does of itself: how its level wanders while the tool rests and touches nothing.

An estimate from joint currents lets go in steps, and a sensor drifts; neither is a contact. Where
the tool rests free the recording itself shows how large such steps are.
"""

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.speed import Speed
from keyphase.segmentation.evidence.state_view import RATE_HZ, StateView

LEAST_REST_S = 4.0
"""With less rest than this nothing is known of how the force wanders."""

_WITHIN_S = 2.0
_LEVEL_S = 1.5
_EDGE_S = 0.3
_QUANTILE = 0.8
_ABOVE = 1.5
_SHARE_OF_STRONGEST = 0.25


def least_step(grid: Grid, view: StateView, speed: Speed) -> float:
    """A step of the force smaller than this is none of contact, in sizes of the wrench.

    Half as much again as the level of the force, a running median that touches in passing leave
    alone, changes within two seconds in four fifths of the time at rest; but no more than a quarter
    of the strongest force. Zero where the tool rests for less than `LEAST_REST_S` in all.
    """
    changes = [_level_changes(levels) for levels in _resting_free(grid, view, speed)]
    count = sum(len(each) for each in changes)
    if count < (LEAST_REST_S - _WITHIN_S) * RATE_HZ:
        return 0.0
    wander = _ABOVE * float(np.quantile(np.concatenate(changes), _QUANTILE))
    return min(wander, _most(view))


def _most(view: StateView) -> float:
    """What is nearer to free space than this is not contact, where it is stronger elsewhere."""
    return _SHARE_OF_STRONGEST * max(1.0, view.contact_distance)


def _resting_free(grid: Grid, view: StateView, speed: Speed) -> list[Array]:
    """The force (M, 3) at 10 Hz, over each stretch in which the tool rests and is free."""
    assert grid.wrench is not None
    block = max(1, round(grid.rate_hz / RATE_HZ))
    margin, least = round(_EDGE_S * grid.rate_hz), block * round(_WITHIN_S * RATE_HZ)
    free = np.zeros(len(grid), dtype=bool)
    for first, last in speed.rests.tolist():
        free[first + margin : max(last - margin, 0)] = True
    free &= view.distance < _most(view)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], free, [False]]).astype(np.int8)))
    found = []
    for first, last in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        if last - first > least:
            whole = (last - first) // block
            force = grid.wrench[first : first + whole * block, :3]
            found.append(force.reshape(whole, block, 3).mean(axis=1))
    return found


def _level_changes(force: Array) -> Array:
    """How far its level (M, 3) is from that of two seconds later, at each tenth of a second."""
    from scipy.ndimage import median_filter

    level = median_filter(force, (round(_LEVEL_S * RATE_HZ), 1), mode="nearest")
    lag = round(_WITHIN_S * RATE_HZ)
    return np.asarray(np.linalg.norm(level[lag:] - level[:-lag], axis=1))
