"""Which column is the time, in numbers, two parts or dates; and what tells demonstrations apart."""

import re
from collections.abc import Sequence
from datetime import datetime
from itertools import pairwise

import numpy as np

from keyphase.demonstration import Array
from keyphase.readers.proposing.guess import Guess, measured_rows
from keyphase.readers.proposing.naming import (
    COUNTER,
    DEMONSTRATION,
    TIME,
    elements_of_vectors,
    unit_in,
)

RESTARTS = "time starts again"
"""Detail of a time that falls back where another demonstration begins."""

_NEAR_BEGIN = 0.1

_MIN_RATE_HZ, _MAX_RATE_HZ = 2.0, 5000.0
_TIME_UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
_SINCE_1970_S = 1e9
_SLOW = {"min": 60.0}
"""Read only where a name says it."""
_FORMATS = (
    *("%Y-%m-%d %H:%M:%S.%f", "%Y-%m-%d %H:%M:%S", "%Y/%m/%d %H:%M:%S.%f", "%Y/%m/%d %H:%M:%S"),
    *("%d.%m.%Y %H:%M:%S.%f", "%d.%m.%Y %H:%M:%S,%f", "%d.%m.%Y %H:%M:%S"),
    *("%Y-%m-%d_%H-%M-%S-%f", "%Y%m%d_%H%M%S_%f", "%H:%M:%S.%f", "%H:%M:%S,%f", "%H:%M:%S:%f"),
)
"""Each can be read in one way only: the month before the day, or with points after it."""


def time_of_numbers(names: Sequence[str], values: Array, free: Sequence[int]) -> Guess | None:
    """The column that rises as a time does, or falls only where a demonstration begins anew."""
    two = _two_part_time(names, free) or _two_parts_by_numbers(values, free)
    if two is not None:
        return two
    elements = elements_of_vectors(names)
    rising = [i for i in free if _rises(values[:, i]) and not _is_counter(names[i], values[:, i])]
    named = [i for i in rising if TIME.search(names[i]) and i not in elements]
    if not named and not (rising and rising[0] == 0):
        return _restarting(names, values, free)
    return _time_of(names, values, (named or rising)[0], bool(named))


def clock_guess(names: Sequence[str], values: Array, column: int) -> Guess | None:
    """What is known of a column that is said to be a clock."""
    return _time_of(names, values, column, named=True)


def is_clock(name: str, values: Array) -> bool:
    """Whether numbers (N,) rise like a time and are called so; no element of a vector is one."""
    return bool(TIME.search(name)) and _rises(values) and not _is_counter(name, values)


def _time_of(names: Sequence[str], values: Array, column: int, named: bool) -> Guess | None:
    seen = measured_rows(values, (column,))[:, 0]
    unit, step = _unit_and_step(names[column], seen)
    if not (named or unit):
        return None
    why = f"steps of {step:.6g}: {unit or '?'}, which makes {_rate(step, unit)}"
    return Guess("time", (column,), unit, "", (why, "the column never falls"))


def _unit_and_step(name: str, seen: Array) -> tuple[str, float]:
    steps = np.diff(seen)
    step = float(np.median(steps[steps > 0]))
    if not (possible := _possible_units(step)):
        # Topics that are merged follow each other at once: then their mean says more.
        step = float(np.mean(steps))
        possible = _possible_units(step)
    told = unit_in(name, {**_TIME_UNITS, **_SLOW})
    return told or (possible[0] if len(possible) == 1 else _by_size(step, possible)), step


def _possible_units(step: float) -> list[str]:
    """The units in which a step makes a rate that a recorder has."""
    rates = {unit: 1 / (step * size) for unit, size in _TIME_UNITS.items()}
    return [unit for unit, rate in rates.items() if _MIN_RATE_HZ <= rate <= _MAX_RATE_HZ]


def _restarting(names: Sequence[str], values: Array, free: Sequence[int]) -> Guess | None:
    for column in free:
        seen = measured_rows(values, (column,))[:, 0]
        falls = int((np.diff(seen) < 0).sum())
        if TIME.search(names[column]) and 0 < falls <= len(seen) // 20 and np.ptp(seen) > 0:
            unit, step = _unit_and_step(names[column], seen)
            why = f"steps of {step:.6g}: {unit or '?'}, which makes {_rate(step, unit)}"
            if not _starts_over(seen):
                back = f"the clock was set back {falls} times: read it in pieces, or mend it"
                return Guess("time", (column,), unit, "", (why, back))
            told = f"it falls back {falls} times: a demonstration begins there"
            return Guess("time", (column,), unit, RESTARTS, (why, told))
    return None


