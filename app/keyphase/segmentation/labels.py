"""What the program proposes to call a segment, from the segment's own motion and force.

Axes are the robot base's: x forward, y left, z up.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.rotations.quaternions import difference, from_rotation_vector
from keyphase.segmentation.contact import ContactForce, contact_force_of
from keyphase.segmentation.gripper import SAME_EVENT_S, GripperEvent
from keyphase.segmentation.motion import METRES_PER_RADIAN, Motion, motion_of
from keyphase.segmentation.paper.strokes import idle_speed, mean_velocity
from keyphase.segmentation.segmentation import Change, GripperChange

IDLE = "idle"

ENDINGS: Mapping[Change, str] = {
    "": "",
    "made": " until contact",
    "lost": " until contact is lost",
    "changed": " until contact changes",
    "released": " until release",
}
"""How a segment is said to end, by what became of the contact."""

UNTIL: Mapping[GripperChange | Literal[""], str] = {
    "": "",
    "grasp": " until grasp",
    "release": " until release",
}
"""How a segment is said to end, by what the gripper does."""

_TOWARDS = (("forward", "back"), ("left", "right"), ("up", "down"))
_SECOND_AXIS = 0.5
_IN_PLACE = 0.3
_AGAINST = 0.6
_MOSTLY = 0.6
_SETTLED_S = 0.2
_BUILT_UP = 0.35
_STILL_SHARE = 0.02
_MIN_STILL_M, _MAX_STILL_M = 1e-3, 5e-3
_STILL_TURN_M = METRES_PER_RADIAN * np.radians(3.0)


@dataclass(frozen=True, eq=False)
class Evidence:
    """What labels are made from, once per demonstration.

    contact is the force above the free level, in the motion's bins; None without force.
    idle_m_s is the speed below which this recording is idle, still_m the extent of a place in
    which it counts as standing still. gaps_s are the stretches without data, which say nothing of
    how fast the tool was, and gapless the motion without them.
    """

    motion: Motion
    idle_m_s: float
    still_m: float
    contact: ContactForce | None
    gaps_s: tuple[tuple[float, float], ...]
    gapless: Motion

    @classmethod
    def of(cls, demonstration: Demonstration, motion: Motion | None = None) -> "Evidence":
        """Evidence of a demonstration; `motion` where it is already at hand."""
        motion = motion or motion_of(demonstration)
        extent = _size(np.ptp(motion.position_m, axis=0))
        still = min(max(_STILL_SHARE * extent, _MIN_STILL_M), _MAX_STILL_M)
        gaps = demonstration.gaps_s
        gapless = _without(gaps, motion)
        contact = contact_force_of(demonstration)
        return cls(motion, idle_speed(motion), still, contact, gaps, gapless)

    def recorded_s(self, start_s: float, end_s: float) -> float:
        """How long a stretch of time is without its gaps [s]."""
        missing = (min(end_s, to) - max(start_s, since) for since, to in self.gaps_s)
        return end_s - start_s - sum(each for each in missing if each > 0.0)


def _without(gaps_s: Sequence[tuple[float, float]], motion: Motion) -> Motion:
    """A motion whose gaps are as long as one of its steps."""
    time = motion.time_s.copy()
    for start, end in gaps_s:
        time[motion.time_s >= end] -= max(end - start - motion.step_s, 0.0)
    return replace(motion, time_s=time) if gaps_s else motion


class Proposal(NamedTuple):
    """What a segment is proposed to be called: a name without numbers, and its measure beside.

    For example "Move down until contact" and "42 mm", "Rotate about z" and "90°", "idle" and "".
    """

    label: str
    measure: str
    idle: bool


def proposed_label(
    evidence: Evidence,
    start_s: float,
    end_s: float,
    contact_change: bool,
    gripper: Sequence[GripperEvent] = (),
) -> Proposal:
    """Proposal for the segment from `start_s` to `end_s`.

    `contact_change` says whether one is at its end, `gripper` when the gripper did something.
    """
    first, last = _bins(evidence.motion, start_s, end_s)
    done = _done_by_gripper(gripper, end_s)
    ending = _ending(evidence, end_s) if contact_change else UNTIL[done]
    # The next bin counts, too: after a gap in the data the tool may be somewhere else.
    next_bin = min(last, len(evidence.motion.time_s) - 1)
    travel = evidence.motion.pose_m[last - 1] - evidence.motion.pose_m[first]
    beyond = evidence.motion.pose_m[next_bin] - evidence.motion.pose_m[first]
    if _is_idle(evidence, first, next_bin + 1, evidence.recorded_s(start_s, end_s), beyond):
        strength = _built_up_force(evidence, first, last)
        if strength:
            return Proposal(f"Push{ending}", f"{strength:.0f} N", False)
        if done == "grasp":
            return Proposal("Grasp", "", False)
        if _done_by_gripper(gripper, start_s) == "release":
            return Proposal("Release", "", False)
        return Proposal(IDLE + ending, "", True)
    if _size(travel) < 0.5 * _size(beyond):
        travel = beyond
    words, measure = _movement(evidence, first, last, travel)
    return Proposal(words + ending, measure, False)


def _bins(motion: Motion, start_s: float, end_s: float) -> tuple[int, int]:
    first, last = np.searchsorted(motion.time_s, (start_s, end_s)).tolist()
    first = min(first, len(motion.time_s) - 1)
    # Where data is missing at the start, what comes after says nothing of where the tool was then.
    if first > 0 and motion.time_s[first] - start_s > 2.0 * motion.step_s:
        first -= 1
    return first, max(last, first + 1)


def _is_idle(evidence: Evidence, first: int, last: int, duration_s: float, travel: Array) -> bool:
    """Whether the tool stays in a small place, or only drifts slower than hands move on purpose."""
    stretch = evidence.motion.pose_m[first:last]
    reach = np.ptp(stretch, axis=0)
    if _size(reach[:3]) < evidence.still_m and _size(reach[3:]) < _STILL_TURN_M:
        return True
    slowest = evidence.idle_m_s
    drifts = _size(mean_velocity(evidence.gapless, first, last)) < slowest
    nowhere = _size(travel) < 1.5 * slowest * duration_s + _MIN_STILL_M
    return drifts and nowhere and _size(reach) < max(0.02, 2.0 * slowest * duration_s)


def _size(vector: Array) -> float:
    return float(np.sqrt(vector @ vector))


def _built_up_force(evidence: Evidence, first: int, last: int) -> float:
    """Greatest force [N] of a standing tool in contact, where most of it was built up here."""
    contact = evidence.contact
    if contact is None or contact.touching[first:last].mean() < _MOSTLY:
        return 0.0
    strength = np.linalg.norm(contact.force_N[first:last], axis=1)
    settled = max(1, round(_SETTLED_S / evidence.motion.step_s))
    # The impact of arriving is not built up: count from when it has settled.
    greatest = float(strength[settled:].max(initial=0.0))
    return greatest if greatest - strength[:settled].mean() > _BUILT_UP * greatest else 0.0


def _movement(evidence: Evidence, first: int, last: int, travel: Array) -> tuple[str, str]:
    distance = _size(travel[:3])
    if len(travel) == 6:
        turn = _rotation_between(evidence.motion, first, last - 1)
        if METRES_PER_RADIAN * _size(turn) > distance:
            return _rotation(turn)
    steps = np.diff(evidence.motion.position_m[first:last], axis=0)
    path = float(np.linalg.norm(steps, axis=1).sum())
    manner = _manner(evidence, first, last, travel[:3])
    if distance < _IN_PLACE * path and distance < 0.5 * _reach(evidence.motion, first, last):
        return f"{manner} around", _length(path)
    return f"{manner} {_direction(travel[:3])}", _length(distance)


def _reach(motion: Motion, first: int, last: int) -> float:
    return _size(np.ptp(motion.position_m[first:last], axis=0))


def _manner(evidence: Evidence, first: int, last: int, travel: Array) -> str:
    """Push where the force stands against the movement, slide in contact, else move."""
    contact = evidence.contact
    if contact is None or contact.touching[first:last].mean() < _MOSTLY:
        return "Move"
    force = contact.force_N[first:last].mean(axis=0)
    against = -float(force @ travel)
    strength = _size(force) * _size(travel)
    return "Push" if against > _AGAINST * strength else "Slide"


def _done_by_gripper(gripper: Sequence[GripperEvent], time_s: float) -> GripperChange | Literal[""]:
    near = (one for one in gripper if abs(one.time_s - time_s) <= SAME_EVENT_S)
    nearest = min(near, key=lambda one: abs(one.time_s - time_s), default=None)
    return nearest.change if nearest else ""


def _ending(evidence: Evidence, end_s: float) -> str:
    return ENDINGS["made" if evidence.contact is None else evidence.contact.change_at(end_s)]


def _direction(travel: Array) -> str:
    """Along the dominant axis, and the second where it is at least half as much."""
    order = np.argsort(-np.abs(travel))
    most, second = int(order[0]), int(order[1])
    words = [_TOWARDS[most][int(travel[most] < 0)]]
    if abs(travel[second]) >= _SECOND_AXIS * abs(travel[most]):
        words.append(_TOWARDS[second][int(travel[second] < 0)])
    return " and ".join(words)


def _rotation(turn_rad: Array) -> tuple[str, str]:
    axis = int(np.argmax(np.abs(turn_rad)))
    angle = np.degrees(np.copysign(np.linalg.norm(turn_rad), turn_rad[axis]))
    return f"Rotate about {'xyz'[axis]}", f"{angle:.0f}°".replace("-", "−")


def _rotation_between(motion: Motion, first: int, last: int) -> Array:
    """Rotation vector (3,) from one bin to another, base frame, not folded at 180°."""
    assert motion.rotation_rad is not None
    start, end = from_rotation_vector(motion.rotation_rad[[first, last]])
    return difference(end, start)


def _length(metres: float) -> str:
    if metres >= 1.0:
        return f"{metres:.2f} m"
    return f"{1e3 * metres:.0f} mm" if metres >= 0.01 else f"{1e3 * metres:.1f} mm"
