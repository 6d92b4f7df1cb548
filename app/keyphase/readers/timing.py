"""What the time stamps of a recording are like."""

from collections.abc import Callable

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import DemonstrationError

_JITTER = 0.5
"""How far a step may be from the median one, relative to it, and still be regular."""


def refuse_not_increasing(time_s: Array, where: Callable[[int], str]) -> None:
    """Refuse the first row that is not later than the one before; `where` names a row."""
    stuck = np.flatnonzero(~(np.diff(time_s) > 0))
    if stuck.size:
        row = int(stuck[0]) + 1
        raise DemonstrationError(
            f"{where(row)}: expected time to increase, but {time_s[row]:.9g} s comes after "
            f"{time_s[row - 1]:.9g} s; sort the rows, or let a recipe drop the repeated ones."
        )


def irregularity(time_s: Array) -> str | None:
    """A phrase that says how irregular the rows are in time, or None where they are regular."""
    steps = np.diff(time_s)
    median = np.median(steps) if steps.size else 0.0
    if np.all(np.abs(steps - median) <= _JITTER * median):
        return None
    return (
        f"rows are irregular in time: steps from {steps.min():.3g} to {steps.max():.3g} s, "
        f"median {median:.3g} s"
    )


def irregular_notices(time_s: Array) -> tuple[str, ...]:
    """One sentence where the rows are irregular and were left so."""
    phrase = irregularity(time_s) if time_s.ndim == 1 else None
    return (f"The {phrase}; left as they came.",) if phrase else ()
