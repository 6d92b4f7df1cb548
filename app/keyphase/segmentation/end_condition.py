"""When a segment is over: at a contact (force threshold) or a configuration (near the goal).

Both are plain values; `end_condition_at` derives one from what the demonstrated force did.
"""

from dataclasses import dataclass
from math import radians

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import ParameterError

BEFORE_S = (-0.20, -0.06)
"""Window, relative to a segment's end, whose mean is the force before the contact change."""

AFTER_S = (0.08, 0.22)
"""Window, relative to a segment's end, whose mean is the force after the contact change."""

BEFORE_LAST_S = (-0.40, -0.20)
"""The window before, where the recording itself ends in the contact."""

LAST_S = (-0.04, 1.0)
"""The window after, where the recording itself ends in the contact."""

LAST_STEP_N = 1.0
LAST_NOISE_FACTOR = 8.0
"""A recording ends in a contact if its force ends changed by this much, and by this many standard
deviations of the force before; whether it would stay changed cannot be seen."""

LEAST_STEP_N = 1e-9
LARGEST_THRESHOLD_N = 1e9
"""Outside of these a force has no direction in floating point, or is no force of this world."""

STEP_FRACTION = 0.5
"""Part of the demonstrated force step that has to be passed again."""

NOISE_FACTOR = 5.0
"""A threshold is never below this many standard deviations of the force before the change."""


@dataclass(frozen=True)
class ContactEnd:
    """Over when the force along `direction` has risen by more than `threshold_N`.

    direction    unit vector of the demonstrated force change, base frame; the force is what the
                 environment exerts on the tool, so a tool that meets the table has (0, 0, 1)
    threshold_N  counted from the level before the contact, above zero

    Raises ParameterError if the direction is no unit vector or the threshold is not positive.
    """

    direction: tuple[float, float, float]
    threshold_N: float

    def __post_init__(self) -> None:
        norm = float(np.linalg.norm(self.direction))
        if len(self.direction) != 3 or not abs(norm - 1.0) < 1e-6:
            raise ParameterError(
                f"The direction of a contact end condition must be a unit vector x y z, but "
                f"{tuple(self.direction)} has length {norm:.6g}; divide it by its length."
            )
        _refuse_not_positive(self.threshold_N, "threshold_N")


@dataclass(frozen=True)
class ConfigurationEnd:
    """Over when the pose is within both tolerances of the goal.

    Raises ParameterError if a tolerance is not positive.
    """

    position_tolerance_m: float = 0.005
    rotation_tolerance_rad: float = radians(3.0)

    def __post_init__(self) -> None:
        _refuse_not_positive(self.position_tolerance_m, "position_tolerance_m")
        _refuse_not_positive(self.rotation_tolerance_rad, "rotation_tolerance_rad")


EndCondition = ContactEnd | ConfigurationEnd


def end_condition_at(
    demonstration: Demonstration, start_s: float, end_s: float, contact_change: bool
) -> EndCondition:
    """End condition of the segment from `start_s` to `end_s`, from the force around its end.

    A contact change gives a ContactEnd along the demonstrated change of the mean force, its
    threshold half that change but at least five standard deviations of the force before. Without
    a contact change, without recorded force, or where the force did not change at all (a change
    of torque alone) or beyond any sense, it is the default ConfigurationEnd.
    """
    if not contact_change or demonstration.force_N is None:
        return ConfigurationEnd()
    before, after = _forces_around(demonstration, start_s, end_s)
    direction, step, noise = _force_step(before, after)
    threshold = max(STEP_FRACTION * step, NOISE_FACTOR * noise)
    if not (step > LEAST_STEP_N and threshold < LARGEST_THRESHOLD_N):
        return ConfigurationEnd()
    x, y, z = direction.tolist()
    return ContactEnd((x, y, z), threshold)


def ends_in_contact(demonstration: Demonstration, start_s: float) -> bool:
    """Whether the recording breaks off in a contact change within its last moments.

    No boundary can say so, as none lies that close to an end. The last segment starts at
    `start_s`; the force before it does not count.
    """
    if demonstration.force_N is None:
        return False
    before, after = _forces_around(demonstration, start_s, demonstration.end_s)
    _, step, noise = _force_step(before, after)
    return step > max(LAST_STEP_N, LAST_NOISE_FACTOR * noise)


def _force_step(before: Array, after: Array) -> tuple[Array, float, float]:
    """Direction (3,) and size of the step of the mean force, and the noise along it before [N]."""
    level = before.sum(axis=0) / len(before)
    change = after.sum(axis=0) / len(after) - level
    step = float(np.sqrt(change @ change))
    direction = change / max(step, 1e-300)
    along = (before - level) @ direction
    return direction, step, float(np.sqrt(along @ along / len(along)))


def _forces_around(
    demonstration: Demonstration, start_s: float, end_s: float
) -> tuple[Array, Array]:
    """Forces of the windows before and after `end_s`; of one sample where a window holds none."""
    assert demonstration.force_N is not None
    breaks_off = end_s + AFTER_S[0] > demonstration.end_s
    before, after = (BEFORE_LAST_S, LAST_S) if breaks_off else (BEFORE_S, AFTER_S)
    edges = (
        max(start_s, end_s + before[0]),
        end_s + before[1],
        end_s,
        end_s + after[0],
        end_s + after[1],
    )
    first, last, end, later, latest = np.searchsorted(demonstration.time_s, edges).tolist()
    if last <= first:
        first = max(min(first, end - 1), 0)
        last = first + 1
    if latest <= later:
        later = min(later, len(demonstration) - 1)
        latest = later + 1
    return demonstration.force_N[first:last], demonstration.force_N[later:latest]


def _refuse_not_positive(value: float, name: str) -> None:
    if not (np.isfinite(value) and value > 0.0):
        raise ParameterError(
            f"{name} of an end condition must be a positive number, but is {value}; "
            "give a value above zero."
        )
