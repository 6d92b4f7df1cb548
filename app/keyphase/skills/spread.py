"""How far the demonstrations of a skill lie apart, along its way."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SkillError

KEPT = 21
"""So many values are kept of the spread along a skill."""

TIGHT_M, WIDE_M = 0.002, 0.007
"""Demonstrations nearer to each other than the first agree; from the second on it does not matter
where exactly the tool goes."""

SOFTEST = 0.5
"""The least part of the stiffness with which a reference is followed."""


@dataclass(frozen=True, eq=False)
class Spread:
    """What several demonstrations of a skill have in common, and what not.

    demonstrations  how many there are
    position_m      (M,) root mean square distance from their mean, at even parts of the time

    Raises SkillError where these are no distances.
    """

    demonstrations: int
    position_m: Array

    def __post_init__(self) -> None:
        values = self.position_m
        if self.demonstrations < 1 or values.ndim != 1 or len(values) < 2:
            raise SkillError("A spread is of at least one demonstration, at two times or more.")
        if not np.isfinite(values).all() or (values < 0.0).any():
            raise SkillError("A spread must hold distances that are finite and not below zero.")

    def at(self, fraction: float) -> float:
        """The spread at a part of the demonstrated time, 0 to 1 [m]."""
        return self._between(self.position_m, fraction)

    @cached_property
    def stiffness(self) -> Array:
        """The part of the stiffness that is needed there (M,), at the same parts of the time."""
        return np.interp(self.position_m, (TIGHT_M, WIDE_M), (1.0, SOFTEST))

    def stiffness_at(self, fraction: float) -> float:
        """The same at a part of the demonstrated time, 0 to 1."""
        return self._between(self.stiffness, fraction)

    def _between(self, values: Array, fraction: float) -> float:
        return float(np.interp(fraction, np.linspace(0.0, 1.0, len(values)), values))


def spread_between(
    time_s: Array, spread_m: Array, start_s: float, end_s: float, demonstrations: int
) -> Spread:
    """The spread of a skill that was demonstrated from one time to another."""
    at = np.linspace(start_s, end_s, KEPT)
    return Spread(demonstrations, np.interp(at, time_s, spread_m))
