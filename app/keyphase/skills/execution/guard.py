"""Guarded motion: a contact is not approached faster than it was met in the demonstration.

A part that lies higher is met earlier in the stroke, where the demonstrated hand was still fast.
Time is stretched there, so that the path stays what it is.
"""

from dataclasses import dataclass, replace
from math import inf, sqrt

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.changed import changed
from keyphase.skills.coupling import State
from keyphase.skills.primitive import tau_of
from keyphase.skills.skill import Skill

SPEED_M_S = (0.02, 0.04)
"""A contact is approached at least and at most this fast; the impedance is soft enough for that."""

BRAKE_M_S2 = 0.5
"""How hard the guard brakes before the guarded stretch."""


@dataclass(frozen=True, eq=False)
class Guard:
    """Where a contact may be met, and how fast it may be approached.

    contact_m    (3,) where it was demonstrated, shifted with the skill
    direction    (3,) in which the tool travels there
    stretch_m    how far before it a contact may be met
    speed_m_s    the fastest approach within that stretch
    further_m    how far it goes on beyond the goal, as slowly, once the motion is over
    tau          time constant of the primitive without guard [s]
    """

    contact_m: Array
    direction: Array
    stretch_m: float
    speed_m_s: float
    further_m: float
    tau: float

    def slowed(self, state: State, k_c: float, most_m_s: float = inf) -> State:
        """The state with its time stretched to the speed that is allowed where it is.

        That is `most_m_s` at the most; `k_c` is the primitive's.
        """
        return stretched(state, self.tau, min(self._allowed(state.position_m), most_m_s), k_c)

    def gone_on(self, state: State, goal_m: Array, h: float) -> State:
        """The state with its goal moved on for `h` seconds, from `goal_m` (3,) where it was.

        What lies further away than the demonstration was extended is looked for no faster.
        """
        gone = float((state.goal_position_m - goal_m).dot(self.direction))
        if gone >= self.further_m:
            return state
        step = min(self.speed_m_s * h, self.further_m - gone) * self.direction
        return replace(state, goal_position_m=state.goal_position_m + step)

    def _allowed(self, position_m: Array) -> float:
        ahead = float((self.contact_m - position_m).dot(self.direction)) - self.stretch_m
        return sqrt(self.speed_m_s**2 + 2.0 * BRAKE_M_S2 * max(ahead, 0.0))


def stretched(state: State, tau: float, allowed_m_s: float, k_c: float) -> State:
    """The state with its time, of constant `tau` where free, stretched to a speed at the most.

    `k_c` is the primitive's: the temporal coupling stretches time on top of it.
    """
    speed = state.z[:3]
    tau = tau * max(1.0, sqrt(speed.dot(speed)) / tau / allowed_m_s)
    before = float(state.tau)
    if tau == before:
        return state
    # The reference has to know of the change of speed, as if it were in its acceleration.
    coupled = 1.0 + k_c * float(state.error_m.dot(state.error_m))
    change = state.z * (1.0 / tau - 1.0 / before) / coupled
    return changed(state, tau=np.asarray(tau), reference_velocity=state.reference_velocity + change)


def guard_of(skill: Skill, shift_m: Array) -> Guard | None:
    """The guard of a contact-terminated skill; None for others."""
    speed = guarded_speed(skill)
    if skill.travel_direction is None or speed is None:
        return None
    return Guard(
        contact_m=skill.end_position_m + shift_m,
        direction=np.asarray(skill.travel_direction),
        stretch_m=guarded_stretch(skill),
        speed_m_s=speed,
        further_m=skill.further_m,
        tau=float(tau_of(skill.primitive.duration_s)),
    )


def guarded_stretch(skill: Skill) -> float:
    """From how far before its contact on a skill is guarded [m]: where a contact may end it."""
    return max(skill.offset_m, skill.arming.within_m if skill.arming else 0.0)


def guarded_speed(skill: Skill) -> float | None:
    """How fast a skill approaches its contact within the guarded stretch [m/s]; None: no guard.

    A skill that goes on for a distance a beyond its contact brakes from speed v in 2 a / v.
    """
    if skill.travel_direction is None or skill.demonstrated_s is None or skill.offset_m <= 0.0:
        return None
    start_s, end_s = skill.demonstrated_s
    brake_s = skill.primitive.duration_s - (end_s - start_s)
    speed = 2.0 * skill.offset_m / brake_s if brake_s > 0.0 else SPEED_M_S[0]
    return min(max(speed, SPEED_M_S[0]), SPEED_M_S[1])
