"""Which columns of a table a recipe means: by name, by index from 0, or by a pattern."""

import difflib
import fnmatch
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from keyphase.errors import RecipeError
from keyphase.readers.table import Columned


@dataclass(frozen=True)
class Columns:
    """A choice of columns, as written in section `where` of a recipe.

    `chosen` is a list of names and indices, or one pattern of column names in which * stands for
    any text and ? for one character; the columns it matches are taken in the order of the table.
    (Patterns are no regular expressions: recipes travel with data, and one of those can hang.)
    """

    where: str
    chosen: tuple[str | int, ...] | str
    counts: tuple[int, ...]

    def find(self, table: Columned) -> list[int]:
        """Indices of the columns in `table`.

        Raises RecipeError where a name is missing or ambiguous, an index is outside the table, or
        the number of columns is not one of `counts`.
        """
        if isinstance(self.chosen, str):
            found = self._matching(self.chosen, table)
        else:
            found = [self._one(choice, table) for choice in self.chosen]
        if len(found) not in self.counts or len(set(found)) < len(found):
            expected = " or ".join(map(str, self.counts))
            raise RecipeError(
                f"{self.where}: expected {expected} different columns of {table.file}, but "
                f"{self._shown()} gives {len(set(found))}; correct the recipe."
            )
        return found

    def names_some_of(self, names: Sequence[str]) -> bool:
        """Whether all that it calls by a name is among these; a place by its index always is."""
        if isinstance(self.chosen, str):
            return any(map(_matcher(self.chosen), names))
        return all(choice in names for choice in self.chosen if isinstance(choice, str))

    def _shown(self) -> str:
        chosen = [self.chosen] if isinstance(self.chosen, str) else self.chosen
        return ", ".join(repr(choice)[:60] for choice in chosen[:4])

    def _matching(self, pattern: str, table: Columned) -> list[int]:
        self._refuse_without_names(table)
        matches = _matcher(pattern)
        return [i for i, name in enumerate(table.names[: table.width]) if matches(name)]

    def _one(self, choice: str | int, table: Columned) -> int:
        if isinstance(choice, int):
            if 0 <= choice < table.width:
                return choice
            raise RecipeError(
                f"{self.where}: expected column indices from 0 to {table.width - 1} for "
                f"{table.file}, but found {choice}; correct the recipe."
            )
        self._refuse_without_names(table)
        count = table.names[: table.width].count(choice)
        if count == 1:
            return table.names.index(choice)
        if count:
            raise RecipeError(
                f"{self.where}: the header of {table.file} names {choice[:80]!r} {count} times; "
                "choose the column by its index."
            )
        near = difflib.get_close_matches(choice[:80], table.names, n=1)
        hint = f"did you mean {near[0][:80]!r}?" if near else "choose one that is there."
        raise RecipeError(
            f"{self.where}: the header of {table.file} has no column {choice[:80]!r}; {hint}"
        )

    def _refuse_without_names(self, table: Columned) -> None:
        if not table.form.header:
            raise RecipeError(
                f"{self.where}: columns can be named only where the table has a header; "
                "choose them by index, from 0."
            )


def _matcher(pattern: str) -> Callable[[str], object]:
    return re.compile(fnmatch.translate(pattern.replace("[", "[[]"))).fullmatch
