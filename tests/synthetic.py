"""Seeded synthetic demonstrations of the paper's two set-ups, with what is true of them.

Setup 1: move forward, idle, down until contact, idle, sideways until contact (five segments).
Setup 2: rotate, down until contact, sideways until contact, on, pushing (four segments).
At the level "easy" movements are minimum-jerk and clean; "real" adds tremor, drift, skewed
speed, curved paths and directions off the axes. `python tests/synthetic.py` writes the bundled
data/synthetic_setup1.npz.
"""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Demonstration

Array = NDArray[np.float64]
Level = Literal["easy", "real"]

RATE_HZ = 250.0
BUNDLED = Path(__file__).parents[1] / "data" / "synthetic_setup1.npz"

_SLOW = 0.05


@dataclass(frozen=True, eq=False)
class Synthetic:
    """A demonstration with the times at which its movements switch.

    switches_s   the generator's own switch times
    slow_s       the same, where speed passes 5 % of the movement's peak; None for Setup 2
    contacts_s   the contact changes among the switches
    """

    demonstration: Demonstration
    switches_s: Array
    slow_s: Array | None
    contacts_s: Array


def setup1(seed: int, level: Level, forces: bool = False) -> Synthetic:
    """Setup 1; the same seed gives the same demonstration."""
    rng = np.random.default_rng(seed)
    real = level == "real"
    durations, distances = rng.uniform(0.5, 2.0, 5), rng.uniform(0.05, 0.40, 3)
    edges = np.concatenate([[0.0], np.cumsum(durations)])
    time = _times(edges[-1])
    skews = rng.uniform(0.8, 1.25, 3) if real else np.ones(3)
    noise = _noise_level(rng, real)
    directions = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    if real:
        directions = directions * rng.choice([-1, 1], (3, 1))
        directions = Rotation.from_rotvec(rng.normal(size=3) * 0.15).apply(directions)
    position = np.zeros((len(time), 3))
    for move, direction in enumerate(directions):
        part = (time - edges[2 * move]) / durations[2 * move]
        reached = minimum_jerk(np.clip(part, 0.0, 1.0) ** skews[move])
        position += distances[move] * reached[:, None] * direction
        if real:
            position += _bulge(rng, part, distances[move], direction)
    if real:
        position += _tremor_and_drift(rng, len(time), 5e-4, 1e-3)
    position += rng.normal(size=position.shape) * noise
    switches = edges[1:-1]
    force = _contact_force(seed, time, position, [(switches[2], -directions[1])])
    return Synthetic(
        Demonstration(f"setup1_{level}_{seed}", time, position, force_N=force if forces else None),
        switches,
        _slow_instants(edges, durations, skews),
        switches[2:3],
    )


def setup2(seed: int, level: Level, forces: bool = True) -> Synthetic:
    """Setup 2; the same seed gives the same demonstration."""
    rng = np.random.default_rng(10_000 + seed)
    real = level == "real"
    durations, distances = rng.uniform(0.7, 2.0, 4), rng.uniform(0.08, 0.40, 2)
    angle = np.radians(rng.uniform(30, 120))
    edges = np.concatenate([[0.0], np.cumsum(durations)])
    time = _times(edges[-1])
    noise = _noise_level(rng, real)
    axis = rng.normal(size=3) if real else np.array([0.0, 0.0, 1.0])
    axis /= np.linalg.norm(axis)
    parts = [(time - begin) / length for begin, length in zip(edges, durations, strict=False)]
    rotation = angle * minimum_jerk(parts[0])[:, None] * axis
    cut = rng.uniform(0.75, 1.0) if real else 0.9
    down = minimum_jerk(np.clip(parts[1], 0.0, 1.0) * cut) / minimum_jerk(cut)
    position = -distances[0] * down[:, None] * np.array([0.0, 0.0, 1.0])
    slowed = rng.uniform(0.35, 0.65) if real else 0.5
    turned = rng.uniform(-0.35, 0.35) if real else 0.0
    sideways = _pushed_path(parts[2], parts[3], slowed, turned)
    position = position + sideways * distances[1] / np.linalg.norm(sideways[-1])
    if real:
        position += _tremor_and_drift(rng, len(time), 5e-4, 1e-3)
        rotation += _tremor_and_drift(rng, len(time), 2e-3, 5e-3)
    position = position + rng.normal(size=position.shape) * noise
    rotation = rotation + rng.normal(size=rotation.shape) * noise * 3.0
    switches = edges[1:-1]
    meets = [(switches[1], np.array([0.0, 0.0, 1.0])), (switches[2], np.array([0.0, -1.0, 0.0]))]
    force = _contact_force(seed, time, position, meets)
    return Synthetic(
        Demonstration(
            f"setup2_{level}_{seed}",
            time,
            position,
            Rotation.from_rotvec(rotation).as_quat(scalar_first=True),
            force if forces else None,
        ),
        switches,
        None,
        switches[1:],
    )


