"""One recording nobody has described yet, and how it would be read by what a person says of it."""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import DemonstrationError, KeyphaseError, RecipeError
from keyphase.files.parts import with_part
from keyphase.files.reading import DEFAULT_LIMIT_BYTES, read_whole
from keyphase.readers import RECIPE_SUFFIX, Recipe, parse_recipe, read
from keyphase.readers.finding import parts_of
from keyphase.readers.formats.known import format_of
from keyphase.readers.proposing.answered import recipe_text
from keyphase.readers.proposing.answers import Answers, answers_to, with_parts
from keyphase.readers.proposing.proposal import propose
from keyphase.readers.recipes.sections import ENCODINGS, SEPARATORS
from keyphase.readers.table import TableForm, open_table, split_cells
from keyphase.workbench.apart.apart import Calls, right_here

SHOWN_ROWS = 20
MAX_COLUMNS = 2000
PATH_POINTS, FORCE_POINTS = 240, 320
"""So much of the path and the force is shown of a recording before it is taken in."""

_SHOWN_TOOLS = 4

_LOOKED_AT_BYTES = 1 << 18


@dataclass(frozen=True)
class Look:
    """The recording as it would be read.

    name      which of the tools side by side in the file it is, "" where there is one
    path_m    (N, 3) [m]
    force_N   times [s] and sizes of the force [N], both (N,); None without a force
    notices   what would be done to it on reading
    """

    name: str
    samples: int
    duration_s: float
    rate_hz: float
    path_m: Array
    force_N: tuple[Array, Array] | None
    notices: tuple[str, ...]


@dataclass(frozen=True)
class Tried:
    """What a person's answers come to.

    names, rows  the table as it is split by them, at most `SHOWN_ROWS` rows
    missing      what is still to be said, or why the table cannot be read so
    looks        the recording, where it can be read; of two tools in it one each
    recipe       the recipe that the answers make, where nothing is missing
    """

    answers: Answers
    names: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    missing: tuple[str, ...] = ()
    looks: tuple[Look, ...] = ()
    recipe: str | None = None


