"""The tool's path without its noise: strokes, rests and rounds, one after the other, and when
motion began, ended or turned.
"""

from dataclasses import dataclass, field
from itertools import pairwise
from typing import Literal

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.making.draws import Array
from keyphase.making.strokes import MIN_SAMPLES

TURN_M_PER_RAD = 0.2
"""What a turn counts for beside a way [m/rad], as in the segmentation."""

MOVES_FROM = 0.05
"""Share of a stroke's largest speed from which the tool counts as moving."""

REST_S = 0.5
"""Where the tool stands for at least this long it rests: motion ended and began again. Where it
stands for less, that is one event, in its middle."""

SMALL = 0.1
"""A stroke whose largest speed is below this share of the fast ones' is small: nobody would cut at
it for certain, nor call a cut wrong."""

MotionLabel = Literal["motion began", "motion ended", "motion turned"]


@dataclass(frozen=True)
class MotionEvent:
    """When motion began, ended or turned, how long the tool stood there [s], and whether nobody
    could judge it, because a stroke beside it is small or flows out of the other."""

    time_s: float
    label: MotionLabel
    standing_s: float = 0.0
    unclear: bool = False


@dataclass(frozen=True)
class Stretch:
    """Samples first to last (not included) in which the tool moves or rests; a stroke that `flows`
    began before the one before it had ended."""

    moves: bool
    first: int
    last: int
    flows: bool = False


@dataclass
class Path:
    """The path while it is put together: positions [m], turns as rotations, and its stretches."""

    rate_hz: float
    positions: list[Array] = field(default_factory=list)
    rotations: list[Rotation] = field(default_factory=list)
    stretches: list[Stretch] = field(default_factory=list)
    at_m: Array = field(default_factory=lambda: np.zeros(3))
    pose: Rotation = field(default_factory=Rotation.identity)
    count: int = 0

    @property
    def now_s(self) -> float:
        """Time at the end of what there is."""
        return self.count / self.rate_hz

    def samples(self, seconds: float) -> int:
        """How many samples this long a stroke has."""
        return max(MIN_SAMPLES, round(seconds * self.rate_hz))

    def move(
        self, along: Array, offset: Array, turn: Array, aside: Array, overlap: float = 0.0
    ) -> None:
        """A stroke by `offset` [m] and `turn` (rotation vector) with progress `along` (n,), off the
        straight way by `aside` (n, 3); see `follow` for `overlap`."""
        way = along[:, None]
        self.follow(way * offset + aside, way * turn, overlap)

    def follow(self, way: Array, turn: Array, overlap: float = 0.0) -> None:
        """Move along `way` (n, 3) [m] and `turn` (n, 3) relative to here, as one stroke.

        With an `overlap` it begins before the stroke before it has ended, by this share of the
        shorter one: the two are added, as a hand does that does not stop in between.
        """
        before = self.stretches[-1] if self.stretches else None
        shared = 0
        if before is not None and before.moves and overlap > 0.0:
            shared = int(
                overlap * min(len(way), before.last - before.first, len(self.positions[-1]))
            )
        turned = Rotation.from_rotvec(turn)
        if shared and before is not None:
            self.positions[-1][-shared:] += way[:shared]
            last = self.rotations[-1]
            self.rotations[-1] = Rotation.concatenate(
                [last[:-shared], last[-shared:] * turned[:shared]]
            )
            middle = self.count - shared // 2
            self.stretches[-1] = Stretch(True, before.first, middle, before.flows)
        position = self.at_m + way[shared:]
        self._add(True, position, self.pose * turned[shared:], shared - shared // 2)
        self.at_m = self.at_m + way[-1]
        self.pose = self.pose * Rotation.from_rotvec(turn[-1])

    def rest(self, seconds: float) -> None:
        """Stand still."""
        count = max(1, round(seconds * self.rate_hz))
        still = np.repeat(self.at_m[None], count, axis=0)
        self._add(False, still, self.pose * Rotation.from_rotvec(np.zeros((count, 3))))

    def _add(self, moves: bool, position: Array, rotation: Rotation, earlier: int = 0) -> None:
        self.positions.append(position)
        self.rotations.append(rotation)
        first, last = self.count - earlier, self.count + len(position)
        before = self.stretches[-1] if self.stretches else None
        if before and not moves and not before.moves:
            self.stretches[-1] = Stretch(False, before.first, last)
        else:
            self.stretches.append(Stretch(moves, first, last, earlier > 0))
        self.count = last

    def poses(self) -> tuple[Array, Rotation]:
        """All positions (N, 3) [m] and rotations (N)."""
        return np.concatenate(self.positions), Rotation.concatenate(self.rotations)


def speed(position: Array, rotation: Rotation, rate_hz: float) -> Array:
    """Speed (N,) [m/s] of a path, turning counted by `TURN_M_PER_RAD`."""
    step = np.diff(position, axis=0)
    turned = TURN_M_PER_RAD * (rotation[:-1].inv() * rotation[1:]).as_rotvec()
    return np.concatenate([[0.0], np.sqrt((step**2).sum(1) + (turned**2).sum(1))]) * rate_hz


def motion_events(stretches: list[Stretch], speed_m_s: Array, rate_hz: float) -> list[MotionEvent]:
    """When motion began, ended or turned: where a stroke passes `MOVES_FROM` of its largest speed.

    Between two strokes for less than `REST_S` of which the tool is slower than that, motion
    turned, in the middle.
    """
    strokes = [_stroke(each, speed_m_s) for each in stretches if each.moves]
    if not strokes:
        return []
    fast = np.quantile([stroke.fastest_m_s for stroke in strokes], 0.9)
    small = [stroke.fastest_m_s < SMALL * fast for stroke in strokes]
    events: list[MotionEvent] = []
    if not stretches[0].moves:
        events.append(MotionEvent(strokes[0].began / rate_hz, "motion began", unclear=small[0]))
    for index, (before, after) in enumerate(pairwise(strokes)):
        ended, began = before.ended / rate_hz, after.began / rate_hz
        tiny, next_tiny = small[index], small[index + 1]
        if after.flows:
            events.append(MotionEvent(after.first / rate_hz, "motion turned", unclear=True))
        elif began - ended >= REST_S:
            events.append(MotionEvent(ended, "motion ended", unclear=tiny))
            events.append(MotionEvent(began, "motion began", unclear=next_tiny))
        else:
            middle = 0.5 * (ended + began)
            either = tiny or next_tiny
            events.append(MotionEvent(middle, "motion turned", began - ended, either))
    if not stretches[-1].moves:
        events.append(MotionEvent(strokes[-1].ended / rate_hz, "motion ended", unclear=small[-1]))
    return events


@dataclass(frozen=True)
class _Stroke:
    """Samples at which it begins and ends, and its largest speed."""

    first: int
    flows: bool
    began: int
    ended: int
    fastest_m_s: float


def _stroke(stretch: Stretch, speed_m_s: Array) -> _Stroke:
    part = speed_m_s[stretch.first : stretch.last]
    moving = np.flatnonzero(part >= MOVES_FROM * part.max())
    began, ended = stretch.first + int(moving[0]), stretch.first + int(moving[-1])
    return _Stroke(stretch.first, stretch.flows, began, ended, float(part.max()))
