"""The curves of the timeline: computed once per recording, decimated for the range in view."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType

import numpy as np
from tsdownsample import MinMaxDownsampler

from keyphase.demonstration import Array, Demonstration
from keyphase.rotations.courses import from_first
from keyphase.segmentation.segmentation import ErrorCurve, EvidenceTrack

POINTS_PER_PIXEL = 2
"""Two points a pixel show every extreme; more cannot be seen."""

SPEED_WINDOW_S = 0.02
"""Speed is a difference over this long, since sample to sample it would be noise."""

_AXES = ("x", "y", "z")


@dataclass(frozen=True, eq=False)
class Series:
    """One curve: (N,) times [s] and values, and the least and greatest value of all of them."""

    key: str
    time_s: Array
    values: Array

    @cached_property
    def scale(self) -> tuple[float, float]:
        """Least and greatest value over the whole recording."""
        return float(self.values.min()), float(self.values.max())

    def decimated(self, from_s: float, to_s: float, points: int) -> tuple[Array, Array]:
        """Times and values from `from_s` to `to_s`, about `points` of them.

        They are the least and the greatest value of each of `points` / 2 equal stretches, so no
        peak is lost, which the LTTB selection on top of that does not promise. One sample outside
        either end is included, so that the curve runs on to the edges.
        """
        first = max(int(np.searchsorted(self.time_s, from_s, "left")) - 1, 0)
        last = min(int(np.searchsorted(self.time_s, to_s, "right")) + 1, len(self.time_s))
        time, values = self.time_s[first:last], self.values[first:last]
        bins = max(points // 2, 1)
        if len(time) <= 2 * bins:
            return time, values
        found = MinMaxDownsampler().downsample(time, values, n_out=2 * bins)
        kept = np.unique(np.concatenate([[0], found.astype(np.intp), [len(time) - 1]]))
        return time[kept], values[kept]


class SignalTracks:
    """The tracks of one recording; each is computed when it is first asked for."""

    def __init__(
        self,
        demonstration: Demonstration,
        curve: ErrorCurve | None,
        track: EvidenceTrack | None = None,
    ) -> None:
        self._demonstration = demonstration
        self._track = track
        self._makers: Mapping[str, Callable[[], tuple[Series, ...]]] = MappingProxyType(
            self._known(curve)
        )
        self._made: dict[str, tuple[Series, ...]] = {}

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the tracks this recording has."""
        return tuple(self._makers)

    def track(self, name: str) -> tuple[Series, ...]:
        """The curves of a track; none for a track this recording does not have."""
        if name not in self._makers:
            return ()
        if name not in self._made:
            self._made[name] = self._makers[name]()
        return self._made[name]

    def _known(self, curve: ErrorCurve | None) -> dict[str, Callable[[], tuple[Series, ...]]]:
        d = self._demonstration
        known: dict[str, Callable[[], tuple[Series, ...]]] = {}
        if curve is not None:
            known["error"] = lambda: (
                Series("error", curve.time_s, curve.error),
                Series("median", curve.time_s, curve.running_median),
            )
        if self._track is not None:
            known["evidence"] = lambda track=self._track: tuple(
                Series(key, track.time_s, values)
                for key, values in (("contact", track.contact), ("motion", track.motion))
                if values is not None
            )
        known["position"] = lambda: self._three(1e3 * (d.position_m - d.position_m[0]))
        known["speed"] = lambda: (Series("speed", d.time_s, speed_mm_s(d)),)
        if d.gripper is not None:
            known["gripper"] = lambda values=d.gripper: (Series("gripper", d.time_s, values),)
        for name, values in (("force", d.force_N), ("torque", d.torque_Nm)):
            if values is not None:
                known[name] = lambda values=values: self._three(values)
        if d.orientation_wxyz is not None:
            known["orientation"] = lambda: self._three(rotation_from_start_deg(d))
        for name, values in d.channels.items():
            known[f"channel/{name}"] = lambda values=values: (Series("value", d.time_s, values),)
        return known

    def _three(self, values: Array) -> tuple[Series, ...]:
        time = self._demonstration.time_s
        return tuple(
            Series(axis, time, np.ascontiguousarray(values[:, i])) for i, axis in enumerate(_AXES)
        )


def speed_mm_s(demonstration: Demonstration) -> Array:
    """(N,) speed of the tool point, a central difference over SPEED_WINDOW_S [mm/s]."""
    time, position = demonstration.time_s, demonstration.position_m
    half = max(round(0.5 * SPEED_WINDOW_S * demonstration.rate_hz), 1)
    index = np.arange(len(time))
    before, after = np.maximum(index - half, 0), np.minimum(index + half, len(time) - 1)
    distance = np.linalg.norm(position[after] - position[before], axis=1)
    return 1e3 * distance / (time[after] - time[before])


def rotation_from_start_deg(demonstration: Demonstration) -> Array:
    """(N, 3) rotation vector from the first sample, base frame, however far it turns [deg]."""
    assert demonstration.orientation_wxyz is not None
    return np.rad2deg(from_first(demonstration.orientation_wxyz))
