# MuJoCo tells no types.
# pyright: reportAttributeAccessIssue=false
"""The wrist force/torque sensor, modelled as a real one, and the load it has to forget.

A wrench is six numbers, force [N] before torque [N m].
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import SimulationError


@dataclass(frozen=True)
class SensorModel:
    """What distinguishes the reading from the truth.

    noise             standard deviation of the white noise, force and torque
    bias_walk         the slow bias, a random walk per square root of a second
    first_bias        standard deviation of the bias it starts with
    resolution        one step of the converter
    cutoff_hz         of the first-order low-pass before it
    """

    noise: tuple[float, float] = (0.1, 0.002)
    bias_walk: tuple[float, float] = (0.004, 0.0001)
    first_bias: tuple[float, float] = (0.5, 0.01)
    resolution: tuple[float, float] = (0.02, 0.0005)
    cutoff_hz: float = 70.0

    def worse(self, noise: float, drift: float) -> "SensorModel":
        """The same sensor with `noise` times the noise, its bias `drift` times as restless."""
        force, torque = self.noise
        force_walk, torque_walk = self.bias_walk
        return SensorModel(
            (noise * force, noise * torque),
            (drift * force_walk, drift * torque_walk),
            self.first_bias,
            self.resolution,
            self.cutoff_hz,
        )


class WristSensor:
    """Reads wrenches in its own frame, one per `step_s`, from a seeded generator."""

    def __init__(self, model: SensorModel, step_s: float, seed: int) -> None:
        self._random = np.random.default_rng(seed)
        self._noise = _six(model.noise)
        self._walk = _six(model.bias_walk) * np.sqrt(step_s)
        self._resolution = _six(model.resolution)
        self._gain = 1.0 - float(np.exp(-2.0 * np.pi * model.cutoff_hz * step_s))
        self._first_bias = _six(model.first_bias) * self._random.standard_normal(6)
        self._passed: Array | None = None
        self._offset = np.zeros(6)
        self._seed = seed
        self._errors = self._drawn_errors()

    def read(self, wrench: Array) -> Array:
        """One reading of the true `wrench` (6,)."""
        before = wrench if self._passed is None else self._passed
        passed = self._passed = before + self._gain * (wrench - before)
        return quantised(passed + self._offset + next(self._errors), self._resolution)

    def be_off_by(self, force_N: float) -> None:
        """Read `force_N` too much from now on, in a direction that the seed chooses."""
        drawn = np.random.default_rng([self._seed, _OFFSETS]).standard_normal(3)
        self._offset[:3] = force_N * drawn / np.linalg.norm(drawn)

    def settle(self) -> None:
        """Forget the low-pass filter's past, as after a jump of the simulation."""
        self._passed = None

    def _drawn_errors(self) -> Iterator[Array]:
        """Bias and noise together (6,) of one reading after the other.

        They are drawn many at once, which costs hardly more than drawing one.
        """
        bias = self._first_bias
        while True:
            drawn = self._random.standard_normal((_DRAWN_AT_ONCE, 2, 6))
            steps = self._walk * drawn[:, 0]
            steps[0] += bias
            biases = np.add.accumulate(steps)
            yield from biases + self._noise * drawn[:, 1]
            bias = biases[-1]


@dataclass(frozen=True, eq=False)
class Load:
    """What hangs on the sensor and its bias, as estimated from readings at rest.

    weight_N  of everything below the sensor; moment_Nm (3,) its centre times the weight, in the
    sensor's frame; bias (6,) reading without any load.
    """

    weight_N: float
    moment_Nm: Array
    bias: Array

    def compensated(self, reading: Array, rotation: Array) -> Array:
        """The wrench (6,) the environment exerts, sensor frame, about the sensor.

        reading   (6,) what the sensor says is exerted on the tool, load and bias included
        rotation  (3, 3) sensor to base frame
        """
        wrench = reading - self.bias
        wrench += self._hanging.dot(rotation[2])
        return wrench

    @cached_property
    def _hanging(self) -> Array:
        """(6, 3) from the direction that is up, in the sensor's frame, to weight and moment."""
        return np.concatenate((self.weight_N * np.eye(3), _skew(self.moment_Nm)))


def estimated_load(readings: Array, rotations: Array) -> Load:
    """Weight, centre and bias by least squares from readings at rest in several poses.

    readings   (P, 6) mean reading in each pose
    rotations  (P, 3, 3) sensor to base frame

    Solves f = w R^T d + b_f and t = m x R^T d + b_t, d pointing down, for w, m and b.
    Raises SimulationError if the poses do not tell weight from bias.
    """
    downs = np.einsum("pji,j->pi", rotations, _DOWN)
    poses = len(downs)
    forces = np.zeros((poses, 3, 4))
    forces[:, :, 0], forces[:, :, 1:] = downs, np.eye(3)
    torques = np.zeros((poses, 3, 6))
    torques[:, :, :3], torques[:, :, 3:] = [-_skew(down) for down in downs], np.eye(3)
    force_part, _, rank, _ = np.linalg.lstsq(forces.reshape(-1, 4), readings[:, :3].ravel())
    torque_part, _, torque_rank, _ = np.linalg.lstsq(
        torques.reshape(-1, 6), readings[:, 3:].ravel()
    )
    if rank < 4 or torque_rank < 6:
        raise SimulationError(
            f"The load on the wrist sensor must be read in at least three poses tilted against "
            f"each other, but the {poses} given do not tell it from the bias; tilt the wrist more."
        )
    bias = np.concatenate([force_part[1:], torque_part[3:]]).astype(np.float64)
    return Load(float(force_part[0]), torque_part[:3].astype(np.float64), bias)


def quantised(values: Array, resolution: Array) -> Array:
    """`values` rounded to whole steps of `resolution`."""
    return np.rint(values / resolution) * resolution


def about_tool(wrench: Array, rotation: Array, sensor_m: Array, tool_m: Array) -> Array:
    """A wrench in the sensor's frame and about it, turned into base frame and about the tool."""
    turned, moment = wrench.reshape(2, 3).dot(rotation.T), np.empty(3)
    mujoco.mju_cross(moment, sensor_m - tool_m, turned[0])
    turned[1] += moment
    return turned.ravel()


_DOWN = np.array([0.0, 0.0, -1.0])
_DRAWN_AT_ONCE = 256
_OFFSETS = 1
"""Offsets are drawn apart, so that a sensor without one reads what it always did."""


def _six(pair: tuple[float, float]) -> Array:
    return np.repeat(np.array(pair), 3)


def _skew(v: Array) -> Array:
    x, y, z = v
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
