"""How a person says that a table is to be read: a role for each column, and what goes with it."""

import json
from dataclasses import dataclass, replace
from typing import Literal, get_args

from keyphase.errors import RecipeError
from keyphase.readers.proposing.guess import Guess
from keyphase.readers.proposing.proposal import Proposal

Part = Literal[
    "ignore", "time", "seconds", "nanoseconds", "x", "y", "z", "qw", "qx", "qy", "qz",
    "roll", "pitch", "yaw", "fx", "fy", "fz", "tx", "ty", "tz", "gripper", "joint",
]  # fmt: skip
"""What one column can be."""

PARTS: tuple[Part, ...] = get_args(Part)

_PARTS_OF_ROLE: dict[str, tuple[Part, ...]] = {
    "time": ("time",),
    "position": ("x", "y", "z"),
    "euler": ("roll", "pitch", "yaw"),
    "turn": ("roll", "pitch", "yaw"),
    "force": ("fx", "fy", "fz"),
    "torque": ("tx", "ty", "tz"),
    "gripper": ("gripper",),
}
_QUANTITIES: dict[str, str] = {"position": "length", "euler": "angle", "turn": "angle"}
_QUATERNION: dict[str, Part] = {"w": "qw", "x": "qx", "y": "qy", "z": "qz"}


@dataclass(frozen=True)
class Answers:
    """Everything a recipe says of one table; what is "" or None is still open.

    parts              what each column is
    units              of `time`, `length`, `angle`, `force`, `torque`, `joints`, `gripper`
    sequence           of roll, pitch and yaw, as in a recipe
    frame, sign        of the wrench, as in a recipe
    rate_hz            of a table without time
    from_first_s       so long nothing touches the tool at the beginning: the mean is taken out
    """

    encoding: str
    separator: str
    decimal: str
    skip_lines: int
    header: bool
    parts: tuple[Part, ...]
    units: dict[str, str]
    sequence: str = "xyz"
    frame: Literal["", "base", "tool"] = ""
    sign: Literal[0, 1, -1] = 0
    rate_hz: float | None = None
    from_first_s: float | None = None

    def open(self) -> tuple[str, ...]:
        """What must be said before the table can be read, as sentences."""
        has = set(self.parts)
        said = []
        if not has & {"time", "seconds"} and self.rate_hz is None:
            said.append("Say which column is the time, or how many rows there are a second.")
        if not {"x", "y", "z"} <= has:
            said.append("Say which three columns are x, y and z of the tool.")
        needed = {
            "time": "time" in has,
            "length": "x" in has,
            "angle": "roll" in has,
            "force": "fx" in has,
            "torque": "tx" in has,
            "joints": "joint" in has,
            "gripper": "gripper" in has,
        }
        said += [
            f"Say the unit of the {quantity}."
            for quantity, is_needed in needed.items()
            if is_needed and not self.units.get(quantity)
        ]
        if has & {"fx", "tx"}:
            said += [] if self.frame else ["Say in whose axes the wrench is written."]
            said += [] if self.sign else ["Say which way the force points when the tool presses."]
        return tuple(said)


def answers_to(proposal: Proposal) -> Answers:
    """A proposal for a table as answers, frame and sign of the wrench left open.

    Raises RecipeError for the proposal for a binary format.
    """
    parts: list[Part] = ["ignore"] * len(proposal.names)
    units: dict[str, str] = {}
    for guess in proposal.guesses:
        for column, part in zip(guess.columns, _parts_of(guess), strict=True):
            parts[column] = part
        quantity = _QUANTITIES.get(guess.role, guess.role)
        if guess.unit:
            units[quantity] = guess.unit
    layout = proposal.layout
    if layout is None:
        raise RecipeError("Expected a table of text; another format is described by a recipe.")
    return Answers(
        encoding=layout.encoding,
        separator=layout.separator,
        decimal=layout.form.decimal,
        skip_lines=layout.form.skip_lines,
        header=layout.form.header,
        parts=tuple(parts),
        units=units,
    )


def with_parts(answers: Answers, count: int) -> Answers:
    """Answers for a table of `count` columns: those that are new are passed over."""
    more: tuple[Part, ...] = ("ignore",) * max(0, count - len(answers.parts))
    return replace(answers, parts=(*answers.parts, *more)[:count])


