"""How a recording is sampled: 10 to 1000 Hz, evenly or with jitter, channels held, rows lost."""

from dataclasses import dataclass

import numpy as np

from keyphase.making.draws import Array, Rows, chance

FINE_HZ = 100.0
"""No demonstration is made more coarsely than this; slower recordings take samples out of it."""

RATES_HZ = (10, 20, 30, 50, 60, 100, 100, 125, 200, 200, 250, 250, 500, 1000)


@dataclass(frozen=True)
class Sampling:
    """Which samples of a fine demonstration a recording has.

    fine_hz   rate at which it is made; every `every`th sample is recorded
    """

    fine_hz: float
    every: int
    jitter: float
    lost: float
    pose_held: int
    wrench_held: int

    @classmethod
    def drawn(cls, rng: np.random.Generator) -> "Sampling":
        """Any sampling; most are even and hold nothing."""
        rate = float(rng.choice(RATES_HZ))
        every = max(1, int(np.ceil(FINE_HZ / rate)))
        uneven = chance(rng, 0.15)
        held = int(rng.integers(2, 8)) if rate >= 100.0 and chance(rng, 0.15) else 1
        pose_is_held = chance(rng, 0.7)
        return cls(
            rate * every,
            every,
            rng.uniform(0.05, 0.4) if uneven else 0.0,
            rng.uniform(0.0, 0.03) if uneven else 0.0,
            held if pose_is_held else 1,
            1 if pose_is_held else held,
        )

    def rows(self, rng: np.random.Generator, count: int) -> tuple[Array, Rows, Rows]:
        """Stamps (N,) [s], and which fine sample the pose and the wrench of each row come from."""
        rows = np.arange(0, count, self.every)
        if self.lost:
            kept = rng.random(len(rows)) >= self.lost
            kept[[0, -1]] = True
            rows = rows[kept]
        stamps = rows / self.fine_hz
        if self.jitter:
            step = self.every / self.fine_hz
            stamps = stamps + step * self.jitter * rng.uniform(-0.5, 0.5, len(rows))
            stamps = np.maximum(stamps - stamps[0], 0.0)
        return stamps, _held(rows, self.pose_held), _held(rows, self.wrench_held)


def _held(rows: Rows, times: int) -> Rows:
    return rows[np.arange(len(rows)) // times * times]
