"""What two recordings of one task are compared by: the same few signals, each in its own size.

Speed and velocity over the fast speed, place relative to the start over the recording's extent,
rotation relative to the start, force relative to the start over its large values, the gripper's
opening over its range. A recording of another operator, another place or another robot keeps them.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.rotations.courses import from_first
from keyphase.transfer.rests import awake

RATE_HZ = 25.0
"""Enough for phases."""

MAX_SAMPLES = 400
"""Of longer recordings the samples lie wider apart: an alignment costs their square."""

VECTORS = ("velocity", "place", "turn", "force")
"""Kinds of three columns, x y z in the base frame."""

SIZES = ("speed", "size", "gripper")
"""Kinds that are the same in every frame."""

GRIPPER = "gripper"
"""The kind of one column, the opening."""

_UNLIKE = 0.29
_MORE_UNLIKE = {"turn": 0.16, "force": 0.90, GRIPPER: 0.43}
"""The squared mean distance of recordings of different tasks once they are aligned, and what each
kind that not every recording has adds to it (tests/benchmarks/unlike_costs.py)."""

_LEVER_M = 0.2
_FORCE_WEIGHT = 1.5
_SMOOTHING_S = 0.12
_LARGE = 0.98


@dataclass(frozen=True, eq=False)
class Signals:
    """Signals (M, D) at times (M,): an even grid, of which long rests are left out.

    kinds  which columns there are, so that only like are compared with like
    """

    time_s: Array
    values: Array
    kinds: tuple[str, ...]

    @cached_property
    def step_s(self) -> float:
        """How far apart samples are where none are left out [s]."""
        return float(np.diff(self.time_s).min())

    def awake_s(self, time_s: Array) -> Array:
        """Seconds (...) to times (...) on a clock that stands still while samples are left out."""
        return self.step_s * np.interp(time_s, self.time_s, np.arange(len(self.time_s)))

    def between(self, time_s: Array) -> Array:
        """The values (..., D) at times (...), straight between samples."""
        return self.at_awake(self.awake_s(time_s))

    def at_awake(self, awake_s: Array) -> Array:
        """The values (..., D) at moments (...) of the clock that stands still."""
        place = np.clip(awake_s / self.step_s, 0.0, len(self.time_s) - 1.0)
        row = np.minimum(place.astype(int), len(self.time_s) - 2)
        part = (place - row)[..., None]
        return (1.0 - part) * self.values[row] + part * self.values[row + 1]

    def turned(self, turn: Array) -> "Signals":
        """The same in another frame: vectors times an orthogonal matrix (3, 3).

        In a mirror image rotations go the other way round.
        """
        values = self.values.copy()
        for kind in VECTORS:
            if kind in self.kinds:
                x = self.kinds.index(kind)
                values[:, x : x + 3] = self.values[:, x : x + 3] @ turn.T
                if kind == "turn":
                    values[:, x : x + 3] *= np.sign(np.linalg.det(turn))
        return replace(self, values=values)

    def moved(self, by: Sequence[float]) -> "Signals":
        """The same with every place moved by this (3,), in parts of the extent."""
        if "place" not in self.kinds:
            return self
        values = self.values.copy()
        x = self.kinds.index("place")
        values[:, x : x + 3] += by
        return replace(self, values=values)

    def pushed(self, sign: float) -> "Signals":
        """The same with this sign of the force."""
        if "force" not in self.kinds or sign > 0.0:
            return self
        values = self.values.copy()
        x = self.kinds.index("force")
        values[:, x : x + 3] *= sign
        return replace(self, values=values)

    def with_gripper(self) -> "Signals":
        """With a gripper that stands still where there is none."""
        if GRIPPER in self.kinds:
            return self
        still = np.zeros((len(self.time_s), 1))
        return replace(self, values=np.hstack([self.values, still]), kinds=(*self.kinds, GRIPPER))

    def only(self, kinds: Sequence[str]) -> "Signals":
        """With these kinds alone."""
        chosen = [i for kind in kinds for i, name in enumerate(self.kinds) if name == kind]
        return Signals(self.time_s, self.values[:, chosen], tuple(self.kinds[i] for i in chosen))


@dataclass(frozen=True, eq=False)
class Standing:
    """How a recording has to be turned, and then moved, to lie on another.

    turn   (3, 3) orthogonal; its determinant is -1 where the other is its mirror image
    moved  (3,) of its places relative to the start, in parts of its extent: it began elsewhere
    pushed -1 where its force has the other sign: one tells what the tool pushes, the other what
           pushes the tool
    """

    turn: Array = field(default_factory=lambda: np.eye(3))
    moved: tuple[float, float, float] = (0.0, 0.0, 0.0)
    pushed: float = 1.0

    @property
    def turned_rad(self) -> float:
        """The angle about the vertical, where that is all it is turned about [rad]."""
        return float(np.arctan2(self.turn[1, 0], self.turn[0, 0]))

    def after(self, turn: Array) -> "Standing":
        """As it stands where it is turned before."""
        return replace(self, turn=self.turn @ turn)


def about_vertical(angle_rad: float) -> Array:
    """The turn (3, 3) by an angle about the vertical."""
    cosine, sine = np.cos(angle_rad), np.sin(angle_rad)
    return np.array([[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]])


AS_IT_STANDS = Standing()


def in_common(
    first: Signals, second: Signals, standing: Standing = AS_IT_STANDS
) -> tuple[Signals, Signals]:
    """Both with the kinds that both have, the second turned and moved.

    A gripper that only one has stands still in the other: what is done with one and without one is
    not the same task.
    """
    if (GRIPPER in first.kinds) != (GRIPPER in second.kinds):
        first, second = first.with_gripper(), second.with_gripper()
    shared = [kind for kind in dict.fromkeys(first.kinds) if kind in second.kinds]
    stands = second.only(shared).turned(standing.turn).moved(standing.moved)
    return first.only(shared), stands.pushed(standing.pushed)


def unlike(kinds: Sequence[str]) -> float:
    """How far apart recordings of different tasks are that have these kinds of signals.

    The fewer there are to differ in, the nearer are strangers.
    """
    return float(np.sqrt(_UNLIKE + sum(_MORE_UNLIKE.get(kind, 0.0) for kind in set(kinds))))


def signals_of(demonstration: Demonstration) -> Signals:
    """The signals of a demonstration at RATE_HZ, or slower where it is long."""
    count = min(max(int(demonstration.duration_s * RATE_HZ) + 1, 2), MAX_SAMPLES)
    grid = np.linspace(demonstration.start_s, demonstration.end_s, count)
    place = _smooth(_at(demonstration.time_s, demonstration.position_m, grid))
    velocity = np.gradient(place, grid, axis=0)
    speed = np.linalg.norm(velocity, axis=1, keepdims=True)
    fast = np.quantile(speed, _LARGE) + 1e-9
    relative = place - place[0]
    extent = np.linalg.norm(relative, axis=1).max() + 1e-9
    columns = {"speed": speed / fast, "velocity": velocity / fast, "place": relative / extent}
    if demonstration.orientation_wxyz is not None:
        turn = _turn(demonstration.time_s, demonstration.orientation_wxyz, grid)
        largest = float(np.linalg.norm(turn, axis=1).max())
        columns["turn"] = _LEVER_M * turn / max(extent, _LEVER_M * largest, 1e-9)
    if demonstration.force_N is not None:
        columns |= _force(_smooth(_at(demonstration.time_s, demonstration.force_N, grid)))
    if demonstration.gripper is not None:
        opening = np.interp(grid, demonstration.time_s, demonstration.gripper)[:, None]
        columns[GRIPPER] = (opening - opening.min()) / (np.ptp(opening) + 1e-9)
    kinds = tuple(name for name, values in columns.items() for _ in range(values.shape[1]))
    values = np.hstack(list(columns.values()))
    kept = awake(grid, values)
    return Signals(grid[kept], values[kept], kinds)


def _force(force: Array) -> dict[str, Array]:
    rest = np.median(force[: max(3, int(0.3 * RATE_HZ))], axis=0)
    change = force - rest
    size = np.linalg.norm(change, axis=1, keepdims=True)
    large = np.quantile(size, _LARGE) + 1e-9
    return {"force": _FORCE_WEIGHT * change / large, "size": _FORCE_WEIGHT * size / large}


def _turn(time_s: Array, wxyz: Array, grid: Array) -> Array:
    """Rotation vector (M, 3) from the first orientation."""
    nearest = np.clip(np.searchsorted(time_s, grid), 0, len(time_s) - 1)
    return from_first(wxyz[nearest])


def _at(time_s: Array, values: Array, grid: Array) -> Array:
    return np.column_stack([np.interp(grid, time_s, column) for column in values.T])


def _smooth(values: Array) -> Array:
    width = max(int(_SMOOTHING_S * RATE_HZ) | 1, 1)
    padded = np.pad(values, ((width // 2, width // 2), (0, 0)), mode="edge")
    kernel = np.ones(width) / width
    return np.column_stack([np.convolve(column, kernel, mode="valid") for column in padded.T])
