"""Cuts into contiguous Gaussians, moved to where all stretches together cost least."""

import itertools

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.paper.contiguous import Moments

MARGIN = 30.0
"""How much log-likelihood a coarse move may cost above the best and still be looked at closely.

A few samples on the wrong side of a cut cost as much.
"""


def refine_cuts(
    moments: Moments, cuts: Indices, reach: int, least: int, stride: int = 1
) -> Indices:
    """Move each cut by up to `reach` samples so that all stretches together cost least.

    Moves by whole strides are compared first, and then all moves less than a stride from those
    with which the stretches cost at most MARGIN more than the best; so a cut may go that much
    further. Stretches have at least `least` samples; where that cannot be, the cuts stay.
    """
    choices = [_moves(moments, cut, reach, least, stride) for cut in cuts.tolist()]
    if stride > 1:
        totals = _least_totals(_costs_between(moments, choices, least))
        promising = [
            moved[total <= total.min() + MARGIN]
            for moved, total in zip(choices, totals, strict=True)
        ]
        choices = [_around(moments, moved, least, stride) for moved in promising]
    picks = _cheapest(_costs_between(moments, choices, least))
    if picks is None:
        return cuts
    chosen = [moved[pick] for moved, pick in zip(choices, picks, strict=True)]
    return np.array(chosen, dtype=np.intp)


def _moves(moments: Moments, cut: int, reach: int, least: int, stride: int) -> Indices:
    """Where a cut may be, by strides from where it is; nowhere else if there is no room."""
    back = min(reach, cut - least) // stride * stride
    ahead = min(reach, len(moments) - least - cut)
    moved = np.arange(cut - back, cut + ahead + 1, stride)
    return moved if len(moved) else np.array([cut])


def _around(moments: Moments, cuts: Indices, least: int, stride: int) -> Indices:
    """All samples less than a stride from any of the cuts."""
    near = [_moves(moments, cut, stride - 1, least, 1) for cut in cuts.tolist()]
    return np.unique(np.concatenate(near))


def _costs_between(moments: Moments, choices: list[Indices], least: int) -> list[Array]:
    """Costs of the stretches between each cut's choices and the next cut's, ends included."""
    points = [np.zeros(1, dtype=np.intp), *choices, np.array([len(moments)])]
    least = min(least, len(moments))
    return [moments.costs(begin, end, least) for begin, end in itertools.pairwise(points)]


def _least_totals(costs: list[Array]) -> list[Array]:
    """For each choice of each cut, what all stretches cost at least with the cut there."""

    def until(best: Array, cost: Array) -> Array:
        return (best[:, None] + cost).min(axis=0)

    def after(best: Array, cost: Array) -> Array:
        return (cost + best).min(axis=1)

    forward = list(itertools.accumulate(costs[:-1], until, initial=np.zeros(1)))[1:]
    backward = list(itertools.accumulate(costs[:0:-1], after, initial=np.zeros(1)))[1:]
    return [begun + rest for begun, rest in zip(forward, reversed(backward), strict=True)]


def _cheapest(costs: list[Array]) -> list[int] | None:
    """For each cut the index of its choice on the cheapest way; None where there is no way."""
    best = np.zeros(1)
    came_from: list[Indices] = []
    for cost in costs:
        total = best[:, None] + cost
        came_from.append(total.argmin(axis=0))
        best = total.min(axis=0)
    if not np.isfinite(best[0]):
        return None
    picks = [0]
    for step in reversed(came_from[1:]):
        picks.append(int(step[picks[-1]]))
    return picks[:0:-1]
