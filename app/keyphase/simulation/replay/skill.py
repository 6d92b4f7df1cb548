"""One skill being replayed: its primitive, its end monitor, and the contacts it keeps."""

from dataclasses import dataclass, replace

import numpy as np

from keyphase.demonstration import Array
from keyphase.simulation import impedance
from keyphase.simulation.impedance import RATE_HZ
from keyphase.simulation.replay.contact import KeptContact, given_way
from keyphase.simulation.replay.guard import guard_of
from keyphase.simulation.simulation import Sample
from keyphase.skills import coupling
from keyphase.skills.changed import changed
from keyphase.skills.coupling import Measured
from keyphase.skills.end_monitor import Outcome, start_monitor
from keyphase.skills.primitive import progress
from keyphase.skills.skill import Skill

STEP_S = 1.0 / RATE_HZ


@dataclass(frozen=True, eq=False)
class Start:
    """How a skill begins: measured pose, velocity (6,) to take over, force, shift (3,).

    reference  what the impedance followed last, so that nothing jumps
    """

    measured: Measured
    reference: impedance.Reference
    velocity: Array
    force_N: Array
    shift_m: Array


class SkillRun:
    """A skill while it runs; `reference`, then a tick of the simulation, then `outcome`."""

    def __init__(
        self, skill: Skill, begin: Start, kept: tuple[KeptContact, ...], coupled: bool
    ) -> None:
        self.skill, self.kept, self.shift_m = skill, kept, begin.shift_m
        self._primitive = skill.primitive if coupled else _uncoupled(skill)
        primitive = self._primitive
        state = coupling.start(
            primitive,
            begin.measured.position_m,
            begin.measured.orientation_wxyz,
            goal_position_m=primitive.goal_position_m + begin.shift_m,
            velocity=begin.velocity,
        )
        self._state = replace(
            state,
            reference_position_m=begin.reference.position_m,
            reference_orientation_wxyz=begin.reference.orientation_wxyz,
        )
        self._guard = guard_of(skill, begin.shift_m)
        self._monitor = start_monitor(skill, begin.force_N, begin.shift_m)
        self.acceleration = np.zeros(6)
        self.fraction = 0.0
        """How much of the motion is done, in the primitive's own time: 0 to 1 and beyond."""

    @property
    def demonstrated_s(self) -> float | None:
        """The moment of the demonstration that is being repeated; None in a connecting move."""
        span = self.skill.demonstrated_s
        if span is None:
            return None
        return min(span[0] + self.fraction * self._primitive.duration_s, span[1])

    @property
    def moment_s(self) -> float:
        """Like `demonstrated_s`, going on beyond its end; zero in a connecting move."""
        span = self.skill.demonstrated_s
        return 0.0 if span is None else span[0] + self.fraction * self._primitive.duration_s

    @property
    def demonstrated_fraction(self) -> float:
        """How much of the demonstrated time is done; a contact's motion goes on beyond it."""
        span, at = self.skill.demonstrated_s, self.demonstrated_s
        return 0.0 if span is None or at is None else (at - span[0]) / (span[1] - span[0])

    def reference(self, measured: Measured, stiffness_N_m: float) -> impedance.Reference:
        """What the impedance is to follow for the coming tick."""
        state = self._state
        if self._guard is not None:
            state = self._guard.slowed(state, self._primitive.constants.k_c)
        followed = given_way(measured, state, self.kept)
        self._state, reference = coupling.step(self._primitive, state, followed, STEP_S)
        self.acceleration = reference.acceleration
        self.fraction = progress(self._primitive, float(self._state.phase))
        wanted = impedance.Reference(
            reference.position_m,
            reference.orientation_wxyz,
            reference.velocity[:3],
            reference.velocity[3:],
        )
        if not self.kept:
            return wanted
        return pressing(
            wanted, measured.position_m, self.kept, self.demonstrated_fraction, stiffness_N_m
        )

    def outcome(self, sample: Sample, waits: bool) -> Outcome | None:
        """How the skill has ended, if it has; its time stands still while it `waits`.

        A goal is within its tolerances some way before the motion is over. The motion is still
        completed, so that the next skill begins where, and as fast as, the demonstration was.
        """
        before = self._monitor.time_s
        self._monitor, outcome = self._monitor.step(
            sample.position_m,
            sample.orientation_wxyz,
            sample.force_N,
            float(self._state.phase),
            STEP_S,
        )
        if waits:
            self._monitor = replace(self._monitor, time_s=before)
        return None if outcome == "reached" and self.fraction < 1.0 else outcome


def pressing(
    reference: impedance.Reference,
    position_m: Array,
    kept: tuple[KeptContact, ...],
    fraction: float,
    stiffness_N_m: float,
) -> impedance.Reference:
    """The reference with the spring pressed as the kept contacts ask, at rest along them."""
    if not kept:
        return reference
    at, velocity = reference.position_m, reference.velocity_m_s
    for contact in kept:
        d = contact.direction
        wanted = contact.pressed_m(position_m, reference.position_m, fraction, stiffness_N_m)
        at = at + (wanted - float(at.dot(d))) * d
        velocity = velocity - float(velocity.dot(d)) * d
    return changed(reference, position_m=at, velocity_m_s=velocity)


def _uncoupled(skill: Skill):
    constants = replace(skill.primitive.constants, k_c=0.0)
    return replace(skill.primitive, constants=constants)
