# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""Replay a plan of skills in a workcell, tick by tick."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import count
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import SimulationError
from keyphase.segmentation.end_condition import AFTER_S
from keyphase.simulation.impedance import Reference
from keyphase.simulation.replay.contact import (
    AfterContact,
    KeptContact,
    after_contact,
    kept_contact,
    square,
)
from keyphase.simulation.replay.hand import Hand
from keyphase.simulation.replay.result import (
    Frame,
    ReplayResult,
    ReplayState,
    SkillResult,
    Stage,
    greatest_force,
    went_on,
)
from keyphase.simulation.replay.skill import STEP_S, SkillRun, Start, pressing
from keyphase.simulation.samples import as_demonstration, ground_truth, provenance
from keyphase.simulation.simulated import Simulated
from keyphase.simulation.simulation import Sample
from keyphase.simulation.workcells.course import Course
from keyphase.skills.connecting import connecting_skill, is_apart
from keyphase.skills.coupling import Measured
from keyphase.skills.end_monitor import Outcome
from keyphase.skills.skill import Skill, shift_after

PRESSED_S = (AFTER_S[1], 1.0)
"""A contact that was met is pressed at least this long, and at most that long, until it is still.

The end condition's force step is the demonstrated mean until 0.22 s after the contact; so long the
contact is made, too, before anything follows.
"""

STILL_M_S = 0.002
"""A tool slower than this is still."""

LATEST_S = 0.5
"""A contact that has not come yet may come as late as this after the demonstrated one."""

REST_S = 0.5
"""How long the tool rests after the last skill before success is judged."""

_FRAME_TICKS = 10
_AT_REST = np.zeros(6)


@dataclass(frozen=True)
class ReplayOptions:
    """coupled: whether temporal coupling is on; without it skills do not wait."""

    coupled: bool = True


