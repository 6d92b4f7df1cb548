"""The tool's motion at 50 Hz, in the units in which the position segmentation sees it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.oddities.poses import dropouts
from keyphase.rotations.courses import from_first
from keyphase.segmentation.bins import bin_means, bins_of, typical_step_s
from keyphase.segmentation.filters import smoothed

METRES_PER_RADIAN = 0.2
"""How far a rotation counts as a movement: about the reach of a hand around its wrist."""

_MAX_DISTANCE_M = 1e3
_SMOOTHING_HZ = 5.0


@dataclass(frozen=True, eq=False)
class Motion:
    """The tool's motion in bins of 20 ms.

    time_s      (n,)        mean time of each bin
    position_m  (n, 3)      mean position
    rotation_rad (n, 3)     rotation vector from the first bin, base frame; None if not recorded
    pose_m      (n, 3 or 6) position, and the rotation vector times 0.2 m/rad, first bin at zero
    speed       (n,)        norm of the pose's velocity, smoothed below 5 Hz [m/s]
    """

    time_s: Array
    position_m: Array
    rotation_rad: Array | None
    pose_m: Array
    speed: Array

    @cached_property
    def step_s(self) -> float:
        """Median time from bin to bin."""
        return typical_step_s(self.time_s)


def motion_of(demonstration: Demonstration) -> Motion:
    """Bin the pose of a demonstration; see `Motion`.

    Rows in which the tool jumps away and is back at once count for nothing.
    """
    bins = bins_of(demonstration)
    starts, time = bins.starts, bins.time_s
    places, wxyz = _without_dropouts(demonstration)
    position = bin_means(places, starts)
    rotation = None if wxyz is None else from_first(bin_means(wxyz, starts))
    pose = _pose(position, rotation)
    return Motion(time, position, rotation, pose, _speed(time, pose))


def _without_dropouts(demonstration: Demonstration) -> tuple[Array, Array | None]:
    """Positions and orientations, on a straight way where the tool jumped away and back."""
    position, wxyz = demonstration.position_m, demonstration.orientation_wxyz
    found = dropouts(demonstration)
    if not found:
        return position, wxyz
    time = demonstration.time_s
    good = np.ones(len(time), dtype=bool)
    for out, back in found:
        good[out + 1 : back + 1] = False

    def bridged(values: Array) -> Array:
        return np.stack([np.interp(time, time[good], column[good]) for column in values.T], axis=1)

    return bridged(position), None if wxyz is None else bridged(wxyz)


def _pose(position: Array, rotation: Array | None) -> Array:
    # Beyond a kilometre squares lose the millimetres; such a recording is shrunk to one.
    scale = max(1.0, float(np.abs(position).max()) / _MAX_DISTANCE_M)
    translation = position / scale
    translation = translation - translation[0]
    if rotation is None:
        return translation
    return np.hstack([translation, METRES_PER_RADIAN * rotation])


def _speed(time: Array, pose: Array) -> Array:
    if len(time) < 2:
        return np.zeros(len(time))
    rate = 1.0 / typical_step_s(time)
    if len(time) > 20 and rate > 2.5 * _SMOOTHING_HZ:
        pose = smoothed(pose, _SMOOTHING_HZ, rate)
    return np.linalg.norm(np.gradient(pose, time, axis=0), axis=1)
