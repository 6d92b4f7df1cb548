"""Places for boundaries in their order: the best of several options each, none before another."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

MIN_GAP_S = 0.04


@dataclass(frozen=True)
class Option:
    """Where a boundary may lie, the probability of the evidence there, and what it costs."""

    time_s: float
    probability: float
    cost: float


def in_order(
    options: Sequence[Sequence[Option]], start_s: float, end_s: float
) -> list[Option | None]:
    """One option each, in rising order within (start_s, end_s), at the least cost in all.

    None for a boundary that has no place between the others; that costs more than any option.
    """
    missing_cost = 10.0
    layers = [[Option(start_s, 0.0, 0.0)], *([*layer, None] for layer in options)]
    best: list[list[tuple[float, float, int]]] = [[(0.0, start_s, -1)]]
    for layer in layers[1:]:
        row = []
        for option in layer:
            reached = [
                (total + (missing_cost if option is None else option.cost), last, k)
                for k, (total, last, _) in enumerate(best[-1])
                if option is None or last + MIN_GAP_S <= option.time_s < end_s
            ]
            total, last, k = min(reached, default=(np.inf, start_s, -1))
            row.append((total, last if option is None else option.time_s, k))
        best.append(row)
    return _followed(layers, best)


def _followed(
    layers: Sequence[Sequence[Option | None]], best: Sequence[Sequence[tuple[float, float, int]]]
) -> list[Option | None]:
    at = int(np.argmin([total for total, _, _ in best[-1]]))
    chosen: list[Option | None] = []
    for layer, row in zip(layers[:0:-1], best[:0:-1], strict=True):
        chosen.append(layer[at])
        at = row[at][2]
    return chosen[::-1]
