"""End conditions as plain values: a contact (force threshold) or a configuration (near a goal)."""

from dataclasses import dataclass
from math import radians
from typing import Literal

import numpy as np

from keyphase.errors import ParameterError


@dataclass(frozen=True)
class ContactEnd:
    """Over when the force along `direction` has risen by more than `threshold_N`.

    direction    unit vector of the demonstrated force change, base frame; the force is what the
                 environment exerts on the tool, so a tool that meets the table has (0, 0, 1)
    threshold_N  counted from the level before the contact, above zero
    release      a force that ends: the skill is over as it falls, and never goes on beyond
    agrees       whether the demonstration, fed through this condition, ends where it did, within
                 0.25 s; None where that was not asked
    offset_m     how far to go on beyond the demonstrated contact; None leaves it to the skill
    timeout_s    how long without progress until the skill has failed; None leaves it to the skill

    Raises ParameterError if the direction is no unit vector, the threshold or the timeout is not
    positive, or the offset is below zero.
    """

    direction: tuple[float, float, float]
    threshold_N: float
    release: bool = False
    agrees: bool | None = None
    offset_m: float | None = None
    timeout_s: float | None = None

    def __post_init__(self) -> None:
        norm = float(np.linalg.norm(self.direction))
        if len(self.direction) != 3 or not abs(norm - 1.0) < 1e-6:
            raise ParameterError(
                f"The direction of a contact end condition must be a unit vector x y z, but "
                f"{tuple(self.direction)} has length {norm:.6g}; divide it by its length."
            )
        _refuse_not_positive(self.threshold_N, "threshold_N")
        _refuse_not_positive(self.timeout_s, "timeout_s")
        if self.offset_m is not None and not (np.isfinite(self.offset_m) and self.offset_m >= 0.0):
            raise ParameterError(
                f"offset_m of an end condition must not be below zero, but is {self.offset_m}; "
                "give metres beyond the contact."
            )


@dataclass(frozen=True)
class GripperEnd:
    """What the gripper has done by the end: closed on something, or begun to open.

    opening    the demonstrated opening at that moment, in m or as the fraction that was recorded
    tolerance  in the same unit, above zero: a grasp is over at `opening` + `tolerance` and below,
               or where the gripper, once closed by that much, moves no more for `stalled_s`: what
               it holds may be wider. A release has begun above `opening` + `tolerance`

    Raises ParameterError if opening or tolerance are no numbers, or tolerance or stall not
    positive.
    """

    change: Literal["grasp", "release"]
    opening: float
    tolerance: float
    stalled_s: float = 0.3

    def __post_init__(self) -> None:
        if self.change not in ("grasp", "release") or not np.isfinite(self.opening):
            raise ParameterError(
                "A gripper's end condition must be a grasp or a release at an opening, but is "
                f"{str(self.change)[:40]!r} at {self.opening}; give both."
            )
        _refuse_not_positive(self.tolerance, "tolerance")
        _refuse_not_positive(self.stalled_s, "stalled_s")

    def is_met(self, opening: float, begun_at: float, still_s: float) -> bool:
        """Whether an opening that was `begun_at` and has not changed for `still_s` meets it."""
        if self.change == "release":
            return opening > self.opening + self.tolerance
        stalled = still_s >= self.stalled_s and begun_at - opening >= self.tolerance
        return opening <= self.opening + self.tolerance or stalled


@dataclass(frozen=True)
class ConfigurationEnd:
    """Over when the pose is within both tolerances of the goal, and the gripper did its part.

    timeout_s  how long without progress until the skill has failed; None leaves it to the skill
    gripper    what the gripper has to have done; None where it did nothing. It is asked of those
               only who measure the opening

    Raises ParameterError if a tolerance or the timeout is not positive.
    """

    position_tolerance_m: float = 0.005
    rotation_tolerance_rad: float = radians(3.0)
    timeout_s: float | None = None
    gripper: GripperEnd | None = None

    def __post_init__(self) -> None:
        _refuse_not_positive(self.position_tolerance_m, "position_tolerance_m")
        _refuse_not_positive(self.rotation_tolerance_rad, "rotation_tolerance_rad")
        _refuse_not_positive(self.timeout_s, "timeout_s")


EndCondition = ContactEnd | ConfigurationEnd


def _refuse_not_positive(value: float | None, name: str) -> None:
    if value is not None and not (np.isfinite(value) and value > 0.0):
        raise ParameterError(
            f"{name} of an end condition must be a positive number, but is {value}; "
            "give a value above zero."
        )
