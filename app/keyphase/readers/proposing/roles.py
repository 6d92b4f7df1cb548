"""What each column probably is, by its name and by its numbers, and why."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from keyphase.demonstration import Array

Role = Literal[
    "time", "position", "quaternion", "euler", "force", "torque", "gripper", "joints", "show"
]

_AXIS = re.compile(r"(|.*?[^a-z]|.*?[a-z])([xyz])(|[\W_].*|\d*)")
_TIME = re.compile(r"time|zeit|stamp|^t$|^t[\W_]|sec", re.I)
_POSITION = re.compile(
    r"pos|tcp|tool|ee|pose|^[xyz]$|^[xyz][\W_]|^p?[xyz]$|translation|punkt", re.I
)
_NO_POSITION = re.compile(
    r"vel|speed|acc|cmd|soll|target|force|torque|quat|orient|ori[\W_]|roll|pitch|yaw|kraft|moment"
    r"|(^|[\W_])[ftmq]\d?[\W_]?[xyz]($|[\W_])",
    re.I,
)
_FORCE = re.compile(r"force|kraft|(^|[\W_])f[\W_]?[xyz]|^f\d?[xyz]", re.I)
_TORQUE = re.compile(r"torque|moment|(^|[\W_])[tm][\W_]?[xyz]($|[\W_])", re.I)
_QUATERNION = re.compile(r"quat|orient|(^|[\W_])q[\W_]?[wxyz0-3]", re.I)
_EULER = re.compile(r"roll|pitch|yaw|euler|rpy|(^|[\W_])r[xyz]|rot", re.I)
_UNNAMED = re.compile(r"column \d+")
_GRIPPER = re.compile(r"grip|greifer|width|opening|finger|backe", re.I)
_JOINT = re.compile(r"joint|achse|axis_?\d|(^|[\W_])[qj]_?\d", re.I)
_NO_JOINT = re.compile(r"header|stamp|seq|vel|effort|torque|current|cmd|soll", re.I)

_MIN_RATE_HZ, _MAX_RATE_HZ = 2.0, 5000.0
_TIME_UNITS = (("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9))


@dataclass(frozen=True)
class Guess:
    """What some columns, in this order, probably are.

    unit      as a recipe writes it, or "" where the numbers do not tell
    detail    order of a quaternion, sequence of Euler angles, or ""
    evidence  sentences, the best reason first
    """

    role: Role
    columns: tuple[int, ...]
    unit: str
    detail: str
    evidence: tuple[str, ...]


def guesses_of(names: Sequence[str], values: Array) -> list[Guess]:
    """At most one guess a role; a column is in no two. `values` (N, D), NaN where no number."""
    free = [i for i in range(len(names)) if np.isfinite(values[:, i]).all()]
    found: list[Guess] = []
    for look in (_time, _quaternion, _force, _torque, _euler, _gripper, _joints, _position):
        guess = look(names, values, free)
        if guess is not None:
            found.append(guess)
            free = [i for i in free if i not in guess.columns]
    before = _before_quaternion(names, values, free, found)
    return [*found, before] if before else found


def _before_quaternion(
    names: Sequence[str], values: Array, free: list[int], found: Sequence[Guess]
) -> Guess | None:
    """A position without a name: most recorders write it right before the orientation."""
    turns = next((guess for guess in found if guess.role == "quaternion"), None)
    if turns is None or any(guess.role == "position" for guess in found):
        return None
    first = min(turns.columns) - 3
    columns = (first, first + 1, first + 2)
    if not set(columns) <= set(free) or any(_NO_POSITION.search(names[i]) for i in columns):
        return None
    reach = float(np.abs(values[:, columns]).max())
    unit = "mm" if reach > 10 else "m"
    evidence = ("the three before the quaternion", f"reaches {reach:.4g}: {unit} (by its size)")
    return Guess("position", columns, unit, "", evidence)


def _time(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    two = _two_part_time(names, free)
    if two is not None:
        return two
    rising = [i for i in free if (np.diff(values[:, i]) >= 0).all() and np.ptp(values[:, i]) > 0]
    named = [i for i in rising if _TIME.search(names[i])]
    if not named and not (rising and rising[0] == 0):
        return None
    column = (named or rising)[0]
    steps = np.diff(values[:, column])
    step = float(np.median(steps[steps > 0]))
    told = _unit_in(names[column], dict(_TIME_UNITS))
    possible = [u for u, s in _TIME_UNITS if _MIN_RATE_HZ <= 1 / (step * s) <= _MAX_RATE_HZ]
    unit = told or (possible[0] if len(possible) == 1 else _by_size(step, possible))
    if not (named or unit):
        return None
    why = f"steps of {step:.6g}: {unit or '?'}, which makes {_rate(step, unit)}"
    return Guess("time", (column,), unit, "", (why, "the column never falls"))


def _two_part_time(names: Sequence[str], free: list[int]) -> Guess | None:
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


def _by_size(step: float, possible: Sequence[str]) -> str:
    """Whole steps of at least one are rarely seconds."""
    if step >= 1 and "ms" in possible:
        return "ms"
    return possible[0] if possible else ""


def _rate(step: float, unit: str) -> str:
    size = dict(_TIME_UNITS).get(unit)
    return f"{1 / (step * size):.6g} Hz" if size else "no rate that a recorder has"


def _quaternion(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    for first in free:
        columns = tuple(range(first, first + 4))
        if not set(columns) <= set(free):
            continue
        norms = np.linalg.norm(values[:, columns], axis=1)
        spread = float(np.ptp(values[:, columns], axis=0).max())
        told = any(_QUATERNION.search(names[c]) or _UNNAMED.fullmatch(names[c]) for c in columns)
        if np.abs(norms - 1).max() > 0.02 or (spread == 0 and not told):
            continue
        order, why = _order([names[c] for c in columns], values[0, list(columns)])
        evidence = (f"norm of these four is {norms.mean():.3f} in every row: a quaternion", why)
        return Guess("quaternion", columns, "", order, evidence)
    return None


def _order(names: Sequence[str], first: Array) -> tuple[str, str]:
    ends = [re.sub(r"[\W_\d]*$", "", name.lower())[-1:] for name in names]
    if sorted(ends) == ["w", "x", "y", "z"] and "".join(ends) in ("wxyz", "xyzw"):
        return "".join(ends), f"the names end in {' '.join(ends)}"
    if abs(first[3]) > 0.9:
        return "xyzw", "the last is near 1 at the beginning: x y z w"
    if abs(first[0]) > 0.9:
        return "wxyz", "the first is near 1 at the beginning: w x y z"
    return "", "neither names nor numbers tell the order"


def _force(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    columns = _three(names, free, _FORCE, _TORQUE)
    if columns is None:
        return None
    unit = _unit_in(names[columns[0]], {"N": 1, "mN": 1, "kN": 1, "lbf": 1}) or "N"
    top = float(np.abs(values[:, columns]).max())
    return Guess("force", columns, unit, "", (f"named like a force, at most {top:.3g}",))


def _torque(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    columns = _three(names, free, _TORQUE, _FORCE)
    if columns is None:
        return None
    unit = _unit_in(names[columns[0]], {"Nm": 1, "Nmm": 1, "Ncm": 1, "mNm": 1}) or "Nm"
    top = float(np.abs(values[:, columns]).max())
    return Guess("torque", columns, unit, "", (f"named like a torque, at most {top:.3g}",))


def _position(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    columns = _three(names, free, _POSITION, _NO_POSITION)
    others: list[tuple[int, int, int]] = []
    if columns is None:
        bare = {i: _bare(names[i]) for i in free}
        plain = [i for i in free if not _NO_POSITION.search(bare[i])]
        others = _by_axis(bare, plain)
        columns = others[0] if others else None
    if columns is None:
        return None
    told = _unit_in(names[columns[0]], {"mm": 1, "cm": 1, "m": 1, "um": 1})
    reach = float(np.abs(values[:, columns]).max())
    unit = told or ("mm" if reach > 10 else "m")
    evidence = f"reaches {reach:.4g}: {unit} ({'named so' if told else 'by its size'})"
    first = (f"the first of {len(others)} threes of x, y and z",) if len(others) > 1 else ()
    return Guess("position", columns, unit, "", (evidence, *first))


def _euler(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    angles = [i for i in free if re.search(r"roll|pitch|yaw", names[i], re.I)]
    columns = tuple(angles[:3]) if len(angles) >= 3 else _three(names, free, _EULER, _FORCE)
    if columns is None:
        return None
    told = _unit_in(names[columns[0]], {"deg": 1, "rad": 1, "mrad": 1})
    top = float(np.abs(values[:, columns]).max())
    unit = told or ("deg" if top > 2 * np.pi + 0.1 else "rad")
    return Guess("euler", columns, unit, "", (f"angles up to {top:.4g}: {unit}",))


def _gripper(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    columns = [i for i in free if _GRIPPER.search(names[i])][:1]
    if not columns:
        return None
    top = float(np.abs(values[:, columns]).max())
    told = _unit_in(names[columns[0]], {"mm": 1, "cm": 1, "m": 1})
    unit = told or ("mm" if top > 1.5 else "m" if top < 0.25 else "fraction")
    return Guess("gripper", tuple(columns), unit, "", (f"opens up to {top:.4g}: {unit}",))


def _joints(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    columns = tuple(i for i in free if _JOINT.search(names[i]) and not _NO_JOINT.search(names[i]))
    if len(columns) < 4:
        return None
    top = float(np.abs(values[:, columns]).max())
    unit = "deg" if top > 4 * np.pi else "rad"
    return Guess("joints", columns, unit, "", (f"{len(columns)} joints, up to {top:.4g}: {unit}",))


def _three(
    names: Sequence[str], free: list[int], want: re.Pattern[str], never: re.Pattern[str]
) -> tuple[int, int, int] | None:
    """Columns of x, y and z with one beginning, or three in a row, whose names fit."""
    bare = {i: _bare(names[i]) for i in free}
    fitting = [i for i in free if want.search(bare[i]) and not never.search(bare[i])]
    groups = _by_axis(bare, fitting)
    if groups:
        return groups[0]
    for i in fitting:
        if {i, i + 1, i + 2} <= set(fitting):
            return i, i + 1, i + 2
    return None


def _by_axis(bare: dict[int, str], columns: Sequence[int]) -> list[tuple[int, int, int]]:
    """Threes of columns whose names differ in their axis only, in the order of the table."""
    found: dict[str, dict[str, int]] = {}
    for i in columns:
        axis = _AXIS.fullmatch(bare[i].lower())
        if axis:
            found.setdefault(f"{axis[1]}\0{axis[3]}", {}).setdefault(axis[2], i)
    return [(g["x"], g["y"], g["z"]) for g in found.values() if len(g) == 3]


def _bare(name: str) -> str:
    """A name without the unit in brackets."""
    return re.sub(r"\s*[(\[{][^)\]}]*[)\]}]\s*$", "", name).strip()


def _unit_in(name: str, units: dict[str, float] | dict[str, int]) -> str:
    """A unit written in a name, as in `px [mm]`, `t_ms` or `Fx(N)`; "" where there is none."""
    found = re.findall(r"[(\[{]\s*([A-Za-zµ·*]+)\s*[)\]}]", name) or re.findall(
        r"[_\s]([A-Za-zµ]+)$", name
    )
    plain = {unit.lower(): unit for unit in units}
    aliases = {"radian": "rad", "degree": "deg", "degrees": "deg", "µs": "us", "m": "m"}
    for one in found:
        word = one.replace("·", "").replace("*", "").lower()
        word = aliases.get(word, word)
        if word in plain:
            return plain[word]
    return ""