def minimum_jerk(part):
    """Share of the way after a part of the time."""
    part = np.clip(part, 0.0, 1.0)
    return 10.0 * part**3 - 15.0 * part**4 + 6.0 * part**5


def in_band(rng: np.random.Generator, count: int, low_hz: float, high_hz: float, rms: float):
    """Gaussian noise (count, 3) of a frequency band."""
    frequency = np.fft.rfftfreq(count, 1.0 / RATE_HZ)
    spectrum = np.zeros((len(frequency), 3), complex)
    band = (frequency >= low_hz) & (frequency <= high_hz)
    shape = (band.sum(), 3)
    spectrum[band] = rng.normal(size=shape) + 1j * rng.normal(size=shape)
    noise = np.fft.irfft(spectrum, count, axis=0)
    spread = noise.std(axis=0)
    return rms * noise / np.where(spread == 0.0, 1.0, spread)


def _times(end_s: float) -> Array:
    return np.arange(round(end_s * RATE_HZ) + 1) / RATE_HZ


def _noise_level(rng: np.random.Generator, real: bool) -> float:
    return 10 ** rng.uniform(np.log10(2e-5), np.log10(5e-4)) if real else 1e-4


def _bulge(rng: np.random.Generator, part: Array, distance: float, direction: Array) -> Array:
    """Off the straight line by up to 3 % of the distance."""
    beside = np.cross(direction, rng.normal(size=3))
    beside /= np.linalg.norm(beside)
    reached = minimum_jerk(part)
    height = rng.uniform(0, 0.03) * distance * 4.0
    return (height * reached * (1.0 - reached))[:, None] * beside


def _tremor_and_drift(rng: np.random.Generator, count: int, tremor: float, drift: float) -> Array:
    shaking = in_band(rng, count, 4.0, 12.0, rng.uniform(0, tremor))
    return shaking + in_band(rng, count, 0.1, 1.0, rng.uniform(0, drift))


def _pushed_path(before: Array, after: Array, slowed: float, turned: float) -> Array:
    """Start, run into something at full speed, and go on slower and turned until stopping."""
    start = np.clip(before / 0.4, 0.0, 1.0)
    speed_before = np.where((before >= 0) & (before < 1), start**2 * (3 - 2 * start), 0.0)
    stop = np.clip((1 - after) / 0.4, 0.0, 1.0)
    moving = (after >= 0) & (after <= 1)
    speed_after = np.where(moving, slowed * stop**2 * (3 - 2 * stop), 0.0)
    velocity = speed_before[:, None] * np.array([0.0, 1.0, 0.0])
    velocity = velocity + speed_after[:, None] * np.array([np.sin(turned), np.cos(turned), 0.0])
    return np.cumsum(velocity, axis=0) / RATE_HZ


def _slow_instants(edges: Array, durations: Array, skews: Array) -> Array:
    """Where the speed of Setup 1's movements passes 5 % of its peak, at the four switches."""
    part = np.linspace(0.0, 1.0, 20_001)
    instants = []
    for move, skew in enumerate(skews):
        speed = np.gradient(minimum_jerk(part**skew), part)
        fast = part[speed > _SLOW * speed.max()][[0, -1]]
        instants.extend(edges[2 * move] + durations[2 * move] * fast)
    return np.array(instants[1:-1])


