"""What the time stamps of a recording are like."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.errors import DemonstrationError

_COARSE = 0.5
_JITTER = 0.5
"""How far a step may be from the median one, relative to it, and still be regular."""


def refuse_not_increasing(time_s: Array, where: Callable[[int], str]) -> None:
    """Refuse the first row that is not later than the one before; `where` names a row."""
    stuck = np.flatnonzero(~(np.diff(time_s) > 0))
    if not stuck.size:
        return
    row = int(stuck[0]) + 1
    came = (
        f"{where(row)}: expected time to increase, but {float(time_s[row])!r} s comes after "
        f"{float(time_s[row - 1])!r} s; "
    )
    again = _restarts(time_s, stuck)
    if len(again) == len(stuck):
        places = ", ".join(where(int(start)).rpartition(": ")[2] for start in again[:5])
        more = ", …" if len(again) > 5 else ""
        raise DemonstrationError(
            f"{came}time starts over at {places}{more}, so the file seems to hold "
            f"{len(again) + 1} recordings: say so in a recipe, [table] time_starts_again = true, "
            "or demonstration = the column that tells them apart."
        )
    if len(stuck) > _COARSE * len(time_s):
        raise DemonstrationError(
            f"{came}{len(stuck)} of {len(time_s)} rows have no time of their own: this column is "
            "too coarse; name another, such as [time] seconds and nanoseconds."
        )
    back = time_s[stuck] - time_s[stuck + 1]
    if not (back > 0).any():
        raise DemonstrationError(f"{came}let a recipe drop what is repeated ([rows] repeated).")
    at = where(int(stuck[np.argmax(back > 0)]) + 1).rpartition(": ")[2]
    raise DemonstrationError(
        f"{came}the clock was set back by {back[back > 0][0]:.3g} s at {at}: read what is before "
        "and after as recordings of their own ([table] time_starts_again = true), or sort the rows "
        "where they are only mixed up."
    )


def _restarts(time_s: Array, stuck: NDArray[np.intp]) -> NDArray[np.intp]:
    """Rows at which time goes back to near where it began."""
    rows = stuck + 1
    near = time_s[0] + 0.1 * (time_s[: rows[0]].max() - time_s[0])
    return rows[(time_s[rows] < time_s[rows - 1]) & (time_s[rows] <= near)]


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
