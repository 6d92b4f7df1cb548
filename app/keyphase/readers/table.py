"""A text table: lines of cells, of which some columns are numbers.

Messages name columns as the header does and rows by the number of their line in the file. Numbers
are parsed by NumPy's C reader; only a file that it refuses is searched, cell by cell, for the cell
to name.
"""

import csv
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.errors import DemonstrationError
from keyphase.notices import Caution
from keyphase.readers.table_lines import (
    lists_apart,
    refuse_zero_bytes,
    rows_among,
    without_lost_end,
)

_MAX_LINE_LENGTH = 100_000
"""Thousands of columns; what is longer is no table, and the csv module would refuse its cells."""
_BYTES_PER_LINE = 200
"""A limit of 2 GiB in memory lets ten million lines in: eleven hours at 250 Hz."""
_BYTES_PER_CHARACTER = 4
"""What a character costs while a table is decoded, split and parsed."""

UNMEASURED = frozenset((
    "", "nan", "-nan", "null", "none", "na", "n/a", "<na>", "#n/a", "#na", "-", "--",
    "1.#ind", "-1.#ind", "1.#qnan", "-1.#qnan",
))  # fmt: skip
"""What recorders write, in any case, where nothing was measured."""

_QUOTED_OR_PLAIN = re.compile(r'"([^"]*)"|(\S+)')
_NUMBER = re.compile(
    r"\s*[+-]?(\d+\.?\d*(e[+-]?\d+)?|\.\d+(e[+-]?\d+)?|nan|inf(inity)?)\s*",
    re.ASCII | re.IGNORECASE,
)


@dataclass(frozen=True)
class TableForm:
    """How the text of a table is laid out; the defaults are those of a plain CSV.

    `separator` is one character, or None for any white space. `skip_lines` lines are passed over,
    then comes one line of column names if `header`, and after it `lines_after_header` that say
    more of the columns, such as their units.
    """

    separator: str | None = ","
    skip_lines: int = 0
    header: bool = True
    encoding: str = "utf-8-sig"
    decimal: str = "."
    lines_after_header: int = 0


class Columned(Protocol):
    """Named columns, whatever they came from: what a recipe chooses among."""

    @property
    def file(self) -> str: ...  # noqa: D102
    @property
    def form(self) -> TableForm: ...  # noqa: D102
    @property
    def names(self) -> tuple[str, ...]: ...  # noqa: D102
    @property
    def width(self) -> int: ...  # noqa: D102
    def __len__(self) -> int: ...
    def label(self, column: int) -> str: ...  # noqa: D102
    def line(self, row: int) -> int: ...  # noqa: D102
    def text(self, column: int) -> list[str]: ...  # noqa: D102
    def numbers(self, columns: Sequence[int]) -> Array: ...  # noqa: D102
    def measured(self, columns: Sequence[int]) -> NDArray[np.bool_]: ...  # noqa: D102
    def only(self, kept: NDArray[np.bool_]) -> "Columned": ...  # noqa: D102


