"""What a replay shows while it runs, and what it leaves behind."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.simulation.impedance import Reference
from keyphase.simulation.replay.allowed_force import Hardest
from keyphase.simulation.simulation import Sample
from keyphase.skills.execution.result import SkillResult, Stage, went_on
from keyphase.skills.skill import Skill

_STOOD_TICKS, _STOOD_M, _OFF_M, _FREE_N = 75, 0.003, 0.005, 1.0
"""A tool that moved less than so far in 0.3 s stood; one so far off its reference is pulled by more
than 10 N, which something holds, and that is the arm if no more than so much is felt."""

GENTLE = "no force above twice the demonstrated"
"""At the moment that was repeated, 15 N at least (`AllowedForce`)."""


@dataclass(frozen=True, eq=False)
class ReplayState:
    """One tick of a replay, for whoever shows it.

    elapsed_s       since the replay began
    skill           index in the plan, None before and after it
    fraction        how much of the skill's motion is done, 0 to 1
    demonstrated_s  the moment of the demonstration that is being repeated, if one is
    sample          what was measured: pose, joints, wrench
    reference       what the impedance follows
    acceleration    (6,) reference acceleration of the skill
    held            whether the hand is on the robot
    """

    elapsed_s: float
    stage: Stage
    skill: int | None
    fraction: float
    demonstrated_s: float | None
    sample: Sample
    reference: Reference
    acceleration: Array
    held: bool


@dataclass(frozen=True, eq=False)
class Frame:
    """Where everything was at one moment, to be drawn.

    position_m (B, 3) and orientation_wxyz (B, 4), w x y z, of the result's `bodies`, base frame.
    """

    time_s: float
    position_m: Array
    orientation_wxyz: Array


@dataclass(frozen=True, eq=False)
class ReplayResult:
    """A replay that is over.

    skills         the plan as it was replayed, connecting moves included
    results        one for each skill that was begun
    stopped        whether somebody stopped it
    goals          what the workcell asks for, by name: events in their order, predicates at the end
    hardest        how near it came to the force that is allowed; beyond, it is no success
    states         every tick
    bodies         names of what the frames hold: the robot's links, then the parts
    frames         the scene at 25 Hz
    demonstration  the replay as a recording, which can be saved, opened and segmented
    """

    skills: tuple[Skill, ...]
    results: tuple[SkillResult, ...]
    stopped: bool
    goals: Mapping[str, bool]
    hardest: Hardest
    states: tuple[ReplayState, ...]
    bodies: tuple[str, ...]
    frames: tuple[Frame, ...]
    demonstration: Demonstration

    @property
    def checks(self) -> Mapping[str, bool]:
        """All that success is made of, by name: the goals, the plan, and the forces."""
        return {
            **self.goals,
            "plan carried out": self.completed,
            GENTLE: self.hardest.share <= 1.0,
        }

    @property
    def succeeded(self) -> bool:
        """Whether all of `checks` holds; nothing less is a success."""
        return all(self.checks.values())

    @property
    def completed(self) -> bool:
        """Whether every skill of the plan ended as its end condition says."""
        done = len(self.results) == len(self.skills) and all(map(went_on, self.results))
        return done and not self.stopped

    @property
    def duration_s(self) -> float:
        """How long the replay took in the workcell's time."""
        return self.states[-1].elapsed_s

    @property
    def peak_force(self) -> float:
        """Largest force the wrist sensor measured [N]."""
        return max(float(np.linalg.norm(state.sample.force_N)) for state in self.states)

    def profile(self, skill: int) -> tuple[Array, Array]:
        """Times (N,) since its start and measured forces (N, 3) of one skill of the plan."""
        ticks = [state for state in self.states if state.skill == skill]
        time = np.array([state.elapsed_s for state in ticks])
        force = np.array([state.sample.force_N for state in ticks]).reshape(-1, 3)
        return time - time[:1], force

    def outcome(self) -> str:
        """What became of it, in one line."""
        if self.succeeded:
            return "success"
        if self.stopped:
            where = f"in “{self.results[-1].label}”" if self.results else "before it moved"
            goals = (f"{name}: {'yes' if holds else 'no'}" for name, holds in self.goals.items())
            return "; ".join([f"stopped by you {where}", *goals])
        failed = ", ".join(name for name, holds in self.checks.items() if not holds)
        too_hard = f"; {self.hardest}" if not self.checks[GENTLE] else ""
        return f"failed, not {failed}: {self._reason()}{too_hard}"

    def _reason(self) -> str:
        bad = next((r for r in self.results if not went_on(r)), None)
        if bad is not None:
            why = ": nothing is in its way, the arm does not reach its goal"
            out_of_reach = bad.outcome == "timeout" and self._is_out_of_reach(bad.skill)
            said = f"skill {bad.skill + 1} ({bad.label}) ended with {bad.outcome}"
            return said + (why if out_of_reach else "")
        return "every skill ended as planned"

    def _is_out_of_reach(self, skill: int) -> bool:
        """Whether a tool that nothing touched stood still in the end, off what it was to follow."""
        ticks = [state for state in self.states if state.skill == skill][-_STOOD_TICKS:]
        if not ticks or not len(ticks[-1].sample.joints_rad) or ticks[-1].held:
            return False
        felt = np.mean([state.sample.force_N for state in ticks], axis=0)
        end, begin = ticks[-1].sample.position_m, ticks[0].sample.position_m
        off_m = float(np.linalg.norm(ticks[-1].reference.position_m - end))
        stood = float(np.linalg.norm(end - begin)) < _STOOD_M
        return stood and off_m > _OFF_M and float(np.linalg.norm(felt)) < _FREE_N