class Replay:
    """A plan being replayed: `step` advances one tick of 4 ms; not stepping is a pause.

    What is to be seen of it is in `state`, what has ended in `results`, the whole in `result`.
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
        self.results: list[SkillResult] = []
        self.states: list[ReplayState] = []
        self.frames: list[Frame] = []
        self.bodies = simulation.bodies
        self._hand = Hand(simulation)
        self._course = Course(simulation.workcell)
        self._stage: Stage = "moving"
        self._stopped = False
        self._shift = np.zeros(3)
        self._kept: tuple[KeptContact, ...] = ()
        self._reference = simulation.here()
        self._run: SkillRun | None = None
        self._outcome: Outcome | None = None
        self._after: AfterContact
        self._stage_ticks = 0
        self._sample = simulation.step(self._reference)
        self._begin(_AT_REST)

    @property
    def state(self) -> ReplayState:
        """The newest tick."""
        return self.states[-1]

    @property
    def over(self) -> bool:
        """Whether there is nothing more to step."""
        return self._stage == "over"

    def step(self) -> ReplayState:
        """Advance one tick; after the end nothing moves any more."""
        if self.over:
            return self.state
        run = self._run
        self._reference = self._next_reference()
        self._hand.act()
        self.simulation.be_at(self._moment(), None if run is None else run.skill.demonstrated_s)
        self._sample = self.simulation.step(self._reference)
        self._course.watch(self.simulation)
        self._stage_ticks += 1
        self._note()
        self._go_on()
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
            if self._stage in ("moving", "pressing"):
                self._note_result(None)
            self._stage = "over"

    def result(self) -> ReplayResult:
        """What the replay was, once it is over."""
        return ReplayResult(
            skills=self.skills,
            results=tuple(self.results),
            stopped=self._stopped,
            goals=dict(self._course.checks(self.simulation)),
            force_limit_N=greatest_force(self.demonstration),
            states=tuple(self.states),
            bodies=self.bodies,
            frames=tuple(self.frames),
            demonstration=self._recording(),
        )

    def _next_reference(self) -> Reference:
        stiffness = self.simulation.gains.stiffness_N_m
        if self._stage == "moving" and self._run is not None:
            return self._run.reference(self._measured(), stiffness)
        return pressing(self._still, self._sample.position_m, self._kept, 1.0, stiffness)

    def _go_on(self) -> None:
        """Enter the next stage where this one is over."""
        if self._stage == "moving":
            assert self._run is not None
            self._outcome = self._run.outcome(self._sample, waits=self._hand.is_on)
            if self._outcome == "contact":
                self._meet()
            elif self._outcome is not None:
                self._end_skill(self._carried())
        elif self._stage == "pressing":
            if self._has_settled():
                self._shift = self._after.shift(self._sample.position_m, self._shift)
                self._end_skill(_AT_REST)
        elif self._stage_ticks * STEP_S >= REST_S:
            self._stage = "over"

    def _meet(self) -> None:
        """A contact was met: press it as the demonstration did, or move on as it did."""
        assert self._run is not None
        self._after = after_contact(self.demonstration, self._run.skill)
        contact = square(self._after.kept(), self._kept)
        if not self._after.stayed or contact is None:
            self._shift = shift_after(self._run.skill, self._sample.position_m, self._shift)
            self._end_skill(self._carried())
        else:
            self._kept = (*self._kept, contact)
            self._enter("pressing")

    def _has_settled(self) -> bool:
        least_s, most_s = PRESSED_S
        time_s = self._stage_ticks * STEP_S
        speed = _length(self.simulation.tool_velocity()[:3])
        return time_s >= most_s or (time_s >= least_s and speed < STILL_M_S)

    def _end_skill(self, velocity: Array) -> None:
        """Note how the skill ended; begin the next one with a velocity (6,), or rest."""
        self._note_result(self._outcome)
        if not went_on(self.results[-1]):
            # What was not expected is not pressed on against.
            self._reference, self._kept = self.simulation.here(), ()
            self._rest()
        elif len(self.results) == len(self.skills):
            self._rest()
        else:
            self._begin(velocity)

    def _begin(self, velocity: Array) -> None:
        """Begin the next skill, taking over a velocity (6,)."""
        skill = self.skills[len(self.results)]
        if skill.connecting:
            self._shift = np.zeros(3)
        kept = (kept_contact(contact, self.demonstration, skill) for contact in self._kept)
        self._kept = tuple(contact for contact in kept if contact is not None)
        begin = Start(
            self._measured(), self._reference, velocity, self._sample.force_N, self._shift
        )
        self._run = SkillRun(skill, begin, self._kept, self.options.coupled)
        self._skill_start_s = self._elapsed_s
        self._peak_N = 0.0
        self._enter("moving")

    def _rest(self) -> None:
        self._run = None
        self._enter("resting")

    def _enter(self, stage: Stage) -> None:
        self._stage, self._stage_ticks = stage, 0
        at = self._reference
        self._still = Reference(at.position_m, at.orientation_wxyz)

    def _carried(self) -> Array:
        """The velocity (6,) of the reference."""
        velocity = self._reference.velocity_m_s
        return np.concatenate((velocity, self._reference.angular_velocity_rad_s))

    def _measured(self) -> Measured:
        sample = self._sample
        velocity = self.simulation.tool_velocity()
        return Measured(sample.position_m, sample.orientation_wxyz, velocity)

    def _moment(self) -> float | None:
        """The moment of the demonstration that is being repeated, a contact's lateness included."""
        run = self._run
        if run is None or run.skill.demonstrated_s is None:
            return None
        end_s = run.skill.demonstrated_s[1]
        if self._stage == "pressing":
            return end_s + min(self._stage_ticks * STEP_S, PRESSED_S[0])
        return min(run.moment_s, end_s + LATEST_S)

    @property
    def _elapsed_s(self) -> float:
        return len(self.states) * STEP_S

    def _note(self) -> None:
        run = self._run
        self._peak_N = max(self._peak_N, _length(self._sample.force_N))
        if len(self.states) % _FRAME_TICKS == 0:
            self.frames.append(Frame(self._elapsed_s, *self.simulation.frame()))
        self.states.append(
            ReplayState(
                elapsed_s=self._elapsed_s + STEP_S,
                stage=self._stage,
                skill=None if run is None else len(self.results),
                fraction=1.0 if run is None else min(run.fraction, 1.0),
                demonstrated_s=None if run is None else run.demonstrated_s,
                sample=self._sample,
                reference=self._reference,
                acceleration=_AT_REST if run is None else run.acceleration,
                held=self._hand.is_on,
            )
        )

    def _note_result(self, outcome: Outcome | None) -> None:
        assert self._run is not None
        self.results.append(
            SkillResult(
                skill=len(self.results),
                label=self._run.skill.label,
                outcome=outcome,
                start_s=self._skill_start_s,
                end_s=self._elapsed_s,
                peak_force_N=self._peak_N,
                ended_m=self._sample.position_m,
                shift_m=self._run.shift_m,
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


def _length(vector: Array) -> float:
    return sqrt(vector.dot(vector))


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
