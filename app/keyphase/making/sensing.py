"""What sensors make of pose and contact force: weight, inertia, noise, drift, filters, saturation;
and what an estimate from joint currents makes of them: it wanders.
"""

from dataclasses import dataclass

import numpy as np
from scipy.signal import butter, lfilter, sosfilt, sosfiltfilt
from scipy.spatial.transform import Rotation

from keyphase.making.draws import Array, chance, direction, log_uniform, low_noise

GRAVITY = np.array([0.0, 0.0, -9.81])
_PER_TORQUE = 0.05


@dataclass(frozen=True)
class Moving:
    """How the tool moved: positions (N, 3) [m], rotations (N), rate [Hz]."""

    position_m: Array
    rotation: Rotation
    rate_hz: float

    @property
    def velocity_m_s(self) -> Array:
        """(N, 3), smoothed as inertia feels it."""
        return np.gradient(self._smooth(self.position_m), 1.0 / self.rate_hz, axis=0)

    @property
    def acceleration_m_s2(self) -> Array:
        """(N, 3), below 15 Hz."""
        return np.gradient(self.velocity_m_s, 1.0 / self.rate_hz, axis=0)

    def _smooth(self, values: Array) -> Array:
        sos = butter(2, min(15.0, 0.4 * self.rate_hz), fs=self.rate_hz, output="sos")
        return np.asarray(sosfiltfilt(sos, values, axis=0))


def wrist_sensor(rng: np.random.Generator, contact: Array, moving: Moving, newton: float) -> Array:
    """What a force/torque sensor at the wrist measures (N, 6) of this contact wrench (N, 6).

    The tool's weight may be left in, constant or turning with the tool; its inertia shows; noise is
    coloured; the zero drifts; a filter may lag by up to 45 ms; what is beyond its range is cut off.
    `newton` is the smallest contact force that counts as an event: noise stays below a tenth of it.
    """
    out = contact.copy()
    out[:, :3] += _weight(rng, moving.rotation, newton)
    mass = float(rng.choice([0.0, 0.2, 1.0])) * rng.uniform(0.0, 1.0)
    out[:, :3] += min(mass, 0.05 * newton) * moving.acceleration_m_s2
    noise = min(log_uniform(rng, 0.005, 0.3), 0.1 * newton)
    out += _noise(rng, len(out), moving.rate_hz, noise)
    walk = min(log_uniform(rng, 1e-4, 2e-2), 0.02 * newton) / np.sqrt(moving.rate_hz)
    out[:, :3] += np.cumsum(rng.normal(0.0, walk, (len(out), 3)), axis=0)
    out += _handling(rng, len(out), moving.rate_hz, newton)
    return _read_out(rng, out, moving.rate_hz, np.abs(contact[:, :3]).max())


def estimated(rng: np.random.Generator, contact: Array, moving: Moving, newton: float) -> Array:
    """What an estimate from the joints' currents gives (N, 6): friction that is not modelled.

    Where nothing is touched it still moves with the arm: Coulomb friction against each direction
    of motion, errors of the model with the configuration, stiction that lets go in steps of
    milliseconds to half a second, and a slow wander. All of it stays below a quarter of `newton`.
    """
    size = min(log_uniform(rng, 0.2, 3.0), 0.25 * newton)
    count = len(contact)
    velocity = moving.velocity_m_s
    speed = np.linalg.norm(velocity, axis=1, keepdims=True)
    slow = 0.05 * np.quantile(speed, 0.95) + 1e-6
    wander = _stiction(rng, count, moving.rate_hz, size)
    wander += size * rng.uniform(0.0, 0.6) * velocity / (speed + slow)
    placed = moving.position_m - moving.position_m[0]
    mixing = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    wander += size * rng.uniform(0.0, 0.8) * placed @ mixing / (np.ptp(placed) + 0.01)
    lasting = low_noise(rng, count, moving.rate_hz, log_uniform(rng, 0.1, 1.0), 1.0)
    wander += size * rng.uniform(0.05, 0.3) * lasting + direction(rng) * rng.uniform(0.0, 2.0)
    out = contact + np.hstack([wander, _PER_TORQUE * wander[:, ::-1]])
    return out + _noise(rng, count, moving.rate_hz, min(log_uniform(rng, 0.005, 0.1), 0.1 * newton))


