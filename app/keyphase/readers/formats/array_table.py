"""Arrays of a binary format as named columns, so that a recipe can choose among them.

An array (N, D) called `pose` is the columns `pose[0]`, `pose[1]`, …; one of (N,) is the column
`pose`. Arrays may differ in length: which clock each follows is said by the recipe.
"""

import hashlib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers.beginnings import Zero
from keyphase.readers.table import TableForm

MAX_COLUMNS = 100_000
"""More numbers in a row than any recorder writes; images are left out before."""


@dataclass(frozen=True, eq=False)
class ArrayTable:
    """The numeric arrays of one recording, by name; each (N, …), flattened after its first axis.

    file     the recording as messages name it
    arrays   by name, in the order of the file
    texts    columns of text, by name
    notices  what was done on the way out of the file
    names_of further names of an array's columns, such as the features of a LeRobot state
    remarks  what the file says of its columns that a person should know who describes them
    zeros    from when the clocks count that a recorder wrote beside each stream, by column
    """

    file: str
    arrays: Mapping[str, NDArray[Any]]
    texts: Mapping[str, Sequence[str]]
    notices: tuple[str, ...]
    names_of: Mapping[str, Sequence[str]]
    remarks: tuple[str, ...] = ()
    zeros: Mapping[str, Zero] = field(default_factory=dict[str, Zero])

    form = TableForm()

    @cached_property
    def _columns(self) -> tuple[tuple[str, str, int], ...]:
        found: list[tuple[str, str, int]] = []
        for name, values in self.arrays.items():
            width = int(np.prod(values.shape[1:], dtype=np.int64))
            if values.ndim == 1:
                found.append((name, name, 0))
                continue
            given = self.names_of.get(name, ())
            named = len(given) == width
            shown = [f"{name}.{given[i]}" if named else f"{name}[{i}]" for i in range(width)]
            found += [(shown[i], name, i) for i in range(width)]
        if len(found) > MAX_COLUMNS:
            raise DemonstrationError(
                f"{self.file}: expected at most {MAX_COLUMNS} columns of numbers, but there are "
                f"{len(found)}; export the pose and the force alone."
            )
        return tuple(found)

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all columns of numbers, then those of text."""
        return self._names

    @cached_property
    def _names(self) -> tuple[str, ...]:
        return (*(shown for shown, _, _ in self._columns), *self.texts)

    @property
    def width(self) -> int:
        """How many columns there are."""
        return len(self.names)

    def __len__(self) -> int:
        return max((len(values) for values in self.arrays.values()), default=0)

    def label(self, column: int) -> str:
        """A column as messages name it."""
        return f"column {self.names[column][:80]!r}"

    def line(self, row: int) -> int:
        """A row as messages number it, from 0 as in the arrays."""
        return row

    def where(self, row: int, column: int) -> str:
        """A cell as messages name it."""
        return f"{self.file}: row {row}, {self.label(column)}"

    def text(self, column: int) -> list[str]:
        """The cells of one column as text."""
        name = self.names[column]
        if name in self.texts:
            return list(self.texts[name])
        return [f"{value:.17g}" for value in self.numbers([column])[:, 0]]

    def length(self, column: int) -> int:
        """How many rows one column of numbers has."""
        return len(self._column(column))

    def first(self, column: int, count: int) -> Array:
        """The first `count` numbers of one column, whatever they are."""
        return self._column(column)[:count].astype(np.float64)

    def numbers(self, columns: Sequence[int]) -> Array:
        """Some columns (N, len(columns)) as finite numbers.

        Raises DemonstrationError for what is not finite, RecipeError for columns of text or of
        different lengths.
        """
        chosen = [self._column(column) for column in columns]
        lengths = {len(values) for values in chosen}
        if len(lengths) > 1:
            shown = ", ".join(self.names[column] for column in columns[:4])
            raise RecipeError(
                f"{self.file}: expected columns of one length, but {shown} have {sorted(lengths)}; "
                "choose columns of one array."
            )
        values = np.stack(chosen, axis=1).astype(np.float64)
        if not np.isfinite(values).all():
            row, at = (int(i) for i in np.argwhere(~np.isfinite(values))[0])
            raise DemonstrationError(
                f"{self.where(row, columns[at])}: expected a finite number, but found "
                f"{values[row, at]}; cut the rows that were not measured or fill them first."
            )
        return values

    def measured(self, columns: Sequence[int]) -> NDArray[np.bool_]:
        """Which rows (N,) are finite in each of these columns."""
        return np.all([np.isfinite(self._column(column)) for column in columns], axis=0)

    def only(self, kept: NDArray[np.bool_]) -> "ArrayTable":
        """The rows that are kept (N,), of the arrays that have so many."""
        arrays = {
            name: values[kept] if len(values) == len(kept) else values
            for name, values in self.arrays.items()
        }
        return replace(self, arrays=arrays)

    def fingerprint(self) -> str:
        """SHA-256 (hex) of all names, types and numbers, whatever file they are in."""
        digest = hashlib.sha256()
        for name, values in self.arrays.items():
            digest.update(f"{name}\0{values.dtype.str}\0{values.shape}\0".encode())
            digest.update(np.ascontiguousarray(values).tobytes())
        return digest.hexdigest()

    def _column(self, column: int) -> NDArray[Any]:
        if column >= len(self._columns):
            raise RecipeError(
                f"{self.file}: {self.label(column)} holds text; choose a column of numbers."
            )
        _, name, at = self._columns[column]
        values = self.arrays[name]
        if values.ndim == 1:
            return values
        # A width of -1 cannot be found out where there are no rows.
        return values.reshape(len(values), math.prod(values.shape[1:]))[:, at]
