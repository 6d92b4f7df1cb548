"""When the gripper grasped and let go, and boundaries there.

A gripper closes until it holds something or is shut, and opens from the moment it lets go: a grasp
is where closing ends, a release where opening begins. Strokes are found in the opening as it was
recorded, so metres, a fraction and a command of 0 and 1 serve alike.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition import GripperEnd
from keyphase.segmentation.segmentation import Boundary, GripperChange, Reason

MIN_SHARE = 0.1
"""A stroke over a smaller share of the opening's range is no event."""

JOIN_CONTACT_S = 0.05
"""A contact change this near to an event is the same; it keeps its time."""

JOIN_MOTION_S = 0.2
"""A boundary of motion this near to an event gives way to it."""

SAME_EVENT_S = 0.1
"""A segment that ends this near to an event ends with it; nearer than this to either end of a
recording there is no segment."""

STOOD_S, STOOD_M = 0.3, 0.003
"""A tool that moved by less than the second for so long came to no contact by its own motion."""

_STEP_S = 0.02
_REACH = 5
_PAUSE = 10
_MOVING_SHARE = 0.03
_ARRIVED_SHARE = 0.02
_REBOUND_SHARE = 0.5
_NOISES = 6.0


@dataclass(frozen=True)
class GripperEvent:
    """A grasp or a release.

    time_s  when closing ended, or opening began
    share   how much of the opening's range the gripper moved, 0 to 1
    """

    time_s: float
    change: GripperChange
    share: float

    @property
    def confidence(self) -> float:
        """That a person would put a boundary there; a small stroke may be slack."""
        return self.share / (self.share + 0.25 * MIN_SHARE)


def gripper_events(demonstration: Demonstration) -> tuple[GripperEvent, ...]:
    """All grasps and releases in time order; none where no gripper was recorded, or none moved."""
    opening = demonstration.gripper
    if opening is None or not np.ptp(opening) > 0.0:
        return ()
    time = demonstration.time_s
    span = float(np.ptp(np.quantile(opening, (0.002, 0.998)))) or float(np.ptp(opening))
    noise = float(np.median(np.abs(np.diff(opening))))
    found = (
        _event(time, opening, stroke_s, span, noise)
        for stroke_s in _strokes(time, opening, max(_MOVING_SHARE * span, _NOISES * noise))
    )
    return tuple(one for one in found if one.share >= max(MIN_SHARE, _NOISES * noise / span))


TOLERANCE_SHARE = 0.1
"""An opening counts as the demonstrated one within this share of what the gripper moved."""


def gripper_end(
    demonstration: Demonstration, events: Sequence[GripperEvent], end_s: float
) -> GripperEnd | None:
    """What the gripper has done as a segment ends at `end_s`; None where it did nothing there."""
    near = [one for one in events if abs(one.time_s - end_s) <= SAME_EVENT_S]
    opening = demonstration.gripper
    if not near or opening is None:
        return None
    event = min(near, key=lambda one: abs(one.time_s - end_s))
    row = int(np.searchsorted(demonstration.time_s, event.time_s - 1e-9))
    # A command opens from one sample to the next: what it opens from is the one before.
    row -= event.change == "release"
    held = float(opening[min(max(row, 0), len(opening) - 1)])
    moved = event.share * float(np.ptp(opening))
    return GripperEnd(event.change, held, TOLERANCE_SHARE * moved)


def stands_at(demonstration: Demonstration, end_s: float) -> bool:
    """Whether the tool stands before a moment: what it touches then its fingers have brought."""
    rows = slice(*np.searchsorted(demonstration.time_s, (end_s - STOOD_S, end_s)).tolist())
    place = demonstration.position_m[rows]
    return bool(len(place)) and float(np.linalg.norm(np.ptp(place, axis=0))) < STOOD_M


