"""The tool's path without its noise: strokes, rests and rounds, one after the other, and when
motion began, ended or turned.
"""

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.making.draws import Array
from keyphase.making.strokes import SHORTEST

TURN_M_PER_RAD = 0.2
"""What a turn counts for beside a way [m/rad], as in the segmentation."""

MOVES_FROM = 0.05
"""Share of a stroke's largest speed from which the tool counts as moving."""

PAUSE_S = 0.4
"""A rest shorter than this is one event, its middle; a longer one has a beginning and an end."""

MotionLabel = Literal["motion began", "motion ended", "motion turned"]


@dataclass(frozen=True)
class MotionEvent:
    """When motion began, ended or turned, and how long the tool stood there [s]."""

    time_s: float
    label: MotionLabel
    standing_s: float = 0.0


@dataclass(frozen=True)
class Stretch:
    """Samples first to last (not included) in which the tool moves or rests."""

    moves: bool
    first: int
    last: int


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
        return max(SHORTEST, round(seconds * self.rate_hz))

    def move(self, along: Array, offset: Array, turn: Array, aside: Array) -> None:
        """A stroke by `offset` [m] and `turn` (rotation vector) with progress `along` (n,), off the
        straight way by `aside` (n, 3)."""
        way = along[:, None]
        self._add(
            True, self.at_m + way * offset + aside, self.pose * Rotation.from_rotvec(way * turn)
        )
        self.at_m = self.at_m + offset
        self.pose = self.pose * Rotation.from_rotvec(turn)

    def follow(self, way: Array, turn: Array) -> None:
        """Move along `way` (n, 3) [m] and `turn` (n, 3) relative to here, as one stroke."""
        self._add(True, self.at_m + way, self.pose * Rotation.from_rotvec(turn))
        self.at_m = self.at_m + way[-1]
        self.pose = self.pose * Rotation.from_rotvec(turn[-1])

    def rest(self, seconds: float) -> None:
        """Stand still."""
        count = max(1, round(seconds * self.rate_hz))
        still = np.broadcast_to(self.at_m, (count, 3))
        self._add(False, still, self.pose * Rotation.from_rotvec(np.zeros((count, 3))))

    def _add(self, moves: bool, position: Array, rotation: Rotation) -> None:
        self.positions.append(position)
        self.rotations.append(rotation)
        last = self.count + len(position)
        before = self.stretches[-1] if self.stretches else None
        if before and not moves and not before.moves:
            self.stretches[-1] = Stretch(False, before.first, last)
        else:
            self.stretches.append(Stretch(moves, self.count, last))
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

    Between two strokes with no rest, or one shorter than `PAUSE_S`, motion turned, in the middle of
    the time for which both are slower.
    """
    edges = [_moving(each, speed_m_s) for each in stretches if each.moves]
    if not edges:
        return []
    events: list[MotionEvent] = []
    rested = [each for each in stretches if not each.moves]
    if rested and rested[0].first == 0:
        events.append(MotionEvent(edges[0][0] / rate_hz, "motion began"))
    long = {each.first for each in rested if each.last - each.first >= PAUSE_S * rate_hz}
    ends = [each.last for each in stretches if each.moves]
    for (_, ended), (began, _), end in zip(edges, edges[1:], ends, strict=False):
        if end in long:
            events.append(MotionEvent(ended / rate_hz, "motion ended"))
            events.append(MotionEvent(began / rate_hz, "motion began"))
        else:
            middle, standing = 0.5 * (ended + began) / rate_hz, (began - ended) / rate_hz
            events.append(MotionEvent(middle, "motion turned", standing))
    if not stretches[-1].moves:
        events.append(MotionEvent(edges[-1][1] / rate_hz, "motion ended"))
    return events


def _moving(stretch: Stretch, speed_m_s: Array) -> tuple[int, int]:
    part = speed_m_s[stretch.first : stretch.last]
    moving = np.flatnonzero(part >= MOVES_FROM * part.max())
    return stretch.first + int(moving[0]), stretch.first + int(moving[-1])
