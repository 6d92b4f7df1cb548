"""How a tool stands in a contact it met, tick by tick, for whoever executes a skill file.

What an executor computes of pressing and of a seat's search is the same in every run but for what
the tool meets. The file states it in the same words for both, so that nobody has to compute it
again, or to tell one from another. The strokes of a squaring go by what is felt: the file has their
numbers.
"""

from functools import lru_cache
from typing import Any

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.execution.executor import PRESSED_S, STEP_S
from keyphase.skills.execution.seeking import GIVING, SEATING_S, TURNING, rocked
from keyphase.skills.execution.squared import FLATTENING, HELD
from keyphase.skills.search import RETURNS_1_S, YIELDS, Search
from keyphase.skills.skill import Skill

MAX_TICKS = 15_000
"""What takes longer, a minute, ends there."""

_DECIMALS = 9

Moves = list[list[float]]


def pressing_of(skill: Skill) -> dict[str, Any] | None:
    """How the contact that ends a skill is pressed; None where it is not.

    force_N         at the least
    least_s         how long, once the tool is still; most_s: in any case
    aside_left      part of the stiffness aside of the press that is left in any case
    yields_N        what the tool exerts aside at the most, if that leaves more
    stays_aside     1 where it stays where it gave way to, 0 where it comes back
    returns_1_s     at which rate it comes back from there all the same, while it does not give way
    turning_left    part of the stiffness in rotation that is left; second: once the part fell in
                    or was found
    moves           (N, 6) for each tick, the last one for all that follow: how far it is moved [m],
                    and by which rotation vector it is tilted [rad]
    """
    press, seat = skill.press, skill.search or skill.squaring
    if press is None:
        return None
    if seat is None:
        least_s, most_s = PRESSED_S
        return _stage(press.force_N, least_s, most_s, moves=[[0.0] * 6])
    x, y, z = press.direction.tolist()
    return _stage(
        max(press.force_N, seat.press_N),
        SEATING_S,
        SEATING_S,
        aside_left=GIVING if skill.search else HELD,
        turning_left=(TURNING if skill.search else FLATTENING, FLATTENING),
        moves=_rocking((x, y, z)),
    )


def seeking_of(skill: Skill) -> dict[str, Any] | None:
    """How a seat is sought, the same way; `moves` end it; None where none is."""
    press, search = skill.press, skill.search
    if press is None or search is None:
        return None
    x, y, z = press.direction.tolist()
    return _stage(
        max(press.force_N, search.press_N),
        aside_left=0.0,
        yields_N=YIELDS * search.press_N,
        stays_aside=1,
        returns_1_s=RETURNS_1_S,
        turning_left=(TURNING, TURNING),
        moves=_spiral(search, (x, y, z)),
    )


def _stage(
    force_N: float,
    least_s: float = 0.0,
    most_s: float = 0.0,
    *,
    moves: Moves,
    aside_left: float = 1.0,
    yields_N: float = 0.0,
    stays_aside: int = 0,
    returns_1_s: float = 0.0,
    turning_left: tuple[float, float] = (1.0, 1.0),
) -> dict[str, Any]:
    return {
        "force_N": force_N,
        "least_s": least_s,
        "most_s": most_s,
        "aside_left": aside_left,
        "yields_N": yields_N,
        "stays_aside": stays_aside,
        "returns_1_s": returns_1_s,
        "turning_left": list(turning_left),
        "moves": moves,
    }


@lru_cache(maxsize=8)
def _rocking(way: tuple[float, float, float]) -> Moves:
    direction = np.array(way)
    ticks = _ticks(SEATING_S)
    return _rounded([np.concatenate([np.zeros(3), rocked(direction, t)]) for t in ticks])


@lru_cache(maxsize=8)
def _spiral(search: Search, way: tuple[float, float, float]) -> Moves:
    direction, ticks = np.array(way), _ticks(search.duration_s)
    return _rounded([np.append(search.aside(direction, t), np.zeros(3)) for t in ticks])


def _ticks(duration_s: float) -> Array:
    return STEP_S * np.arange(min(round(duration_s / STEP_S), MAX_TICKS), dtype=np.float64)


def _rounded(rows: list[Array]) -> Moves:
    return np.round(np.array(rows), _DECIMALS).tolist()
