"""A demonstration: one recording of a tool's pose and contact force, and what is always true of it.

Nothing here knows how a demonstration is stored; `keyphase.readers` turns files into one.
"""

import copy
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from keyphase.arrays import Array as Array
from keyphase.errors import DemonstrationError
from keyphase.logged import Event, checked_channels, checked_events, switch_events
from keyphase.rotations.courses import continued

UNIT_TOLERANCE = 1e-3
"""How far a quaternion's norm may be from one before it is refused rather than normalised."""

MAX_MAGNITUDE = 1e9
"""No pose or wrench in SI units is larger; what is has been read in the wrong unit or type."""

MAX_TIME_S = 1e10
"""No time stamp is farther from zero; nanoseconds since 1970 read as seconds are."""

MIN_STEP_S, MAX_STEP_S = 1e-10, 100.0
"""No recorder is faster, and over longer steps no motion of a tool can be followed."""

_GAP_STEPS = 8.0
_MIN_GAP_S = 0.2

_CHANNELS: Mapping[str, int | None] = {
    "position_m": 3,
    "orientation_wxyz": 4,
    "force_N": 3,
    "torque_Nm": 3,
    "joints_rad": None,
}


@dataclass(frozen=True)
class Source:
    """The file a demonstration was read from: its path and the SHA-256 of its bytes (hex).

    recipe, recipe_sha256  the recipe it was read with, its name and the SHA-256 of its text,
                           and of the file beside the recording that it names
    """

    path: Path
    sha256: str
    recipe: str | None = None
    recipe_sha256: str | None = None


