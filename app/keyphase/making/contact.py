"""What contact does to the tool: levels of a wrench that come as clicks or ramps, swing, ring and
rub, and when contact was made, lost or changed.
"""

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from keyphase.making.draws import Array, band_noise, chance, direction, log_uniform, low_noise

ContactLabel = Literal["contact made", "contact lost", "contact changed"]
Shape = Literal["smooth", "straight", "late"]
SHAPES: tuple[Shape, ...] = ("smooth", "straight", "late")

CLICK_S = 0.06
"""A rise shorter than this is a click: exponential, and it may ring."""


@dataclass(frozen=True)
class Ring:
    """An oscillation after an impact: amplitude (6,), frequency [Hz], time to die out [s]."""

    amplitude: Array
    frequency_hz: float
    fading_s: float


@dataclass(frozen=True)
class Change:
    """The wrench goes to `level` (6,) from `time_s` on, within `rise_s`; `label` None: no event."""

    time_s: float
    rise_s: float
    level: Array
    shape: Shape
    label: ContactLabel | None
    ring: Ring | None = None


@dataclass(frozen=True)
class Swing:
    """From sample `first` on the contact's force is multiplied by 1 + `factor` (n,)."""

    first: int
    factor: Array


@dataclass
class Contact:
    """All that touches the tool, while it is put together."""

    changes: list[Change] = field(default_factory=list)
    swings: list[Swing] = field(default_factory=list)

    @property
    def level(self) -> Array:
        """The wrench (6,) it has come to [N, N m]."""
        return self.changes[-1].level if self.changes else np.zeros(6)

    @property
    def settled_s(self) -> float:
        """When the last change is over."""
        return self.changes[-1].time_s + self.changes[-1].rise_s if self.changes else 0.0


def wrench(rng: np.random.Generator, newton: float, along: Array | None = None) -> Array:
    """A wrench (6,) of this force, at a lever of 2 to 12 cm, along a direction or any."""
    force = newton * (direction(rng) if along is None else along)
    lever = rng.uniform(0.02, 0.12) * direction(rng)
    return np.concatenate([force, np.cross(lever, force)])


def levels(contact: Contact, time_s: Array) -> Array:
    """The contact's wrench (N, 6) over time, with swings, without rings and rubbing."""
    out = np.zeros((len(time_s), 6))
    value = np.zeros(6)
    ends = [change.time_s for change in contact.changes[1:]] + [np.inf] * bool(contact.changes)
    for change, end in zip(contact.changes, ends, strict=True):
        first, last = np.searchsorted(time_s, [change.time_s, end])
        out[first:last] = value + _shape(change, time_s[first:last])[:, None] * (
            change.level - value
        )
        if last > first:
            value = out[last - 1]
    for swing in contact.swings:
        last = min(swing.first + len(swing.factor), len(out))
        out[swing.first : last] *= 1.0 + swing.factor[: last - swing.first, None]
    return out


def rings(contact: Contact, time_s: Array) -> Array:
    """What impacts ring (N, 6)."""
    out = np.zeros((len(time_s), 6))
    for change in contact.changes:
        if change.ring:
            since = np.maximum(time_s - change.time_s, 0.0)
            fading = np.exp(-since / change.ring.fading_s)
            wave = fading * np.sin(2.0 * np.pi * change.ring.frequency_hz * since)
            out += wave[:, None] * change.ring.amplitude
    return out


def settled(rng: np.random.Generator, contact: Contact, time_s: Array, share: float) -> Array:
    """What hand or controller add (N, 6) in the second after they have touched, in a `share` of
    contacts: the force overshoots, gives way and comes back before it has its level. It is part of
    the same change.
    """
    out = np.zeros((len(time_s), 6))
    before = np.zeros(6)
    rate_hz = 1.0 / (time_s[1] - time_s[0])
    for change in contact.changes:
        step, before = float(np.linalg.norm((change.level - before)[:3])), change.level
        if change.label in (None, "contact lost") or not chance(rng, share):
            continue
        first = int(np.searchsorted(time_s, change.time_s))
        since = time_s[first:] - change.time_s
        envelope = -np.expm1(-since / 0.05) * np.exp(-since / log_uniform(rng, 0.2, 0.8))
        high_hz, size = log_uniform(rng, 1.5, 5.0), step * log_uniform(rng, 0.2, 1.0)
        force = size * envelope[:, None] * low_noise(rng, len(since), rate_hz, high_hz, 1.0)
        lever = rng.uniform(0.02, 0.12) * direction(rng)
        out[first:] += np.hstack([force, np.cross(lever, force)])
    return out


def rubbing(rng: np.random.Generator, level: Array, velocity_m_s: Array, rate_hz: float) -> Array:
    """What hand and friction add (N, 6) while something is touched: all grows with the force.

    Coulomb friction against the motion, a hand that presses unevenly, and the rattle of sliding.
    """
    pressed = np.linalg.norm(level[:, :3], axis=1, keepdims=True)
    speed = np.linalg.norm(velocity_m_s, axis=1, keepdims=True)
    fast = np.quantile(speed, 0.9) + 1e-6
    count = len(level)
    friction = -rng.uniform(0.0, 0.5) * velocity_m_s / (speed + 0.05 * fast)
    uneven = low_noise(rng, count, rate_hz, log_uniform(rng, 0.3, 1.5), log_uniform(rng, 0.01, 0.1))
    rattle = band_noise(rng, count, rate_hz, (3.0, 25.0), log_uniform(rng, 0.003, 0.06))
    force = pressed * (friction + uneven + rattle * (0.3 + np.clip(speed / fast, 0.0, 1.5)))
    lever = rng.uniform(0.02, 0.12) * direction(rng)
    return np.asarray(np.hstack([force, np.cross(lever, force)]), dtype=np.float64)


def _shape(change: Change, time_s: Array) -> Array:
    part = (time_s - change.time_s) / change.rise_s
    if change.rise_s < CLICK_S:
        return 1.0 - np.exp(-3.0 * part)
    part = np.clip(part, 0.0, 1.0)
    if change.shape == "smooth":
        return part**2 * (3.0 - 2.0 * part)
    if change.shape == "straight":
        return part
    return part**1.6 if np.any(change.level) else 1.0 - (1.0 - part) ** 1.6
