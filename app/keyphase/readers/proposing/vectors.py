"""What numbered columns probably are: `wrench[0]` to `wrench[5]`, `O_T_EE_0` to `O_T_EE_15`.

Numbers decide where they can: a 4x4 matrix has a last row of zeros and a one, a quaternion has norm
one. What they cannot tell, such as the order of a quaternion, stays open.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from keyphase.demonstration import Array
from keyphase.readers.proposing.guess import (
    OTHERS,
    Guess,
    likely_torque_unit,
    measured_rows,
    reach_of,
)
from keyphase.readers.proposing.naming import (
    COMMANDED,
    FORCE,
    GRIPPER,
    JOINT,
    NO_JOINT,
    OTHER_THINGS,
    POSITION,
    TOOL,
    TORQUE,
    TURN,
    WRENCH,
    vectors,
)

_UNIT_NORM = 0.02


def vector_guesses(names: Sequence[str], values: Array, free: Sequence[int]) -> list[Guess]:
    """At most one guess a role, of the columns that are numbered; a column is in no two."""
    groups = [one for one in vectors(names, free) if not COMMANDED.search(one[0].lower())]
    still = {stem: _is_still(measured_rows(values, columns)) for stem, columns in groups}
    groups.sort(key=lambda one: (_is_other(one[0]), still[one[0]], not TOOL.search(one[0])))
    found: dict[str, Guess] = {}
    ranks: dict[str, tuple[bool, ...]] = {}
    for stem, columns in groups:
        guesses = list(_guesses(stem, columns, values))
        others = {guess.role for guess in guesses} & found.keys()
        rank = (_is_other(stem), still[stem], not TOOL.search(stem))
        for role in others & _PLACES:
            if rank == ranks[role]:
                found[role] = _with_other(found[role], stem)
        ranks = dict.fromkeys((guess.role for guess in guesses), rank) | ranks
        taken = "pose" in found and {"position", "quaternion", "turn"} & {g.role for g in guesses}
        turned = any(g.role in _TURNS for g in guesses) and bool(_TURNS & found.keys())
        if guesses and not others and not taken and not turned:
            found |= {guess.role: guess for guess in guesses}
    return list(found.values())


_PLACES = {"position", "pose"}
_TURNS = {"quaternion", "turn", "rot6d", "matrix", "pose", "euler"}


def _with_other(guess: Guess, stem: str) -> Guess:
    """A guess that says of another one as good."""
    if guess.is_one_of_several:
        return replace(guess, evidence=(*guess.evidence[:-1], f"{guess.evidence[-1]}, {stem}"))
    return replace(guess, evidence=(*guess.evidence, f"{OTHERS} {stem}"))


def _is_other(stem: str) -> bool:
    return bool(OTHER_THINGS.search(stem))


def _guesses(stem: str, columns: tuple[int, ...], values: Array) -> Iterator[Guess]:
    """What one group of columns is, or nothing."""
    is_joint = bool(JOINT.search(stem)) or re.split(r"[./_]", stem.lower())[-1] in ("q", "j")
    found = list(_by_number(stem, columns, values, is_joint))
    yield from found
    named = (
        is_joint
        and not found
        and reach_of(values, columns) > 0
        and not NO_JOINT.search(stem)
        and not GRIPPER.search(stem)
    )
    if named and 4 <= len(columns) <= 8:
        unit = "deg" if reach_of(values, columns) > 4 * np.pi else "rad"
        told = f"{len(columns)} joints: {unit} (by their size)"
        yield Guess("joints", columns, unit, "", (told,))


def _by_number(
    stem: str, columns: tuple[int, ...], values: Array, is_joint: bool
) -> Iterator[Guess]:
    """What so many numbers are in robotics."""
    rows = measured_rows(values, columns)
    if len(rows) < 2:
        return
    match len(columns):
        case 16:
            yield from _pose(columns, rows)
        case 12:
            yield from three_rows(columns, rows)
        case 9:
            yield from _nine(columns, rows)
        case 7 if not is_joint:
            yield from _seven(columns, rows)
        case 6 if WRENCH.search(stem):
            yield from _wrench(stem, columns, values)
        case 6 if not is_joint and POSITION.search(stem):
            yield _position(columns[:3], values)
            yield _turn(columns[3:], values)
        case 4 if _is_unit(rows):
            yield _quaternion(columns, stem)
        case 3:
            yield from _three(stem, columns, values)


def _is_unit(rows: Array) -> bool:
    off = np.abs(np.linalg.norm(rows, axis=1) - 1)
    return bool(off.max() < _UNIT_NORM) and not _is_still(rows)


def _is_still(rows: Array) -> bool:
    return len(rows) < 2 or bool((np.ptp(rows, axis=0) == 0).all())


def _pose(columns: tuple[int, ...], rows: Array) -> Iterator[Guess]:
    """A homogeneous matrix says itself how it is laid out."""
    matrices = rows.reshape(-1, 4, 4)
    last = np.array([0.0, 0.0, 0.0, 1.0])
    by_rows = bool(np.abs(matrices[:, 3] - last).max() < 1e-6)
    by_columns = bool(np.abs(matrices[:, :, 3] - last).max() < 1e-6)
    if by_rows == by_columns:
        return
    layout, at = ("row_major", [3, 7, 11]) if by_rows else ("column_major", [12, 13, 14])
    reach = float(np.abs(rows[:, at]).max())
    unit = "mm" if reach > 10 else "m"
    where = "row" if by_rows else "fours"
    evidence = (
        f"a 4x4 matrix: 0 0 0 1 {'in its last ' + where if by_rows else 'ends its ' + where}",
        f"its place reaches {reach:.4g}: {unit} (by its size)",
    )
    yield Guess("pose", columns, unit, layout, evidence)


def three_rows(columns: tuple[int, ...], rows: Array) -> Iterator[Guess]:
    """The first three rows of a 4x4 matrix, as KITTI writes poses."""
    by_rows, by_columns = rows.reshape(-1, 3, 4), rows.reshape(-1, 4, 3).swapaxes(1, 2)
    for layout, matrices in (("row_major", by_rows), ("column_major", by_columns)):
        turns = matrices[:, :, :3]
        if np.abs(turns @ turns.transpose(0, 2, 1) - np.eye(3)).max() < _UNIT_NORM:
            reach = float(np.abs(matrices[:, :, 3]).max())
            unit = "mm" if reach > 1000 else "m"
            told = ("twelve numbers that are three rows of a 4x4 matrix", f"reaches {reach:.4g}")
            yield Guess("pose", columns, unit, layout, told)
            return


def _nine(columns: tuple[int, ...], rows: Array) -> Iterator[Guess]:
    """A rotation matrix, or a place and the first two columns of one."""
    square = rows.reshape(-1, 3, 3)
    if np.abs(square @ square.transpose(0, 2, 1) - np.eye(3)).max() < _UNIT_NORM:
        yield Guess("matrix", columns, "", "", ("nine numbers that are a rotation matrix",))
        return
    first, second = rows[:, 3:6], rows[:, 6:9]
    norms = np.concatenate([np.linalg.norm(first, axis=1), np.linalg.norm(second, axis=1)])
    upright = np.abs(np.einsum("ij,ij->i", first, second)).max() < _UNIT_NORM
    if upright and np.abs(norms - 1).max() < _UNIT_NORM:
        unit = "mm" if np.abs(rows[:, :3]).max() > 10 else "m"
        yield Guess("position", columns[:3], unit, "", ("the first three of nine",))
        told = ("two unit vectors at right angles: rot6d",)
        yield Guess("rot6d", columns[3:], "", "", told)


def _seven(columns: tuple[int, ...], rows: Array) -> Iterator[Guess]:
    """A place and a quaternion, whichever comes first."""
    if _is_unit(rows[:, 3:]) and not _is_unit(rows[:, :4]):
        place, turn = columns[:3], columns[3:]
    elif _is_unit(rows[:, :4]):
        place, turn = columns[4:], columns[:4]
    else:
        return
    reach = float(np.abs(rows[:, [columns.index(c) for c in place]]).max())
    unit = "mm" if reach > 10 else "m"
    yield Guess("position", place, unit, "", (f"reaches {reach:.4g}: {unit} (by its size)",))
    yield _quaternion(turn, "")


def _quaternion(columns: tuple[int, ...], stem: str) -> Guess:
    order = next((o for o in ("wxyz", "xyzw") if o in stem.lower()), "")
    why = f"its name says {order}" if order else "neither names nor numbers tell the order"
    evidence = ("norm of these four is 1 in every row: a quaternion", why)
    return Guess("quaternion", columns, "", order, evidence)


def _wrench(stem: str, columns: tuple[int, ...], values: Array) -> Iterator[Guess]:
    top, twist = reach_of(values, columns[:3]), reach_of(values, columns[3:])
    told = f"{stem} has six numbers: the first three are the force"
    yield Guess("force", columns[:3], "N", "", (f"{told}, at most {top:.3g}",))
    unit = likely_torque_unit(twist)
    yield Guess("torque", columns[3:], unit, "", (f"the last three, at most {twist:.3g}",))


def _three(stem: str, columns: tuple[int, ...], values: Array) -> Iterator[Guess]:
    top = reach_of(values, columns)
    if FORCE.search(stem) and not TORQUE.search(stem):
        yield Guess("force", columns, "N", "", (f"named like a force, at most {top:.3g}",))
    elif TORQUE.search(stem):
        unit = likely_torque_unit(top)
        yield Guess("torque", columns, unit, "", (f"named like a torque, at most {top:.3g}",))
    elif TURN.search(stem):
        yield _turn(columns, values)
    elif POSITION.search(stem) and not JOINT.search(stem) and not GRIPPER.search(stem):
        yield _position(columns, values)


def _position(columns: tuple[int, ...], values: Array) -> Guess:
    reach = reach_of(values, columns)
    unit = "mm" if reach > 10 else "m"
    return Guess("position", columns, unit, "", (f"reaches {reach:.4g}: {unit} (by its size)",))


def _turn(columns: tuple[int, ...], values: Array) -> Guess:
    top = reach_of(values, columns)
    unit = "deg" if top > 2 * np.pi + 0.1 else "rad"
    return Guess("turn", columns, unit, "", (f"three numbers that turn, up to {top:.4g}: {unit}",))
