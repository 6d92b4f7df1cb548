"""What a page is told of a replay: how it stands, and what was measured since the last message."""

import threading
from collections.abc import Sequence

import numpy as np
from msgspec import UNSET, Struct, UnsetType

from keyphase.segmentation.end_condition import ContactEnd
from keyphase.simulation.replay.replay import Replay
from keyphase.simulation.replay.result import ReplayState, SkillResult, went_on
from keyphase.skills.skill import until
from keyphase.web.protocol.document_messages import Point
from keyphase.web.scene.figures.force_arrow import MIN_FORCE_N
from keyphase.web.scene.replaying.seen_replay import arrow_scale
from keyphase.workbench.replaying.plan import PlannedSkill
from keyphase.workbench.replaying.plan_paths import (
    demonstrated,
    expected_s,
    middle_of_skill,
    path_of_skill,
)
from keyphase.workbench.replaying.polyline import Polyline
from keyphase.workbench.replaying.run import Phase
from keyphase.workbench.replaying.running import Running
from keyphase.workbench.showing.short_labels import short_labels

EVERY = 2
"""Of the ticks every second one is told: 125 Hz show all there is to see."""


class ContactMessage(Struct, frozen=True):
    """The contact at which a skill is over."""

    direction: Point
    threshold_N: float


class ForceArrowMessage(Struct, frozen=True):
    """How the scene draws the force, so that a page can put its size at the arrow's tip."""

    beside_m: Point
    metres_per_N: float
    least_N: float = MIN_FORCE_N


class SkillMessage(Struct, frozen=True):
    """One skill of a replay.

    proposed        its name is the program's, and no person's
    middle_m        where it is named
    demonstrated_s  (from, to) in the recording
    met_s           when a contact was met
    """

    segment: int | None
    color: int | None
    label: str
    proposed: bool
    short: tuple[str, str, str]
    middle_m: Point
    until: str
    contact: ContactMessage | None
    expected_s: float
    demonstrated_s: tuple[float, float] | None
    way_m: float
    outcome: str | None
    start_s: float | None
    end_s: float | None
    met_s: float | None
    peak_N: float | None


class ReplayMessage(Struct, frozen=True, tag_field="type", tag="replay"):
    """How a replay stands, whenever a skill ends or it pauses, goes on, is over.

    run      counts up
    words    what is disturbed; `world` is seed, friction and noise
    current  index of the skill that runs
    zero_m   positions are told from there
    """

    run: int
    phase: Phase
    name: str
    words: str
    world: str
    goal: str
    speed: float
    held: bool
    time_s: float
    current: int | None
    zero_m: Point
    force_arrow: ForceArrowMessage
    skills: tuple[SkillMessage, ...]
    outcome: str | None
    succeeded: bool | None


class ReplayClosed(Struct, frozen=True, tag_field="type", tag="replay_closed"):
    """The replay is shown no more."""


class ReplaySamples(Struct, frozen=True, tag_field="type", tag="replay_samples"):
    """What was measured since, about 60 times a second, at 125 Hz.

    first         index of the first row
    factor        replay time per real time
    rows          time_s, position x y z [mm], force x y z [N], torque x y z [N m], mm off the path
    demonstrated  columns by name for each skill, with row 0 only; null in a connecting move
    """

    run: int
    first: int
    factor: float
    rows: list[list[float]]
    demonstrated: tuple[dict[str, list[float]] | None, ...] | UnsetType = UNSET


def replay_message(running: Running) -> ReplayMessage:
    """Everything but what was measured."""
    run, settings, plan, result = running.run, running.settings, running.plan, running.result
    results, arrow = run.replay.results, arrow_scale(running)
    return ReplayMessage(
        run=running.number,
        phase=run.phase,
        name=running.opened.recording.name,
        words=settings.in_words(),
        world=settings.world(),
        goal=f"Success when {' and '.join(running.goals)}",
        speed=settings.speed,
        held=run.held,
        time_s=run.elapsed_s,
        current=None if run.phase == "over" else running_skill(run.replay),
        zero_m=_point(plan.demonstration.position_m[0]),
        force_arrow=ForceArrowMessage(arrow.beside_m, arrow.metres_per_N),
        skills=tuple(
            _skill(running, one, results[k] if k < len(results) else None, run.met_s.get(k))
            for k, one in enumerate(plan.planned)
        ),
        outcome=None if result is None else result.outcome(),
        succeeded=None if result is None else result.succeeded,
    )


def running_skill(replay_: Replay) -> int | None:
    """The skill the next tick belongs to; None where none follows what has ended."""
    results = replay_.results
    if len(results) == len(replay_.skills) or (results and not went_on(results[-1])):
        return None
    return len(results)


class Streamed:
    """What one page was told of one replay's measurements; for many threads."""

    def __init__(self, running: Running) -> None:
        self._running = running
        self._lock = threading.Lock()
        self._ticks = self._rows = 0
        self._paths: dict[int, Polyline] = {}

    def more(self) -> ReplaySamples | None:
        """What has come since it was asked last; None where nothing has."""
        run = self._running.run
        with self._lock:
            states = run.replay.states
            end = len(states)
            new = [states[k] for k in range(self._ticks, end) if k % EVERY == 0]
            self._ticks = end
            if not new:
                return None
            first = self._rows
            self._rows += len(new)
            rows = self._rows_of(new)
        plan = self._running.plan
        shown = tuple(demonstrated(plan, one) for one in plan.planned) if first == 0 else UNSET
        return ReplaySamples(self._running.number, first, round(run.factor, 3), rows, shown)

    def _rows_of(self, states: Sequence[ReplayState]) -> list[list[float]]:
        samples = [state.sample for state in states]
        at_m = np.array([sample.position_m for sample in samples])
        columns = (
            np.array([[state.elapsed_s] for state in states]),
            1e3 * (at_m - self._running.plan.demonstration.position_m[0]),
            np.array([sample.force_N for sample in samples]),
            np.array([sample.torque_Nm for sample in samples]),
            np.array([[self._off_mm(state)] for state in states]),
        )
        return np.round(np.concatenate(columns, axis=1), 4).tolist()

    def _off_mm(self, state: ReplayState) -> float:
        """How far the tool is from the path of its skill, wherever on it [mm]."""
        plan = self._running.plan
        skill = state.skill if state.skill is not None else len(plan.planned) - 1
        if skill not in self._paths:
            self._paths[skill] = Polyline(path_of_skill(plan, plan.planned[skill].skill))
        return 1e3 * self._paths[skill].distance_m(state.sample.position_m)


def _skill(
    running: Running, one: PlannedSkill, result: SkillResult | None, met_s: float | None
) -> SkillMessage:
    skill = one.skill
    contact = skill.end_condition if isinstance(skill.end_condition, ContactEnd) else None
    way_m = np.linalg.norm(skill.end_position_m - skill.primitive.start_position_m)
    return SkillMessage(
        segment=one.segment,
        color=one.color,
        label=skill.label,
        proposed=one.proposed,
        short=short_labels(skill.label),
        middle_m=_point(middle_of_skill(running.plan, skill)),
        until=until(skill),
        contact=None if contact is None else ContactMessage(contact.direction, contact.threshold_N),
        expected_s=expected_s(skill),
        demonstrated_s=skill.demonstrated_s,
        way_m=float(way_m),
        outcome=None if result is None else result.outcome or "stopped",
        start_s=None if result is None else result.start_s,
        end_s=None if result is None else result.end_s,
        met_s=met_s,
        peak_N=None if result is None else result.peak_force_N,
    )


def _point(values: np.ndarray) -> Point:
    x, y, z = values.tolist()
    return x, y, z
