"""Where a human hand leads the tool: strokes, turns and pauses, with the habits of a hand."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array
from keyphase.simulation.impedance import RATE_HZ, Reference

_STEP_S = 1.0 / RATE_HZ


@dataclass(frozen=True)
class Habits:
    """How steady a hand is: root mean squares of tremor (4 to 12 Hz) and drift (below 1 Hz).

    `bulge` is how far a stroke bends aside, as a part of its length.
    """

    tremor_m: float
    drift_m: float
    tremor_rad: float
    drift_rad: float
    bulge: float

    @classmethod
    def drawn(cls, random: np.random.Generator) -> "Habits":
        """Those of one person on one day."""
        return cls(
            tremor_m=random.uniform(0.02e-3, 0.10e-3),
            drift_m=random.uniform(0.05e-3, 0.25e-3),
            tremor_rad=random.uniform(0.1e-3, 0.5e-3),
            drift_rad=random.uniform(0.5e-3, 2e-3),
            bulge=random.uniform(0.0, 0.03),
        )


@dataclass(frozen=True)
class Phase:
    """One thing the operator meant to do, and when; the ground truth of a segmentation."""

    name: str
    start_s: float
    end_s: float


class HandPath:
    """A path that grows phase by phase from a start pose, then is sampled at the control rate."""

    def __init__(self, start: Reference, habits: Habits, random: np.random.Generator) -> None:
        self._random, self._habits = random, habits
        self._offsets: list[Array] = [np.zeros((1, 3))]
        self._turns: list[Array] = [np.zeros((1, 3))]
        self._start = start
        self.phases: list[Phase] = []

    @property
    def end_s(self) -> float:
        """How long the path is so far."""
        return (sum(len(part) for part in self._offsets) - 1) * _STEP_S

    def pause(self, name: str, duration_s: float) -> None:
        """Rest while the hand changes its grasp, which nudges the tool a little."""
        s = _progress(duration_s)
        nudge = self._random.normal(size=3) * 0.3e-3
        offset = np.outer(minimum_jerk(3.0 * s - 1.0), nudge)
        self._extend(name, offset, np.zeros_like(offset))

    def stroke(self, name: str, displacement_m: Array, duration_s: float) -> None:
        """Move by `displacement_m`, sooner or later fast, and never quite straight."""
        skew = self._random.uniform(0.85, 1.2)
        s = minimum_jerk(_progress(duration_s) ** skew)
        self._extend(name, np.outer(s, displacement_m) + self._bulged(s, displacement_m), None)

    def turn(self, name: str, turn_rad: Array, duration_s: float) -> None:
        """Rotate the tool about its point by the rotation vector `turn_rad`, base frame."""
        skew = self._random.uniform(0.85, 1.2)
        s = minimum_jerk(_progress(duration_s) ** skew)
        wander = self._random.normal(size=3) * 1e-3
        self._extend(name, np.outer(s, wander), np.outer(s, turn_rad))

    def push(self, name: str, direction: Array, speeds_m_s: Array, overlap_s: float = 0.0) -> None:
        """Move along the unit vector `direction` at the given speeds, one per control tick.

        It sets in `overlap_s` before the phase before is over, as hands do at a via point.
        """
        travelled = np.outer(np.cumsum(speeds_m_s) * _STEP_S, direction)
        early = round(overlap_s * RATE_HZ)
        if early:
            self._offsets[-1][-early:] += travelled[:early]
        self._extend(name, travelled[early:] - (travelled[early - 1] if early else 0.0), None)
        self.phases[-1] = replace(self.phases[-1], start_s=self.phases[-1].start_s - overlap_s)

    def references(self) -> list[Reference]:
        """The path at the control rate; tremor and drift move it, but are not meant."""
        meant = np.concatenate(self._offsets)
        turns = np.concatenate(self._turns)
        velocity = np.gradient(meant, _STEP_S, axis=0)
        turning = np.gradient(turns, _STEP_S, axis=0)
        habits, rows = self._habits, len(meant)
        position = (
            self._start.position_m + meant + self._unsteady(rows, habits.tremor_m, habits.drift_m)
        )
        first = Rotation.from_quat(self._start.orientation_wxyz, scalar_first=True)
        shaken = Rotation.from_rotvec(self._unsteady(rows, habits.tremor_rad, habits.drift_rad))
        wxyz = (shaken * Rotation.from_rotvec(turns) * first).as_quat(scalar_first=True)
        rows = zip(position, wxyz, velocity, turning, strict=True)
        return [Reference(p, q, v, w) for p, q, v, w in rows]

    def _extend(self, name: str, offset: Array, turn: Array | None) -> None:
        start_s = self.end_s
        self._offsets.append(self._offsets[-1][-1] + offset)
        turned = np.zeros_like(offset) if turn is None else turn
        self._turns.append(self._turns[-1][-1] + turned)
        self.phases.append(Phase(name, start_s, self.end_s))

    def _bulged(self, s: Array, displacement_m: Array) -> Array:
        aside = np.cross(displacement_m, self._random.normal(size=3))
        aside *= self._habits.bulge * np.linalg.norm(displacement_m) / np.linalg.norm(aside)
        return np.outer(4.0 * s * (1.0 - s), aside)

    def _unsteady(self, rows: int, tremor: float, drift: float) -> Array:
        wobble = band_noise(self._random, rows, (4.0, 12.0)) * tremor
        wobble += band_noise(self._random, rows, (0.1, 1.0)) * drift
        return wobble - wobble[0]


def minimum_jerk(s: Array) -> Array:
    """The minimum-jerk course from 0 to 1 (Flash and Hogan 1985), held outside [0, 1]."""
    s = np.clip(s, 0.0, 1.0)
    return s**3 * (10.0 - 15.0 * s + 6.0 * s**2)


def band_noise(random: np.random.Generator, rows: int, band_hz: tuple[float, float]) -> Array:
    """Gaussian noise (rows, 3) of unit root mean square with all its power in a band."""
    frequencies = np.fft.rfftfreq(rows, _STEP_S)
    inside = (frequencies >= band_hz[0]) & (frequencies <= band_hz[1])
    spectrum = np.zeros((len(frequencies), 3), complex)
    shape = (int(inside.sum()), 3)
    spectrum[inside] = random.normal(size=shape) + 1j * random.normal(size=shape)
    noise = np.fft.irfft(spectrum, rows, axis=0)
    return noise / np.maximum(noise.std(axis=0), 1e-12)


def _progress(duration_s: float) -> Array:
    ticks = max(1, round(duration_s * RATE_HZ))
    return np.arange(1, ticks + 1) / ticks
