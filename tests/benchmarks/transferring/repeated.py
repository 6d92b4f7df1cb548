"""A task by formula, done again and again: one made recording, each time otherwise.

Each phase takes its own time (a quarter more or less, and the whole a tempo of 0.6 to 1.6), each of
its ends lies elsewhere (up to a tenth of the extent), the hand bends the ways and presses harder or
softer, and all stands otherwise to the robot.
"""

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation
from transferring.known import SIMULATED_TOLERANCE_S, Known

from keyphase.demonstration import Demonstration
from keyphase.making import make

REPEATED = {"push": 0, "wipe": 8, "hand-over": 1, "two-handed": 2}
"""Families and the seed of the recording that is done again."""

_RATE_HZ = 100.0


def repeated(family: str, seed: int, count: int) -> list[Known]:
    """The recording of a family with this seed, done `count` times."""
    made = make(family, seed)
    demonstration = made.demonstration
    ends_s = [event.time_s for event in made.events]
    known = Known(
        demonstration,
        tuple(ends_s),
        tuple(f"{number}" for number in range(len(ends_s) + 1)),
        SIMULATED_TOLERANCE_S,
    )
    return [_again(known, np.random.default_rng([17, seed, number])) for number in range(count)]


def _again(known: Known, rng: np.random.Generator) -> Known:
    own = known.demonstration
    edges = np.array([own.start_s, *known.ends_s, own.end_s])
    took = np.diff(edges) * np.exp(rng.uniform(np.log(0.6), np.log(1.6)))
    later = np.concatenate([[0.0], np.cumsum(took * np.exp(rng.normal(0.0, 0.22, len(took))))])
    time_s = np.arange(0.0, later[-1], 1.0 / _RATE_HZ)
    was_s = np.interp(time_s, later, edges)
    turn = Rotation.from_rotvec([0.0, 0.0, np.deg2rad(rng.uniform(-40.0, 40.0))])
    extent_m = np.linalg.norm(np.ptp(own.position_m, axis=0))
    aside_m = rng.normal(0.0, 0.03 * extent_m, (len(edges), 3))
    bent_m = _smoothly(time_s, later, aside_m)
    position = _at(was_s, own.time_s, own.position_m) + bent_m
    channels = {"position_m": turn.apply(position) + rng.uniform(-0.5, 0.5, 3)}
    for name in ("force_N", "torque_Nm"):
        values = getattr(own, name)
        if values is not None:
            noise = rng.normal(0.0, 0.005 * np.ptp(values), (len(time_s), 3))
            harder = np.exp(rng.normal(0.0, 0.15))
            channels[name] = turn.apply(harder * _at(was_s, own.time_s, values) + noise)
    if own.orientation_wxyz is not None:
        nearest = np.searchsorted(own.time_s, was_s).clip(0, len(own.time_s) - 1)
        turned = turn * Rotation.from_quat(own.orientation_wxyz[nearest], scalar_first=True)
        channels["orientation_wxyz"] = turned.as_quat(scalar_first=True)
    return replace(
        known,
        demonstration=Demonstration(own.name, time_s, **channels),
        ends_s=tuple(later[1:-1].tolist()),
    )


def _at(time_s: np.ndarray, known_s: np.ndarray, values: np.ndarray) -> np.ndarray:
    return np.column_stack([np.interp(time_s, known_s, column) for column in values.T])


def _smoothly(time_s: np.ndarray, at_s: np.ndarray, values: np.ndarray) -> np.ndarray:
    """From value to value without a jerk, still at each of them."""
    part = np.interp(time_s, at_s, np.arange(len(at_s)))
    whole = np.minimum(part.astype(int), len(at_s) - 2)
    share = (0.5 - 0.5 * np.cos(np.pi * (part - whole)))[:, None]
    return (1.0 - share) * values[whole] + share * values[whole + 1]
