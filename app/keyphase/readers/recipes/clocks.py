"""Channels that follow clocks of their own, brought to one.

The channel that came most often keeps its samples; the others are interpolated to its times
(orientations along great arcs), and what not all of them cover at either end is left out.
"""

from collections.abc import Mapping

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import RecipeError
from keyphase.notices import Caution
from keyphase.readers.resampling import interpolate

_STEERING = ("position_m", "orientation_wxyz", "force_N", "torque_Nm")
"""Whose clock all others follow: one of what is segmented by."""

_BY_JOINTS = ("joints_rad", "joint_torques_Nm")
"""The same where it is by its joints that is known where the tool was."""


def on_one_clock(
    channels: Mapping[str, Array], clocks: Mapping[str, Array], recipe: str
) -> tuple[dict[str, Array], tuple[str, ...]]:
    """The channels (each (N_i, D)) with one `time_s` (N,), and what was done.

    `clocks` has the seconds (N_i,) of every channel. Raises RecipeError where a channel and its
    clock have different lengths, or no two samples of the leading channel lie in all clocks.
    """
    for channel, values in channels.items():
        if len(values) != len(clocks[channel]):
            raise RecipeError(
                f"{recipe}: {channel} has {len(values)} values but its clock "
                f"{len(clocks[channel])}; name its own with time = in its section."
            )
    steering = _STEERING if "position_m" in channels else (*_STEERING, *_BY_JOINTS)
    leading = min(
        (channel for channel in steering if channel in channels),
        key=lambda channel: float(np.median(np.diff(clocks[channel]))),
    )
    lead = clocks[leading]
    begin = max(float(clock[0]) for clock in clocks.values())
    end = min(float(clock[-1]) for clock in clocks.values())
    time = lead[(lead >= begin) & (lead <= end)]
    if len(time) < 2:
        raise RecipeError(
            f"{recipe}: the clocks of the channels do not overlap (from {begin:.3f} to {end:.3f} "
            "s); check their columns and whether all have one unit and one zero."
        )
    kept = (lead >= time[0]) & (lead <= time[-1])
    moved = {channel for channel in channels if not np.array_equal(clocks[channel], lead)}
    brought = {
        channel: (
            interpolate(channel, clocks[channel], values, time)
            if channel in moved
            else values[kept]
        )
        for channel, values in channels.items()
    }
    return {"time_s": time, **brought}, _notices(clocks, leading, moved, time)


def _notices(
    clocks: Mapping[str, Array], leading: str, moved: set[str], time: Array
) -> tuple[str, ...]:
    rates = {channel: 1.0 / float(np.median(np.diff(clock))) for channel, clock in clocks.items()}
    others = [f"{channel} ({rates[channel]:.3g} Hz)" for channel in clocks if channel in moved]
    lead = clocks[leading]
    cut = float(time[0] - lead[0] + lead[-1] - time[-1])
    notices = ()
    if others:
        told = (
            f"Interpolated {', '.join(others)} to the times of {leading} ({rates[leading]:.3g} Hz)."
        )
        notices += (Caution(told),)
    if cut > 0:
        told = f"Left out {cut:.3g} s at the ends that not all channels cover."
        notices += (Caution(told),)
    return notices