@dataclass(frozen=True)
class Table:
    """The lines of a table that hold data, each with `width` cells, and its column names.

    notices  what is odd about the end of the file
    """

    file: str
    form: TableForm
    names: tuple[str, ...]
    width: int
    lines: Sequence[str]
    line_numbers: Sequence[int]
    quoted: bool
    notices: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.lines)

    def label(self, column: int) -> str:
        """A column as messages name it."""
        named = column < len(self.names) and self.names[column]
        return f"column {self.names[column][:80]!r}" if named else f"column {column}"

    def line(self, row: int) -> int:
        """Number in the file, from 1, of the line that holds data row `row`."""
        return self.line_numbers[row]

    def where(self, row: int, column: int) -> str:
        """A cell as messages name it."""
        return f"{self.file}: line {self.line(row)}, {self.label(column)}"

    def text(self, column: int) -> list[str]:
        """The cells of one column as they stand."""
        return [split_cells(line, self.form.separator)[column].strip() for line in self.lines]

    def numbers(self, columns: Sequence[int]) -> Array:
        """Some columns (N, len(columns)) as finite numbers.

        Raises DemonstrationError naming line and column of the first cell that is no number, not
        finite or empty.
        """
        lines, separator, used = self._plain(columns)
        try:
            values = np.loadtxt(lines, delimiter=separator, comments=None, usecols=used, ndmin=2)
        except ValueError as error:
            raise self._not_a_number(columns) or DemonstrationError(
                f"{self.file}: expected a table of numbers, but it cannot be read ({error})."
            ) from error
        if not np.isfinite(values).all():
            row, at = (int(i) for i in np.argwhere(~np.isfinite(values))[0])
            raise DemonstrationError(
                f"{self.where(row, columns[at])}: expected a finite number, but found "
                f"{values[row, at]}; cut the rows that were not measured or fill them first."
            )
        return values

    def measured(self, columns: Sequence[int]) -> NDArray[np.bool_]:
        """Which rows (N,) hold more than nothing or NaN in each of these columns."""
        lines, separator, used = self._plain(columns)
        rows = (line.split(separator) for line in lines)
        found = [all(row[i].strip().lower() not in UNMEASURED for i in used) for row in rows]
        return np.array(found, dtype=bool)

    def only(self, kept: NDArray[np.bool_]) -> "Table":
        """The rows that are kept (N,), with the numbers of their lines."""
        rows = np.flatnonzero(kept).tolist()
        lines, numbers = [self.lines[r] for r in rows], [self.line_numbers[r] for r in rows]
        return replace(self, lines=lines, line_numbers=numbers)

    def _plain(self, columns: Sequence[int]) -> tuple[Sequence[str], str | None, Sequence[int]]:
        """Lines NumPy can read, their separator and the columns in them: no quotes, points."""
        lines, separator, used = self.lines, self.form.separator, columns
        if self.quoted:
            rows = (split_cells(line, separator) for line in lines)
            lines = ["\t".join(cells[i] for i in columns) for cells in rows]
            separator, used = "\t", range(len(columns))
        if self.form.decimal != ".":
            lines = [line.replace(self.form.decimal, ".") for line in lines]
        return lines, separator, used

    def _not_a_number(self, columns: Sequence[int]) -> DemonstrationError | None:
        for row, line in enumerate(self.lines):
            cells = split_cells(line, self.form.separator)
            for column in columns:
                cell = cells[column].strip()
                if not _NUMBER.fullmatch(cell.replace(self.form.decimal, ".")):
                    came = f"found {cell[:40]!r}" if cell else "the cell is empty"
                    return DemonstrationError(
                        f"{self.where(row, column)}: expected a number, but {came}; "
                        "correct the cell or leave the line out."
                    )
        return None


def split_cells(line: str, separator: str | None) -> list[str]:
    """The cells of one line, quotes taken off."""
    if '"' not in line:
        return line.split(separator)
    if separator is None:
        return [quoted or plain for quoted, plain in _QUOTED_OR_PLAIN.findall(line)]
    return next(csv.reader([line], delimiter=separator, skipinitialspace=True), [])


def open_table(file: str, data: bytes, form: TableForm, limit_bytes: int) -> Table:
    """Decode and split a table, and check that all its rows are equally long.

    Raises DemonstrationError for binary or wrongly encoded content, tables too large for
    `limit_bytes` of memory, tables without rows, and rows of another length.
    """
    lines, lost = _lines(file, data, form, limit_bytes)
    body_at = form.skip_lines + form.header + form.lines_after_header
    header = lines[form.skip_lines] if form.header and form.skip_lines < len(lines) else None
    body, numbers, told = rows_among(lines, body_at, header, form.separator)
    if not body:
        raise DemonstrationError(
            f"{file}: expected rows of numbers after line {body_at}, but there are none; "
            "record or export the file again."
        )
    names = () if header is None else header_names(header, form)
    width = len(split_cells(body[0], form.separator))
    ends_whole = not lines[-1].strip() or numbers[-1] < len(lines)
    cut = () if ends_whole else _end_notices(body, numbers, width, form)
    quoted = any('"' in line for line in body)
    table = Table(file, form, names, width, body, numbers, quoted, (*lost, *told, *cut))
    _refuse_ragged(table)
    return table


