"""Rows in which something was measured, where a table has cells without a number.

Merged logs have a row for each message of any topic and numbers only in its own columns; others
write NaN while a tracker is blind. Each channel goes by the rows in which it has numbers.
"""

import numpy as np
from numpy.typing import NDArray

from keyphase.errors import DemonstrationError
from keyphase.readers.recipes.columns import Columns
from keyphase.readers.recipes.recipe import NumberTime, Recipe, TwoPartTime
from keyphase.readers.table import Columned

Mask = NDArray[np.bool_]


class MeasuredRows:
    """A table seen channel by channel; without `rows.empty = "leave_out"` always all of it."""

    def __init__(self, table: Columned, recipe: Recipe) -> None:
        self._leave_out = recipe.rows.empty == "leave_out"
        self._masks: dict[Columns, Mask] = {}
        self.table = table
        if self._leave_out and (clock := _clock_columns(recipe)):
            self.table = table.only(table.measured(clock_indices(clock, table)))

    def of(self, columns: Columns) -> Columned:
        """The rows in which all these columns hold numbers.

        Raises DemonstrationError where they never do.
        """
        mask = self._mask(columns)
        return self.table if mask is None or mask.all() else self.table.only(mask)

    def times(self, columns: Columns, time: NDArray[np.float64]) -> NDArray[np.float64]:
        """Of the times of all rows (N,) those of the rows in `of`."""
        mask = self._mask(columns)
        return time if mask is None or len(mask) != len(time) else time[mask]

    def notices(self) -> tuple[str, ...]:
        """How many rows were left out of what."""
        told = [
            f"{columns.where.rpartition(': ')[2]} was measured in {int(mask.sum())} of "
            f"{len(mask)} rows."
            for columns, mask in self._masks.items()
            if not mask.all()
        ]
        return tuple(told)

    def _mask(self, columns: Columns) -> Mask | None:
        if not self._leave_out:
            return None
        if columns not in self._masks:
            mask = self.table.measured(columns.find(self.table))
            if mask.sum() < 2:
                raise DemonstrationError(
                    f"{columns.where}: expected at least two rows of {self.table.file} with "
                    f"numbers in all of its columns, but there are {int(mask.sum())}; choose "
                    "columns that were measured together."
                )
            self._masks[columns] = mask
        return self._masks[columns]


def clock_indices(clocks: tuple[Columns, ...], table: Columned) -> list[int]:
    """The columns of some clocks."""
    return [index for clock in clocks for index in clock.find(table)]


def _clock_columns(recipe: Recipe) -> tuple[Columns, ...]:
    match recipe.time:
        case TwoPartTime(seconds, nanoseconds):
            return (seconds, nanoseconds)
        case NumberTime(column):
            return (column,)
    return ()