def _starts_over(seen: Array) -> bool:
    """Whether time falls to near where it began, as of another demonstration, each time."""
    after = np.flatnonzero(np.diff(seen) < 0) + 1
    return bool((seen[after] <= seen[0] + _NEAR_BEGIN * (seen[: after[0]].max() - seen[0])).all())


def _rises(values: Array) -> bool:
    seen = values[np.isfinite(values)]
    return len(seen) > 1 and bool((np.diff(seen) >= 0).all()) and bool(np.ptp(seen) > 0)


def _is_counter(name: str, values: Array) -> bool:
    """A number of the row says nothing of the time."""
    if DEMONSTRATION.search(name):
        return True
    seen = values[np.isfinite(values)]
    by_one = bool((np.diff(seen) == 1).all())
    return by_one and (not TIME.search(name) or bool(COUNTER.search(name)))


def demonstrations_of(names: Sequence[str], cells: Sequence[Sequence[str]]) -> Guess | None:
    """A column whose word or number holds for many rows and changes between demonstrations.

    `cells` are the first cells of each column, as text; none for a column that is not looked at.
    """
    for column, name in enumerate(names):
        seen = cells[column]
        if not DEMONSTRATION.search(name) or not seen:
            continue
        changes = sum(a != b for a, b in pairwise(seen))
        if 0 < changes <= len(seen) // 20:
            told = f"{changes + 1} demonstrations in the rows looked at"
            return Guess("demonstration", (column,), "", "", (told,))
    return None


def stamps_of(cells: Sequence[Sequence[str]]) -> Guess | None:
    """The first column of dates or times of day, with the format that reads all that were seen."""
    for column, seen in enumerate(cells):
        form = _format_of(seen) if seen else None
        if form is not None:
            told = f"{seen[0]!r} is a date or a time of day"
            return Guess("time", (column,), "", form, (told,))
    return None


def _format_of(seen: Sequence[str]) -> str | None:
    return next((form for form in ("iso", *_FORMATS) if _reads(seen[:20], form)), None)


def _reads(cells: Sequence[str], form: str) -> bool:
    """Whether a format reads all of these; a number such as 20250101 is no ISO stamp here."""
    try:
        for cell in cells:
            if form != "iso":
                datetime.strptime(cell, form)
            elif len(cell) < len("2025-01-01T10:00") or ":" not in cell:
                return False
            else:
                datetime.fromisoformat(cell)
    except ValueError:
        return False
    return True


def _two_part_time(names: Sequence[str], free: Sequence[int]) -> Guess | None:
    """Whole seconds and nanoseconds in two columns of one beginning."""
    for i in free:
        begin = re.fullmatch(r"(.*?)n(?:ano)?sec(s|onds)?", names[i], re.I)
        seconds = begin and [
            k for k in free if re.fullmatch(re.escape(begin[1]) + r"sec(s|onds)?", names[k], re.I)
        ]
        if seconds:
            evidence = ("seconds and nanoseconds in two columns",)
            return Guess("time", (seconds[0], i), "", "seconds and nanoseconds", evidence)
    return None


def _two_parts_by_numbers(values: Array, free: Sequence[int]) -> Guess | None:
    """The same in the first two columns, whatever they are called: whole seconds since 1970 that
    stand still while whole nanoseconds beside them run.
    """
    if list(free[:2]) != [0, 1]:
        return None
    rows = measured_rows(values, (0, 1))
    whole = len(rows) > 1 and bool((rows == np.round(rows)).all())
    if not whole or rows[:, 0].min() < _SINCE_1970_S or rows[:, 1].min() < 0:
        return None
    seconds, rest = np.diff(rows[:, 0]), np.diff(rows[:, 1])
    runs = bool((seconds * 1e9 + rest > 0).all()) and rows[:, 1].max() < 1e9
    if not (runs and (seconds == 0).mean() > 0.5 and rows[:, 1].max() > 1e6):
        return None
    evidence = ("whole seconds since 1970, and whole nanoseconds that run beside them",)
    return Guess("time", (0, 1), "", "seconds and nanoseconds", evidence)


def _by_size(step: float, possible: Sequence[str]) -> str:
    """Whole steps of at least one are rarely seconds."""
    if step >= 1 and "ms" in possible:
        return "ms"
    return possible[0] if possible else ""


def _rate(step: float, unit: str) -> str:
    size = {**_TIME_UNITS, **_SLOW}.get(unit)
    return f"{1 / (step * size):.6g} Hz" if size else "no rate that a recorder has"
