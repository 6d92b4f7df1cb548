"""A recipe proposed for an unknown table, with the evidence for each line and what is left open."""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import DemonstrationError
from keyphase.files.reading import DEFAULT_LIMIT_BYTES, read_whole
from keyphase.readers.proposing.layout import Layout, layout_of
from keyphase.readers.proposing.roles import Guess, guesses_of
from keyphase.readers.table import Table, open_table

_LOOKED_AT_ROWS = 2000


@dataclass(frozen=True)
class Proposal:
    """How a table would be read if a person agrees.

    names   of the columns, or their numbers where there is no header
    open    what only a person knows, as the keys of a recipe: `wrench.frame`, `wrench.sign`, …
    """

    layout: Layout
    names: tuple[str, ...]
    guesses: tuple[Guess, ...]
    open: tuple[str, ...]

    def recipe_text(self) -> str:
        """The recipe as TOML, the evidence as comments; what is open stands as a comment, too."""
        lines = [*_table_lines(self.layout), *self._time_lines()]
        for guess in self.guesses:
            lines += self._section_lines(guess)
        roles = {guess.role for guess in self.guesses}
        if roles & {"force", "torque"}:
            lines += [
                "",
                "[wrench]",
                '# frame = "base"    # or "tool": in whose axes is the wrench written?',
                "# sign = 1          # 1: pressing down on a table gives a force upwards; else -1",
            ]
        return "\n".join(lines) + "\n"

    def _time_lines(self) -> list[str]:
        if any(guess.role == "time" for guess in self.guesses):
            return []
        return [
            "",
            "[time]",
            "# rate_hz = 100    # no column rises like a time: how many rows a second?",
        ]

    def _section_lines(self, guess: Guess) -> list[str]:
        chosen = [self.names[i] if self.layout.form.header else i for i in guess.columns]
        section = {"quaternion": "orientation", "euler": "orientation"}.get(guess.role, guess.role)
        lines = ["", *(f"# {reason}" for reason in guess.evidence), f"[{section}]"]
        if guess.detail == "seconds and nanoseconds":
            return [*lines, f"seconds = {_toml(chosen[0])}", f"nanoseconds = {_toml(chosen[1])}"]
        if guess.role == "time":
            lines.append(f"column = {_toml(chosen[0])}")
        else:
            kind = {"quaternion": '"quaternion"', "euler": '"euler"'}.get(guess.role)
            lines += [f"kind = {kind}"] if kind else []
            lines.append(f"columns = {_toml(chosen)}")
        if guess.role == "quaternion":
            lines.append(_said("order", guess.detail, '"wxyz" or "xyzw"'))
        elif guess.role == "euler":
            lines += ['# sequence = "xyz"    # fixed axes: roll, pitch, yaw; or "ZYX" and the like']
            lines.append(_said("unit", guess.unit, '"rad" or "deg"'))
        else:
            lines.append(_said("unit", guess.unit, "the unit of these numbers"))
        return lines


def propose(path: Path, limit_bytes: int = DEFAULT_LIMIT_BYTES) -> Proposal:
    """A proposal for the table at `path`.

    Raises DemonstrationError for what is no table of numbers.
    """
    file = read_whole(path, limit_bytes)
    try:
        layout = layout_of(file.data)
    except DemonstrationError as error:
        raise DemonstrationError(f"{file.name}: {error}") from error
    table = open_table(file.name, file.data, layout.form, limit_bytes)
    names = tuple(
        table.names[i] if i < len(table.names) and table.names[i] else f"column {i}"
        for i in range(table.width)
    )
    guesses = guesses_of(names, _numbers(table))
    return Proposal(layout, names, tuple(guesses), _open_questions(guesses))


def _open_questions(guesses: Sequence[Guess]) -> tuple[str, ...]:
    by_role = {guess.role: guess for guess in guesses}
    questions = [f"{role} is missing" for role in ("time", "position") if role not in by_role]
    questions += [
        f"{g.role}.unit" for g in guesses if not (g.unit or g.role == "quaternion" or g.detail)
    ]
    if "quaternion" in by_role and not by_role["quaternion"].detail:
        questions.append("orientation.order")
    if "euler" in by_role:
        questions.append("orientation.sequence")
    if "force" in by_role or "torque" in by_role:
        questions += ["wrench.frame", "wrench.sign"]
    return tuple(questions)


def _numbers(table: Table) -> Array:
    """The first rows as numbers (N, D); a column with anything else in it is NaN throughout."""
    values = np.full((min(len(table), _LOOKED_AT_ROWS), table.width), np.nan)
    for column in range(table.width):
        cells = table.text(column)[:_LOOKED_AT_ROWS] if table.quoted else None
        try:
            numbers = _parsed(table, column, cells)
        except ValueError:
            continue
        values[:, column] = numbers
    return values


def _parsed(table: Table, column: int, cells: list[str] | None) -> list[float]:
    if cells is None:
        separator = table.form.separator
        cells = [line.split(separator)[column] for line in table.lines[:_LOOKED_AT_ROWS]]
    return [float(cell.strip().replace(table.form.decimal, ".")) for cell in cells]


def _table_lines(layout: Layout) -> list[str]:
    form, evidence = layout.form, layout.evidence
    values = {
        "encoding": (layout.encoding, "utf-8"),
        "separator": (layout.separator, ","),
        "decimal": (form.decimal, "."),
    }
    lines = [
        f"{key} = {_toml(value)}    # {evidence[key]}"
        for key, (value, usual) in values.items()
        if value != usual
    ]
    lines += [f"skip_lines = {form.skip_lines}"] if form.skip_lines else []
    lines += [] if form.header else [f"header = false    # {evidence['header']}"]
    return ["[table]", *lines] if lines else []


def _said(key: str, value: str, question: str) -> str:
    return f"{key} = {_toml(value)}" if value else f"# {key} =    # {question}"


def _toml(value: object) -> str:
    """Texts, numbers and lists are written alike in TOML and JSON."""
    return json.dumps(value, ensure_ascii=False)