def _contact_force(seed: int, time: Array, position: Array, meets) -> Array:
    """Force on the tool that meets something at each (time, direction of the force) and stays.

    Contact within 30 ms with an overshoot, slow variation by the hand, friction against the
    movement while something is touched, handling forces and white sensor noise.
    """
    rng = np.random.default_rng([seed, 1])
    force = np.zeros((len(time), 3))
    for instant, direction in meets:
        since = time - instant
        pressed = np.clip(since / 0.03, 0.0, 1.0)
        overshoot = 0.3 * np.exp(-np.clip(since - 0.03, 0.0, None) / 0.06) * (since > 0.03)
        hand = 1.0 + in_band(rng, len(time), 0.1, 1.0, 0.06)[:, :1] * pressed[:, None]
        strength = rng.uniform(3.0, 10.0)
        force += strength * (pressed * (1.0 + overshoot))[:, None] * hand * direction
    velocity = np.gradient(_smoothed(position), time, axis=0)
    speed = np.linalg.norm(velocity, axis=1, keepdims=True)
    sliding = velocity / np.maximum(speed, 0.1)
    force -= 0.2 * np.linalg.norm(force, axis=1, keepdims=True) * sliding
    force += in_band(rng, len(time), 0.5, 6.0, 0.1) * np.minimum(speed / 0.1, 1.0)
    return force + rng.normal(size=force.shape) * 0.15


def _smoothed(values: Array) -> Array:
    width = round(0.1 * RATE_HZ)
    kernel = np.ones(width) / width
    padded = np.pad(values, ((width, width), (0, 0)), mode="edge")
    same = np.column_stack([np.convolve(column, kernel, mode="same") for column in padded.T])
    return same[width:-width]


def bundled_setup1() -> Demonstration:
    """The demonstration of data/synthetic_setup1.npz: Setup 1 with both contacts held.

    On the way forward the tool is bumped for a moment, which is no contact change.
    """
    rng = np.random.default_rng(2013)
    durations = np.array([1.56, 1.24, 1.40, 1.29, 1.48, 0.70])
    edges = np.concatenate([[0.0], np.cumsum(durations)])
    time = _times(edges[-1])
    start = np.array([0.36, -0.12, 0.24])
    moves = [(0, [0.171, 0, 0], 1.0), (2, [0, 0, -0.105], 0.9), (4, [0, 0.054, 0], 0.85)]
    position = np.tile(start, (len(time), 1))
    for phase, travel, cut in moves:
        part = np.clip((time - edges[phase]) / durations[phase], 0.0, 1.0)
        reached = minimum_jerk(part * cut) / minimum_jerk(cut)
        position += reached[:, None] * np.array(travel)
        position += _bulge(rng, part, float(np.linalg.norm(travel)), np.array(travel))
    position += _tremor_and_drift(rng, len(time), 2e-4, 4e-4)
    position += rng.normal(size=position.shape) * 5e-5
    meets = [(edges[3], np.array([0.0, 0.0, 1.0])), (edges[5], np.array([0.0, -1.0, 0.0]))]
    force = _contact_force(2013, time, position, meets)
    bump = 2.5 * np.exp(-0.5 * ((time - 0.78) / 0.025) ** 2)
    force += bump[:, None] * np.array([-0.8, 0.5, 0.33])
    wobble = in_band(rng, len(time), 0.1, 2.0, 4e-3)
    pointing_down = Rotation.from_euler("x", np.pi)
    orientation = Rotation.from_rotvec(wobble) * pointing_down
    lever = np.array([0.0, 0.0, -0.04])
    torque = np.cross(lever, force) + rng.normal(size=force.shape) * 4e-3
    return Demonstration(
        "synthetic_setup1",
        time,
        position,
        orientation.as_quat(scalar_first=True),
        force,
        torque,
        metadata={
            "description": "synthetic Setup 1: forward, idle, down until contact, idle, "
            "sideways until contact, hold",
            "generator": "tests/synthetic.py, seed 2013",
            "switches_s": edges[1:-1].round(3).tolist(),
        },
    )


def write_bundled(path: Path = BUNDLED) -> None:
    """Write the bundled demonstration in keyphase's native form."""
    made = bundled_setup1()
    np.savez_compressed(
        path,
        time_s=made.time_s,
        position_m=made.position_m.round(7),
        orientation_wxyz=made.orientation_wxyz,
        force_N=made.force_N.round(5),
        torque_Nm=made.torque_Nm.round(6),
        metadata_json=np.array(json.dumps(dict(made.metadata))),
    )


if __name__ == "__main__":
    write_bundled()
    print(f"wrote {BUNDLED}")