def with_gripper(
    boundaries: Sequence[Boundary], events: Sequence[GripperEvent]
) -> tuple[Boundary, ...]:
    """Boundaries with those of the gripper among them, in time order.

    A contact change beside an event is the same boundary; one of motion gives way, since arriving,
    closing and leaving are one grasp.
    """
    kept = sorted(boundaries, key=_time)
    for event in events:
        first = bisect_left(kept, event.time_s - JOIN_MOTION_S, key=_time)
        last = bisect_right(kept, event.time_s + JOIN_MOTION_S, key=_time)
        near = kept[first:last]
        same = [one for one in near if _is_same(one, event)]
        if same:
            nearest = min(same, key=lambda one: abs(one.time_s - event.time_s))
            reasons = (_reason(event), *nearest.reasons)
            joined = replace(nearest, gripper=event.change, reasons=reasons)
            kept[first + near.index(nearest)] = joined
            continue
        moved = [one for one in near if not (one.contact_change or one.gripper)]
        stays = [one for one in near if one.contact_change or one.gripper]
        away = [abs(one.time_s - event.time_s) for one in moved]
        moved_s = moved[int(np.argmin(away))].time_s if moved else None
        kept[first:last] = sorted([*stays, _boundary(event, moved_s)], key=_time)
    return tuple(kept)


def _time(boundary: Boundary) -> float:
    return boundary.time_s


def _is_same(boundary: Boundary, event: GripperEvent) -> bool:
    return boundary.contact_change and abs(boundary.time_s - event.time_s) <= JOIN_CONTACT_S


def _boundary(event: GripperEvent, moved_s: float | None) -> Boundary:
    return Boundary(
        time_s=event.time_s,
        origin="gripper",
        interval_s=(event.time_s, event.time_s),
        confidence=event.confidence,
        contact_change=False,
        position_s=moved_s,
        reasons=(_reason(event),),
        gripper=event.change,
    )


def _reason(event: GripperEvent) -> Reason:
    how = "closed" if event.change == "grasp" else "opens"
    odds = float(np.log(event.confidence / (1.0 - event.confidence)))
    return Reason(f"the gripper {how} by {100 * event.share:.0f} %", event.share, odds)


def _strokes(time: Array, opening: Array, moving: float) -> Iterator[tuple[float, float]]:
    """From when to when [s] the opening changes one way by more than `moving` in 0.2 s."""
    grid = np.arange(time[0], time[-1] + _STEP_S, _STEP_S)
    # What came before and after is taken to be as at the ends.
    level = np.pad(np.interp(grid, time, opening), _REACH, mode="edge")
    change = level[2 * _REACH :] - level[: -2 * _REACH]
    way = np.where(np.abs(change) > moving, np.sign(change), 0.0)
    steps = np.flatnonzero(way)
    if not len(steps):
        return
    parts = np.flatnonzero((np.diff(steps) > _PAUSE) | (np.diff(way[steps]) != 0.0)) + 1
    reach = np.array([-_REACH, _REACH])
    strokes = [np.clip(part[[0, -1]] + reach, 0, len(grid) - 1) for part in np.split(steps, parts)]
    for first, last in _with_rebounds(strokes, np.interp(grid, time, opening)):
        yield float(grid[first]), float(grid[last])


def _with_rebounds(strokes: Sequence[NDArray[np.intp]], level: Array) -> list[tuple[int, int]]:
    """Strokes (first, last), a spring back that follows at once being the end of its stroke."""
    joined: list[tuple[int, int]] = []
    for first, last in strokes:
        before = joined[-1] if joined else None
        if before and first <= before[1] + _REACH:
            gone = level[before[0] : before[1] + 1]
            if abs(level[last] - level[before[1]]) < _REBOUND_SHARE * np.ptp(gone):
                joined[-1] = before[0], int(last)
                continue
        joined.append((int(first), int(last)))
    return joined


def _event(
    time: Array, opening: Array, stroke_s: tuple[float, float], span: float, noise: float
) -> GripperEvent:
    first, last = np.searchsorted(time, stroke_s).tolist()
    first, last = max(first - 1, 0), min(last, len(time) - 1)
    stroke = opening[first : last + 1]
    change = float(stroke[-1] - stroke[0])
    near = max(_ARRIVED_SHARE * abs(change), 3.0 * noise)
    if change < 0.0:
        row = int(np.argmax(stroke <= stroke[-1] + near))
    else:
        row = int(np.argmax(stroke > stroke[0] + near))
    kind: GripperChange = "grasp" if change < 0.0 else "release"
    return GripperEvent(float(time[first + row]), kind, min(abs(change) / span, 1.0))