@dataclass(frozen=True, eq=False)
class Demonstration:
    """One recording, checked on construction; its arrays are read-only.

    time_s           (N,)   seconds, strictly increasing, N at least 2
    position_m       (N, 3) tool point in the robot's base frame
    orientation_wxyz (N, 4) unit quaternions, made continuous in sign, or None
    force_N          (N, 3) what the environment exerts on the tool, base frame, or None
    torque_Nm        (N, 3) the same about the tool point, or None
    joints_rad       (N, J) joint angles, or None
    gripper          (N,)   opening, in m or as the fraction that was recorded, or None
    channels         (N,) each, whatever else was logged, by name and in its own unit
    events           what was logged in words, in time order
    wrench_estimated whether force and torque were worked out of joint torques, not measured
    metadata         what the recorder wrote beside the numbers (JSON values)
    notices          what the reader did that a person should know (held, resampled, flipped)

    Raises DemonstrationError with channel, row, what was expected and what came.
    """

    name: str
    time_s: Array
    position_m: Array
    orientation_wxyz: Array | None = None
    force_N: Array | None = None
    torque_Nm: Array | None = None
    joints_rad: Array | None = None
    gripper: Array | None = None
    channels: Mapping[str, Array] = field(default_factory=dict)
    events: tuple[Event, ...] = ()
    wrench_estimated: bool = False
    metadata: Mapping[str, Any] = field(default_factory=dict)
    source: Source | None = None
    notices: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        time = _checked_time(self.time_s, self.name)
        object.__setattr__(self, "time_s", time)
        for channel, width in _CHANNELS.items():
            values = getattr(self, channel)
            if values is not None:
                checked = _checked_channel(values, channel, width, len(time), self.name)
                object.__setattr__(self, channel, checked)
        if self.gripper is not None:
            gripper = _checked_gripper(self.gripper, len(time), self.name)
            object.__setattr__(self, "gripper", gripper)
        channels = checked_channels(self.channels, len(time), self.name)
        object.__setattr__(self, "channels", channels)
        object.__setattr__(self, "events", checked_events(self.events, self.name))
        if self.orientation_wxyz is not None:
            continuous = _unit_and_continuous(self.orientation_wxyz, self.name)
            object.__setattr__(self, "orientation_wxyz", continuous)
        object.__setattr__(self, "metadata", MappingProxyType(dict(self.metadata)))

    def __len__(self) -> int:
        return len(self.time_s)

    def __getstate__(self) -> dict[str, Any]:
        """Its values; read-only mappings cannot be sent to another process as they are."""
        mappings = {"channels": dict(self.channels), "metadata": dict(self.metadata)}
        return {**self.__dict__, **mappings}

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Read-only again, as it was."""
        for values in (*state.values(), *state["channels"].values()):
            if isinstance(values, np.ndarray):
                values.flags.writeable = False
        mappings = {key: MappingProxyType(state[key]) for key in ("channels", "metadata")}
        self.__dict__.update({**state, **mappings})

    @property
    def start_s(self) -> float:
        """Time of the first sample."""
        return float(self.time_s[0])

    @property
    def end_s(self) -> float:
        """Time of the last sample."""
        return float(self.time_s[-1])

    @property
    def duration_s(self) -> float:
        """From the first to the last sample."""
        return self.end_s - self.start_s

    @cached_property
    def rate_hz(self) -> float:
        """Samples per second, from the median step."""
        return float(1.0 / np.median(np.diff(self.time_s)))

    @cached_property
    def gaps_s(self) -> tuple[tuple[float, float], ...]:
        """Stretches without data, as (last time before, first time after).

        A step many times longer than the others; what lies inside is neither rest nor motion that
        was demonstrated.
        """
        steps = np.diff(self.time_s)
        usual = max(float(np.median(steps)), float(np.quantile(steps, 0.95)) / 2)
        rows = np.flatnonzero(steps > max(_GAP_STEPS * usual, _MIN_GAP_S))
        times = self.time_s
        return tuple((float(times[row]), float(times[row + 1])) for row in rows)

    @cached_property
    def happenings(self) -> tuple[Event, ...]:
        """Events in words, and what buttons and digital outputs did, in time order."""
        return tuple(sorted((*self.events, *switch_events(self.time_s, self.channels))))

    def told(self, more: Iterable[str]) -> "Demonstration":
        """The same recording with more notices."""
        other = copy.copy(self)
        object.__setattr__(other, "notices", (*self.notices, *more))
        return other

    def index_at(self, time_s: float) -> int:
        """Index of the sample nearest to `time_s`."""
        after = int(np.searchsorted(self.time_s, time_s).clip(1, len(self) - 1))
        before_is_nearer = time_s - self.time_s[after - 1] <= self.time_s[after] - time_s
        return after - 1 if before_is_nearer else after


def _frozen(values: ArrayLike) -> Array:
    array = np.array(values, dtype=np.float64, order="C")
    array.flags.writeable = False
    return array


def _checked_time(values: ArrayLike, name: str) -> Array:
    time = _frozen(values)
    if time.ndim != 1 or len(time) < 2:
        raise DemonstrationError(
            f"{name}: time_s must be one column of at least two samples, "
            f"but has shape {time.shape}."
        )
    _refuse_not_finite(time, "time_s", name)
    _refuse_impossible_time(time, name)
    steps = np.diff(time)
    if (steps <= 0).any():
        row = int(np.argmax(steps <= 0)) + 1
        raise DemonstrationError(
            f"{name}: time_s must increase from row to row, but row {row} has {time[row]:.9g} s "
            f"after {time[row - 1]:.9g} s; sort the rows or drop the repeated ones."
        )
    return time


def _refuse_impossible_time(time: Array, name: str) -> None:
    farthest = float(np.abs(time).max())
    if farthest > MAX_TIME_S:
        raise DemonstrationError(
            f"{name}: time_s must lie within {MAX_TIME_S:g} s, but reaches {farthest:g}; check the "
            "column and its unit."
        )
    step = float(np.median(np.abs(np.diff(time))))
    if 0.0 < step < MIN_STEP_S:
        raise DemonstrationError(
            f"{name}: time_s must have steps of at least {MIN_STEP_S:g} s, but the median one "
            f"is {step:g} s; check the column and its unit."
        )
    if step > MAX_STEP_S:
        raise DemonstrationError(
            f"{name}: time_s must have steps of at most {MAX_STEP_S:g} s, in which a tool can be "
            f"followed, but the median one is {step:g} s; check the column and its unit."
        )


def _checked_channel(
    values: ArrayLike, channel: str, width: int | None, rows: int, name: str
) -> Array:
    array = _frozen(values)
    expected = f"({rows}, {width if width is not None else 'J'})"
    if array.ndim != 2 or len(array) != rows or (width is not None and array.shape[1] != width):
        raise DemonstrationError(
            f"{name}: {channel} must have shape {expected}, one row per time sample, "
            f"but has shape {array.shape}."
        )
    _refuse_not_finite(array, channel, name)
    _refuse_absurd(array, channel, name)
    return array


def _checked_gripper(values: ArrayLike, rows: int, name: str) -> Array:
    array = _frozen(values)
    if array.shape not in ((rows,), (rows, 1)):
        raise DemonstrationError(
            f"{name}: gripper must have shape ({rows},), one opening per time sample, but has "
            f"shape {array.shape}; give one gripper, and as many values as times."
        )
    upright = _checked_channel(array.reshape(rows, 1), "gripper", 1, rows, name)
    return _frozen(upright[:, 0])


def _refuse_not_finite(array: Array, channel: str, name: str) -> None:
    bad = ~np.isfinite(array)
    if bad.any():
        row, *column = (int(i) for i in np.argwhere(bad)[0])
        where = f"row {row}" + (f", column {column[0]}" if column else "")
        value = array[(row, *column)]
        raise DemonstrationError(
            f"{name}: {channel} must be finite, but {where} holds {value}; "
            "cut the samples that were not measured or fill them before reading."
        )


def _refuse_absurd(array: Array, channel: str, name: str) -> None:
    large = np.abs(array) > MAX_MAGNITUDE
    if large.any():
        row, column = (int(i) for i in np.argwhere(large)[0])
        raise DemonstrationError(
            f"{name}: {channel} must lie within {MAX_MAGNITUDE:g} in SI units, but row {row}, "
            f"column {column} holds {array[row, column]:g}; check the column's unit and type."
        )


def _unit_and_continuous(wxyz: Array, name: str) -> Array:
    norms = np.linalg.norm(wxyz, axis=1)
    off = np.abs(norms - 1.0) > UNIT_TOLERANCE
    if off.any():
        row = int(np.argmax(off))
        raise DemonstrationError(
            f"{name}: orientation_wxyz must hold unit quaternions in the order w x y z, "
            f"but row {row} has norm {norms[row]:.6g}; check the columns and their order."
        )
    # Dividing a unit quaternion by its rounded norm would change its last digit on every reading.
    exact = np.abs(norms - 1.0) <= 4 * np.finfo(np.float64).eps
    unit = wxyz / np.where(exact, 1.0, norms)[:, None]
    return _frozen(continued(unit))
