"""A recording of an hour and more: Setup 1 there and back, again and again."""

from pathlib import Path

import numpy as np

from synthetic import setup1

MILLION = 1_000_000
"""Samples of a little more than an hour at 250 Hz."""


def write_long(path: Path, samples: int = MILLION) -> None:
    """Write a recording of so many samples, its position continuous, its force noisy."""
    one = setup1(5000, "real", forces=True).demonstration
    assert one.force_N is not None
    there_and_back = np.concatenate([one.position_m, one.position_m[::-1]])
    force = np.concatenate([one.force_N, one.force_N[::-1]])
    times = -(-samples // len(there_and_back))
    noise = np.random.default_rng(0).normal(0.0, 0.05, (samples, 3))
    np.savez(
        path,
        time_s=np.arange(samples) / one.rate_hz,
        position_m=np.tile(there_and_back, (times, 1))[:samples],
        force_N=np.tile(force, (times, 1))[:samples] + noise,
    )