def _weight(rng: np.random.Generator, rotation: Rotation, newton: float) -> Array:
    """Weight left in: seen from the base it is constant, seen from the tool it turns with it."""
    weight = GRAVITY * rng.choice([0.0, 0.0, 0.05, 0.2, 1.0])
    constant = weight + (direction(rng) * rng.uniform(0.0, 15.0) if chance(rng, 0.3) else 0.0)
    turning = GRAVITY * rng.choice([0.0, 0.0, 0.0, 0.05, 0.2])
    turned = rotation.inv().apply(turning) - rotation[0].inv().apply(turning)
    reach = np.abs(turned).max()
    return constant + turned * min(1.0, 0.3 * newton / reach if reach else 1.0)


def _noise(rng: np.random.Generator, count: int, rate_hz: float, newton: float) -> Array:
    force = low_noise(rng, count, rate_hz, log_uniform(rng, 4.0, 200.0), newton)
    lever = log_uniform(rng, 0.01, 0.1)
    return np.hstack(
        [force, low_noise(rng, count, rate_hz, log_uniform(rng, 4.0, 200.0), lever * newton)]
    )


def _handling(rng: np.random.Generator, count: int, rate_hz: float, newton: float) -> Array:
    """Bumps that pass: the hand on the arm, a cable that tugs. None is a contact of the tool."""
    out = np.zeros((count, 6))
    time = np.arange(count) / rate_hz
    for _ in range(rng.poisson(0.6)):
        at_s, width_s = rng.uniform(0.0, time[-1]), log_uniform(rng, 0.02, 0.12)
        bump = newton * log_uniform(rng, 0.1, 0.6) * np.exp(-0.5 * ((time - at_s) / width_s) ** 2)
        out += bump[:, None] * np.concatenate([direction(rng), _PER_TORQUE * direction(rng)])
    return out


def _stiction(rng: np.random.Generator, count: int, rate_hz: float, size: float) -> Array:
    time = np.arange(count) / rate_hz
    steps = np.zeros((count, 3))
    for at_s in rng.uniform(0.0, time[-1], rng.poisson(time[-1] * log_uniform(rng, 0.05, 0.3))):
        risen = np.clip((time - at_s) / log_uniform(rng, 0.002, 0.5), 0.0, 1.0)
        steps += risen[:, None] * direction(rng) * size * log_uniform(rng, 0.2, 0.8)
    if chance(rng, 0.5):
        forgotten = 1.0 / (rng.uniform(2.0, 5.0) * rate_hz)
        return steps - lfilter([forgotten], [1.0, forgotten - 1.0], steps, axis=0)
    return 0.6 * steps


def _read_out(rng: np.random.Generator, wrench: Array, rate_hz: float, largest: float) -> Array:
    """Filters as sensors and authors apply them, then the range and the steps of the converter."""
    if chance(rng, 0.35):
        sos = butter(2, min(log_uniform(rng, 5.0, 80.0), 0.4 * rate_hz), fs=rate_hz, output="sos")
        wrench = np.asarray(sosfilt(sos, wrench - wrench[0], axis=0)) + wrench[0]
    elif chance(rng, 0.3):
        sos = butter(1, min(log_uniform(rng, 2.0, 20.0), 0.4 * rate_hz), fs=rate_hz, output="sos")
        wrench = np.asarray(sosfiltfilt(sos, wrench, axis=0))
    if chance(rng, 0.1):
        middle = np.median(wrench[:, :3], axis=0)
        limit = max(largest, 0.5) * rng.uniform(1.0, 1.3)
        wrench[:, :3] = middle + np.clip(wrench[:, :3] - middle, -limit, limit)
    if chance(rng, 0.2):
        step = log_uniform(rng, 0.005, 0.05)
        wrench = np.round(wrench / step) * step if chance(rng, 0.5) else wrench
    return wrench
