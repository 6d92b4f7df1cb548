"""What pages are told of a replay: how it stands, and what was measured since the last message."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition import AFTER_S, ContactEnd
from keyphase.simulation.replay.replay import Replay
from keyphase.simulation.replay.result import (
    ReplayResult,
    ReplayState,
    SkillResult,
    went_on,
)
from keyphase.skills.skill import Skill, drawn, until
from keyphase.web.protocol.document_message import short_labels
from keyphase.web.scene.force_arrow import force_arrow_message
from keyphase.web.scene.polyline import Polyline
from keyphase.workbench.recordings import Recording
from keyphase.workbench.replay_plan import PlannedSkill, ReplayPlan
from keyphase.workbench.replay_run import ReplayRun
from keyphase.workbench.replay_settings import ReplaySettings

Rows = NDArray[np.intp]

EVERY = 2
"""Of the ticks every second one is told: 125 Hz show all there is to see."""

MOST_DEMONSTRATED = 250
"""So many samples of the demonstration are told of each skill."""


def replay_message(
    *,
    number: int,
    recording: Recording,
    settings: ReplaySettings,
    plan: ReplayPlan,
    goals: Sequence[str],
    run: ReplayRun,
    result: ReplayResult | None,
) -> dict[str, Any]:
    """The `replay` message: everything but what was measured."""
    results = run.replay.results
    return {
        "type": "replay",
        "run": number,
        "phase": run.phase,
        "recording": recording.id,
        "name": recording.name,
        "workcell": settings.workcell,
        "words": settings.in_words(),
        "world": settings.world(),
        "goal": f"Success when {' and '.join(goals)}",
        "speed": settings.speed,
        "held": run.held,
        "time_s": run.elapsed_s,
        "current": None if run.phase == "over" else running_skill(run.replay),
        "zero_m": plan.demonstration.position_m[0].tolist(),
        "force_arrow": force_arrow_message(),
        "skills": [
            _skill_message(plan, one, results[k] if k < len(results) else None, run.met_s.get(k))
            for k, one in enumerate(plan.planned)
        ],
        "outcome": None if result is None else result.outcome(),
        "succeeded": None if result is None else result.succeeded,
        "stopped": None if result is None else result.stopped,
    }


def running_skill(replay_: Replay) -> int | None:
    """The skill the next tick belongs to; None where none follows what has ended."""
    results = replay_.results
    if len(results) == len(replay_.skills) or (results and not went_on(results[-1])):
        return None
    return len(results)


def _skill_message(
    plan: ReplayPlan, one: PlannedSkill, result: SkillResult | None, met_s: float | None
) -> dict[str, Any]:
    skill = one.skill
    contact = skill.end_condition if isinstance(skill.end_condition, ContactEnd) else None
    return {
        "entry": one.entry,
        "segment": one.segment,
        "color": one.color,
        "label": skill.label,
        "short": short_labels(skill.label),
        "middle_m": middle_of_skill(plan, skill).tolist(),
        "until": until(skill),
        "contact": None
        if contact is None
        else {"direction": list(contact.direction), "threshold_N": contact.threshold_N},
        "expected_s": expected_s(skill),
        "demonstrated_s": skill.demonstrated_s,
        "way_m": float(
            np.linalg.norm(skill.end_position_m - skill.primitive.start_position_m),
        ),
        "outcome": None if result is None else result.outcome or "stopped",
        "start_s": None if result is None else result.start_s,
        "end_s": None if result is None else result.end_s,
        "met_s": met_s,
        "peak_N": None if result is None else result.peak_force_N,
    }


def expected_s(skill: Skill) -> float:
    """How long a skill takes if all is as it was demonstrated."""
    if skill.demonstrated_s is None:
        return skill.primitive.duration_s
    start_s, end_s = skill.demonstrated_s
    return end_s - start_s + (AFTER_S[1] if isinstance(skill.end_condition, ContactEnd) else 0.0)


@dataclass
class Streamed:
    """What was told of one replay's measurements; used under the lock of its session."""

    number: int
    plan: ReplayPlan
    _told: int = 0
    _factor: float = 0.0
    _rows: list[list[float]] = field(default_factory=list)
    _paths: dict[int, Polyline] = field(default_factory=dict)

    def more(self, states: Sequence[ReplayState], factor: float) -> dict[str, Any] | None:
        """The `replay_samples` message with what has come since; None where nothing has."""
        end = len(states)
        new = [states[k] for k in range(self._told, end) if k % EVERY == 0]
        self._told, self._factor = end, factor
        if not new:
            return None
        first = len(self._rows)
        self._rows += self._rows_of(new)
        return self._message(first)

    def everything(self) -> dict[str, Any]:
        """All rows told so far and what was demonstrated, for a page that has come later."""
        return self._message(0)

    def _message(self, first: int) -> dict[str, Any]:
        message: dict[str, Any] = {
            "type": "replay_samples",
            "run": self.number,
            "first": first,
            "factor": round(self._factor, 3),
            "rows": self._rows[first:],
        }
        if first == 0:
            message["demonstrated"] = [demonstrated(self.plan, one) for one in self.plan.planned]
        return message

    def _rows_of(self, states: Sequence[ReplayState]) -> list[list[float]]:
        samples = [state.sample for state in states]
        at_m = np.array([sample.position_m for sample in samples])
        columns = (
            np.array([[state.elapsed_s] for state in states]),
            1e3 * (at_m - self.plan.demonstration.position_m[0]),
            np.array([sample.force_N for sample in samples]),
            np.array([sample.torque_Nm for sample in samples]),
            np.array([[self._off_mm(state)] for state in states]),
        )
        return np.round(np.concatenate(columns, axis=1), 4).tolist()

    def _off_mm(self, state: ReplayState) -> float:
        """How far the tool is from the path of its skill, wherever on it [mm]."""
        skill = state.skill if state.skill is not None else len(self.plan.planned) - 1
        if skill not in self._paths:
            path_m = path_of_skill(self.plan, self.plan.planned[skill].skill)
            self._paths[skill] = Polyline(path_m)
        return 1e3 * self._paths[skill].distance_m(state.sample.position_m)


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
    count = min(last - first, MOST_DEMONSTRATED)
    return np.unique(np.linspace(first, min(last, len(recording)) - 1, count).astype(np.intp))
