"""Channels evaluated at other times: straight lines for vectors, great arcs for orientations."""

from collections.abc import Mapping

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from keyphase.demonstration import Array
from keyphase.readers.held import Hold

SMOOTH = (
    "position_m",
    "orientation_wxyz",
    "force_N",
    "torque_Nm",
    "joints_rad",
    "joint_torques_Nm",
    "gripper",
)
"""Anything else may be a button, between whose values there is nothing: its last one holds."""


def interpolate(channel: str, time_s: Array, values: Array, at_s: Array) -> Array:
    """A channel (N, D) at the times `at_s` (M,); before its first and after its last, held."""
    within = np.clip(at_s, time_s[0], time_s[-1])
    if channel not in SMOOTH:
        return values[np.searchsorted(time_s, within, side="right") - 1]
    if channel == "orientation_wxyz":
        rotations = Rotation.from_quat(values, scalar_first=True)
        return Slerp(time_s, rotations)(within).as_quat(scalar_first=True)
    return np.column_stack([np.interp(within, time_s, column) for column in values.T])


def interpolate_hold(channel: str, time_s: Array, values: Array, hold: Hold) -> Array:
    """A held channel with its repeats replaced by values between the rows at which it changed."""
    fresh = hold.fresh_rows
    return interpolate(channel, time_s[fresh], values[fresh], time_s)


def resample(channels: Mapping[str, Array], rate_hz: float) -> dict[str, Array]:
    """All channels at an even rate, from the first row on to the last."""
    time = channels["time_s"]
    count = int(np.floor((time[-1] - time[0]) * rate_hz * (1 + 1e-12))) + 1
    even = time[0] + np.arange(count) / rate_hz
    return {
        channel: even if channel == "time_s" else interpolate(channel, time, values, even)
        for channel, values in channels.items()
    }
