"""What the hand wants: a path of poses among the things, and when it closes the gripper."""

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.making.draws import Array, log_uniform
from keyphase.making.path import Path
from keyphase.making.strokes import progress
from keyphase.simulation.making.bench import RATE_HZ


class Wanting:
    """A path in the bench's frame, growing from its beginning to its end."""

    def __init__(self, rng: np.random.Generator, start_m: Array, tempo: float) -> None:
        self.rng, self.tempo = rng, tempo
        self.path = Path(RATE_HZ, at_m=np.asarray(start_m, float))
        self.closed: list[tuple[int, float]] = [(0, 0.0)]
        self.reversals_s: list[float] = []
        self.rest()

    @property
    def at_m(self) -> Array:
        """Where the hand wants the tool to be now (3,)."""
        return self.path.at_m

    def go(self, x: float | None = None, y: float | None = None, z: float | None = None) -> None:
        """To a place; coordinates that are not given stay."""
        target = np.array(
            [a if b is None else b for a, b in zip(self.at_m, (x, y, z), strict=True)]
        )
        way = target - self.at_m
        reach = float(np.linalg.norm(way))
        seconds = max(0.3, self.tempo * self.rng.uniform(0.7, 1.4) * np.sqrt(reach / 0.15 + 0.05))
        along = progress(self.rng, self.path.samples(seconds), 0.2)
        self.path.move(along, way, np.zeros(3), np.zeros((len(along), 3)))

    def rest(self, low_s: float = 0.4, high_s: float = 2.5) -> None:
        """Want to stay."""
        self.path.rest(log_uniform(self.rng, low_s, high_s))

    def rounds(self, seconds: float, reach_m: float, flatness: float) -> None:
        """Round, or to and fro, in the plane, pressing now more and now less."""
        count = self.path.samples(seconds)
        time = np.arange(count) / RATE_HZ
        phase = 2.0 * np.pi * log_uniform(self.rng, 0.3, 1.2) * time
        grown = reach_m * np.clip(np.minimum(time, time[::-1]) / 0.5, 0.0, 1.0)
        press = 0.0015 * self.rng.uniform(0.0, 1.0) * grown / reach_m * np.sin(phase + 1.0)
        way = np.stack([grown * np.sin(phase), flatness * grown * (np.cos(phase) - 1.0), press], 1)
        if flatness < 0.5:
            turns = np.flatnonzero(np.diff(np.floor(phase / np.pi + 0.5)) > 0)
            self.reversals_s += [float(t) for t in (self.path.count + turns) / RATE_HZ]
        self.path.follow(way, np.zeros((count, 3)))

    def grip(self, closed: bool) -> None:
        """Close or open the gripper from now on."""
        self.closed.append((self.path.count, float(closed)))

    def wanted(self) -> tuple[Array, Rotation, Array]:
        """Positions (N, 3), rotations (N), closing (N,)."""
        position, rotation = self.path.poses()
        closing = np.zeros(len(position))
        for first, value in self.closed:
            closing[first:] = value
        return position, rotation, closing
