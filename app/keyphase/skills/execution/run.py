"""One skill being executed: its primitive, its end monitor, and the forces it keeps up."""

from dataclasses import dataclass, replace
from math import inf

import numpy as np

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.skills import coupling
from keyphase.skills.changed import changed
from keyphase.skills.coupling import Reference, State
from keyphase.skills.end_monitor import Outcome, start_monitor
from keyphase.skills.execution.guard import guard_of, stretched
from keyphase.skills.execution.pressing import (
    DRAGGED_S,
    HEAVY_M_S,
    PUSHED_S,
    given_way,
    is_heavy,
    pressed_now,
    pressing,
    pushed_now,
)
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.execution.softly import softly
from keyphase.skills.primitive import Primitive, progress, tau_of
from keyphase.skills.skill import Skill

UNTURNED = np.array([1.0, 0.0, 0.0, 0.0])
"""Nothing is turned."""


@dataclass(frozen=True, eq=False)
class Start:
    """How a skill begins: what is sensed, velocity (6,) to take over, and shift (3,).

    reference  what was followed last, so that nothing jumps
    turn       (4,) how what follows is turned against its demonstration
    """

    sensed: Sensed
    reference: Reference
    velocity: Array
    shift_m: Array
    turn: Array


class SkillRun:
    """A skill while it runs; `reference`, then a tick of the robot, then `outcome`."""

    def __init__(self, skill: Skill, begin: Start, coupled: bool, stiffness_N_m: float) -> None:
        self.skill, self.shift_m = skill, begin.shift_m
        self._stiffness_N_m = stiffness_N_m
        self._primitive = skill.primitive if coupled else _uncoupled(skill)
        state = coupling.start(
            self._primitive,
            begin.sensed.position_m,
            begin.sensed.orientation_wxyz,
            goal_position_m=self._primitive.goal_position_m + begin.shift_m,
            goal_orientation_wxyz=_turned_goal(self._primitive, begin.turn),
            velocity=begin.velocity,
        )
        self._state = replace(
            state,
            reference_position_m=begin.reference.position_m,
            reference_orientation_wxyz=begin.reference.orientation_wxyz,
        )
        self._guard, self._goal_m = guard_of(skill, begin.shift_m), state.goal_position_m
        self._monitor = start_monitor(skill, begin.sensed.force_N, begin.shift_m)
        self._pressed = pressed_now(skill, 0.0, begin.sensed.force_N)
        self._dragged_N = begin.sensed.force_N
        self._heavy = is_heavy(skill, 0.0, begin.sensed.force_N)
        self._pushed_N = pushed_now(skill, 0.0, begin.sensed.force_N)
        self.velocity = begin.velocity
        """What it moves with (6,), as the next skill takes it over: nowhere soft."""
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

    def reference(self, sensed: Sensed, h: float) -> Reference:
        """What is to be followed for the coming `h` seconds."""
        state = self._slowed(h)
        followed = given_way(sensed, state, self._pressed)
        self._state, wanted = coupling.step(self._primitive, state, followed, h)
        self.fraction = progress(self._primitive, float(self._state.phase))
        wanted = self._pressing(wanted, sensed, h)
        self.velocity = wanted.velocity
        return softly(wanted, sensed, self._pressed, self.skill, self.demonstrated_fraction)

    def _slowed(self, h: float) -> State:
        """The primitive's state, time stretched by its guard and by what is heavy to push."""
        state, k_c = self._state, self._primitive.constants.k_c
        most_m_s = HEAVY_M_S if self._heavy else inf
        if self._guard is None:
            tau = float(tau_of(self._primitive.duration_s))
            return stretched(state, tau, most_m_s, k_c) if self._heavy else state
        state = self._guard.slowed(state, k_c, most_m_s)
        return self._guard.gone_on(state, self._goal_m, h) if self.fraction >= 1.0 else state

    def _pressing(self, wanted: Reference, sensed: Sensed, h: float) -> Reference:
        if not self.skill.kept:
            return wanted
        self._dragged_N = self._dragged_N + min(h / DRAGGED_S, 1.0) * (
            sensed.force_N - self._dragged_N
        )
        self._pressed = pressed_now(
            self.skill, self.demonstrated_fraction, sensed.force_N, self._dragged_N
        )
        fraction = self.demonstrated_fraction
        self._heavy = self._heavy or is_heavy(self.skill, fraction, sensed.force_N)
        pushed = pushed_now(self.skill, fraction, sensed.force_N)
        self._pushed_N = self._pushed_N + min(h / PUSHED_S, 1.0) * (pushed - self._pushed_N)
        at = pressing(wanted, sensed.position_m, self._pressed, self._stiffness_N_m)
        return changed(at, position_m=at.position_m + self._pushed_N / self._stiffness_N_m)

    def outcome(self, sensed: Sensed, h: float, waits: bool) -> Outcome | None:
        """How the skill has ended, if it has; its timeout stands still while it `waits`.

        A goal is within its tolerances some way before the motion is over. The motion is still
        completed, so that the next skill begins where, and as fast as, the demonstration was.
        """
        stalled_s, phase = self._monitor.stalled_s, float(self._state.phase)
        self._monitor, outcome = self._monitor.step(
            sensed.position_m, sensed.orientation_wxyz, sensed.force_N, phase, h, sensed.gripper
        )
        if waits:
            self._monitor = replace(self._monitor, stalled_s=stalled_s)
        return None if outcome == "reached" and self.fraction < 1.0 else outcome


def _turned_goal(primitive: Primitive, turn: Array) -> Array | None:
    """The goal's orientation, turned as what is held was; None where there is none, or no turn."""
    if turn is UNTURNED or not primitive.oriented:
        return None
    return quaternions.product(turn, primitive.goal_orientation_wxyz)


def _uncoupled(skill: Skill) -> Primitive:
    constants = replace(skill.primitive.constants, k_c=0.0)
    return replace(skill.primitive, constants=constants)
