"""How hard a replay may press at each moment: twice what was then demonstrated, 15 N at least.

Judged by the moment that is repeated, the limit is that of the recording and no plan's: one long
skill may press no harder, where nothing was touched, than a short one that only moves there.
"""

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import maximum_filter1d

from keyphase.demonstration import Array, Demonstration
from keyphase.recorded_force import RATE_HZ, evenly, offset_while_moving
from keyphase.simulation.recorded.surfaces import contact_spans
from keyphase.skills.library import FORCE_LIMIT_FACTOR, MIN_FORCE_LIMIT_N

AROUND_S = 0.6
"""What was demonstrated so long before and after a moment counts; its path is judged so, too."""


@dataclass(frozen=True)
class Hardest:
    """The tick that pressed hardest beside what was allowed; of a moment of the demonstration."""

    force_N: float
    allowed_N: float
    moment_s: float

    @property
    def share(self) -> float:
        """Of the allowed force; above 1 it was too much."""
        return self.force_N / self.allowed_N

    def __str__(self) -> str:
        """What was too much, as an outcome says it."""
        return (
            f"{self.force_N:.0f} N at {self.moment_s:.1f} s of the demonstration, "
            f"where {self.allowed_N:.0f} N are allowed"
        )


class AllowedForce:
    """The limit over a recording's time."""

    def __init__(self, demonstration: Demonstration) -> None:
        """Of a recording; 15 N all along for one without force."""
        even = evenly(demonstration)
        force = even.force_N - offset_while_moving(even)
        self._start_s, self._limit_N = demonstration.start_s, _limits(force)

    def at(self, moment_s: float) -> float:
        """How hard it may be pressed while a moment of the demonstration is repeated [N]."""
        row = round((moment_s - self._start_s) * RATE_HZ)
        return float(self._limit_N[min(max(row, 0), len(self._limit_N) - 1)])


def _limits(force_N: Array) -> Array:
    """For each row of a force (N, 3).

    A surface that lies nearer than it did is met before its moment has come: where nothing was
    touched, what is allowed as the next contact is made is, too.
    """
    size = np.linalg.norm(force_N, axis=1)
    peak = maximum_filter1d(size, 2 * round(AROUND_S * RATE_HZ) + 1, mode="nearest")
    most, free_from = peak.copy(), 0
    for first, last in contact_spans(force_N):
        most[free_from:first] = np.maximum(peak[free_from:first], peak[first])
        free_from = last
    return np.maximum(FORCE_LIMIT_FACTOR * most, MIN_FORCE_LIMIT_N)
