"""What the program proposes to call a segment, from the segment's own motion and force.

Axes are the robot base's: x forward, y left, z up.
"""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.contact import contact_force, in_contact
from keyphase.segmentation.motion import METRES_PER_RADIAN, Motion, motion_of
from keyphase.segmentation.paper.strokes import idle_speed, mean_velocity

IDLE = "idle"

_TOWARDS = (("forward", "back"), ("left", "right"), ("up", "down"))
_SECOND_AXIS = 0.5
_IN_PLACE = 0.3
_AGAINST = 0.6
_MOSTLY = 0.6
_RELEASED = 0.5
_SETTLED_S = 0.2
_BUILT_UP = 0.35
_STILL_SHARE = 0.02
_LEAST_STILL_M, _MOST_STILL_M = 1e-3, 5e-3
_STILL_TURN_M = METRES_PER_RADIAN * np.radians(3.0)


@dataclass(frozen=True, eq=False)
class Evidence:
    """What labels are made from, once per demonstration.

    force_N (n, 3) above the free level and touching (n,), in the motion's bins; None without
    force. idle_m_s is the speed below which this recording is idle, still_m the extent of a
    place in which it counts as standing still.
    """

    motion: Motion
    idle_m_s: float
    still_m: float
    force_N: Array | None
    touching: np.ndarray | None

    @classmethod
    def of(cls, demonstration: Demonstration, motion: Motion | None = None) -> "Evidence":
        """Evidence of a demonstration; `motion` where it is already at hand."""
        motion = motion or motion_of(demonstration)
        force = contact_force(demonstration)
        touching = None if force is None else in_contact(force)
        extent = _size(np.ptp(motion.position_m, axis=0))
        still = min(max(_STILL_SHARE * extent, _LEAST_STILL_M), _MOST_STILL_M)
        return cls(motion, idle_speed(motion), still, force, touching)


def proposed_label(
    evidence: Evidence, start_s: float, end_s: float, contact_change: bool
) -> tuple[str, bool]:
    """Label of the segment from `start_s` to `end_s`, and whether it is idle.

    For example "Move down 42 mm until contact", "Rotate about z 90°", "Slide left 54 mm", "idle".
    `contact_change` says whether one is at its end.
    """
    first, last = _bins(evidence.motion, start_s, end_s)
    ending = _ending(evidence, last) if contact_change else ""
    travel = evidence.motion.pose_m[last - 1] - evidence.motion.pose_m[first]
    if _is_idle(evidence, first, last, end_s - start_s, travel):
        strength = _built_up_force(evidence, first, last)
        return (f"Push with {strength:.0f} N{ending}", False) if strength else (IDLE + ending, True)
    return _movement(evidence, first, last, travel) + ending, False


def _bins(motion: Motion, start_s: float, end_s: float) -> tuple[int, int]:
    first, last = np.searchsorted(motion.time_s, (start_s, end_s)).tolist()
    first = min(first, len(motion.time_s) - 1)
    return first, max(last, first + 1)


def _is_idle(evidence: Evidence, first: int, last: int, duration_s: float, travel: Array) -> bool:
    """Whether the tool stays in a small place, or only drifts slower than hands move on purpose."""
    stretch = evidence.motion.pose_m[first:last]
    reach = np.ptp(stretch, axis=0)
    if _size(reach[:3]) < evidence.still_m and _size(reach[3:]) < _STILL_TURN_M:
        return True
    slowest = evidence.idle_m_s
    drifts = _size(mean_velocity(evidence.motion, first, last)) < slowest
    nowhere = _size(travel) < 1.5 * slowest * duration_s + _LEAST_STILL_M
    return drifts and nowhere and _size(reach) < max(0.02, 2.0 * slowest * duration_s)


def _size(vector: Array) -> float:
    return float(np.sqrt(vector @ vector))


