"""What each column probably is, by its name and by its numbers, and why."""

import re
from collections.abc import Sequence

import numpy as np

from keyphase.demonstration import Array
from keyphase.readers.proposing.conventions import UNNAMED, kuka_angles, translation, unnamed_rows
from keyphase.readers.proposing.guess import (
    OTHERS,
    Guess,
    Role,
    likely_torque_unit,
    measured_rows,
    reach_of,
)
from keyphase.readers.proposing.naming import (
    AXIS,
    COMMANDED,
    EULER,
    FORCE,
    GRIPPER,
    GRIPPER_PLACE,
    JOINT,
    NO_JOINT,
    NO_POSITION,
    OTHER_THINGS,
    POSITION,
    QUATERNION,
    RAW,
    TORQUE,
    bare,
    likely_unit,
    parts_of_matrices,
    unit_in,
)
from keyphase.readers.proposing.one_axis import ONE_AXIS, is_one_axis
from keyphase.readers.proposing.vectors import vector_guesses

_NEAR_ONE = 0.9
_UNIT_NORM, _WELL_UNIT_NORM = 0.02, 0.002
_HOMOGENEOUS = 16
_MOST_JOINTS = 16
_TURNS = ("quaternion", "euler", "turn", "rot6d", "matrix", "pose")


def guesses_of(names: Sequence[str], values: Array, taken: Sequence[int] = ()) -> list[Guess]:
    """At most one guess a role, none of them of time; a column is in no two.

    `values` (N, D) are NaN where no number stands; `taken` are columns that are known already.
    """
    numeric = np.atleast_1d(np.isfinite(values).any(axis=0))
    free = [i for i in range(len(names)) if numeric[i] and i not in taken]
    found: list[Guess] = []
    for look in (_quaternion, _force, _torque, _euler, _gripper, _joints, _position):
        turned = look is _euler and any(guess.role == "quaternion" for guess in found)
        guess = None if turned else look(names, values, free)
        if guess is not None:
            found.append(guess)
            free = [i for i in free if i not in guess.columns]
    found = _with_vectors(found, vector_guesses(names, values, free))
    free = [i for i in free if all(i not in guess.columns for guess in found)]
    found = translation(names, values, unnamed_rows(names, values) or found)
    before = _before_quaternion(names, values, free, found)
    return [*found, before] if before else found


def _with_vectors(found: list[Guess], numbered: list[Guess]) -> list[Guess]:
    """Numbered columns where nothing was found by name."""
    roles = {guess.role for guess in found}
    turned = bool(roles & set(_TURNS))
    placed = "position" in roles
    for guess in numbered:
        twice = guess.role in roles or (turned and guess.role in _TURNS)
        if not twice and not (placed and guess.role == "pose"):
            found = [*found, guess]
    return found


def _before_quaternion(
    names: Sequence[str], values: Array, free: list[int], found: Sequence[Guess]
) -> Guess | None:
    """A position without a name: most recorders write it right before the orientation."""
    turns = next((guess for guess in found if guess.role == "quaternion"), None)
    if turns is None or any(guess.role == "position" for guess in found):
        return None
    first = min(turns.columns) - 3
    columns = (first, first + 1, first + 2)
    if not set(columns) <= set(free) or any(NO_POSITION.search(names[i]) for i in columns):
        return None
    reach = reach_of(values, columns)
    unit = "mm" if reach > 10 else "m"
    evidence = ("the three before the quaternion", f"reaches {reach:.4g}: {unit} (by its size)")
    return Guess("position", columns, unit, "", evidence)


