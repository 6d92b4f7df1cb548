"""Rows a recorder wrote though it had read nothing, left out where the recipe says so."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from keyphase.errors import DemonstrationError
from keyphase.notices import Caution
from keyphase.oddities.poses import MAX_SPEED_M_S
from keyphase.readers.recipes.channels import Channels, Noted
from keyphase.readers.recipes.recipe import Rows

_MIN_JUMP_M = 0.02
_MAX_OUTLIER_ROWS = 5
"""Rows; what stays away longer is no single misreading."""


def without_bad_rows(channels: Channels, rows: Rows, line: Callable[[int], int]) -> Noted:
    """The rows that were measured, and a notice of those that were left out.

    `line` names the line of a row. Raises DemonstrationError where fewer than two are left.
    """
    bad = np.zeros(len(channels["time_s"]), bool)
    notices: tuple[str, ...] = ()
    if rows.missing is not None:
        missing = np.all(channels["position_m"] == rows.missing, axis=1)
        notices += _notice(missing, f"whose place is {rows.missing:g}", line)
        bad |= missing
    if rows.outliers == "drop":
        outliers = np.zeros_like(bad)
        kept = np.flatnonzero(~bad)
        outliers[kept[_outliers(channels["time_s"][kept], channels["position_m"][kept])]] = True
        notices += _notice(outliers, "to which the tool jumped and back", line)
        bad |= outliers
    if not bad.any():
        return channels, notices
    if (~bad).sum() < 2:
        raise DemonstrationError(
            f"Of {len(bad)} rows only {(~bad).sum()} were measured, by what the recipe says in "
            "[rows]; correct it or record again."
        )
    return {channel: values[~bad] for channel, values in channels.items()}, notices


def _outliers(time_s: NDArray[np.float64], position_m: NDArray[np.float64]) -> NDArray[np.intp]:
    """Rows reached faster than any arm, up to the row at which the tool is where it was."""
    steps = np.diff(time_s)
    travel = np.linalg.norm(np.diff(position_m, axis=0), axis=1)
    found: list[int] = []
    for row in np.flatnonzero((travel > _MIN_JUMP_M) & (travel > MAX_SPEED_M_S * steps)).tolist():
        if found and row <= found[-1]:
            continue
        after = position_m[row + 2 : row + 2 + _MAX_OUTLIER_ROWS]
        back = np.linalg.norm(after - position_m[row], axis=1) < 0.2 * travel[row]
        if back.any():
            found += range(row + 1, row + 2 + int(np.argmax(back)))
    return np.array(found, dtype=np.intp)


def _notice(bad: NDArray[np.bool_], which: str, line: Callable[[int], int]) -> tuple[str, ...]:
    if not bad.any():
        return ()
    first = line(int(np.argmax(bad)))
    return (Caution(f"Dropped {int(bad.sum())} rows {which}, first line {first}."),)