def _built_up_force(evidence: Evidence, first: int, last: int) -> float:
    """Greatest force [N] of a standing tool in contact, where most of it was built up here."""
    if evidence.force_N is None or evidence.touching is None:
        return 0.0
    if evidence.touching[first:last].mean() < _MOSTLY:
        return 0.0
    strength = np.linalg.norm(evidence.force_N[first:last], axis=1)
    settled = max(1, round(_SETTLED_S / evidence.motion.step_s))
    # The impact of arriving is not built up: count from when it has settled.
    greatest = float(strength[settled:].max(initial=0.0))
    return greatest if greatest - strength[:settled].mean() > _BUILT_UP * greatest else 0.0


def _movement(evidence: Evidence, first: int, last: int, travel: Array) -> str:
    distance = _size(travel[:3])
    if len(travel) == 6:
        turn = _rotation_between(evidence.motion, first, last - 1)
        if METRES_PER_RADIAN * _size(turn) > distance:
            return _rotation(turn)
    steps = np.diff(evidence.motion.position_m[first:last], axis=0)
    path = float(np.linalg.norm(steps, axis=1).sum())
    manner = _manner(evidence, first, last, travel[:3])
    if distance < _IN_PLACE * path and distance < 0.5 * _reach(evidence.motion, first, last):
        return f"{manner} around {_length(path)}"
    return f"{manner} {_direction(travel[:3])} {_length(distance)}"


def _reach(motion: Motion, first: int, last: int) -> float:
    return _size(np.ptp(motion.position_m[first:last], axis=0))


def _manner(evidence: Evidence, first: int, last: int, travel: Array) -> str:
    """Push where the force stands against the movement, slide in contact, else move."""
    if evidence.force_N is None or evidence.touching is None:
        return "Move"
    if evidence.touching[first:last].mean() < _MOSTLY:
        return "Move"
    force = evidence.force_N[first:last].mean(axis=0)
    against = -float(force @ travel)
    strength = _size(force) * _size(travel)
    return "Push" if against > _AGAINST * strength else "Slide"


def _ending(evidence: Evidence, end: int) -> str:
    """Contact made or changed, or lost."""
    if evidence.force_N is None or evidence.touching is None:
        return " until contact"
    reach = max(1, round(_SETTLED_S / evidence.motion.step_s))
    before = evidence.force_N[max(end - reach, 0) : max(end - 1, 1)]
    after = evidence.force_N[end + 1 : end + 1 + reach]
    touching_after = evidence.touching[end + 1 : end + 1 + reach]
    if not len(after):
        return " until contact"
    lost = _size(after.mean(axis=0)) < _RELEASED * _size(before.mean(axis=0))
    return " until release" if lost and not touching_after[-1] else " until contact"


def _direction(travel: Array) -> str:
    """Along the dominant axis, and the second where it is at least half as much."""
    order = np.argsort(-np.abs(travel))
    most, second = int(order[0]), int(order[1])
    words = [_TOWARDS[most][int(travel[most] < 0)]]
    if abs(travel[second]) >= _SECOND_AXIS * abs(travel[most]):
        words.append(_TOWARDS[second][int(travel[second] < 0)])
    return " and ".join(words)


def _rotation(turn_rad: Array) -> str:
    axis = int(np.argmax(np.abs(turn_rad)))
    angle = np.degrees(np.copysign(np.linalg.norm(turn_rad), turn_rad[axis]))
    return f"Rotate about {'xyz'[axis]} {angle:.0f}°".replace("-", "−")


def _rotation_between(motion: Motion, first: int, last: int) -> Array:
    """Rotation vector (3,) from one bin to another, base frame, not folded at 180°."""
    assert motion.rotation_rad is not None
    from scipy.spatial.transform import Rotation

    start, end = Rotation.from_rotvec(motion.rotation_rad[[first, last]])
    short = (end * start.inv()).as_rotvec()
    coarse = motion.rotation_rad[last] - motion.rotation_rad[first]
    angle = float(np.linalg.norm(short))
    if angle > 1e-9 and short @ coarse < 0 and np.linalg.norm(coarse) > np.pi:
        return short * (1.0 - 2.0 * np.pi / angle)
    return short


def _length(metres: float) -> str:
    if metres >= 1.0:
        return f"{metres:.2f} m"
    return f"{1e3 * metres:.0f} mm" if metres >= 0.01 else f"{1e3 * metres:.1f} mm"
