"""Several demonstrations in one table: side by side, or one below the other."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from keyphase.errors import DemonstrationError, RecipeError
from keyphase.readers.recipes.recipe import NumberTime, Recipe, Split
from keyphase.readers.table import Table

MAX_PARTS = 100_000

_NAMELESS = "nameless"
"""The demonstration of rows in which the column that tells them apart is empty."""


def parts_of_table(table: Table, recipe: Recipe) -> tuple[str, ...]:
    """The demonstrations a table holds by this recipe, or none where it is one."""
    if recipe.parts:
        return tuple(recipe.parts)
    return () if recipe.split is None else tuple(_rows_by_part(table, recipe, recipe.split))


def recipe_of_part(recipe: Recipe, part: str | None, file: str) -> Recipe:
    """How to read one of the demonstrations that stand side by side.

    Raises DemonstrationError where there is none of this name.
    """
    if not recipe.parts:
        if part is not None and recipe.split is None:
            raise DemonstrationError(
                f"{file}: it is one recording by the recipe {recipe.name}; name it without "
                f"#{part[:80]}."
            )
        return recipe
    if part is None or part not in recipe.parts:
        raise _unknown(file, part, recipe.parts)
    return recipe.parts[part]


def rows_of_part(table: Table, recipe: Recipe, part: str | None) -> Table:
    """The rows of one of the demonstrations that stand one below the other."""
    if recipe.split is None:
        return table
    found = _rows_by_part(table, recipe, recipe.split)
    if part not in found:
        raise _unknown(table.file, part, found)
    rows = found[part]
    return replace(
        table,
        lines=[table.lines[row] for row in rows],
        line_numbers=[table.line_numbers[row] for row in rows],
    )


def _rows_by_part(table: Table, recipe: Recipe, split: Split) -> dict[str, list[int]]:
    names = _named_rows(table, recipe, split)
    found: dict[str, list[int]] = {}
    for row, name in enumerate(names):
        found.setdefault(name, []).append(row)
    if len(found) > MAX_PARTS:
        raise RecipeError(
            f"{table.file}: {recipe.name} makes {len(found)} demonstrations of it, more than "
            f"{MAX_PARTS}; check the column that tells them apart."
        )
    return found


def _named_rows(table: Table, recipe: Recipe, split: Split) -> list[str]:
    if split.column is not None:
        cells = table.text(split.column.find(table)[0])
        named = _names_of(dict.fromkeys(cells), recipe)
        return [named[cell] for cell in cells]
    if not isinstance(recipe.time, NumberTime):
        raise RecipeError(
            f"{recipe.name}: time_starts_again needs a column of time in numbers; "
            "name one in [time]."
        )
    time = table.numbers(recipe.time.column.find(table))[:, 0]
    return [str(number) for number in np.cumsum(np.diff(time, prepend=time[0]) < 0)]


def _names_of(cells: Iterable[str], recipe: Recipe) -> dict[str, str]:
    """What each demonstration is called; raises RecipeError where two would be called the same."""
    named: dict[str, str] = {}
    taken: dict[str, str] = {}
    for cell in cells:
        name = cell.replace("#", "_").replace("/", "_")[:100] or _NAMELESS
        other = taken.setdefault(name, cell)
        if other != cell:
            raise RecipeError(
                f"{recipe.name}: [table] demonstration: {other[:80]!r} and {cell[:80]!r} would "
                f"both be called {name!r}; write them differently."
            )
        named[cell] = name
    return named


def _unknown(file: str, part: str | None, parts: Iterable[str]) -> DemonstrationError:
    there = list(parts)
    shown = ", ".join(there[:5]) + (f", … ({len(there)} in all)" if len(there) > 5 else "")
    asked = "none was named" if part is None else f"there is no {part[:80]!r}"
    return DemonstrationError(
        f"{file}: expected one of the demonstrations in it, {shown}; {asked}; name it as "
        f"{file.rpartition('/')[2]}#{there[0]}."
    )
