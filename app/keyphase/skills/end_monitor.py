"""Watch a skill while it runs and say when, and how, it is over."""

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ConfigurationEnd, ContactEnd
from keyphase.segmentation.end_condition.watch import Arming
from keyphase.skills.changed import changed
from keyphase.skills.execution.grip import Grip, gripped
from keyphase.skills.execution.pressing import TOUCHING_N
from keyphase.skills.primitive import progress
from keyphase.skills.skill import Skill

Outcome = Literal["reached", "contact", "timeout", "too far", "unexpected contact", "not ready"]

REACHED_AFTER = 0.8
"""A configuration counts from this fraction of the motion on; a closed path starts at its goal."""

FELL_AWAY = 0.4
"""A change of force counts as a contact if the force is above this part of it, and not gone."""

PROGRESS_FRACTION, PROGRESS_M = 0.01, 0.001
"""A skill gets on while its motion, or the tool towards the contact, gains this much."""


@dataclass(frozen=True, eq=False)
class EndMonitor:
    """A skill's end condition while it runs; a value, `step` returns the next one.

    skill, shift_m    what is watched, and by how much it is executed away from its demonstration
    start_force_N     (3,) at the start
    level_N           force along the contact direction before the contact; it follows the force,
                      friction that starts with the motion included, until the tool comes near
    armed             whether the tool is near enough for a contact to count
    time_s            since the start
    stalled_s         since the skill last got on: its motion, or the tool towards its contact
    fraction, beyond_m  how far it had got by then
    over_s, beyond_s  how long the force has been over the threshold, and beyond the limit
    grip              the gripper's opening since the start; None where nobody measures it
    """

    skill: Skill
    shift_m: Array
    start_force_N: Array
    level_N: float
    armed: bool = False
    time_s: float = 0.0
    stalled_s: float = 0.0
    fraction: float = 0.0
    beyond_m: float = -np.inf
    over_s: float = 0.0
    beyond_s: float = 0.0
    grip: Grip | None = None

    def step(
        self,
        position_m: Array,
        orientation_wxyz: Array,
        force_N: Array,
        phase: float,
        h: float,
        gripper: float | None = None,
    ) -> tuple["EndMonitor", Outcome | None]:
        """Take in a sample, `h` seconds after the one before.

        position_m, force_N (3,) and orientation_wxyz (4,) as measured, phase of the primitive;
        the gripper's opening, where it is measured.
        """
        at_m = position_m - self.shift_m
        beyond_m = _beyond_contact(self.skill, at_m)
        change = force_N - self.start_force_N
        changed_by = float(change.dot(change))
        # What fell away is no contact that was not expected, however hard it was pressed before.
        is_there = float(force_N.dot(force_N)) > FELL_AWAY**2 * changed_by
        beyond = is_there and changed_by > self.skill.force_limit_N**2
        done = progress(self.skill.primitive, phase)
        following = changed(
            self,
            time_s=self.time_s + h,
            beyond_s=self.beyond_s + h if beyond else 0.0,
            **self._got_on(beyond_m, min(done, 1.0), h),
            **self._taken_in(beyond_m, force_N, done, h),
            **({} if gripper is None else {"grip": gripped(self.grip, gripper, h)}),
        )
        return following, following._outcome(at_m, beyond_m, orientation_wxyz, done)

    def _got_on(self, beyond_m: float, fraction: float, h: float) -> dict[str, Any]:
        """The fields that say since when nothing has been gained."""
        gained = beyond_m >= self.beyond_m + PROGRESS_M
        if gained or fraction >= self.fraction + PROGRESS_FRACTION:
            furthest = max(beyond_m, self.beyond_m)
            return {"stalled_s": 0.0, "fraction": fraction, "beyond_m": furthest}
        return {"stalled_s": self.stalled_s + h}

    def _taken_in(self, beyond_m: float, force_N: Array, done: float, h: float) -> dict[str, Any]:
        """The fields that a force changes in a skill that ends at a contact."""
        end, arming = self.skill.end_condition, self.skill.arming
        if not isinstance(end, ContactEnd) or arming is None:
            return {}
        along = _along(force_N, end.direction)
        if not (self.armed or _is_near(self.skill, arming, beyond_m, done)):
            following = min(h / arming.level_s, 1.0)
            return {"level_N": self.level_N + following * (along - self.level_N)}
        over = along - self.level_N > end.threshold_N or (
            # What presses no more cannot be released again.
            end.release and done >= 1.0 and float(force_N.dot(force_N)) < TOUCHING_N**2
        )
        return {"armed": True, "over_s": self.over_s + h if over else 0.0}

    def _outcome(self, at_m: Array, beyond_m: float, wxyz: Array, done: float) -> Outcome | None:
        debounce_s = self.skill.debounce_s
        if _lasts(self.over_s, debounce_s):
            return "contact"
        if _lasts(self.beyond_s, debounce_s):
            return "unexpected contact"
        if beyond_m > self.skill.travel_limit_m:
            return "too far"
        if _is_reached(self.skill, at_m, wxyz, done) and _has_gripped(self.skill, self.grip):
            return "reached"
        return "timeout" if self.stalled_s >= self.skill.timeout_s else None


def start_monitor(
    skill: Skill, force_N: ArrayLike, shift_m: ArrayLike = (0.0, 0.0, 0.0)
) -> EndMonitor:
    """Monitor of a skill that starts now under the measured force (3,).

    `shift_m` (3,): how far start and goal are moved against the demonstration.
    """
    force = np.asarray(force_N, float)
    end = skill.end_condition
    level = _along(force, end.direction) if isinstance(end, ContactEnd) else 0.0
    return EndMonitor(skill, np.asarray(shift_m, float), force, level)


def _lasts(duration_s: float, debounce_s: float) -> bool:
    return duration_s >= debounce_s - 1e-9


def _beyond_contact(skill: Skill, at_m: Array) -> float:
    """How far past the demonstrated contact (below zero: before it) [m]."""
    if skill.travel_direction is None:
        return 0.0
    return _along(at_m - skill.end_position_m, skill.travel_direction)


def _along(vector: Array, direction: tuple[float, float, float]) -> float:
    # In plain numbers: making an array of the direction takes several times as long.
    x, y, z = vector.tolist()
    a, b, c = direction
    return a * x + b * y + c * z


def _is_near(skill: Skill, arming: Arming, beyond_m: float, done: float) -> bool:
    if done * skill.primitive.duration_s < arming.after_s - 1e-6:
        return False
    return beyond_m >= -arming.within_m


def _has_gripped(skill: Skill, grip: Grip | None) -> bool:
    end = skill.end_condition
    if grip is None or not isinstance(end, ConfigurationEnd) or end.gripper is None:
        return True
    return end.gripper.is_met(grip.opening, grip.begun_at, grip.still_s)


def _is_reached(skill: Skill, at_m: Array, wxyz: Array, done: float) -> bool:
    end = skill.end_condition
    if not isinstance(end, ConfigurationEnd) or done < REACHED_AFTER:
        return False
    way = at_m - skill.end_position_m
    if float(way.dot(way)) > end.position_tolerance_m**2:
        return False
    if not skill.primitive.oriented:
        return True
    left = quaternions.shortest_difference(skill.end_orientation_wxyz, wxyz)
    return float(left.dot(left)) <= end.rotation_tolerance_rad**2
