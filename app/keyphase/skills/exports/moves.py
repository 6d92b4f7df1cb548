"""How a tool moves while it presses and seeks, tick by tick, for whoever executes a skill file.

What an executor computes of a seat's search, of the strokes of a squaring and of the rocking of
both is the same in every run: the file states it, so that nobody has to compute it again.
"""

from functools import lru_cache
from typing import Any

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.execution.executor import STEP_S
from keyphase.skills.execution.seeking import SEATING_S, rocked
from keyphase.skills.search import Search
from keyphase.skills.skill import Skill
from keyphase.skills.squaring import Squaring

MAX_TICKS = 15_000
"""What takes longer, a minute, stays where its last move was."""

_DECIMALS = 9


def moves_of(skill: Skill) -> dict[str, Any] | None:
    """For each tick of a stage; None for a skill that neither seeks nor squares.

    rocked_rad  (N, 3) rotation vector by which the tool is tilted while it presses
    aside_m     (M, 4) how far it is moved while it seeks or squares, and how much of the way is
                done to where the strokes go around: 0 to 1
    """
    if skill.press is None or (skill.search is None and skill.squaring is None):
        return None
    x, y, z = skill.press.direction.tolist()
    rocked_rad, aside_m = _rows(skill.search, skill.squaring, (x, y, z))
    return {"rocked_rad": rocked_rad, "aside_m": aside_m}


@lru_cache(maxsize=8)
def _rows(
    search: Search | None, squaring: Squaring | None, way: tuple[float, float, float]
) -> tuple[list[list[float]], list[list[float]]]:
    direction = np.array(way)
    rocking = [rocked(direction, time) for time in _ticks(SEATING_S)]
    if squaring is not None:
        times = _ticks(squaring.strokes_s)
        aside = [np.append(squaring.away(t), squaring.approached(t)) for t in times]
    else:
        assert search is not None
        aside = [np.append(search.aside(direction, t), 0.0) for t in _ticks(search.duration_s)]
    return _rounded(rocking), _rounded(aside)


def _ticks(duration_s: float) -> Array:
    return STEP_S * np.arange(min(round(duration_s / STEP_S), MAX_TICKS) + 2, dtype=np.float64)


def _rounded(rows: list[Array]) -> list[list[float]]:
    return np.round(np.array(rows), _DECIMALS).tolist()
