"""The path of a segment, cut from its demonstration and, at a contact, extended beyond it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.signal import savgol_filter

from keyphase.demonstration import Array, Demonstration
from keyphase.errors import SkillError
from keyphase.oddities import breaks_within
from keyphase.rotations import quaternions
from keyphase.rotations.courses import angular_velocity
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.end_condition.travel import last_way
from keyphase.skills.fitting import MIN_SAMPLES

RATE_HZ = 250.0
"""Samples per second of a path; demonstrations come at any rate, even or not."""

SMOOTHING_S = 0.1
"""Window of the smoothing; 0.5 mm of white noise would otherwise put 7 mm into the fit."""

END_WINDOW_S = 0.1
"""The velocity at the end is judged over this time."""

MIN_SPEED_M_S = 0.02
"""The least speed with which a path is extended."""

MAX_OF_MEAN = 1.5
"""The speed at the end is taken as this many times the mean of the last 100 ms at most."""

TURN_BRAKE_S = 0.2
"""A rotation that is still going on at the contact is braked within this time at most."""


@dataclass(frozen=True, eq=False)
class Path:
    """Evenly sampled poses: time_s (M,) from zero, position_m (M, 3), orientation or None.

    orientation_wxyz (M, 4) is continuous in sign.
    """

    time_s: Array
    position_m: Array
    orientation_wxyz: Array | None

    @cached_property
    def duration_s(self) -> float:
        """From the first to the last sample."""
        return float(self.time_s[-1])


def path_of(demonstration: Demonstration, start_s: float, end_s: float) -> Path:
    """The demonstrated path from `start_s` to `end_s`, at 250 Hz and smoothed over 0.1 s.

    Cubic in between samples, third-order Savitzky-Golay over them; both ends are kept in place
    as far as the noise allows. Raises SkillError where the segment holds too few samples, or a
    stretch in which nothing was demonstrated.
    """
    _refuse_breaks(demonstration, start_s, end_s)
    first, last = np.searchsorted(demonstration.time_s, (start_s, end_s), side="left").tolist()
    rows = slice(max(first - 1, 0), min(last + 1, len(demonstration)))
    time = demonstration.time_s[rows]
    if len(time) < MIN_SAMPLES or not end_s > start_s:
        raise SkillError(
            f"{demonstration.name}: a segment needs at least {MIN_SAMPLES} samples to become a "
            f"skill, but the one from {start_s:.3f} s to {end_s:.3f} s has {len(time)}; "
            "drop it or merge it with its neighbour."
        )
    count = max(round((end_s - start_s) * RATE_HZ), 2 * MIN_SAMPLES) + 1
    moments = np.linspace(start_s, end_s, count).clip(time[0], time[-1])
    position = _smooth(CubicSpline(time, demonstration.position_m[rows])(moments))
    wxyz = demonstration.orientation_wxyz
    if wxyz is not None:
        wxyz = quaternions.normalised(_smooth(CubicSpline(time, wxyz[rows])(moments)))
    return Path(np.linspace(0.0, end_s - start_s, count), position, wxyz)


def _refuse_breaks(demonstration: Demonstration, start_s: float, end_s: float) -> None:
    """A gap or a jump is no way that somebody showed."""
    broken = breaks_within(demonstration, start_s, end_s)
    if broken:
        begin, end = broken[0].span_s or (start_s, end_s)
        raise SkillError(
            f"{demonstration.name}: the segment from {start_s:.2f} s to {end_s:.2f} s cannot "
            f"become a skill: {broken[0].text} Split it at {begin:.2f} s and {end:.2f} s and drop "
            "what lies between."
        )


def direction_of_travel(path: Path, end: ContactEnd) -> tuple[Array, float]:
    """Unit vector (3,) and speed [m/s] with which a contact-terminated path meets its contact.

    The direction is that of the last 10 mm of the way, however slow they were; of a tool that
    moved less than 3 mm, against the demonstrated force change. The speed along it is that of a
    parabola through the last 100 ms at its end, 20 mm/s at least.
    """
    way = last_way(path.position_m)
    if way is None:
        return -np.asarray(end.direction), MIN_SPEED_M_S
    direction = way[0]
    first = int(np.searchsorted(path.time_s, path.duration_s - END_WINDOW_S - 1e-9))
    time = path.time_s[first:] - path.duration_s
    mean_speed = float((path.position_m[-1] - path.position_m[first]) @ direction / -time[0])
    speed = float(np.polyfit(time, path.position_m[first:] @ direction, 2)[1])
    fastest = max(MAX_OF_MEAN * mean_speed, MIN_SPEED_M_S)
    return direction, float(np.clip(speed, MIN_SPEED_M_S, fastest))


def extended(path: Path, direction: Array, speed_m_s: float, offset_m: float) -> Path:
    """The path and `offset_m` beyond it along `direction`, braking from `speed_m_s` to rest.

    The brake is s(u) = v T (u - u^3 + u^4 / 2) for u from 0 to 1: it starts with speed v and
    without acceleration, ends at rest, and covers v T / 2.
    """
    if offset_m <= 0.0:
        return path
    brake_s = 2.0 * offset_m / speed_m_s
    step = path.duration_s / (len(path.time_s) - 1)
    time = step * np.arange(1, max(round(brake_s / step), 1) + 1, dtype=np.float64)
    way = offset_m * 2.0 * _braked(time / brake_s)
    return Path(
        np.concatenate([path.time_s, path.duration_s + time]),
        np.concatenate([path.position_m, path.position_m[-1] + way[:, None] * direction]),
        _turned_on(path, time, min(brake_s, TURN_BRAKE_S)),
    )


def _turned_on(path: Path, time: Array, brake_s: float) -> Array | None:
    """Orientations of an extended path: the rotation at its end, braked alike."""
    wxyz = path.orientation_wxyz
    if wxyz is None:
        return None
    window = max(round(END_WINDOW_S * RATE_HZ), 1)
    velocity = angular_velocity(path.time_s, wxyz)[-window:].mean(axis=0)
    angle = brake_s * _braked(time / brake_s)
    turn = quaternions.from_rotation_vector(angle[:, None] * velocity)
    return np.concatenate([wxyz, quaternions.product(turn, wxyz[-1])])


def _braked(u: Array) -> Array:
    u = np.minimum(u, 1.0)
    return u - u**3 + 0.5 * u**4


def _smooth(values: Array) -> Array:
    window = min(round(SMOOTHING_S * RATE_HZ), len(values) - 1) | 1
    return np.asarray(savgol_filter(values, window, 3, axis=0)) if window > 3 else values
