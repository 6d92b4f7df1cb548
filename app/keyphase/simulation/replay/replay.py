# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Replay a plan of skills in a workcell, tick by tick."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count
from math import sqrt

from numpy.typing import ArrayLike

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import SimulationError
from keyphase.simulation.impedance import Reference
from keyphase.simulation.replay.allowed_force import AllowedForce, Hardest
from keyphase.simulation.replay.hand import Hand
from keyphase.simulation.replay.result import Frame, ReplayResult, ReplayState
from keyphase.simulation.samples import as_demonstration, ground_truth, provenance
from keyphase.simulation.simulated import Simulated
from keyphase.simulation.simulation import Sample
from keyphase.simulation.workcells.course import Course
from keyphase.skills import coupling
from keyphase.skills.connecting import connecting_skill, is_apart
from keyphase.skills.execution.executor import PRESSED_S, STEP_S, Executor
from keyphase.skills.execution.result import SkillResult
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.skill import Skill

LATEST_S = 0.5
"""A contact that has not come yet may come as late as this after the demonstrated one."""

_FRAME_TICKS = 10


@dataclass(frozen=True)
class ReplayOptions:
    """coupled: whether temporal coupling is on; without it skills do not wait."""

    coupled: bool = True


class Replay:
    """A plan being replayed: `step` advances one tick of 4 ms; not stepping is a pause.

    What is executed is an `Executor`; the simulation is its robot. What is to be seen of it is in
    `state`, what has ended in `results`, the whole in `result`.
    """

    def __init__(
        self,
        simulation: Simulated,
        skills: Sequence[Skill],
        demonstration: Demonstration,
        options: ReplayOptions | None = None,
    ) -> None:
        """Replay `skills`, made from `demonstration`, in a workcell at its start.

        A connecting move is put before the first skill where the arm is away from its start.
        Raises SimulationError for a plan without skills.
        """
        if not skills:
            raise SimulationError(
                f"A plan must have at least one skill to be replayed, but that of "
                f"{demonstration.name} has none; keep a segment."
            )
        self.simulation, self.demonstration = simulation, demonstration
        self.options = options or ReplayOptions()
        self.skills = (*_approach(simulation, skills[0]), *skills)
        self.states: list[ReplayState] = []
        self.frames: list[Frame] = []
        self.bodies = simulation.bodies
        self._hand = Hand(simulation)
        self._course = Course(simulation.workcell)
        self._stopped = False
        self._allowed = AllowedForce(demonstration)
        self._hardest = Hardest(0.0, self._allowed.at(demonstration.start_s), demonstration.start_s)
        self._repeated_s = demonstration.start_s
        self._executor = Executor(
            self.skills,
            self._sensed(simulation.step(simulation.here())),
            stiffness_N_m=simulation.gains.stiffness_N_m,
            coupled=self.options.coupled,
        )

    @property
    def state(self) -> ReplayState:
        """The newest tick."""
        return self.states[-1]

    @property
    def results(self) -> list[SkillResult]:
        """How the skills that are over ended."""
        return self._executor.results

    @property
    def over(self) -> bool:
        """Whether there is nothing more to step."""
        return self._executor.over

    def step(self) -> ReplayState:
        """Advance one tick; after the end nothing moves any more."""
        if self.over:
            return self.state
        reference = self._executor.reference
        self._hand.act()
        run = self._executor.run
        # A search repeats no path.
        repeated = None if self._executor.stage == "searching" else run
        span = None if repeated is None else repeated.skill.demonstrated_s
        moment_s = self._moment()
        self.simulation.be_at(moment_s, span)
        followed = _followed(reference)
        sample = self.simulation.step(followed)
        self._course.watch(self.simulation)
        self._weigh(sample, moment_s)
        self._note(sample, followed, reference.acceleration)
        self._executor.step(self._sensed(sample), waits=self._hand.is_on)
        return self.state

    def push(self, force_N: ArrayLike) -> None:
        """Push the tool with a force (3,) [N], base frame, until told otherwise."""
        self._hand.push(force_N)

    def hold(self, pose: Reference | None) -> None:
        """Hold the tool at a pose, None to let it go. A skill's time stands still meanwhile."""
        self._hand.held = pose

    def stop(self) -> None:
        """End the replay at once."""
        if not self.over:
            self._stopped = True
            self._executor.stop()

    def result(self) -> ReplayResult:
        """What the replay was, once it is over."""
        return ReplayResult(
            skills=self.skills,
            results=tuple(self.results),
            stopped=self._stopped,
            goals=dict(self._course.checks(self.simulation)),
            hardest=self._hardest,
            states=tuple(self.states),
            bodies=self.bodies,
            frames=tuple(self.frames),
            demonstration=self._recording(),
        )

    def _sensed(self, sample: Sample) -> Sensed:
        pose, velocity = (
            (sample.position_m, sample.orientation_wxyz),
            self.simulation.tool_velocity(),
        )
        return Sensed(*pose, velocity, sample.force_N, sample.gripper)

    def _moment(self) -> float | None:
        """The moment of the demonstration that is being repeated, a contact's lateness included."""
        executor, run = self._executor, self._executor.run
        if run is None:
            return self._repeated_s
        if run.skill.demonstrated_s is None:
            return None
        end_s = run.skill.demonstrated_s[1]
        # While a part is squared, and pressed for it, nothing is repeated.
        if executor.stage == "pressing" and run.skill.squaring is None:
            return end_s + min(executor.in_stage_s, PRESSED_S[0])
        return min(run.moment_s, end_s + LATEST_S)

    def _weigh(self, sample: Sample, moment_s: float | None) -> None:
        """Keep the tick that came nearest to what is allowed; what repeats nothing, as before."""
        self._repeated_s = self._repeated_s if moment_s is None else moment_s
        force_N = sqrt(float(sample.force_N.dot(sample.force_N)))
        now = Hardest(force_N, self._allowed.at(self._repeated_s), self._repeated_s)
        if now.share > self._hardest.share:
            self._hardest = now

    def _note(self, sample: Sample, followed: Reference, acceleration: Array) -> None:
        """Keep the tick that the executor's present stage and skill asked for."""
        executor, run = self._executor, self._executor.run
        if len(self.states) % _FRAME_TICKS == 0:
            self.frames.append(Frame(executor.elapsed_s, *self.simulation.frame()))
        self.states.append(
            ReplayState(
                elapsed_s=executor.elapsed_s + STEP_S,
                stage=executor.stage,
                skill=executor.skill,
                fraction=1.0 if run is None else min(run.fraction, 1.0),
                demonstrated_s=None if run is None else run.demonstrated_s,
                sample=sample,
                reference=followed,
                acceleration=acceleration,
                held=self._hand.is_on,
            )
        )

    def _recording(self) -> Demonstration:
        samples: list[Sample] = [state.sample for state in self.states]
        origin = provenance(self.simulation, "replay")
        metadata = origin | {
            "demonstration": self.demonstration.name,
            "ground_truth": ground_truth(samples, origin),
        }
        return as_demonstration(samples, f"{self.demonstration.name}_replay", metadata)


def run(
    simulation: Simulated,
    skills: Sequence[Skill],
    demonstration: Demonstration,
    options: ReplayOptions | None = None,
) -> ReplayResult:
    """Replay to the end, as fast as it computes.

    Raises SimulationError for a plan without skills, and when the physics diverge.
    """
    replay = Replay(simulation, skills, demonstration, options)
    for _ in count():
        replay.step()
        if replay.over:
            break
    return replay.result()


def _followed(reference: coupling.Reference) -> Reference:
    """The executor's reference as the impedance takes it."""
    velocity = reference.velocity
    return Reference(reference.position_m, reference.orientation_wxyz, velocity[:3], velocity[3:])


def _approach(simulation: Simulated, first: Skill) -> tuple[Skill, ...]:
    """The connecting move from where the arm is to where the plan starts, if one is needed."""
    here = simulation.here()
    start = first.primitive
    there = (start.start_position_m, start.start_orientation_wxyz)
    if not is_apart(here.position_m, here.orientation_wxyz, *there):
        return ()
    label = f"connect to {first.label}"
    return (
        connecting_skill(
            here.position_m, here.orientation_wxyz, *there, oriented=start.oriented, label=label
        ),
    )
