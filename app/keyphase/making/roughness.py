"""What rough hands and surfaces add to a contact force: they press on, waver, rattle and bump.

Weights are fitted on recordings made with it beside those without: on strangers' recordings a
force stays less where contact has put it than a formula's does.
"""

import numpy as np

from keyphase.making.draws import (
    Array,
    band_noise,
    chance,
    direction,
    log_uniform,
    low_noise,
)

MOST_WHILE_FREE = 0.2
"""Of the smallest step of force that is an event: what a guiding hand adds where nothing is
touched stays below."""


def roughness(
    rng: np.random.Generator, level: Array, velocity_m_s: Array, rate_hz: float, newton: float
) -> Array:
    """More force (N, 6) beside the contact's `level` (N, 6); `newton` is its smallest event."""
    count = len(level)
    pressed = np.linalg.norm(level[:, :3], axis=1, keepdims=True)
    speed = np.linalg.norm(velocity_m_s, axis=1, keepdims=True)
    moving = 0.3 + np.clip(speed / (np.quantile(speed, 0.9) + 1e-6), 0.0, 1.5)
    slowly, much = log_uniform(rng, 0.2, 2.0), log_uniform(rng, 0.03, 0.3)
    wavering = low_noise(rng, count, rate_hz, slowly, much)
    rattle = band_noise(rng, count, rate_hz, (3.0, 25.0), log_uniform(rng, 0.003, 0.1))
    force = pressed * (wavering + rattle * moving)
    largest = float(np.quantile(pressed, 0.95)) or newton
    if chance(rng, 0.6):
        guiding = min(largest * log_uniform(rng, 0.01, 0.15), MOST_WHILE_FREE * newton)
        force += moving * low_noise(rng, count, rate_hz, log_uniform(rng, 0.2, 3.0), guiding)
    force += _bumps(rng, count, rate_hz, largest)
    lever = rng.uniform(0.02, 0.12) * direction(rng)
    return np.asarray(np.hstack([force, np.cross(lever, force)]), dtype=np.float64)


def _bumps(rng: np.random.Generator, count: int, rate_hz: float, largest: float) -> Array:
    """Knocks that pass within a few tenths of a second (N, 3)."""
    time_s = np.arange(count) / rate_hz
    out = np.zeros((count, 3))
    for _ in range(rng.poisson(min(0.06 * time_s[-1], 6.0))):
        at_s, width_s = rng.uniform(0.0, time_s[-1]), log_uniform(rng, 0.02, 0.15)
        knock = np.exp(-0.5 * ((time_s - at_s) / width_s) ** 2)
        out += knock[:, None] * direction(rng) * largest * log_uniform(rng, 0.03, 0.4)
    return out
