"""A wrench in a file of its own, as sensors log it that the robot's recorder knows nothing of."""

import hashlib
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import RecipeError
from keyphase.files.parts import split_part
from keyphase.files.reading import read_whole
from keyphase.readers.formats.array_table import ArrayTable
from keyphase.readers.formats.known import format_of
from keyphase.readers.recipes.recipe import NumberTime, Recipe, WrenchFile
from keyphase.readers.table import Columned, open_table
from keyphase.readers.timing import refuse_not_increasing

STEM = "{stem}"
"""Stands in the path for the recording's name without its ending."""


@dataclass(frozen=True, eq=False)
class Beside:
    """The table of a wrench, of text or of a binary format, and the SHA-256 (hex) by which it is
    known: of its file, or of its numbers.
    """

    table: Columned
    sha256: str

    def with_recipe(self, sha256: str) -> str:
        """By what a recipe and this file are known together, so that another wrench is noticed."""
        return hashlib.sha256(f"{sha256} {self.sha256}".encode()).hexdigest()


def table_beside(recording: Path, recipe: Recipe, limit_bytes: int) -> Beside | None:
    """The table of the wrench, where the recipe names one.

    Raises RecipeError for a path that leads out of the recording's folder, DemonstrationError for
    a file that cannot be read. Of a binary file with many recordings it is the one called as the
    recording itself.
    """
    form = recipe.wrench_file
    if form is None:
        return None
    file, part = split_part(recording)
    path = file.parent / form.path.replace(STEM, file.stem)
    if file.parent.resolve() not in path.resolve().parents:
        raise RecipeError(
            f"{recipe.name}: [wrench_file]: path must lie in the recording's folder, but is "
            f"{form.path[:80]!r}; copy the file there."
        )
    binary = format_of(path)
    if binary is not None:
        inner = (part or "").partition("+")[0]
        arrays = binary.table(path, inner if inner in binary.parts(path) else None, limit_bytes)
        return Beside(arrays, arrays.fingerprint())
    whole = read_whole(path, limit_bytes)
    table = open_table(whole.name, whole.data, form.table, limit_bytes)
    return Beside(table, whole.source.sha256)


def clock_beside(table: Columned, form: WrenchFile, main: Columned, recipe: Recipe) -> Array:
    """Its times (N,) [s] on the recording's clock.

    Without `from_zero` both count from one zero, that of the recording. Raises DemonstrationError
    where they do not increase.
    """
    column = form.time.column.find(table)[0]
    seconds = form.time.size * table.numbers([column])[:, 0]

    def where(row: int) -> str:
        return f"{table.file}: line {table.line(row)}, {table.label(column)}"

    refuse_not_increasing(seconds, where)
    if form.time.from_zero:
        return np.asarray(seconds - seconds[0])
    clock = recipe.time
    if not isinstance(clock, NumberTime):
        return seconds
    seconds = seconds + _later_s(table, column, main, clock.column.find(main)[0])
    if clock.from_zero:
        return np.asarray(seconds - clock.size * main.numbers(clock.column.find(main))[0, 0])
    return seconds


def _later_s(table: Columned, column: int, main: Columned, clock: int) -> float:
    """By how much its zero is later than the recording's, where two bags say when they began."""
    if not isinstance(table, ArrayTable) or not isinstance(main, ArrayTable):
        return 0.0
    zeros = table.zeros.get(table.names[column]), main.zeros.get(main.names[clock])
    if zeros[0] is None or zeros[1] is None or zeros[0].clock or zeros[1].clock:
        return 0.0
    return 1e-9 * (zeros[0].own_ns - zeros[1].own_ns)
