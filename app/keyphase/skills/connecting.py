"""Connecting moves: minimum-jerk ways from where one skill ended to where the next starts."""

from math import ceil

import numpy as np

from keyphase.demonstration import Array
from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ConfigurationEnd
from keyphase.skills.fitting import fit_primitive
from keyphase.skills.path import RATE_HZ
from keyphase.skills.skill import Skill

PEAK_SPEED_M_S = 0.15
PEAK_TURN_RAD_S = 1.0
MIN_DURATION_S = 0.5

MIN_TIMEOUT_S = 2.0
"""A connecting move may stand still so long before it has failed."""

MINIMUM_JERK_PEAK = 1.875
"""Peak over mean speed of a minimum-jerk move."""

NEAR = ConfigurationEnd()
"""Poses closer than this need no connecting move."""


def minimum_jerk(u: Array) -> Array:
    """Way covered (0 to 1) at the fraction `u` of the time (Flash and Hogan, 1985)."""
    return u**3 * (10.0 - 15.0 * u + 6.0 * u * u)


def is_apart(
    position_m: Array, orientation_wxyz: Array, to_m: Array, to_wxyz: Array, near=NEAR
) -> bool:
    """Whether two poses are further apart than `near` allows (5 mm, 3 degrees)."""
    way, angle = _apart(position_m, orientation_wxyz, to_m, to_wxyz)
    return way > near.position_tolerance_m or angle > near.rotation_tolerance_rad


def connecting_skill(
    position_m: Array,
    orientation_wxyz: Array,
    to_m: Array,
    to_wxyz: Array,
    *,
    oriented: bool = True,
    label: str = "connecting move",
    force_limit_N: float = 15.0,
) -> Skill:
    """Skill that moves straight from one pose to another, at 0.15 m/s and 1 rad/s at most.

    Its motion is a primitive fitted to the minimum-jerk way, so that it is held, pushed and
    slowed like any other skill. Positions (3,), quaternions (4,).
    """
    turn = quaternions.shortest_rotation_vector(
        quaternions.product(to_wxyz, quaternions.conjugate(orientation_wxyz))
    )
    duration = _duration(float(np.linalg.norm(to_m - position_m)), float(np.linalg.norm(turn)))
    time = np.arange(ceil(duration * RATE_HZ) + 1) / RATE_HZ
    covered = minimum_jerk(time / time[-1])[:, None]
    positions = position_m + covered * (to_m - position_m)
    wxyz = quaternions.product(quaternions.from_rotation_vector(covered * turn), orientation_wxyz)
    primitive = fit_primitive(time, positions, wxyz if oriented else None)
    return Skill(
        label=label,
        connecting=True,
        primitive=primitive,
        end_condition=NEAR,
        end_position_m=positions[-1],
        end_orientation_wxyz=primitive.goal_orientation_wxyz,
        travel_direction=None,
        offset_m=0.0,
        travel_limit_m=0.0,
        timeout_s=max(2.0 * float(time[-1]), MIN_TIMEOUT_S),
        force_limit_N=force_limit_N,
    )


def _duration(way_m: float, angle_rad: float) -> float:
    fastest = max(way_m / PEAK_SPEED_M_S, angle_rad / PEAK_TURN_RAD_S)
    return max(MINIMUM_JERK_PEAK * fastest, MIN_DURATION_S)


def _apart(
    position_m: Array, orientation_wxyz: Array, to_m: Array, to_wxyz: Array
) -> tuple[float, float]:
    turn = quaternions.shortest_rotation_vector(
        quaternions.product(to_wxyz, quaternions.conjugate(orientation_wxyz))
    )
    return float(np.linalg.norm(to_m - position_m)), float(np.linalg.norm(turn))
