"""A skill: a segment made executable, as a primitive and its end condition."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd, EndCondition
from keyphase.segmentation.end_condition.watch import DEBOUNCE_S, Arming
from keyphase.skills.precondition import Precondition
from keyphase.skills.pressed import KeptForce, Press
from keyphase.skills.primitive import Primitive
from keyphase.skills.rollout import Rollout, rollout
from keyphase.skills.search import Search
from keyphase.skills.spread import Spread
from keyphase.skills.squaring import Squaring

DISAGREES = "its own demonstration does not end so"
"""What a skill says whose condition was fed its demonstration and did not end it."""


@dataclass(frozen=True, eq=False)
class Skill:
    """Plain data: everything needed to execute, draw, print and save one segment.

    label                 the segment's, or what a connecting move connects
    connecting            True for a move that was not demonstrated
    primitive             the motion; at a contact it goes on by `offset_m` beyond it
    end_condition         when it is over
    end_position_m        (3,) where the demonstration ended, at a contact the contact itself
    end_orientation_wxyz  (4,)
    met_m                 (3,) where its demonstration met the contact, which a boundary may lie
                          behind; None without a contact that its demonstration agrees about
    travel_direction      unit vector towards the contact, None without a contact
    offset_m              how far the goal lies beyond the contact
    further_m             how far it goes on beyond its goal, slowly, where it met nothing
    travel_limit_m        how far beyond `end_position_m` it may go before it has failed
    timeout_s             how long without progress until it has failed
    force_limit_N         change of the force against its start that no end condition expects
    demonstrated_s        (start, end) in the demonstration, None for a connecting move
    arming                from where on, and how, a force is taken for its contact; None without one
    press                 how it presses the contact it ended in; None where it moves on
    kept                  forces it keeps up while it moves
    shift_beyond_m        how much must be missing for its contact to shift what follows, None: none
    precondition          what must hold before it runs
    search                how a contact that gave way is told from a rim, and sought, if at all
    squaring              how a part put on what it then carries along is squared there, if at all
    agrees                whether its own demonstration ends it as planned, within 0.25 s of where
                          it did; None where there was nothing to ask
    spread                how far several demonstrations of it lie apart; None where it is of one
    """

    label: str
    connecting: bool
    primitive: Primitive
    end_condition: EndCondition
    end_position_m: Array
    end_orientation_wxyz: Array
    travel_direction: tuple[float, float, float] | None
    offset_m: float
    travel_limit_m: float
    timeout_s: float
    force_limit_N: float
    demonstrated_s: tuple[float, float] | None = None
    arming: Arming | None = None
    press: Press | None = None
    kept: tuple[KeptForce, ...] = ()
    shift_beyond_m: float | None = 0.0
    precondition: Precondition | None = None
    search: Search | None = None
    squaring: Squaring | None = None
    agrees: bool | None = None
    spread: Spread | None = None
    further_m: float = 0.0
    met_m: Array | None = None

    @property
    def debounce_s(self) -> float:
        """How long a force must last to count."""
        return DEBOUNCE_S if self.arming is None else self.arming.debounce_s


def drawn(skill: Skill, points: int = 100) -> Rollout:
    """The skill's path as `points` poses from start to goal, for drawing."""
    duration = skill.primitive.duration_s
    return rollout(skill.primitive, duration / max(points - 1, 1))


def describe(skill: Skill) -> str:
    """The skill in one line: what, how long, and until when."""
    doubt = f" ({DISAGREES})" if skill.agrees is False else ""
    return f"{skill.label}, {skill.primitive.duration_s:.2f} s, {until(skill)}{doubt}"


def until(skill: Skill) -> str:
    """The end condition in words."""
    end = skill.end_condition
    if isinstance(end, ContactEnd):
        x, y, z = end.direction
        if end.release:
            x, y, z = -x, -y, -z
        changes = "falls" if end.release else "rises"
        along = f"the force along ({x:.2f}, {y:.2f}, {z:.2f})"
        return f"until {along} {changes} by {end.threshold_N:.2f} N"
    return (
        f"until within {1e3 * end.position_tolerance_m:.3g} mm and "
        f"{np.degrees(end.rotation_tolerance_rad):.3g} deg of {_millimetres(skill.end_position_m)}"
        f"{by_gripper(end)}"
    )


def by_gripper(end: ConfigurationEnd) -> str:
    """What the gripper has to have done, in words; "" where nothing."""
    if end.gripper is None:
        return ""
    if end.gripper.change == "grasp":
        return f" and the gripper has closed to {end.gripper.opening:.3g} or stalled"
    return f" and the gripper has begun to open from {end.gripper.opening:.3g}"


def _millimetres(position_m: Array) -> str:
    return "(" + ", ".join(f"{1e3 * c:.0f}" for c in position_m) + ") mm"
