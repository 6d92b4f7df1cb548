"""While a skill runs that squares a part: the strokes, which end where a side is felt."""

from collections.abc import Generator, Iterator
from math import copysign, cos, inf, pi

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.changed import changed
from keyphase.skills.coupling import Reference
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.skill import Skill

FLATTENING = 0.03
"""Part of the stiffness in rotation that is left while the part is pressed: it is to lie flat, as
one that stands on an edge turns what it then carries along."""

HELD = 1.0
"""Part of the stiffness aside that is left meanwhile: the strokes put the part where it belongs,
and what lies at a slant would lead one off that gives way."""

_ROUNDING_S = 1e-9


class Squared:
    """Of one skill that has a squaring; has the face of `Seeking`."""

    turning, giving = FLATTENING, HELD

    def __init__(self, skill: Skill, sensed: Sensed, step_s: float) -> None:
        assert skill.squaring is not None
        assert skill.press is not None
        self.search, self.press, self.searched = skill.squaring, skill.press, False
        self._step_s, self._there_m, self._done = step_s, skill.end_position_m, False
        self._force_N = self._felt_N = self._free_N = sensed.force_N
        self._path: Iterator[Array] = iter(())
        self._then_m = self._position_m = sensed.position_m

    def watch(self, sensed: Sensed, _lasts: bool) -> None:
        """Take in what was sensed at the end of a tick."""
        self._force_N, self._position_m = sensed.force_N, sensed.position_m
        self._felt_N = self._felt_N + self.search.smoothed * (sensed.force_N - self._felt_N)

    def is_in(self, _sensed: Sensed) -> bool:
        """Whether all strokes are done."""
        return self._done

    def presses_on(self) -> bool:
        """Never: it is pressed for as long as it is, wherever it stands."""
        return False

    def again(self, sensed: Sensed, shift_m: Array) -> None:
        """The strokes begin where the tool is, and go around where the demonstration was.

        That is moved by the skill's shift (3,). A part met higher is met aside of there, too.
        """
        aside_m = self._there_m + shift_m - sensed.position_m
        self._path = self._places(sensed.position_m, aside_m)
        self._then_m = next(self._path)

    def moving(self, reference: Reference, _sensed: Sensed, _time_s: float) -> Reference:
        """The reference on its strokes, for one tick."""
        now_m, then_m = self._then_m, next(self._path, None)
        self._done = then_m is None
        self._then_m = now_m if then_m is None else then_m
        velocity = np.concatenate([(self._then_m - now_m) / self._step_s, np.zeros(3)])
        return changed(reference, position_m=now_m, velocity=velocity)

    def _places(self, begin_m: Array, aside_m: Array) -> Iterator[Array]:
        """Where (3,) the tool is to be, tick by tick, around a place that lies `aside_m` of it."""
        lift_m = -self.search.lift_m * np.array(self.search.normal)
        yield from self._eased(begin_m, lift_m)
        at = begin_m + lift_m
        yield from self._standing(at)
        for way, count in self.search.axes():
            end = yield from self._strokes(at, way, count, float(aside_m.dot(way)))
            at = at + end * way
        yield from self._eased(at, -lift_m)

    def _eased(self, begin_m: Array, move_m: Array) -> Iterator[Array]:
        """At rest where it begins and ends."""
        ticks = round(self.search.lift_s / self._step_s)
        for tick in range(ticks):
            yield begin_m + 0.5 * (1.0 - cos(pi * tick / ticks)) * move_m

    def _standing(self, at: Array) -> Iterator[Array]:
        """While nothing is touched: what is felt then is no side."""
        ticks, sum_N = round(self.search.still_s / self._step_s), np.zeros(3)
        for _ in range(ticks):
            yield at
            sum_N = sum_N + self._force_N
        self._free_N = sum_N / ticks

    def _strokes(
        self, at: Array, way: Array, count: int, middle: float
    ) -> Generator[Array, None, float]:
        """The strokes along one axis, from `at` (3,); returns how far along it the last one ends.

        They go around what is `middle` along it.
        """
        squaring, ends, sides, side = self.search, [0.0], list[float](), None
        for stroke in range(count - 1):
            reach = squaring.reach_m * (-1.0) ** stroke
            goal = ends[-1] + 2.0 * reach if stroke else middle + reach
            flushes = stroke >= count - 1 - squaring.flushing
            lasts_s = squaring.flush_s if flushes else squaring.felt_s
            end, side = yield from self._stroke(at, way, (ends[-1], goal), lasts_s)
            ends.append(end)
            if side is not None:
                sides.append(float((self._position_m - at).dot(way)))
        back = middle
        if side is not None and len(sides) >= squaring.sides:
            # What stands loosely went along with the tool from where its side was met.
            back = sides[-1] + 0.5 * (sides[-2] - side)
        end, _ = yield from self._stroke(at, way, (ends[-1], back), inf)
        return end

    def _stroke(
        self, at: Array, way: Array, ends: tuple[float, float], lasts_s: float
    ) -> Generator[Array, None, tuple[float, float | None]]:
        """One stroke; returns where it ended, and where it met the side that it felt, if one."""
        squaring, (place, goal) = self.search, ends
        sign = copysign(1.0, goal - place)
        time_s, resisted_s, met = 0.0, 0.0, place
        while sign * (goal - place) > 0.0:
            time_s += self._step_s
            speed = squaring.speed_m_s * min(1.0, time_s / squaring.ramp_s)
            place += sign * speed * self._step_s
            yield at + place * way
            resists_N = -sign * float((self._felt_N - self._free_N).dot(way))
            resisted_s = resisted_s + self._step_s if resists_N > squaring.felt_N else 0.0
            if not resisted_s:
                met = float((self._position_m - at).dot(way))
            if abs(resists_N) <= squaring.felt_N:
                drifted_N = squaring.forgets * (self._force_N - self._free_N)
                self._free_N = self._free_N + drifted_N
            is_firm = resists_N > squaring.press_N
            if time_s > squaring.ramp_s and (is_firm or resisted_s >= lasts_s - _ROUNDING_S):
                return place, met
        return place, None