class UnknownTable:
    """The recording at `path`, called `name` by people; `evidence` says why each column is
    proposed.

    It is a table of text, or columns of a binary format (`is_text`), of which the first of several
    recordings, `part`, is looked at; the others are read alike.

    `calls` says where what reads it is called.

    Raises DemonstrationError where it holds no numbers.
    """

    def __init__(
        self,
        path: Path,
        name: str,
        calls: Calls = right_here,
        limit_bytes: int = DEFAULT_LIMIT_BYTES,
    ) -> None:
        self.path, self.name = path, name
        self._calls, self._limit_bytes = calls, limit_bytes
        parts = calls(path, _recordings_in, path)
        self.part, self.others_inside = (parts[0], len(parts) - 1) if parts else (None, 0)
        self._first = with_part(path, self.part) if self.part else path
        self._proposal = proposal = calls(path, propose, self._first, limit_bytes)
        if len(proposal.names) > MAX_COLUMNS:
            raise DemonstrationError(
                f"{name}: the page shows at most {MAX_COLUMNS} columns, but there are "
                f"{len(proposal.names)}; `keyphase inspect --write` proposes a recipe for it."
            )
        self.is_text = proposal.layout is not None
        self.proposed = answers_to(proposal)
        self.clocks = proposal.others
        self.layout_evidence = dict(proposal.layout.evidence if proposal.layout else ())
        sides = [guess for side in proposal.sides.values() for guess in side]
        guesses = [*proposal.guesses, *sides]
        self.evidence = tuple(
            "; ".join(dict.fromkeys(r for g in guesses if column in g.columns for r in g.evidence))
            for column in range(len(proposal.names))
        )

    def tried(self, answers: Answers) -> Tried:
        """What these answers come to; what is wrong with them is told, not raised."""
        try:
            names, rows = self._split(answers)
        except KeyphaseError as error:
            return Tried(answers, (), (), (self._in_words(error),))
        answers = with_parts(answers, len(names))
        shown = Tried(answers, names, rows)
        try:
            text = recipe_text(answers, names)
            looks = self._looks(self.recipe(text))
        except KeyphaseError as error:
            return replace(shown, missing=answers.open() or (self._in_words(error),))
        return replace(shown, looks=looks, recipe=text)

    def recipe(self, text: str) -> Recipe:
        """A recipe's text, parsed. Raises RecipeError for what no recipe can say."""
        return parse_recipe(text, str(self.path.with_name(self.name + RECIPE_SUFFIX)))

    def _looks(self, recipe: Recipe) -> tuple[Look, ...]:
        """The first recording by a recipe, which may find two tools in it, or several tables."""
        parts = self._calls(self.path, parts_of, self.path, recipe)
        if not recipe.parts:
            return (self._look("", with_part(self.path, parts[0]) if parts else self.path, recipe),)
        # Of `take_0+left` and `take_0+right` the tool is the last word.
        return tuple(
            self._look(part.rpartition("+")[2], with_part(self.path, part), recipe)
            for part in parts[: min(_SHOWN_TOOLS, len(recipe.parts))]
        )

    def _look(self, name: str, recording: Path, recipe: Recipe) -> Look:
        demonstration = self._calls(self.path, _read, recording, recipe, self._limit_bytes)
        return _look(name, demonstration, tuple(map(self._in_words, demonstration.notices)))

    def _split(self, answers: Answers) -> tuple[tuple[str, ...], tuple[tuple[str, ...], ...]]:
        """Names of the columns, "" where they have none, and the first rows."""
        if not self.is_text:
            return self._proposal.names, self._proposal.rows
        data = read_whole(self.path, self._limit_bytes).data[:_LOOKED_AT_BYTES]
        data = data[: data.rfind(b"\n") + 1] or data
        table = open_table(self.name, data, _form(answers), self._limit_bytes)
        names = tuple(table.names[i] if i < len(table.names) else "" for i in range(table.width))
        separator = table.form.separator
        first = table.lines[:SHOWN_ROWS]
        return names, tuple(tuple(c.strip() for c in split_cells(r, separator)) for r in first)

    def _in_words(self, told: object) -> str:
        return str(told).replace(str(self.path), self.name).replace(f"{self.path.parent}/", "")


def _recordings_in(path: Path) -> tuple[str, ...]:
    """The recordings of a binary format in one file; none where it is one, or a table."""
    form = format_of(path)
    return () if form is None else form.parts(path)


def _read(recording: Path, recipe: Recipe, limit_bytes: int) -> Demonstration:
    return read(recording, recipe, limit_bytes=limit_bytes)


def _form(answers: Answers) -> TableForm:
    """The layout that was chosen. Raises RecipeError for one that no recipe can name."""
    if answers.separator not in SEPARATORS or answers.encoding not in ENCODINGS:
        raise RecipeError("Separator and encoding must be among those that recipes name.")
    separator, encoding = SEPARATORS[answers.separator], ENCODINGS[answers.encoding]
    return TableForm(
        separator,
        answers.skip_lines,
        answers.header,
        encoding,
        answers.decimal,
        answers.lines_after_header,
    )


def _look(name: str, demonstration: Demonstration, notices: tuple[str, ...]) -> Look:
    force = demonstration.force_N
    at = _spread(len(demonstration), FORCE_POINTS)
    return Look(
        name=name,
        samples=len(demonstration),
        duration_s=demonstration.duration_s,
        rate_hz=demonstration.rate_hz,
        path_m=demonstration.position_m[_spread(len(demonstration), PATH_POINTS)],
        force_N=None if force is None else (demonstration.time_s[at], _largest(force, at)),
        notices=notices,
    )


def _spread(count: int, most: int) -> np.ndarray:
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(int))


def _largest(force_N: Array, at: np.ndarray) -> Array:
    """The largest force from each shown moment to the next, so that no contact is left out."""
    return np.maximum.reduceat(np.linalg.norm(force_N, axis=1), at)
