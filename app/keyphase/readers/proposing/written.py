"""A proposal as the text of a recipe: evidence and what is open stand in it as comments."""

import json
from collections.abc import Mapping, Sequence

from keyphase.readers.proposing.guess import Guess
from keyphase.readers.proposing.layout import Layout
from keyphase.readers.proposing.times import RESTARTS

_SECTIONS = {
    **dict.fromkeys(("quaternion", "euler", "turn", "rot6d", "matrix"), "orientation"),
}
_KINDS = ("quaternion", "euler", "rot6d", "matrix")
_MAX_SHOWN, _MAX_CLOCKS = 30, 4


def section_of(guess: Guess) -> str:
    """The section of a recipe in which it stands."""
    return _SECTIONS.get(guess.role, guess.role)


def table_lines(
    layout: Layout | None, split: Guess | None, restarts: bool, names: Sequence[str]
) -> list[str]:
    """How the text is laid out, and what tells demonstrations in it apart."""
    lines = [] if layout is None else _layout_lines(layout)
    if split is not None:
        lines.append(f"demonstration = {toml(names[split.columns[0]])}    # {split.evidence[0]}")
    elif restarts:
        lines.append("time_starts_again = true")
    return ["[table]", *lines] if lines else []


def rows_lines(gaps: Sequence[str], repeats: int) -> list[str]:
    """What is done about rows that are not as they should be, and why."""
    lines: list[str] = []
    if gaps:
        lines += [f"# {', '.join(gaps)}: not in all rows is there a number", 'empty = "leave_out"']
    if repeats:
        lines += [f"# {repeats} of the rows looked at have the time of the row before"]
        lines += ['repeated = "drop"']
    return ["", "[rows]", *lines] if lines else []


def _layout_lines(layout: Layout) -> list[str]:
    form, evidence = layout.form, layout.evidence
    values = {
        "encoding": (layout.encoding, "utf-8"),
        "separator": (layout.separator, ","),
        "decimal": (form.decimal, "."),
    }
    lines = [
        f"{key} = {toml(value)}    # {evidence[key]}"
        for key, (value, usual) in values.items()
        if value != usual
    ]
    lines += [f"skip_lines = {form.skip_lines}"] if form.skip_lines else []
    if form.lines_after_header:
        lines.append(f"lines_after_header = {form.lines_after_header}    # {evidence['below']}")
    return lines + ([] if form.header else [f"header = false    # {evidence['header']}"])


def guess_lines(
    guess: Guess, chosen: Sequence[str | int], clock: str | None, inside: str = ""
) -> list[str]:
    """One section; `chosen` are its columns by name or index, `clock` its own or None."""
    section = f"[{inside}{section_of(guess)}]"
    lines = ["", *(f"# {reason}" for reason in guess.evidence), section]
    if guess.role == "time":
        return lines + _time_lines(guess, chosen)
    lines += [f"kind = {toml(guess.role)}"] if guess.role in _KINDS else []
    doubtful = "# " if guess.is_one_of_several else ""
    lines.append(f"{doubtful}columns = {toml(list(chosen))}")
    lines += _detail_lines(guess)
    if guess.role not in ("quaternion", "rot6d", "matrix"):
        lines.append(_said("unit", guess.unit, "the unit of these numbers"))
    return lines + ([f"time = {toml(clock)}"] if clock else [])


def _detail_lines(guess: Guess) -> list[str]:
    match guess.role:
        case "quaternion":
            return [_said("order", guess.detail, '"wxyz" or "xyzw"'), "normalise = true"]
        case "euler":
            likely = guess.detail or "xyz"
            told = "small letters: about the fixed axes, as roll, pitch, yaw; else the turned ones"
            return [f"# sequence = {toml(likely)}    # {told}"]
        case "turn":
            return ['# kind = "rotation_vector"    # or kind = "euler" with sequence = "xyz"']
        case "pose" | "matrix":
            return [_said("layout", guess.detail, '"row_major" or "column_major"')]
    return []


def _time_lines(guess: Guess, chosen: Sequence[str | int]) -> list[str]:
    if guess.detail == "seconds and nanoseconds":
        return [f"seconds = {toml(chosen[0])}", f"nanoseconds = {toml(chosen[1])}"]
    lines = [f"column = {toml(chosen[0])}"]
    if guess.detail and guess.detail != RESTARTS:
        return [*lines, f"format = {toml(guess.detail)}"]
    return [*lines, _said("unit", guess.unit, '"s", "ms", "us" or "ns"'), "from_zero = true"]


def maybe_clock_lines(others: Sequence[str]) -> list[str]:
    """What is asked where a table has more than one column that rises like a time."""
    if not 0 < len(others) <= _MAX_CLOCKS:
        return []
    asked = " or ".join(toml(name) for name in others)
    return [f"# time = {asked}    # rises like a time, too: is it the clock of these?"]


def without_time(stated_hz: float | None) -> list[str]:
    """What is asked where no column rises like a time; `stated_hz` seems to be the rate."""
    asked = "# rate_hz = 100    # no column rises like a time: how many rows a second?"
    if stated_hz is not None:
        asked = (
            f"# rate_hz = {stated_hz:g}    # no column rises like a time; a line above the names "
            "says this number: is it the rows a second?"
        )
    return ["", "[time]", asked]


def unread_lines(unread: Sequence[str]) -> list[str]:
    """What the recipe would not read."""
    if not unread:
        return []
    shown = ", ".join(name[:60] for name in unread[:_MAX_SHOWN])
    more = f" and {len(unread) - _MAX_SHOWN} more" if len(unread) > _MAX_SHOWN else ""
    return ["", f"# Not read: {shown}{more}"]


def maybe_wrench_lines(columns: Sequence[str | int], told: bool) -> list[str]:
    """What is asked where three or six numbers without names are left behind a pose."""
    if told or len(columns) not in (3, 6):
        return []
    lines = ["", "# What is left may be the wrench; nothing says so:"]
    lines += ["# [force]", f"# columns = {toml(list(columns[:3]))}", '# unit = "N"']
    if len(columns) == 6:
        lines += ["# [torque]", f"# columns = {toml(list(columns[3:]))}", '# unit = "Nm"']
    return [*lines, "# and [wrench] with its frame and sign"]


def preset_lines(name: str, left_open: Mapping[str, Sequence[str]]) -> list[str]:
    """A recipe that begins with a preset, and what that leaves open, by section."""
    lines = [f"preset = {toml(name)}    # all columns it needs are there"]
    for section, open_lines in left_open.items():
        lines += ["", f"[{section}]", *open_lines]
    return lines


def _said(key: str, value: str, question: str) -> str:
    return f"{key} = {toml(value)}" if value else f"# {key} =    # {question}"


def toml(value: object) -> str:
    """Texts, numbers and lists are written alike in TOML and JSON."""
    return json.dumps(value, ensure_ascii=False)
