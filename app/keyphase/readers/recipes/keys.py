"""One section of a recipe: keys taken out one by one and checked, and what is left refused."""

import difflib
import math
from collections.abc import Mapping, Sequence
from typing import Any, Literal, TypeVar

from keyphase.errors import RecipeError
from keyphase.readers.recipes.columns import Columns
from keyphase.readers.recipes.units import Quantity, unit_size

_Choice = TypeVar("_Choice")
_MAX_TEXT_LENGTH = 1000


class Keys:
    """The keys of one section; what nobody asked for is refused by `finish`.

    Every method raises RecipeError, naming recipe, section and key.
    """

    def __init__(self, values: Mapping[str, Any], where: str) -> None:
        self.where = where
        self._values = dict(values)
        self._known: list[str] = []

    def section(self, key: str) -> "Keys | None":
        """A section of this name, or None where there is none."""
        value = self._take(key)
        if value is None:
            return None
        if not isinstance(value, dict):
            raise self._wrong(key, "a section", value)
        return Keys(value, f"{self.where}: [{key}]")

    def needed_section(self, key: str) -> "Keys":
        """A section that must be there."""
        section = self.section(key)
        if section is None:
            raise RecipeError(f"{self.where}: the section [{key}] is missing; add it.")
        return section

    def text(self, key: str, default: str | None = None, expected: str = "a text") -> str:
        """A text; required where there is no default, `expected` to be what is told then."""
        value = self._required(key, default, expected)
        if not isinstance(value, str) or not 0 < len(value) <= _MAX_TEXT_LENGTH:
            raise self._wrong(key, "a text", value)
        return value

    def choice(
        self, key: str, choices: Mapping[str, _Choice], default: str | None = None
    ) -> _Choice:
        """What stands for one of the words of `choices`."""
        expected = f"one of {', '.join(map(repr, choices))}"
        word = self.text(key, default, expected)
        if word in choices:
            return choices[word]
        near = difflib.get_close_matches(word[:60], choices, n=1)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise self._wrong(key, expected, word, hint)

    def flag(self, key: str, default: bool) -> bool:
        """True or false."""
        value = self._required(key, default)
        if not isinstance(value, bool):
            raise self._wrong(key, "true or false", value)
        return value

    def count(self, key: str, default: int) -> int:
        """A whole number, not negative."""
        value = self._required(key, default)
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < 2**31:
            raise self._wrong(key, "a whole number from 0", value)
        return value

    def positive(self, key: str) -> float | None:
        """A positive finite number, or None where the key is not there."""
        value = self._take(key)
        if value is None:
            return None
        number = _finite(value)
        if number is None or number <= 0:
            raise self._wrong(key, "a positive number", value)
        return number

    def number(self, key: str) -> float | None:
        """A finite number, or None where the key is not there."""
        value = self._take(key)
        number = None if value is None else _finite(value)
        if value is not None and number is None:
            raise self._wrong(key, "a number", value)
        return number

    def sign(self) -> Literal[1, -1]:
        """Plus or minus one under `sign`."""
        expected = "1 (what acts on the tool) or -1 (what the tool exerts)"
        value = self._required("sign", None, expected)
        match value:
            case int(1) if value is not True:
                return 1
            case int(-1):
                return -1
        raise self._wrong("sign", expected, value)

    def vector(self, key: str) -> tuple[float, float, float] | None:
        """Three finite numbers, or None where the key is not there."""
        value = self._take(key)
        if value is None:
            return None
        numbers = [_finite(item) for item in value] if isinstance(value, list) else []
        match numbers:
            case [float(x), float(y), float(z)]:
                return x, y, z
        raise self._wrong(key, "three numbers", value)

    def unit(self, quantity: Quantity) -> float:
        """The size of the unit under `unit`; never taken for granted."""
        return unit_size(self.text("unit"), quantity, self.where)

    def columns(self, counts: Sequence[int]) -> Columns:
        """The choice of columns under `columns`."""
        value = self._required("columns", None)
        if isinstance(value, list) and value and all(_is_column(item) for item in value):
            return Columns(self.where, tuple(value), tuple(counts))
        if isinstance(value, str) and 0 < len(value) <= _MAX_TEXT_LENGTH:
            return Columns(self.where, value, tuple(counts))
        raise self._wrong("columns", "a list of names or indices, or one pattern", value)

    def column(self, key: str = "column") -> Columns | None:
        """The one column under `key`, by name or index, or None where the key is not there."""
        value = self._take(key)
        if value is None:
            return None
        if not _is_column(value):
            raise self._wrong(key, "a name or an index", value)
        return Columns(self.where, (value,), (1,))

    def names(self) -> tuple[str, ...]:
        """All keys of a section in which any name can stand; they are known from now on."""
        self._known += self._values
        return tuple(self._values)

    def column_and_clock(self, key: str) -> tuple[Columns, Columns | None]:
        """A column by name or index, or `{column = …, time = …}` with a clock of its own."""
        if not isinstance(self._values[key], dict):
            column = self.column(key)
            assert column is not None
            return column, None
        inner = Keys(self._values[key], f"{self.where}: {key}")
        column, clock = inner.column(), inner.column("time")
        if column is None:
            raise RecipeError(f"{inner.where}: the key 'column' is missing; add it.")
        inner.finish()
        return column, clock

    def has(self, key: str) -> bool:
        """Whether the key is there; it is known from now on."""
        self._known.append(key)
        return key in self._values

    def finish(self) -> None:
        """Refuse the first key that was never asked for."""
        unknown = next((key for key in self._values if key not in self._known), None)
        if unknown is None:
            return
        known = list(dict.fromkeys(self._known))
        near = difflib.get_close_matches(unknown[:60], known, n=1)
        hint = f"did you mean {near[0]!r}?" if near else "leave it out."
        raise RecipeError(
            f"{self.where}: {unknown[:60]!r} is not a word that can stand here, which are "
            f"{', '.join(known)}; {hint}"
        )

    def _take(self, key: str) -> Any:
        return self._values[key] if self.has(key) else None

    def _required(self, key: str, default: Any, expected: str = "") -> Any:
        value = self._take(key)
        if value is None and default is None:
            told = f", which is {expected}" if expected else ""
            raise RecipeError(f"{self.where}: the key {key!r} is missing{told}; add it.")
        return default if value is None else value

    def _wrong(self, key: str, expected: str, came: Any, hint: str = "") -> RecipeError:
        return RecipeError(
            f"{self.where}: {key} must be {expected}, but is {_shown(came)}{hint or '.'}"
        )


def _is_column(value: Any) -> bool:
    if isinstance(value, str):
        return 0 < len(value) <= _MAX_TEXT_LENGTH
    return isinstance(value, int) and not isinstance(value, bool)


def _finite(value: Any) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    try:
        number = float(value)
    except OverflowError:
        return None
    return number if math.isfinite(number) else None


def _shown(value: Any) -> str:
    try:
        return repr(value)[:60]
    except ValueError:
        return "a number of too many digits"