def recipe_text(answers: Answers, names: tuple[str, ...]) -> str:
    """The recipe (TOML) that answers make, columns by name where names tell them apart.

    Raises RecipeError for what is still open, or said twice.
    """
    if missing := answers.open():
        raise RecipeError(" ".join(missing))
    sections = [_table(answers), _time(answers, names)]
    lists: tuple[tuple[str, tuple[Part, ...], str], ...] = (
        ("position", ("x", "y", "z"), "length"),
        ("force", ("fx", "fy", "fz"), "force"),
        ("torque", ("tx", "ty", "tz"), "torque"),
        ("gripper", ("gripper",), "gripper"),
    )
    for section, parts, quantity in lists:
        columns = _columns(answers, names, parts)
        if columns:
            lines = [f"columns = {_toml(columns)}", f"unit = {_toml(answers.units[quantity])}"]
            if section in ("force", "torque") and answers.from_first_s:
                lines.append(f"offset_from_first_s = {answers.from_first_s}")
            sections.append([f"[{section}]", *lines])
    sections += [_orientation(answers, names), _joints(answers, names)]
    if set(answers.parts) & {"fx", "tx"}:
        sections.append(["[wrench]", f"frame = {_toml(answers.frame)}", f"sign = {answers.sign}"])
    return "\n\n".join("\n".join(lines) for lines in sections if lines) + "\n"


def _parts_of(guess: Guess) -> tuple[Part, ...]:
    if guess.role == "quaternion":
        return tuple(_QUATERNION[letter] for letter in guess.detail or guess.likely or "wxyz")
    if guess.detail == "seconds and nanoseconds":
        return ("seconds", "nanoseconds")
    if guess.role == "joints":
        return ("joint",) * len(guess.columns)
    ignored: tuple[Part, ...] = ("ignore",) * len(guess.columns)
    return (*_PARTS_OF_ROLE.get(guess.role, ()), *ignored)[: len(guess.columns)]


def _table(answers: Answers) -> list[str]:
    values = (
        ("encoding", answers.encoding, "utf-8"),
        ("separator", answers.separator, ","),
        ("decimal", answers.decimal, "."),
        ("skip_lines", answers.skip_lines, 0),
        ("header", answers.header, True),
    )
    lines = [f"{key} = {_toml(value)}" for key, value, usual in values if value != usual]
    return ["[table]", *lines] if lines else []


def _time(answers: Answers, names: tuple[str, ...]) -> list[str]:
    if "seconds" in answers.parts:
        seconds, nanoseconds = _columns(answers, names, ("seconds", "nanoseconds"))
        lines = [f"seconds = {_toml(seconds)}", f"nanoseconds = {_toml(nanoseconds)}"]
    elif "time" in answers.parts:
        column = _columns(answers, names, ("time",))[0]
        lines = [
            f"column = {_toml(column)}",
            f"unit = {_toml(answers.units['time'])}",
            "from_zero = true",
        ]
    else:
        lines = [f"rate_hz = {answers.rate_hz}"]
    return ["[time]", *lines]


def _orientation(answers: Answers, names: tuple[str, ...]) -> list[str]:
    quaternion = _columns(answers, names, ("qw", "qx", "qy", "qz"))
    if quaternion:
        lines = [f"columns = {_toml(quaternion)}", 'order = "wxyz"', "normalise = true"]
        return ["[orientation]", 'kind = "quaternion"', *lines]
    angles = _columns(answers, names, ("roll", "pitch", "yaw"))
    if not angles:
        return []
    return [
        "[orientation]",
        'kind = "euler"',
        f"columns = {_toml(angles)}",
        f"sequence = {_toml(answers.sequence)}",
        f"unit = {_toml(answers.units['angle'])}",
    ]


def _joints(answers: Answers, names: tuple[str, ...]) -> list[str]:
    columns = [_name(answers, names, i) for i, part in enumerate(answers.parts) if part == "joint"]
    if not columns:
        return []
    unit = _toml(answers.units["joints"])
    return ["[joints]", f"columns = {_toml(columns)}", f"unit = {unit}"]


def _columns(answers: Answers, names: tuple[str, ...], parts: tuple[Part, ...]) -> list[str | int]:
    """The columns of some parts in their order; none where none is named.

    Raises RecipeError where some are missing or one is named twice.
    """
    found = {part: [i for i, one in enumerate(answers.parts) if one == part] for part in parts}
    if not any(found.values()):
        return []
    for part, columns in found.items():
        if len(columns) != 1:
            many = "no column" if not columns else f"{len(columns)} columns"
            together = ", ".join(parts)
            raise RecipeError(
                f"One column must be {part}, but {many} are said to be; {together} go together."
            )
    return [_name(answers, names, found[part][0]) for part in parts]


def _name(answers: Answers, names: tuple[str, ...], column: int) -> str | int:
    name = names[column]
    return name if answers.header and name and names.count(name) == 1 else column


def _toml(value: object) -> str:
    """Texts, numbers and lists are written alike in TOML and JSON."""
    return json.dumps(value, ensure_ascii=False)
