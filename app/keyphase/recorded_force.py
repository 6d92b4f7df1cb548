"""What a recorded force says of itself: its offset in free space, and where it is a contact."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array, Demonstration

RATE_HZ = 200.0

CONTACT_N, CONTACT_SHARE = 1.0, 0.1
"""A force counts as one from a newton on, and from this part of the 98 % force."""

MOVING_M_S = 0.005
MIN_SAMPLES = 10

WINDOW_S = 5.0
"""Over so long it is looked at how a force wanders."""

_STILL_M = 2e-3
_SMOOTHED_S = 0.2
_MIN_WANDER_N = 0.5
_MIN_WINDOWS = 2
_FREE_M_S = 0.03
_MIN_FREE = 40
_CALM_S = 0.25
_SMALL_N = 1.0
_REST_M = 0.004
_ALIKE = 0.25
_CARRIED_ALIKE, _CARRIED_ALIKE_N = 0.1, 0.3


@dataclass(frozen=True, eq=False)
class Even:
    """A recording at 200 Hz: time_s (N,), position_m (N, 3), orientation_wxyz (N, 4), force_N."""

    time_s: Array
    position_m: Array
    orientation_wxyz: Array
    force_N: Array

    @property
    def step_s(self) -> float:
        """Between two samples."""
        return 1.0 / RATE_HZ

    def velocity(self, smooth_s: float) -> Array:
        """Velocity (N, 3) of the position averaged over `smooth_s`."""
        return np.gradient(running_mean(self.position_m, smooth_s), self.step_s, axis=0)


def evenly(demonstration: Demonstration, most_s: float = np.inf) -> Even:
    """The recording, interpolated; what was not recorded does not turn, or is no force.

    Of one longer than `most_s` only its beginning.
    """
    end_s = min(demonstration.end_s, demonstration.start_s + most_s)
    time = np.arange(demonstration.start_s, end_s, 1.0 / RATE_HZ)

    def at(values: Array) -> Array:
        return np.stack([np.interp(time, demonstration.time_s, v) for v in values.T], axis=1)

    wxyz, force = demonstration.orientation_wxyz, demonstration.force_N
    turned = np.tile([1.0, 0.0, 0.0, 0.0], (len(time), 1)) if wxyz is None else at(wxyz)
    turned /= np.linalg.norm(turned, axis=1)[:, None]
    return Even(
        time,
        at(demonstration.position_m),
        turned,
        np.zeros((len(time), 3)) if force is None else at(force),
    )


def running_mean(values: Array, window_s: float) -> Array:
    """Mean (N, ...) over a centred window, at the ends over what is there of it."""
    half = round(window_s * RATE_HZ / 2)
    flat = values.reshape(len(values), -1)
    sums = np.vstack([np.zeros(flat.shape[1]), np.cumsum(flat, axis=0)])
    rows = np.arange(len(values))
    first, last = np.maximum(rows - half, 0), np.minimum(rows + half + 1, len(values))
    return ((sums[last] - sums[first]) / (last - first)[:, None]).reshape(values.shape)


def offset_while_moving(even: Even) -> Array:
    """Force (3,) that is read where nothing is touched; zero where that cannot be told [N].

    The force under which the tool rests at its start, if it is read in two fast motions, too, that
    go elsewhere: a tool that was not tared is weighed in free space, and less in contact. Else the
    median over the calmest of the moments in which the tool moves; it is taken for an offset if it
    is small, or if the tool rests under the same force at its start. The segmentation's
    `free_force` asks less: whether there ever is next to no force, and else what it begins with.
    """
    velocity = even.velocity(0.1)
    speed = np.linalg.norm(velocity, axis=1)
    start = even.time_s < even.time_s[0] + _CALM_S
    resting = float(np.linalg.norm(np.ptp(even.position_m[start], axis=0))) < _REST_M
    first = np.median(even.force_N[start], axis=0)
    if resting and _is_carried(even, first, velocity):
        return first
    free = _calmest(even, speed)
    length, away = float(np.linalg.norm(free)), float(np.linalg.norm(first - free))
    is_offset = length < _SMALL_N or (resting and away < _ALIKE * length)
    return free if is_offset else np.zeros(3)


def _is_carried(even: Even, first_N: Array, velocity: Array) -> bool:
    """Whether a force (3,) is read in fast motions to both sides of some direction, too.

    A contact that is slid on resists either of them in another way.
    """
    size, speed = float(np.linalg.norm(first_N)), np.linalg.norm(velocity, axis=1)
    off = np.linalg.norm(running_mean(even.force_N, 0.05) - first_N, axis=1)
    alike = (speed > _FREE_M_S) & (off < max(_CARRIED_ALIKE * size, _CARRIED_ALIKE_N))
    if size < _SMALL_N or alike.sum() < 2 * _MIN_FREE:
        return False
    way = velocity[alike] / speed[alike][:, None]
    main = np.linalg.svd(way, full_matrices=False)[2][0]
    along = way @ main
    return min((along > 0.5).sum(), (along < -0.5).sum()) >= _MIN_FREE


def _calmest(even: Even, speed: Array) -> Array:
    """Median force (3,) over the calmest of the moments in which the tool moves; zero if few."""
    force, mean = even.force_N, running_mean(even.force_N, _CALM_S)
    spread = np.sqrt(
        np.maximum(running_mean((force**2).sum(axis=1), _CALM_S) - (mean**2).sum(axis=1), 0.0)
    )
    size, moving = np.linalg.norm(mean, axis=1), speed > _FREE_M_S
    if moving.sum() < _MIN_FREE:
        return np.zeros(3)
    calm = moving & (spread <= np.percentile(spread[moving], 40))
    least = calm & (size <= np.percentile(size[calm], 50))
    return np.median(force[least], axis=0)


def in_contact(force_N: Array, velocity_m_s: Array) -> np.ndarray:
    """Where (N,) a force counts as one while the tool moves; nowhere, if that is too seldom."""
    size, speed = np.linalg.norm(force_N, axis=1), np.linalg.norm(velocity_m_s, axis=1)
    least = max(CONTACT_N, CONTACT_SHARE * float(np.percentile(size, 98)))
    inside = (speed > MOVING_M_S) & (size > least)
    return inside if inside.sum() >= MIN_SAMPLES else np.zeros(len(inside), bool)


def wander_at_rest(demonstration: Demonstration) -> float:
    """How far the force changes within `WINDOW_S` while the tool stands still, as one that is
    estimated does [N]; zero where that is little, or the tool hardly stands still."""
    force, rate = demonstration.force_N, demonstration.rate_hz
    width = round(WINDOW_S * rate)
    if force is None or width < 4 or len(force) < _MIN_WINDOWS * width:
        return 0.0
    count = len(force) // width
    place = demonstration.position_m[: count * width].reshape(count, width, 3)
    still = np.ptp(place, axis=1).max(axis=1) < _STILL_M
    if still.sum() < _MIN_WINDOWS:
        return 0.0
    part = max(1, min(width // 2, round(_SMOOTHED_S * rate)))
    parts = width // part
    kept = force[: count * width].reshape(count, width, 3)[still, : parts * part]
    smooth = kept.reshape(len(kept), parts, part, 3).mean(axis=2)
    wander = float(np.median(np.linalg.norm(np.ptp(smooth, axis=1), axis=1)))
    return wander if wander >= _MIN_WANDER_N else 0.0
