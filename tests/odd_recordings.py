"""Recordings with one oddity each, and what is said of it."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.readers import save_npz

ROWS = 600
T = np.arange(ROWS) / 50.0
WAY = 0.1 * (1 - np.cos(2 * np.pi * T / 6.0))
PLACE = np.column_stack([0.4 + WAY, 0.0 * T, 0.3 + 0.0 * T])
NOISE = np.random.default_rng(0).normal(0, 0.05, (ROWS, 3))
SPEED = np.gradient(WAY, T)
STILL = np.tile([0.4, 0.1, 0.3], (ROWS, 1))
TURNING = np.linspace(0, 1, ROWS)[:, None]


def at(row: int, values: np.ndarray, value: object) -> np.ndarray:
    """The values with another one in a row."""
    changed = values.copy()
    changed[row] = value
    return changed


def pushed(strength: float) -> np.ndarray:
    """A force along the speed, which helps, or against it."""
    return NOISE + strength * np.column_stack([SPEED, 0 * T, 0 * T]) / np.abs(SPEED).max()


KINDS: Mapping[str, tuple[dict[str, np.ndarray], str]] = {
    "milliseconds": ({"time_s": 1000 * T}, "were milliseconds read as seconds?"),
    "gap": ({"time_s": T + 1.5 * (T > 4)}, "1.52 s without data at 4.00 s"),
    "jump": ({"position_m": at(300, PLACE, [0.9, 0.5, 0.3])}, "The tool jumps"),
    "zero": ({"position_m": at(300, PLACE, 0.0)}, "1 row has the place 0 0 0"),
    "constant": ({"force_N": NOISE * [1, 1, 0]}, "force_N z never changes"),
    "saturated": ({"force_N": np.clip(pushed(-30.0), -8, 8)}, "may have been at its limit"),
    "still": (
        {"position_m": STILL, "joints_rad": TURNING},
        "position_m never changes while joints",
    ),
    "wander": (
        {"position_m": STILL + 1e-5 * NOISE, "force_N": NOISE + 2 * np.sin(T)[:, None]},
        "the force wanders by",
    ),
    "sign": ({"force_N": pushed(10.0)}, "helps the motion"),
}


def save_odd_recordings(folder: Path) -> None:
    """A recording for each oddity, named after it."""
    for name, (channels, _) in KINDS.items():
        given = {"time_s": T, "position_m": PLACE, **channels}
        save_npz(Demonstration(name, **given), folder / f"{name}.npz")
