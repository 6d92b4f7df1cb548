"""What there is to see at each place where the tool's motion may change: valleys of its speed."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.grid import Grid
from keyphase.segmentation.evidence.rests import up_to_strokes
from keyphase.segmentation.evidence.speed import QUICK_HZ, Speed, speed_of
from keyphase.segmentation.evidence.ways import rotation_share, rounds

MOTION_TERMS: Mapping[str, str] = {
    "depth": "how far the speed falls",
    "dwell": "how long it stays low",
    "crowded": "valleys of the speed within a second",
    "turn": "change of direction",
    "stroke_length": "length of the shorter stroke beside it",
    "stroke_speed": "speed of the slower stroke beside it",
    "absolute_speed": "speed of that stroke in m/s",
    "small_stroke": "a stroke of less than a twentieth of the path",
    "rounds": "it goes round: back at the same place without stopping",
    "bare_turn": "a turn where no force was recorded",
    "kinds": "rotation turns into translation, or the other way",
    "stands": "the tool stands still for half a second",
}
"""Each term of a boundary of motion and what it says."""

LEVELS = (0.02, 0.3)
"""Prominence of strokes, in the fast speed: small swings must not split a long stop."""

MIN_STROKE_M_S = 2e-3
LONG_DWELL_S = 0.4
"""A longer valley has two edges, a shorter one a middle."""

CUT_STOP_S = 0.3
"""A shorter stop at the begin or end of a recording is the hand that starts and stops it."""

REST_S = 0.5
"""A valley this long is a rest, a shorter one a mere turn."""

ENDS_S = 0.2
_SHALLOW = 0.8
_EDGE = 0.07
_SAME_S = 0.12
_PLACE_SHARE = 0.02
_PLACE_M = (1e-3, 5e-3)
_SWAY_S = 2.0
_WANDER = 3.0


@dataclass(frozen=True, eq=False)
class MotionCandidates:
    """Where the motion may change, C places in time order.

    cell (C,)       fractional cell
    interval (C, 2) first and last cell it may be
    rest (C,)       whether a stop of half a second begins or ends there
    terms (C, T)    one column per MOTION_TERMS
    """

    cell: Array
    interval: Array
    rest: np.ndarray
    terms: Array


def motion_candidates(grid: Grid, speed: Speed) -> MotionCandidates:
    """Every candidate of a grid with its evidence; none where nothing moves on purpose."""
    tables = [np.zeros((0, 4 + len(MOTION_TERMS)))]
    strokes: list[_Valleys] = []
    if speed.fast_m_s > 0.0:
        strokes = [_Valleys(grid, speed, level) for level in LEVELS]
        crowd = strokes[0].valley
        tables += [valleys.rows(crowd) for valleys in strokes]
        if grid.wrench is None:
            # Beside a force a mere turn is no boundary by itself.
            quick = _Valleys(grid, speed_of(grid, QUICK_HZ), LEVELS[-1])
            tables.append(quick.rows(crowd))
        tables.append(_standing(grid, speed, strokes[0]))
    rows = _distinct(tables, grid.rate_hz)
    if speed.fast_m_s > 0.0:
        rows = rows[~_inside_a_stop(rows[:, 0], _stops(grid, speed, strokes[-1]), grid.rate_hz)]
    margin = ENDS_S * grid.rate_hz
    rows = rows[(rows[:, 0] > margin) & (rows[:, 0] < len(grid) - 1 - margin)]
    return MotionCandidates(rows[:, 0], rows[:, 1:3], rows[:, 3] > 0.0, rows[:, 4:])


class _Valleys:
    """The V valleys of the speed between strokes of one prominence.

    Before the first stroke and after the last one is half a valley: from the slowest moment
    there, with one edge only.
    """

    def __init__(self, grid: Grid, speed: Speed, level: float) -> None:
        from scipy.signal import find_peaks

        self.grid, self.speed = grid, speed
        self.coarse = level > LEVELS[0]
        s = speed.speed_m_s
        least = max(level * speed.fast_m_s, MIN_STROKE_M_S)
        padded = np.concatenate([[0.0], s, [0.0]])
        found, _ = find_peaks(padded, prominence=level * speed.fast_m_s, height=least)
        self.stroke: Indices = (found - 1).astype(np.intp)
        edges = np.concatenate([[0], self.stroke, [len(s) - 1]])
        pairs = zip(edges[:-1].tolist(), edges[1:].tolist(), strict=True)
        lowest = [a + int(np.argmin(s[a : b + 1])) for a, b in pairs]
        self.valley: Indices = np.array(lowest, dtype=np.intp)
        # A half valley has the same stroke on both sides.
        self.before: Indices = np.concatenate([self.stroke[:1], self.stroke])
        self.after: Indices = np.concatenate([self.stroke, self.stroke[-1:]])

    def rows(self, crowd: Indices) -> Array:
        """Candidates of the deep enough valleys: cell, interval, rest, terms."""
        s, rate = self.speed.speed_m_s, self.grid.rate_hz
        if not len(self.stroke):
            return np.zeros((0, 4 + len(MOTION_TERMS)))
        bottom, lower = s[self.valley], np.minimum(s[self.before], s[self.after])
        deep = bottom <= _SHALLOW * lower
        early, late = self.edges(bottom)
        dwell = (late - early) / rate
        terms = self._terms(early, late, bottom / lower, dwell, lower, crowd)
        # A stop that was there before the recording, or goes on after it, has an edge, no middle.
        cut = (early <= 0) | (late >= len(s) - 1)
        deep &= ~cut | (dwell >= CUT_STOP_S)
        rows = _edge_rows(early, late, dwell, terms, deep, cut | (dwell > LONG_DWELL_S))
        return rows[(rows[:, 0] > 0) & (rows[:, 0] < len(s) - 1)]

    def edges(self, bottom: Array) -> tuple[Indices, Indices]:
        """First and last slow cell of each valley, but for one cell; of small strokes' valleys from
        the bottom outwards, of large strokes' from outside: swings in between are no strokes.
        """
        s = self.speed.speed_m_s
        early, late = self.valley.copy(), self.valley.copy()
        last = len(self.valley) - 1
        levels = [bottom + _EDGE * (s[side] - bottom) for side in (self.before, self.after)]
        for index, valley in enumerate(self.valley.tolist()):
            first = 0 if index == 0 else int(self.before[index])
            end = len(s) - 1 if index == last else int(self.after[index])
            left = s[first : valley + 1] > levels[0][index]
            right = s[valley : end + 1] > levels[1][index]
            if self.coarse:
                early[index] = first + max(int(np.argmin(left)) - 1, 0) if left.any() else first
                late[index] = end - max(int(np.argmin(right[::-1])) - 1, 0) if right.any() else end
            else:
                early[index] = valley - int(np.argmax(left[::-1])) if left.any() else first
                late[index] = valley + int(np.argmax(right)) if right.any() else end
        return early, late

    def _terms(
        self,
        early: Indices,
        late: Indices,
        depth: Array,
        dwell: Array,
        lower: Array,
        crowd: Indices,
    ) -> Array:
        pose, fast = self.speed.pose_m, self.speed.fast_m_s
        span = float(np.linalg.norm(np.ptp(pose, axis=0))) + 1e-9
        into, out = pose[early] - pose[self.before], pose[self.after] - pose[late]
        # Where one kind of motion passes into the other, both have their tail in the valley.
        kinds = np.abs(rotation_share(into) - rotation_share(out))
        norms = np.linalg.norm(into, axis=1) * np.linalg.norm(out, axis=1)
        stops = np.concatenate([[0], self.valley, [len(pose) - 1]])
        strokes = np.linalg.norm(np.diff(pose[stops], axis=0), axis=1)
        strokes[0], strokes[-1] = strokes[1] if len(strokes) > 2 else strokes[0], strokes[-2]
        shorter = np.minimum(strokes[:-1], strokes[1:]) / span
        return np.column_stack(
            [
                -np.log(np.maximum(depth * 0.4**kinds, 0.02)),
                np.log(np.maximum(dwell, 0.04)),
                _crowding(self.valley, crowd, self.grid.rate_hz),
                1.0 - (into * out).sum(axis=1) / (norms + 1e-9),
                np.log(np.maximum(shorter, 0.01)),
                np.log(np.maximum(lower / fast, 0.02)),
                np.log(lower.clip(0.01, 1.0)),
                np.minimum(0.0, np.log(np.maximum(shorter, 0.002) / 0.05)),
                rounds(pose[stops], depth),
                (dwell < REST_S) * float(self.grid.wrench is None),
                kinds,
                np.zeros(len(early)),
            ]
        ).astype(np.float64)


def _stops(grid: Grid, speed: Speed, coarse: _Valleys) -> Indices:
    """First and last cell (S, 2) of rests, and of coarse valleys that stay in a small place."""
    found = [tuple(pair) for pair in speed.stops.tolist()]
    if len(coarse.stroke):
        s, pose = speed.speed_m_s, speed.pose_m
        span = float(np.linalg.norm(np.ptp(pose[:, :3], axis=0)))
        place = min(max(_PLACE_SHARE * span, _PLACE_M[0]), _PLACE_M[1])
        margin = round(_SAME_S * grid.rate_hz)
        # A shorter valley has one candidate, in its middle, which must not be taken for a swing.
        shortest = max(LONG_DWELL_S * grid.rate_hz, 2 * margin)
        edges = zip(*coarse.edges(s[coarse.valley]), strict=True)
        for early, late in edges:
            if late - early <= shortest:
                continue
            stretch = pose[early + margin : late - margin]
            if _stays(stretch, place, grid.cells(_SWAY_S)):
                found.append((int(early), int(late)))
    return np.array(found, dtype=np.intp).reshape(-1, 2)


def _stays(pose: Array, place: float, sway: int) -> bool:
    """Whether a pose (n, D) stays in a place: a hand that stands for a minute sways further than in
    `sway` cells, but goes nowhere."""
    whole = float(np.linalg.norm(np.ptp(pose, axis=0)))
    if whole < place or whole >= _WANDER * place or len(pose) <= sway:
        return whole < place
    from scipy.ndimage import maximum_filter1d, minimum_filter1d

    extent = maximum_filter1d(pose, sway, axis=0) - minimum_filter1d(pose, sway, axis=0)
    return float(np.linalg.norm(extent, axis=1).max()) < place


def _inside_a_stop(cell: Array, stops: Indices, rate_hz: float) -> np.ndarray:
    """Which candidates lie well inside a stop: swings there are no strokes."""
    inside = np.zeros(len(cell), dtype=bool)
    margin = _SAME_S * rate_hz
    for early, late in stops.tolist():
        first, last = np.searchsorted(cell, (early + margin, late - margin))
        inside[first : max(first, last)] = True
    return inside


def _edge_rows(
    early: Indices, late: Indices, dwell: Array, terms: Array, use: np.ndarray, long: np.ndarray
) -> Array:
    """Two rows where a valley is long, else one in its middle: cell, interval, rest, terms."""
    long, short = use & long, use & ~long
    middle = 0.5 * (early + late)
    half = 0.25 * (late - early)
    parts = (
        (early, early - 2.0, np.minimum(early + half, middle), long),
        (late, np.maximum(late - half, middle), late + 2.0, long),
        (middle, early, late, short),
    )
    rows = [
        np.column_stack([cell[u], first[u], last[u], dwell[u] >= REST_S, terms[u]])
        for cell, first, last, u in parts
    ]
    return np.vstack(rows).astype(np.float64)


def _crowding(at: Indices | Array, crowd: Indices, rate_hz: float) -> Array:
    """Log of how many valleys lie within a second: a swing has many, a phase has not."""
    low = np.searchsorted(crowd, at - rate_hz)
    high = np.searchsorted(crowd, at + rate_hz, side="right")
    return np.log(np.maximum(high - low, 1))


def _standing(grid: Grid, speed: Speed, fine: _Valleys) -> Array:
    """Both edges of every stop of half a second within a millimetre and a degree."""
    if not len(speed.stops):
        return np.zeros((0, 4 + len(MOTION_TERMS)))
    found = up_to_strokes(speed.stops, fine.stroke, speed.speed_m_s)
    early, late = found.T.astype(float)
    dwell, middle = (late - early) / grid.rate_hz, 0.5 * (early + late)
    ones = np.ones(len(found))
    fast = np.log(speed.fast_m_s)
    terms = np.column_stack(
        [
            -np.log(0.02) * ones,
            np.log(dwell),
            _crowding(middle, fine.valley, grid.rate_hz),
            ones,
            np.log(0.2) * ones,
            np.log(0.5) * ones,
            np.clip(fast, np.log(0.01), 0.0) * ones,
            0.0 * ones,
            0.0 * ones,
            0.0 * ones,
            0.0 * ones,
            ones,
        ]
    )
    return _edge_rows(early, late, dwell, terms, *np.ones((2, len(found)), dtype=bool))


def _distinct(tables: list[Array], rate_hz: float) -> Array:
    """All rows in time order; of two within 0.12 s the deeper, longer and stiller one stays."""
    rows = np.vstack(tables)
    worth = rows[:, 4] + np.minimum(0.0, rows[:, 5] - np.log(LONG_DWELL_S)) + 3.0 * rows[:, -1]
    rows, worth = rows[order := np.argsort(rows[:, 0], kind="stable")], worth[order]
    keep = np.ones(len(rows), dtype=bool)
    last = -1
    for index in range(len(rows)):
        if last >= 0 and rows[index, 0] - rows[last, 0] < _SAME_S * rate_hz:
            loser = last if worth[index] > worth[last] else index
            keep[loser] = False
            last = index if loser == last else last
        else:
            last = index
    return rows[keep]
