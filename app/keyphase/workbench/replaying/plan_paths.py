"""The paths of a plan's skills, and what was demonstrated of each."""

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.windows import AFTER_S
from keyphase.skills.skill import Skill, drawn
from keyphase.workbench.replaying.plan import PlannedSkill, ReplayPlan

Rows = NDArray[np.intp]

MAX_DEMONSTRATED = 250
"""So many samples of the demonstration are told of each skill."""


def expected_s(skill: Skill) -> float:
    """How long a skill takes if all is as it was demonstrated."""
    if skill.demonstrated_s is None:
        return skill.primitive.duration_s
    start_s, end_s = skill.demonstrated_s
    return end_s - start_s + (AFTER_S[1] if isinstance(skill.end_condition, ContactEnd) else 0.0)


def path_of_skill(plan: ReplayPlan, skill: Skill) -> Array:
    """The path (M, 3) a skill repeats: as demonstrated, or as planned in a connecting move."""
    if skill.demonstrated_s is None:
        return drawn(skill).position_m
    return plan.demonstration.position_m[_rows(plan.demonstration, *skill.demonstrated_s)]


def middle_of_skill(plan: ReplayPlan, skill: Skill) -> Array:
    """Where (3,) the path of a skill is named."""
    path_m = path_of_skill(plan, skill)
    return path_m[len(path_m) // 2]


def demonstrated(plan: ReplayPlan, one: PlannedSkill) -> dict[str, list[float]] | None:
    """What was demonstrated of a skill and shortly after it, in the time since its start."""
    span, recording = one.skill.demonstrated_s, plan.demonstration
    if span is None:
        return None
    after = AFTER_S[1] if isinstance(one.skill.end_condition, ContactEnd) else 0.0
    rows = _rows(recording, span[0], min(span[1] + after, recording.end_s))
    at_mm = 1e3 * (recording.position_m[rows] - recording.position_m[0])
    columns = {"time_s": recording.time_s[rows] - span[0]}
    for name, values in (
        ("position", at_mm),
        ("force", _of(recording.force_N, rows)),
        ("torque", _of(recording.torque_Nm, rows)),
    ):
        if values is not None:
            columns |= {f"{name}_{axis}": values[:, k] for k, axis in enumerate("xyz")}
    return {name: np.round(values, 4).tolist() for name, values in columns.items()}


def _of(values: Array | None, rows: Rows) -> Array | None:
    return None if values is None else values[rows]


def _rows(recording: Demonstration, from_s: float, to_s: float) -> Rows:
    first, last = np.searchsorted(recording.time_s, (from_s, to_s)).tolist()
    last = max(last, first + 2)
    count = min(last - first, MAX_DEMONSTRATED)
    return np.unique(np.linspace(first, min(last, len(recording)) - 1, count).astype(np.intp))
