"""Channels that follow clocks of their own, brought to one.

The channel that came most often keeps its samples; the others are interpolated to its times
(orientations along great arcs), and what not all of them cover at either end is left out.
"""

from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.errors import RecipeError
from keyphase.notices import Caution
from keyphase.readers.beginnings import Zero
from keyphase.readers.resampling import interpolate

_STEERING = ("position_m", "orientation_wxyz", "force_N", "torque_Nm")
"""Whose clock all others follow: one of what is segmented by."""

_MIN_BLIND_S, _BLIND_STEPS = 0.25, 10
"""Over longer gaps, in seconds and in its usual steps, nobody knows what a channel did."""

_BY_JOINTS = ("joints_rad", "joint_torques_Nm")
"""The same where it is by its joints that is known where the tool was."""


_WATCHED = frozenset((*_STEERING, *_BY_JOINTS))


def on_one_clock(
    channels: Mapping[str, Array], clocks: Mapping[str, Array], recipe: str
) -> tuple[dict[str, Array], tuple[str, ...]]:
    """The channels (each (N_i, D)) with one `time_s` (N,), and what was done.

    `clocks` has the seconds (N_i,) of every channel. Raises RecipeError where a channel and its
    clock have different lengths or fewer than two samples, or no two samples of the leading channel
    lie in all clocks.
    """
    _refuse_unfit(channels, clocks, recipe)
    steering = _STEERING if "position_m" in channels else (*_STEERING, *_BY_JOINTS)
    leading = min(
        (channel for channel in steering if channel in channels),
        key=lambda channel: float(np.median(np.diff(clocks[channel]))),
    )
    lead = clocks[leading]
    begin = max(float(clock[0]) for clock in clocks.values())
    end = min(float(clock[-1]) for clock in clocks.values())
    kept = (lead >= begin) & (lead <= end)
    blind = {channel: _blind(clocks[channel], lead) for channel in channels if channel in _WATCHED}
    for between in blind.values():
        kept &= ~between
    time = lead[kept]
    if len(time) < 2:
        raise RecipeError(
            f"{recipe}: the clocks of the channels do not overlap (from {begin:.3f} to {end:.3f} "
            "s); check their columns and whether all have one unit and one zero."
        )
    moved = {channel for channel in channels if not np.array_equal(clocks[channel], lead)}
    brought = {
        channel: (
            interpolate(channel, clocks[channel], values, time)
            if channel in moved
            else values[kept]
        )
        for channel, values in channels.items()
    }
    told = _notices(clocks, leading, moved, time) + _blind_notices(blind, lead)
    return {"time_s": time, **brought}, told


def _refuse_unfit(channels: Mapping[str, Array], clocks: Mapping[str, Array], recipe: str) -> None:
    for channel, values in channels.items():
        if len(values) != len(clocks[channel]):
            raise RecipeError(
                f"{recipe}: {channel} has {len(values)} values but its clock "
                f"{len(clocks[channel])}; name its own with time = in its section."
            )
        if len(values) < 2:
            raise RecipeError(
                f"{recipe}: {channel} has {len(values)} sample{'s' * (len(values) != 1)}, and a "
                "channel with a clock of its own needs two at the least; check its columns."
            )


def refuse_clocks_apart(zeros: Mapping[str, Zero], clocks: Iterable[str], recipe: str) -> None:
    """Refuse clocks that a recorder wrote beside its streams and that tell different times."""
    found = {name: zeros[name] for name in clocks if name in zeros}
    one, other = next(iter(found), ""), ""
    for name, zero in found.items():
        if zero.clock != found[one].clock:
            other = name
    if other:
        apart = abs(found[one].own_ns - found[other].own_ns) * 1e-9
        raise RecipeError(
            f"{recipe}: {one} and {other} are of clocks that tell different times ({apart:.6g} s "
            "apart), so that nobody knows which of their samples belong together; take .log_time "
            "for all, or stamps of one clock."
        )


def _blind(clock: Array, lead: Array) -> NDArray[np.bool_]:
    """Which times of the leading channel (N,) lie where another one was not measured for long."""
    steps = np.diff(clock)
    long = steps > max(_MIN_BLIND_S, _BLIND_STEPS * float(np.median(steps)))
    after = np.searchsorted(clock, lead)
    inside = (after > 0) & (after < len(clock))
    step = np.clip(after - 1, 0, len(steps) - 1)
    return inside & long[step] & (lead != clock[np.clip(after, 0, len(clock) - 1)])


def _blind_notices(blind: Mapping[str, NDArray[np.bool_]], lead: Array) -> tuple[str, ...]:
    step = float(np.median(np.diff(lead)))
    return tuple(
        Caution(f"Left out {step * int(rows.sum()):.3g} s in which {channel} was not measured.")
        for channel, rows in blind.items()
        if rows.any()
    )


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