def _end_notices(
    body: list[str], numbers: Sequence[int], width: int, form: TableForm
) -> tuple[str, ...]:
    """Of a file whose last line has no end; where cells are missing the line is left out."""
    last = numbers[len(body) - 1]
    if len(body) > 2 and len(split_cells(body[-1], form.separator)) < width:
        body.pop()
        told = f"The file ends within line {last}, which was left out: it was cut there."
    else:
        told = (
            f"The last line, {last}, has no line end: if the file was cut there, its last number "
            "is not whole."
        )
    return (Caution(told),)


def _lines(
    file: str, data: bytes, form: TableForm, limit_bytes: int
) -> tuple[list[str], tuple[str, ...]]:
    """The lines of the text, and what is odd about its end."""
    _refuse_too_large(file, data, limit_bytes)
    data, notices = without_lost_end(data)
    try:
        text = data.decode(form.encoding)
    except UnicodeError as error:
        line = data[: getattr(error, "start", 0)].count(b"\n") + 1
        raise DemonstrationError(
            f"{file}: expected text in {form.encoding.removesuffix('-sig')}, but in line {line} "
            "there is none; save it as UTF-8 or name its encoding in a recipe."
        ) from error
    refuse_zero_bytes(file, text)
    lines = lists_apart(text.replace("\r\n", "\n").replace("\r", "\n")).split("\n")
    longest = max(range(len(lines)), key=lambda i: len(lines[i]))
    if len(lines[longest]) > _MAX_LINE_LENGTH:
        raise DemonstrationError(
            f"{file}: line {longest + 1} has {len(lines[longest])} characters, more than a table "
            f"of numbers can have ({_MAX_LINE_LENGTH}); check that the file is a text table."
        )
    return lines, notices


def _refuse_too_large(file: str, data: bytes, limit_bytes: int) -> None:
    most_lines = limit_bytes // _BYTES_PER_LINE
    if len(data) > limit_bytes // _BYTES_PER_CHARACTER:
        raise DemonstrationError(
            f"{file}: a text table may have {limit_bytes // _BYTES_PER_CHARACTER} bytes, but this "
            f"one has {len(data)}; convert it to NPZ, cut it or raise the limit."
        )
    lines = max(data.count(b"\n"), data.count(b"\r"))
    if lines > most_lines:
        raise DemonstrationError(
            f"{file}: a text table may have {most_lines} lines, but this one has {lines}; "
            "convert it to NPZ, cut it or raise the limit."
        )


def header_names(line: str, form: TableForm) -> tuple[str, ...]:
    """A header that stands behind a comment mark is read as if it did not."""
    bare = line.strip().lstrip("#%") if line.lstrip().startswith(("#", "%")) else line
    return tuple(cell.strip() for cell in split_cells(bare, form.separator))


def _refuse_ragged(table: Table) -> None:
    for row, line in enumerate(table.lines):
        cells = _count_cells(line, table.form.separator)
        if cells != table.width:
            raise DemonstrationError(
                f"{table.file}: line {table.line(row)} has {cells} cells, but the first row, "
                f"line {table.line(0)}, has {table.width}; complete or leave out the line."
            )
    if table.form.header and not _header_fits(table):
        raise DemonstrationError(
            f"{table.file}: the header names {len(table.names)} columns, but the rows have "
            f"{table.width} cells; check the separator and the header line."
        )


def _count_cells(line: str, separator: str | None) -> int:
    if separator is None or '"' in line:
        return len(split_cells(line, separator))
    return line.count(separator) + 1


def _header_fits(table: Table) -> bool:
    """As many names as cells, but for the empty one that a trailing separator makes."""
    named = len(table.names) - (table.names[-1:] == ("",))
    last = split_cells(table.lines[0], table.form.separator)[-1].strip()
    return named == table.width - (last == "") or len(table.names) == table.width
