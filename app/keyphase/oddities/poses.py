"""Poses no arm has: jumps, rows of zeros, a pose that stands while joints move, a wrong unit."""

from itertools import pairwise

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.oddities.oddity import Oddity, at_row, first_few

MAX_SPEED_M_S = 7.0
"""No arm's tool goes faster; neither does a hand that leads one."""

MAX_DROPOUT_S = 0.2
"""Longer away the tool may have been there."""

_MIN_JUMP_M = 0.02
_MAX_SPEED_RAD_S = 60.0
_MIN_JUMP_RAD = 0.3
_MAX_REACH_M = 20.0
_MIN_REACH_M = 5e-5
_MIN_JOINT_RAD = 0.02

_ALL_OF_IT = 0.98
_MOST_OF_IT = 0.7
"""Parts of a quaternion of length one: within 23 and 91 degrees of half a turn about its axis."""


def jumps(demonstration: Demonstration) -> list[Oddity]:
    """The first few jumps."""
    return first_few(every_jump(demonstration))


def every_jump(demonstration: Demonstration) -> list[Oddity]:
    """Places faster left than any arm can, and back where it comes back."""
    time, steps = demonstration.time_s, np.diff(demonstration.time_s)
    travel, rows = _leaps(demonstration)
    back: dict[int, int] = dict(dropouts(demonstration))
    gone = {float(start) for start, _ in demonstration.gaps_s}
    found: list[Oddity] = []
    last = -2
    for row in map(int, rows):
        if time[row] in gone or row <= last + 1:
            last = max(last, row)
            continue
        last = back.get(row, row)
        text = (
            f"The tool jumps {travel[row]:.3g} m within {steps[row]:.2g} s"
            f"{' and back' if row in back else ''} {at_row(demonstration, row + 1)}, "
            f"{travel[row] / steps[row]:.2g} m/s; no arm does that."
        )
        span = float(time[row]), float(time[back.get(row, row) + 1])
        found.append(Oddity("jump", "warning", text, span))
    return found


def dropouts(demonstration: Demonstration) -> list[tuple[int, int]]:
    """Jumps from a row to the next, and from which row it is back within `MAX_DROPOUT_S`.

    The rows between are where the tool never was: the recorder read nothing, or something else.
    """
    time, position = demonstration.time_s, demonstration.position_m
    travel, rows = _leaps(demonstration)
    found: list[tuple[int, int]] = []
    for out, back in pairwise(rows.tolist()):
        if found and out <= found[-1][1]:
            continue
        near = float(np.linalg.norm(position[back + 1] - position[out])) < 0.2 * travel[out]
        if near and time[back + 1] - time[out] <= MAX_DROPOUT_S:
            found.append((out, back))
    return found


def _leaps(demonstration: Demonstration) -> tuple[Array, np.ndarray]:
    """Way from row to row (N - 1,) [m], and the rows that the tool leaves faster than any arm."""
    steps = np.diff(demonstration.time_s)
    travel = np.linalg.norm(np.diff(demonstration.position_m, axis=0), axis=1)
    return travel, np.flatnonzero((travel > _MIN_JUMP_M) & (travel > MAX_SPEED_M_S * steps))


def turns_too_fast(demonstration: Demonstration) -> list[Oddity]:
    """Orientations that flip from row to row."""
    wxyz = demonstration.orientation_wxyz
    if wxyz is None:
        return []
    inner = np.abs(np.sum(wxyz[1:] * wxyz[:-1], axis=1)).clip(0.0, 1.0)
    angle, steps = 2 * np.arccos(inner), np.diff(demonstration.time_s)
    rows = np.flatnonzero((angle > _MIN_JUMP_RAD) & (angle > _MAX_SPEED_RAD_S * steps))
    if not rows.size:
        return []
    row = int(rows[0])
    text = (
        f"The tool turns by {np.degrees(angle[row]):.0f}° within {steps[row]:.2g} s "
        f"{at_row(demonstration, row + 1)}"
        + (f", and {len(rows) - 1} times more" if len(rows) > 1 else "")
        + "; no arm does that."
    )
    span = float(demonstration.time_s[row]), float(demonstration.time_s[row + 1])
    return [Oddity("jump", "warning", text, span)]


def odd_order(demonstration: Demonstration) -> list[Oddity]:
    """Half a turn about z at the beginning, and near it to the end: no turn, read as x y z w."""
    wxyz = demonstration.orientation_wxyz
    if wxyz is None or np.all(wxyz == wxyz[0]):
        return []
    z = np.abs(wxyz[:, 3])
    if z[0] < _ALL_OF_IT or z.min() < _MOST_OF_IT:
        return []
    text = (
        "The tool begins turned by half a turn about z and stays near that; if its quaternions "
        "were written x y z w, it begins not turned at all: check their order (a recipe says it: "
        'order = "xyzw").'
    )
    return [Oddity("order", "note", text)]


def zero_rows(demonstration: Demonstration) -> list[Oddity]:
    """Rows whose place is exactly the base's origin, as loggers write where reading failed."""
    zero = np.all(demonstration.position_m == 0.0, axis=1)
    count = int(zero.sum())
    if not 0 < count < len(zero) or not _far_from_origin(demonstration.position_m, zero):
        return []
    row = int(np.argmax(zero))
    rows = "row has" if count == 1 else "rows have"
    text = (
        f"{count} {rows} the place 0 0 0, first {at_row(demonstration, row)}: the recorder read "
        "nothing there; a recipe drops them with missing = 0 in [rows]."
    )
    return [Oddity("zero rows", "warning", text)]


def still_pose(demonstration: Demonstration) -> list[Oddity]:
    """A pose that never changes, though joints do."""
    if np.ptp(demonstration.position_m, axis=0).any():
        return []
    joints = demonstration.joints_rad
    turned = 0.0 if joints is None else float(np.ptp(joints, axis=0).max(initial=0.0))
    if turned > _MIN_JOINT_RAD:
        text = (
            f"position_m never changes while joints_rad do (by up to {np.degrees(turned):.0f}°): "
            "the pose was not recorded."
        )
        return [Oddity("still pose", "warning", text)]
    return [Oddity("constant", "warning", "position_m never changes.")]


def odd_reach(demonstration: Demonstration) -> list[Oddity]:
    """A reach no robot has, as when millimetres are read as metres."""
    reach = float(np.linalg.norm(np.ptp(demonstration.position_m, axis=0)))
    if reach > _MAX_REACH_M:
        text = f"The tool reaches {reach:.4g} m: no robot does; were millimetres read as metres?"
        return [Oddity("scale", "warning", text)]
    if 0.0 < reach < _MIN_REACH_M:
        text = f"The tool moves {1e6 * reach:.2g} µm in all; were metres read as millimetres?"
        return [Oddity("scale", "warning", text)]
    return []


def _far_from_origin(position_m: Array, zero: np.ndarray) -> bool:
    """Whether the tool is elsewhere in the rows beside those of zeros."""
    beside = ~zero & (np.roll(zero, 1) | np.roll(zero, -1))
    distances = np.linalg.norm(position_m[beside], axis=1)
    return bool(distances.size) and float(np.median(distances)) > _MIN_JUMP_M
