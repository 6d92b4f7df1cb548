"""Where a human hand leads the tool: strokes, turns and pauses, with the habits of a hand."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array
from keyphase.simulation.impedance import RATE_HZ, Reference

_STEP_S = 1.0 / RATE_HZ
X, Y, Z = np.eye(3)

UNTIL_CONTACT = "until contact"
"""How the names of phases end that wait for a contact change."""


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
            drift_m=random.uniform(0.05e-3, 0.20e-3),
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

    def pause(self, name: str, duration_s: float, ease_m: Array | None = None) -> None:
        """Rest while the hand changes its grasp, which nudges the tool a little.

        `ease_m` is how far the hand gives way meanwhile.
        """
        s = _progress(duration_s)
        nudge = self._random.normal(size=3) * 0.3e-3
        offset = np.outer(minimum_jerk(3.0 * s - 1.0), nudge)
        if ease_m is not None:
            offset += np.outer(minimum_jerk(s), ease_m)
        self._extend(name, offset, np.zeros_like(offset))

    @property
    def here_m(self) -> Array:
        """Where the path has come to, in the base frame."""
        return self._start.position_m + self._offsets[-1][-1]

    def stroke(
        self,
        name: str,
        goal_m: Array,
        duration_s: float,
        overlap_s: float = 0.0,
        on_table: bool = False,
    ) -> None:
        """Move to `goal_m`, sooner or later fast, and never quite straight.

        On the table a stroke begins gently and bends sideways only: the hand feels what it does.
        """
        s = self._course(duration_s, earliest=1.0 if on_table else 0.85)
        displacement = goal_m - self.here_m
        across = Z if on_table else self._random.normal(size=3)
        aside = np.cross(displacement, across)
        bend = self._random.uniform(-1.0, 1.0) * self._habits.bulge
        aside *= bend * np.linalg.norm(displacement) / np.linalg.norm(aside)
        offset = np.outer(s, displacement) + np.outer(4.0 * s * (1.0 - s), aside)
        self._extend(name, offset, np.zeros_like(offset), overlap_s)

    def turn(self, name: str, turn_rad: Array, duration_s: float) -> None:
        """Rotate the tool about its point by the rotation vector `turn_rad`, base frame."""
        s = self._course(duration_s)
        wander = self._random.normal(size=3) * 1e-3
        self._extend(name, np.outer(s, wander), np.outer(s, turn_rad))

    def push(self, name: str, direction: Array, speeds_m_s: Array, overlap_s: float = 0.0) -> None:
        """Move along the unit vector `direction` at the given speeds, one per control tick."""
        travelled = np.outer(np.cumsum(speeds_m_s) * _STEP_S, direction)
        self._extend(name, travelled, np.zeros_like(travelled), overlap_s)

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
        return [
            Reference(position[row], wxyz[row], velocity[row], turning[row]) for row in range(rows)
        ]

    def _course(self, duration_s: float, earliest: float = 0.85) -> Array:
        """From 0 to 1, its fastest moment a little before or after the middle."""
        return minimum_jerk(_progress(duration_s) ** self._random.uniform(earliest, 1.2))

    def _extend(self, name: str, offset: Array, turn: Array, overlap_s: float = 0.0) -> None:
        """Add a phase that sets in before the last one is over, as hands do at a via point."""
        early = min(round(overlap_s * RATE_HZ), len(self._offsets[-1]))
        start_s = self.end_s - early * _STEP_S
        for parts, change in ((self._offsets, offset), (self._turns, turn)):
            before = parts[-1][-1].copy()
            if early:
                parts[-1][-early:] += change[:early]
            parts.append(before + change[early:])
        self.phases.append(Phase(name, start_s, self.end_s))

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
