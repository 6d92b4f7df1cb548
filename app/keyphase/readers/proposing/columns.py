"""The columns of an unknown recording as they are looked at: names, first numbers, clocks."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from keyphase.demonstration import Array
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.proposing.guess import Guess
from keyphase.readers.proposing.layout import Layout
from keyphase.readers.proposing.naming import elements_of_vectors
from keyphase.readers.proposing.times import is_clock
from keyphase.readers.table import UNMEASURED, Table, split_cells

_LOOKED_AT_ROWS = 2000
_SHOWN_ROWS = 4
_OF_THE_LOG = ".log_time"
_FEW_ROWS = 0.02
"""Arrays with less than this share of the longest are no streams beside it."""


@dataclass(frozen=True)
class Looked:
    """What there is to see of a recording.

    names    of the columns
    told     the same with their unit, where that stands in a line of its own
    values   their first numbers (N, D), NaN where there is none
    cells    their first cells as text; none for a binary format
    texts    the same of columns that hold no numbers
    lengths  how many rows each column has
    remarks  what the file says of them
    apart    clocks beside streams that tell another time than others do
    """

    names: tuple[str, ...]
    told: tuple[str, ...]
    values: Array
    cells: tuple[tuple[str, ...], ...]
    texts: tuple[tuple[str, ...], ...]
    lengths: tuple[int, ...]
    remarks: tuple[str, ...] = ()
    apart: frozenset[str] = frozenset()

    def has_gaps(self, columns: Sequence[int]) -> bool:
        """Whether one of these has rows without a number."""
        return bool(np.isnan(self.values[:, list(columns)]).any())

    def first_demonstration(self, split: Guess | None) -> Array:
        """The numbers of the first of several demonstrations, or all."""
        if split is None:
            return self.values
        seen = self.cells[split.columns[0]]
        end = next((i for i, cell in enumerate(seen) if cell != seen[0]), len(seen))
        return self.values[:end]

    def length(self, guess: Guess) -> int:
        """How many rows the columns of a guess have."""
        return self.lengths[guess.columns[0]]

    def first_rows(self) -> tuple[tuple[str, ...], ...]:
        """The first numbers of all columns as text, "" where there is none."""
        rows = self.values[:_SHOWN_ROWS]
        return tuple(tuple(f"{v + 0.0:.6g}" if np.isfinite(v) else "" for v in row) for row in rows)

    def clocks(self) -> tuple[int, ...]:
        """Columns that rise like a time and are called so."""
        vectors = elements_of_vectors(self.names)
        columns = (i for i in range(self.values.shape[1]) if i not in vectors)
        found = [i for i in columns if is_clock(self.names[i], self.values[:, i])]
        found = [i for i in found if self.names[i] not in self.apart]
        # Of a single topic the clock it tells is nearer to the measurement than that of the log;
        # of several only clocks with one zero go together.
        topics = {name.partition(".")[0] for name in self.names if name.startswith("/")}
        own = [i for i in found if not self.names[i].endswith(_OF_THE_LOG)]
        return tuple(own if own and len(topics) == 1 else found)

    def clock_of(self, guess: Guess, clocks: Sequence[int]) -> int | None:
        """Of the clocks as long as a guess's columns that whose name is nearest to theirs."""
        name = self.names[guess.columns[0]]
        fitting = [c for c in clocks if self.lengths[c] == self.length(guess)]
        if not fitting:
            return None
        return max(fitting, key=lambda clock: _nearness(self.names[clock], name))


def _nearness(clock: str, name: str) -> tuple[bool, bool, int, int]:
    """The same last word of a path counts most, then a bag's own clocks, which have one zero, then
    the same beginning, and a header's stamp.
    """
    same = clock.rpartition("/")[2] == name.rpartition("/")[2].partition("[")[0]
    bag = 2 * clock.endswith(".stamp") + clock.endswith(".log_time")
    return same, bag > 0, _shared(clock, name), bag


def _shared(one: str, other: str) -> int:
    """How many characters two names begin with alike."""
    return next((i for i, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), len(one))


def looked_at_arrays(table: ArrayTable) -> Looked:
    """The first rows of every array of numbers, as many as the shortest stream has."""
    names = table.names[: len(table.names) - len(table.texts)]
    lengths = tuple(table.length(column) for column in range(len(names)))
    longest = max(lengths, default=0)
    streams = [n for n in lengths if n > _FEW_ROWS * longest]
    count = min([_LOOKED_AT_ROWS, *streams])
    values = np.full((count, len(names)), np.nan)
    for column in range(len(names)):
        if lengths[column] > _FEW_ROWS * longest:
            values[:, column] = table.first(column, count)
    empty: tuple[tuple[str, ...], ...] = ((),) * len(names)
    return Looked(names, names, values, empty, empty, lengths, table.remarks, _apart(table))


def _apart(table: ArrayTable) -> frozenset[str]:
    """All stamps, where they are not of one clock; the log's times are."""
    stamps = {
        name: zero
        for name, zero in table.zeros.items()
        if name in table.arrays and not name.endswith(_OF_THE_LOG)
    }
    return frozenset(stamps if len({zero.clock for zero in stamps.values()}) > 1 else ())


def looked_at_table(table: Table, layout: Layout) -> Looked:
    """The first rows of a table of text; a column with a word in it holds no numbers."""
    first = replace(table, lines=table.lines[:_LOOKED_AT_ROWS])
    rows = [split_cells(line, first.form.separator) for line in first.lines]
    cells = tuple(tuple(row[i].strip() for row in rows) for i in range(table.width))
    values = np.full((len(rows), table.width), np.nan)
    texts: list[tuple[str, ...]] = []
    for column, seen in enumerate(cells):
        numbers = _numbers(seen, table.form.decimal)
        texts.append(seen if numbers is None else ())
        if numbers is not None:
            values[:, column] = numbers
    names = tuple(
        table.names[i] if i < len(table.names) and table.names[i] else f"column {i}"
        for i in range(table.width)
    )
    below = dict(enumerate(layout.below))
    told = tuple(f"{name} [{below[i]}]" if below.get(i) else name for i, name in enumerate(names))
    return Looked(names, told, values, cells, tuple(texts), (len(table),) * table.width)


def _numbers(cells: Sequence[str], decimal: str) -> list[float] | None:
    """The cells as numbers, NaN where nothing was measured; None where one holds a word."""
    try:
        return [
            float("nan") if cell.lower() in UNMEASURED else float(cell.replace(decimal, "."))
            for cell in cells
        ]
    except ValueError:
        return None