def _quaternion(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    """Four of norm one: whose names say so, and else whose norm is nearest to one."""
    apart = parts_of_matrices(names)
    fitting: list[tuple[bool, bool, bool, Guess]] = []
    for first in free:
        columns = tuple(range(first, first + 4))
        if (
            apart & set(columns)
            or not set(columns) <= set(free)
            or any(COMMANDED.search(names[c]) for c in columns)
            or len(rows := measured_rows(values, columns)) < 2
        ):
            continue
        norms = np.linalg.norm(rows, axis=1)
        moving = int((np.ptp(rows, axis=0) > 0).sum())
        told = all(QUATERNION.search(names[c]) for c in columns) or _ordered(names, columns)
        unnamed = all(UNNAMED.fullmatch(names[c]) for c in columns)
        still = unnamed and moving == 0 and _at_rest(values, rows[0], first)
        enough = told or (unnamed and moving >= 2) or moving == 4 or still
        # Of a rotation matrix three numbers have norm one, and a zero beside them changes nothing.
        beside = _one_of_more(names, columns) and moving < 4 and not still
        off = float(np.abs(norms - 1).max())
        if off > _UNIT_NORM or not enough or beside:
            continue
        norm = f"norm of these four is {norms.mean():.3f} in every row: a quaternion"
        rank = (bool(OTHER_THINGS.search(names[first])), not told, off > _WELL_UNIT_NORM)
        fitting.append((*rank, _of_four(names, columns, rows[0], norm)))
    # A number that hardly moves beside three of a quaternion may give a norm near one, too.
    return min(fitting, key=lambda one: one[:3])[3] if fitting else None


def _of_four(names: Sequence[str], columns: tuple[int, ...], row: Array, norm: str) -> Guess:
    order, why = _order([names[c] for c in columns])
    likely, seen = ("", "") if order else _likely_order(row)
    return Guess("quaternion", columns, "", order, (norm, why, *([seen] if seen else [])), likely)


def _at_rest(values: Array, row: Array, first: int) -> bool:
    """Whether four numbers that never change are a turn by nothing, and no part of a matrix."""
    if sorted(np.abs(row).round(6).tolist()) != [0.0, 0.0, 0.0, 1.0]:
        return False
    starts = range(max(first - _HOMOGENEOUS + 1, 0), first + 1)
    return not any(_is_matrix(values[0, start:]) for start in starts)


def _is_matrix(row: Array) -> bool:
    """Whether numbers begin with a rotation matrix, alone or within three or four rows of four."""
    blocks = [row[:9].reshape(3, 3)] if len(row) >= 9 else []
    blocks += [row[:12].reshape(3, 4)[:, :3]] if len(row) >= 12 else []
    return any(np.allclose(block @ block.T, np.eye(3), atol=0.02) for block in blocks)


def _likely_order(row: Array) -> tuple[str, str]:
    """What the first row suggests, which a person has to look at."""
    if abs(row[3]) > _NEAR_ONE:
        return "xyzw", "the last is near 1 at the beginning: x y z w, if the tool is not turned"
    if abs(row[0]) > _NEAR_ONE:
        return "wxyz", "the first is near 1 at the beginning: w x y z, if the tool is not turned"
    return "", ""


def _one_of_more(names: Sequence[str], columns: tuple[int, ...]) -> bool:
    """Whether the next column has the same name with the next number."""
    stems = {
        re.sub(r"\d+\D*$", "", names[c]) for c in (*columns, columns[-1] + 1) if c < len(names)
    }
    return len(stems) == 1 and columns[-1] + 1 < len(names)


def _ordered(names: Sequence[str], columns: tuple[int, ...]) -> bool:
    return bool(_order([names[c] for c in columns])[0])


def _order(names: Sequence[str]) -> tuple[str, str]:
    """By the names alone: a tool that points down is as near 1 in x as one at rest is in w."""
    ends = [re.sub(r"[\W_\d]*$", "", name.lower())[-1:] for name in names]
    if "".join(ends) in ("wxyz", "xyzw"):
        return "".join(ends), f"the names end in {' '.join(ends)}"
    return "", "neither names nor numbers tell the order"


def _force(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    columns, told = _three(names, free, FORCE, TORQUE)
    if columns is None:
        return None
    unit, _ = likely_unit(names[columns[0]], {"N": 1, "mN": 1, "kN": 1, "lbf": 1}, "N")
    top = reach_of(values, columns)
    return Guess("force", columns, unit, "", (f"named like a force, at most {top:.3g}", *told))


def _torque(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    columns, told = _three(names, free, TORQUE, FORCE)
    if columns is None:
        return None
    units = {"Nm": 1, "Nmm": 1, "Ncm": 1, "mNm": 1}
    top = reach_of(values, columns)
    unit, _ = likely_unit(names[columns[0]], units, likely_torque_unit(top))
    return Guess("torque", columns, unit, "", (f"named like a torque, at most {top:.3g}", *told))


def _position(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    called = [GRIPPER_PLACE.sub("tool", name) for name in names]
    columns, told = _three(called, free, POSITION, NO_POSITION)
    if columns is None:
        shown = {i: bare(names[i]) for i in free}
        plain = [i for i in free if not NO_POSITION.search(shown[i])]
        columns, told = _first(_by_axis(shown, plain), names)
    if columns is None:
        return None
    reach = reach_of(values, columns)
    by_size = "mm" if reach > 10 else "m"
    units = {"mm": 1, "cm": 1, "m": 1, "um": 1, "dm": 1, "in": 1}
    unit, why = likely_unit(names[columns[0]], units, by_size)
    evidence = f"reaches {reach:.4g}: {unit or '?'} ({why})"
    return Guess("position", columns, unit, "", (evidence, *told))


def _euler(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    angles = [i for i in free if re.search(r"roll|pitch|yaw", names[i], re.I)]
    kuka = kuka_angles(names, free)
    told: tuple[str, ...] = ()
    sequence = ""
    role: Role = "euler"
    if len(angles) >= 3:
        columns: tuple[int, ...] | None = tuple(angles[:3])
    elif len(kuka) == 3:
        columns, told = tuple(kuka), ("A, B and C of KUKA turn about z, y and x: ZYX",)
        sequence = "ZYX"
    else:
        columns, told = _three(names, free, EULER, FORCE)
        role = "turn"
    if columns is None:
        return None
    unit = unit_in(names[columns[0]], {"deg": 1, "rad": 1, "mrad": 1})
    top = reach_of(values, columns)
    unit = unit or ("deg" if top > 2 * np.pi + 0.1 else "rad")
    if role == "turn" and is_one_axis(measured_rows(values, columns), unit):
        told = (ONE_AXIS, *told)
    return Guess(role, columns, unit, sequence, (f"angles up to {top:.4g}: {unit}", *told))


def _gripper(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    fitting = [i for i in free if GRIPPER.search(names[i]) and not COMMANDED.search(names[i])]
    places = _by_axis({i: bare(names[i]) for i in free}, fitting)
    fitting = [i for i in fitting if all(i not in place for place in places)]
    if not fitting:
        return None
    columns = tuple(fitting[:1])
    top = reach_of(values, columns)
    unit = unit_in(names[columns[0]], {"mm": 1, "cm": 1, "m": 1})
    unit = unit or ("mm" if top > 1.5 else "m" if top < 0.25 else "fraction")
    return Guess("gripper", columns, unit, "", (f"opens up to {top:.4g}: {unit}",))


def _joints(names: Sequence[str], values: Array, free: list[int]) -> Guess | None:
    alike: dict[str, list[int]] = {}
    for i in free:
        moving = np.ptp(measured_rows(values, (i,))) > 0
        if moving and JOINT.search(names[i]) and not NO_JOINT.search(names[i]):
            alike.setdefault(re.sub(r"\d+", "#", names[i]), []).append(i)
    every = [i for group in alike.values() for i in group]
    groups = [every, *alike.values()] if len(every) <= _MOST_JOINTS else list(alike.values())
    columns = next((tuple(one) for one in groups if 4 <= len(one) <= _MOST_JOINTS), None)
    if columns is None:
        return None
    top = reach_of(values, columns)
    unit = "deg" if top > 4 * np.pi else "rad"
    return Guess("joints", columns, unit, "", (f"{len(columns)} joints, up to {top:.4g}: {unit}",))


_Three = tuple[tuple[int, int, int] | None, tuple[str, ...]]
"""Three columns, if any, and what to say of others that fit as well."""


def _three(
    names: Sequence[str], free: list[int], want: re.Pattern[str], never: re.Pattern[str]
) -> _Three:
    """Columns of x, y and z with one beginning, or three in a row, whose names fit."""
    shown = {i: bare(names[i]) for i in free}
    fitting = [i for i in free if want.search(shown[i]) and not never.search(shown[i])]
    groups = _by_axis(shown, [i for i in fitting if not COMMANDED.search(shown[i])])
    return _first(groups or _by_axis(shown, fitting), names)


def _first(groups: list[tuple[int, int, int]], names: Sequence[str]) -> _Three:
    """The first of the tool that is not called raw, and the others by name."""
    if not groups:
        return None, ()
    called = {one: names[one[0]] for one in groups}
    groups.sort(key=lambda g: (bool(OTHER_THINGS.search(called[g])), bool(RAW.search(called[g]))))
    others = ", ".join(names[one[0]] for one in groups[1:4])
    return groups[0], (f"{OTHERS} {others}",) if others else ()


def _by_axis(shown: dict[int, str], columns: Sequence[int]) -> list[tuple[int, int, int]]:
    """Threes of columns whose names differ in their axis only, in the order of the table."""
    found: dict[str, dict[str, int]] = {}
    for i in columns:
        axis = AXIS.fullmatch(shown[i].lower())
        if axis:
            found.setdefault(f"{axis[1]}\0{axis[3]}", {}).setdefault(axis[2], i)
    return [(g["x"], g["y"], g["z"]) for g in found.values() if len(g) == 3]
