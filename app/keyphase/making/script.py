"""What happens in one demonstration, written by a family in a few verbs: stroke, rest, approach,
touch, rub along, leave. The script keeps path and contact in step.
"""

import numpy as np

from keyphase.making.contact import (
    CLICK_S,
    SHAPES,
    Change,
    Contact,
    ContactLabel,
    Ring,
    Swing,
    wrench,
)
from keyphase.making.draws import Array, beside, chance, direction, log_uniform, low_noise
from keyphase.making.hand import Hand
from keyphase.making.path import Path
from keyphase.making.strokes import progress, progress_into_contact

APART_S = 0.3
"""Least time between two contact changes: nearer ones are one."""


class Script:
    """Path and contact of one demonstration, growing from its beginning to its end."""

    def __init__(self, rng: np.random.Generator, hand: Hand, rate_hz: float) -> None:
        self.rng, self.hand = rng, hand
        self.path = Path(rate_hz)
        self.contact = Contact()
        self.reversals_s: list[float] = []
        self.facing = direction(rng)
        self.flowing = float(rng.choice([0.0, 0.0, 0.4, 0.9]))

    @property
    def now_s(self) -> float:
        """Time at the end of what there is."""
        return self.path.now_s

    def stroke(
        self,
        way: Array | None = None,
        turn: Array | None = None,
        seconds: float | None = None,
        hesitation: float = 0.2,
    ) -> None:
        """Move by `way` [m], turn by `turn` (rotation vector); what is not given is drawn."""
        way = self.way() if way is None else way
        turn = self.turn() if turn is None else turn
        count = self.path.samples(self.seconds_for(way) if seconds is None else seconds)
        self.path.move(
            progress(self.rng, count, hesitation),
            way,
            turn,
            self._aside(way, count),
            self._overlap(),
        )

    def begin(self) -> None:
        """Most begin with a rest."""
        if chance(self.rng, 0.75):
            self.rest(0.4)

    def end(self) -> None:
        """Go elsewhere; most end with a rest."""
        self.stroke()
        if chance(self.rng, 0.75):
            self.rest(0.4)

    def strokes(self, least: int, most: int, resting: float = 0.4) -> None:
        """Some free strokes; after this share of them the hand rests."""
        for _ in range(self.rng.integers(least, most + 1)):
            self.stroke()
            if chance(self.rng, resting):
                self.rest()

    def rest(self, low_s: float = 0.2, high_s: float = 3.0) -> None:
        """Stand still, seldom for a minute or more."""
        if chance(self.rng, 0.003):
            self.path.rest(log_uniform(self.rng, 20.0, 120.0))
            return
        usual = log_uniform(self.rng, 0.4, 2.5) * self.hand.patience_s
        self.path.rest(float(np.clip(usual, low_s, high_s)))

    def wait_until(self, time_s: float) -> None:
        """Stand still until then, if it is not past."""
        if time_s > self.now_s:
            self.path.rest(time_s - self.now_s)

    def way(self, share: float | None = None, along: Array | None = None) -> Array:
        """A way (3,) [m], as long as this share of the hand's usual stroke."""
        share = log_uniform(self.rng, 0.3, 1.6) if share is None else share
        return self.hand.stroke_m * share * (direction(self.rng) if along is None else along)

    def turn(self, share: float = 1.0) -> Array:
        """A rotation vector (3,), at most this share of the hand's usual turn."""
        return direction(self.rng) * self.rng.uniform(0.0, 1.0) * self.hand.turn_rad * share

    def seconds_for(self, way: Array) -> float:
        """How long this hand takes for a way [s]: longer ones take longer, but are faster."""
        share = float(np.linalg.norm(way)) / self.hand.stroke_m
        return max(0.25, self.hand.tempo * self.rng.uniform(0.6, 1.6) * float(np.sqrt(share + 0.1)))

    def approach(self, share: float = 0.25, facing: Array | None = None) -> float:
        """Move until something is met; returns when that is [s]. Then `facing` points into it."""
        self.facing = direction(self.rng) if facing is None else facing
        way = self.way(share * log_uniform(self.rng, 0.6, 1.6), self.facing)
        count = self.path.samples(self.seconds_for(way))
        along, part = progress_into_contact(self.rng, count)
        begun_s = self.now_s
        self.path.move(along, way, self.turn(0.3), self._aside(way, count) * 0.2)
        return begun_s + part * (self.now_s - begun_s)

    def touch(
        self,
        at_s: float,
        level: Array,
        rise_s: float,
        label: ContactLabel | None = "contact made",
        ringing: float = 0.3,
    ) -> None:
        """From `at_s` on the contact's wrench goes to `level`; clicks may ring."""
        last_s = self.contact.changes[-1].time_s if self.contact.changes else -np.inf
        at_s = max(at_s, last_s + APART_S)
        ring = None
        if rise_s < CLICK_S and label != "contact lost" and chance(self.rng, ringing):
            size = self.rng.uniform(0.2, 1.0) * (level - self.contact.level)
            fading_s = log_uniform(self.rng, 0.04, 0.8)
            ring = Ring(size, log_uniform(self.rng, 1.5, 30.0), fading_s)
        shape = SHAPES[self.rng.integers(len(SHAPES))]
        self.contact.changes.append(Change(at_s, rise_s, level, shape, label, ring))

    def press(self, newton: float) -> Array:
        """The wrench (6,) of pressing on what the tool faces."""
        return wrench(self.rng, newton, -self.facing)

    def newton(self, low: float = 0.5, high: float = 1.5) -> float:
        """A force [N] around the hand's usual one."""
        return self.hand.newton * log_uniform(self.rng, low, high)

    def leave(self, fall_s: float, share: float = 0.5) -> None:
        """Let go while still or as the tool draws back, then be clear of it."""
        begun_s = max(self.now_s, self.contact.settled_s + APART_S)
        self.wait_until(begun_s)
        self.touch(begun_s, np.zeros(6), fall_s, "contact lost")
        if fall_s > 0.3:
            self.wait_until(begun_s + fall_s * self.rng.uniform(0.4, 1.0))
        self.stroke(self.way(share, -self.facing + 0.2 * direction(self.rng)))
        self.wait_until(self.contact.settled_s + 0.1)

    def rounds(self, seconds: float, flatness: float, drift_m: float) -> None:
        """Go round on what the tool faces, or to and fro where `flatness` is 0, and drift along."""
        count = self.path.samples(seconds)
        along = beside(self.rng, self.facing)
        across = np.cross(self.facing, along)
        phase = self._phase(count)
        reach = self.hand.stroke_m * log_uniform(self.rng, 0.05, 0.4)
        edge = np.minimum(np.arange(count), np.arange(count)[::-1]) / self.path.rate_hz
        grown = reach * np.clip(edge / 0.4, 0.0, 1.0)
        way = (
            np.outer(grown * np.sin(phase), across)
            + np.linspace(0, drift_m, count)[:, None] * along
        )
        way = way + np.outer(flatness * grown * (np.cos(phase) - 1.0), along)
        self._swing(phase)
        self._remember_reversals(phase, flatness)
        self.path.follow(way, np.outer(0.1 * np.sin(phase), along), self._overlap())

    def swing(self, seconds_from: float, strength: float) -> None:
        """The force wavers from then to now, irregularly."""
        first = round(seconds_from * self.path.rate_hz)
        count = max(self.path.count - first, 1)
        edge = np.minimum(np.arange(count), np.arange(count)[::-1]) / self.path.rate_hz
        noise = low_noise(self.rng, count, self.path.rate_hz, log_uniform(self.rng, 0.5, 3.0), 1.0)
        factor = strength * np.clip(noise[:, 0], -2.0, 2.0) * np.clip(edge / 0.2, 0.0, 1.0)
        self.contact.swings.append(Swing(first, np.maximum(factor, -0.8)))

    def _phase(self, count: int) -> Array:
        frequency = log_uniform(self.rng, 0.3, 1.6)
        wander = low_noise(self.rng, count, self.path.rate_hz, 0.3, 0.1)[:, 0]
        pace = np.clip(frequency * (1.0 + wander), 0.1, 4.0)
        return 2.0 * np.pi * np.cumsum(pace) / self.path.rate_hz

    def _swing(self, phase: Array) -> None:
        if not self.contact.changes:
            return
        rng = self.rng
        strength, slow = rng.uniform(0.05, 0.6), rng.uniform(0.0, 0.25)
        wave = strength * np.sin(rng.choice([1, 2]) * phase + rng.uniform(0.0, 6.0))
        factor = np.maximum(wave + slow * np.sin(0.37 * phase), -0.8)
        edge = np.minimum(np.arange(len(phase)), np.arange(len(phase))[::-1])
        factor = factor * np.clip(edge / self.path.rate_hz / 0.3, 0.0, 1.0)
        self.contact.swings.append(Swing(self.path.count, factor))

    def _remember_reversals(self, phase: Array, flatness: float) -> None:
        """Where a line turns back: conventions differ on whether that is a boundary."""
        if flatness < 0.5:
            turns = np.flatnonzero(np.diff(np.floor(phase / np.pi + 0.5)) > 0)
            self.reversals_s += [float(t) for t in (self.path.count + turns) / self.path.rate_hz]

    def _overlap(self) -> float:
        """How far the next stroke reaches into the one before it, where nothing rests between."""
        return self.rng.uniform(0.15, 0.5) if chance(self.rng, self.flowing) else 0.0

    def _aside(self, way: Array, count: int) -> Array:
        """Off the straight way, as through via points: a smooth curve (count, 3) [m]."""
        part = np.linspace(0.0, 1.0, count)[:, None]
        length = float(np.linalg.norm(way))
        if length == 0.0:
            return np.zeros((count, 3))
        curve = np.zeros((count, 3))
        for bends, share in enumerate(self._bends(), start=1):
            curve += np.sin(bends * np.pi * part) * length * share * beside(self.rng, way / length)
        return curve

    def _bends(self) -> Array:
        return self.rng.normal(0.0, [0.12, 0.04])
