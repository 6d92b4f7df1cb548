"""How skills ended that were executed."""

from dataclasses import dataclass
from typing import Literal

from keyphase.demonstration import Array
from keyphase.skills.end_monitor import Outcome

Stage = Literal["loading", "moving", "pressing", "searching", "resting", "over"]
"""A skill that starts in a contact loads it; a skill moves; a contact that was met is pressed; the
plan is done and the tool rests; over."""


@dataclass(frozen=True, eq=False)
class SkillResult:
    """How one skill ended.

    skill         its index in the plan
    outcome       None where it was stopped
    start_s, end_s  since the plan began, the pressing of a contact included
    peak_force_N  largest measured force
    ended_m       (3,) where the tool was then
    shift_m       (3,) how far it ran away from its demonstration
    """

    skill: int
    label: str
    outcome: Outcome | None
    start_s: float
    end_s: float
    peak_force_N: float
    ended_m: Array
    shift_m: Array


def went_on(result: SkillResult) -> bool:
    """Whether the plan goes on after a skill: it met its own end condition."""
    return result.outcome in ("reached", "contact")
