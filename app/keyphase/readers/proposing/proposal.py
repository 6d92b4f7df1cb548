"""A recipe proposed for an unknown recording, with the evidence for each line and what is open."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import DemonstrationError
from keyphase.files.parts import split_part
from keyphase.files.reading import DEFAULT_LIMIT_BYTES, read_whole
from keyphase.readers.foreign import foreign_kind
from keyphase.readers.formats.known import format_of
from keyphase.readers.formats.reader import split_side
from keyphase.readers.proposing.columns import Looked, looked_at_arrays, looked_at_table
from keyphase.readers.proposing.conventions import UNNAMED
from keyphase.readers.proposing.frames import other_transforms
from keyphase.readers.proposing.guess import Guess, measured_rows
from keyphase.readers.proposing.layout import Layout, layout_of
from keyphase.readers.proposing.roles import guesses_of
from keyphase.readers.proposing.sides import sides_of
from keyphase.readers.proposing.times import (
    RESTARTS,
    clock_guess,
    demonstrations_of,
    stamps_of,
    time_of_numbers,
)
from keyphase.readers.proposing.written import (
    guess_lines,
    maybe_clock_lines,
    maybe_wrench_lines,
    preset_lines,
    rows_lines,
    section_of,
    table_lines,
    toml,
    unread_lines,
    without_time,
)
from keyphase.readers.recipes.presets import (
    ROBOT_QUESTIONS,
    WRENCH_QUESTIONS,
    fitting_preset,
    left_open,
)
from keyphase.readers.table import open_table

_MAX_REMARKS = 10


@dataclass(frozen=True)
class Proposal:
    """How a recording would be read if a person agrees.

    layout  of the text, None for a binary format
    names   of the columns, or their numbers where there is no header
    open    what only a person knows, as the keys of a recipe: `wrench.frame`, `wrench.sign`, …
    clocks  the clock of a section where it has its own
    split   the column that tells several demonstrations apart
    preset  the one that knows these columns, with what it leaves open by section; else None
    gaps    sections with cells without a number
    remarks what the file says of its columns
    sides   what belongs to the left and the right of two tools; else none
    others  further columns that rise like a time
    rows    the first rows as text, "" where a stream has none; of arrays alone
    repeats how many of the rows looked at have the time of the row before
    """

    layout: Layout | None
    names: tuple[str, ...]
    guesses: tuple[Guess, ...]
    open: tuple[str, ...]
    clocks: dict[str, str] = field(default_factory=dict)
    split: Guess | None = None
    preset: tuple[str, dict[str, list[str]]] | None = None
    gaps: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    sides: dict[str, tuple[Guess, ...]] = field(default_factory=dict)
    others: tuple[str, ...] = ()
    rows: tuple[tuple[str, ...], ...] = ()
    repeats: int = 0

    def recipe_text(self) -> str:
        """The recipe as TOML, the evidence as comments; what is open stands as a comment, too."""
        restarts = any(guess.detail == RESTARTS for guess in self.guesses)
        lines = table_lines(self.layout, self.split, restarts, self.names)
        if self.preset is not None:
            return "\n".join([*preset_lines(*self.preset), "", *lines]).rstrip() + "\n"
        if not any(guess.role == "time" for guess in self.guesses):
            lines += without_time(self.layout.rate_hz if self.layout else None)
        lines += self._sections([g for g in self.guesses if g.role == "time"])
        if not self.sides:
            lines += self._sections([g for g in self.guesses if g.role != "time"])
        for side, guesses in self.sides.items():
            lines += ["", "[[demonstration]]", f"name = {toml(side)}"]
            lines += self._sections(guesses, "demonstration.", f"{side}.")
        lines += rows_lines(self.gaps, self.repeats)
        lines += unread_lines(self.unread)
        return "\n".join([*lines, *self._maybe_wrench()]) + "\n"

    def _maybe_wrench(self) -> list[str]:
        left = [i for i, name in enumerate(self.names) if name in self.unread]
        unnamed = all(UNNAMED.fullmatch(self.names[i]) for i in left)
        told = not unnamed or any(g.role in ("force", "torque") for g in self.guesses)
        behind = left == list(range(len(self.names) - len(left), len(self.names)))
        has_names = self.layout is None or self.layout.form.header
        return maybe_wrench_lines(
            [self.names[i] if has_names else i for i in left], told or not behind
        )

    @property
    def unread(self) -> tuple[str, ...]:
        """Columns that the recipe would not read."""
        guesses = [*self.guesses, *(g for side in self.sides.values() for g in side)]
        used = {column for guess in guesses for column in guess.columns}
        used |= set(self.split.columns) if self.split else set()
        clocks = set(self.clocks.values())
        return tuple(
            name for i, name in enumerate(self.names) if i not in used and name not in clocks
        )

    def _sections(self, guesses: Sequence[Guess], inside: str = "", side: str = "") -> list[str]:
        lines: list[str] = []
        for guess in guesses:
            clock = self.clocks.get(f"{side}{section_of(guess)}")
            lines += guess_lines(guess, self._chosen(guess), clock, inside)
            if self.layout and clock is None and guess.role in ("force", "torque"):
                lines += maybe_clock_lines(self.others)
        roles = {guess.role for guess in guesses}
        if "joints" in roles and not roles & {"position", "pose"}:
            lines += ["", f"[{inside}robot]", *ROBOT_QUESTIONS]
        if roles & {"force", "torque"}:
            remarks = [f"# {remark}" for remark in self.remarks[:_MAX_REMARKS]]
            lines += ["", *remarks, f"[{inside}wrench]", *WRENCH_QUESTIONS.values()]
        return lines

    def _chosen(self, guess: Guess) -> list[str | int]:
        has_names = self.layout is None or self.layout.form.header
        return [
            self.names[i] if has_names and self.names.count(self.names[i]) == 1 else i
            for i in guess.columns
        ]


def propose(path: Path, limit_bytes: int = DEFAULT_LIMIT_BYTES) -> Proposal:
    """A proposal for the recording at `path`, a table or one of a binary format.

    Raises DemonstrationError for what holds no numbers, MissingPackageError where the format's
    package is not installed.
    """
    file, part = split_part(path)
    form = format_of(file)
    if form is not None:
        inner, _ = split_side(form, file, part)
        return _of_arrays(looked_at_arrays(form.table(file, inner, limit_bytes)))
    return propose_table(file, limit_bytes)


def propose_table(path: Path, limit_bytes: int = DEFAULT_LIMIT_BYTES) -> Proposal:
    """A proposal for a table of text. Raises DemonstrationError for what is none."""
    whole = read_whole(path, limit_bytes)
    if (foreign := foreign_kind(whole.data)) is not None:
        raise DemonstrationError(f"{whole.name}: expected a recording, but {foreign}.")
    try:
        layout = layout_of(whole.data)
    except DemonstrationError as error:
        raise DemonstrationError(f"{whole.name}: {error}") from error
    table = open_table(whole.name, whole.data, layout.form, limit_bytes)
    return _of_table(looked_at_table(table, layout), layout)


def _of_table(looked: Looked, layout: Layout) -> Proposal:
    preset = _preset_of(looked.names)
    told = looked.told
    split = demonstrations_of(looked.names, looked.cells)
    taken = split.columns if split else ()
    numeric = np.atleast_1d(np.isfinite(looked.values).any(axis=0))
    free = [i for i in range(len(told)) if numeric[i] and i not in taken]
    rows = looked.first_demonstration(split)
    time = time_of_numbers(told, rows, free) or stamps_of(looked.texts)
    taken = (*taken, *(time.columns if time else ()))
    found = tuple(guesses_of(told, looked.values, taken))
    sides = sides_of(looked, found, taken)
    others = tuple(looked.names[i] for i in looked.clocks() if i not in taken)
    guesses = ((time,) if time else ()) + next(iter(sides.values()), found)
    gaps = tuple(section_of(g) for g in guesses if g.role != "time" and looked.has_gaps(g.columns))
    questions = _open_questions(guesses) if preset is None else tuple(preset[1])
    return Proposal(
        layout=layout,
        names=looked.names,
        guesses=guesses,
        open=questions,
        split=split,
        preset=preset,
        gaps=gaps,
        sides=sides,
        others=others,
        repeats=0 if gaps else _repeats(time, rows),
    )


def _repeats(time: Guess | None, rows: Array) -> int:
    """Of a time in one column of numbers; none where most repeat: then it is no clock."""
    if time is None or len(time.columns) != 1 or not np.isfinite(rows[:, time.columns[0]]).any():
        return 0
    repeats = int((np.diff(measured_rows(rows, time.columns)[:, 0]) == 0).sum())
    return repeats if 2 * repeats < len(rows) else 0


def _of_arrays(looked: Looked) -> Proposal:
    """Of arrays each of which may have its own clock; that of the place is the main one."""
    preset = _preset_of(looked.names)
    clocks = looked.clocks()
    passed_over = other_transforms(looked.names, looked.values, looked.remarks)
    taken = (*clocks, *passed_over)
    found = tuple(guesses_of(looked.told, looked.values, taken))
    sides = sides_of(looked, found, taken)
    placed = next(iter(sides.values()), found)
    leading = next((g for r in ("pose", "position", "joints") for g in placed if g.role == r), None)
    main = looked.clock_of(leading, clocks) if leading else next(iter(clocks), None)
    if main is not None:
        time = clock_guess(looked.told, looked.values, main)
    else:
        used = {column for guess in found for column in guess.columns}
        free = [i for i in range(len(looked.told)) if i not in used]
        time = time_of_numbers(looked.told, looked.values, free)
    guesses = ((time,) if time else ()) + placed
    own, without = _own_clocks(looked, sides or {"": found}, leading, main)
    return Proposal(
        layout=None,
        names=looked.names,
        guesses=guesses,
        open=tuple(preset[1]) if preset else (*_open_questions(guesses), *without),
        clocks=own,
        preset=preset,
        gaps=tuple(section_of(g) for g in placed if looked.has_gaps(g.columns)),
        remarks=looked.remarks,
        sides=sides,
        others=tuple(looked.names[clock] for clock in clocks),
        rows=looked.first_rows(),
    )


def _own_clocks(
    looked: Looked, sides: dict[str, tuple[Guess, ...]], leading: Guess | None, main: int | None
) -> tuple[dict[str, str], list[str]]:
    """The clocks of sections that do not follow the main one, and sections whose clock is open."""
    own, without = dict[str, str](), list[str]()
    clocks = looked.clocks()
    for side, guesses in sides.items():
        for guess in guesses:
            section = f"{side}.{section_of(guess)}" if side else section_of(guess)
            clock = looked.clock_of(guess, clocks)
            if clock is not None and main is not None and clock != main:
                own[section] = looked.names[clock]
            elif clock is None and looked.length(guess) != (
                looked.length(leading) if leading else 0
            ):
                without.append(f"{section}.time")
    return own, without


def _preset_of(names: Sequence[str]) -> tuple[str, dict[str, list[str]]] | None:
    name = fitting_preset(names)
    return None if name is None else (name, left_open(name))


def _open_questions(guesses: Sequence[Guess]) -> tuple[str, ...]:
    by_role = {guess.role: guess for guess in guesses}
    placed = "position" in by_role or "pose" in by_role
    questions = [] if "time" in by_role else ["time is missing"]
    questions += [] if placed else ["robot" if "joints" in by_role else "position is missing"]
    without_unit = ("quaternion", "rot6d", "matrix", "demonstration")
    questions += [
        f"{g.role}.unit" for g in guesses if not (g.unit or g.role in without_unit or g.detail)
    ]
    questions += [f"{g.role}.columns" for g in guesses if g.is_one_of_several]
    if "quaternion" in by_role and not by_role["quaternion"].detail:
        questions.append("orientation.order")
    questions += ["orientation.sequence"] if "euler" in by_role else []
    questions += ["orientation.kind"] if "turn" in by_role else []
    questions += ["orientation.layout"] if "matrix" in by_role else []
    if "force" in by_role or "torque" in by_role:
        questions += ["wrench.frame", "wrench.sign"]
    return tuple(questions)
