"""Reference files: what is known of recordings, and what of it may be judged."""

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from math import isfinite
from pathlib import Path
from typing import Any, Literal

from keyphase.errors import ScoreError

What = Literal["contact", "all"]
Kind = Literal["contact", "motion"]
Interval = tuple[float, float]

ONE_EVENT_S = 0.1
"""Labels nearer than this are one event."""


@dataclass(frozen=True)
class ReferenceEvent:
    """Something that happened.

    window_s   how long before and after `time_s` a boundary may lie and still be this event's
    kind       whether contact or motion changed, where the reference says so
    """

    time_s: float
    label: str
    window_s: tuple[float, float]
    kind: Kind | None = None


@dataclass(frozen=True)
class Judged:
    """What may be judged on a recording.

    what              contact: only contact changes were labelled, so only boundaries that claim one
                      take part; all: every boundary does
    ignore_s          stretches in which something real happens that nobody labelled: an unmatched
                      boundary there counts neither way
    ignore_motion_s   the same for boundaries that claim no contact change
    """

    what: What
    events: tuple[ReferenceEvent, ...]
    ignore_s: tuple[Interval, ...] = ()
    ignore_motion_s: tuple[Interval, ...] = ()


@dataclass(frozen=True)
class Truth:
    """What is known of one recording.

    events_s     times of the reference events
    ignore_s     intervals in which an unmatched boundary counts neither way
    tolerance_s  how far a boundary may be from an event and still be its own
    judged       what may be judged; where the reference does not say, all of the above

    The first three make the strict score: every boundary against every event.
    """

    events_s: tuple[float, ...]
    ignore_s: tuple[Interval, ...]
    tolerance_s: float
    judged: Judged = field(default=None)  # pyright: ignore[reportAssignmentType]

    def __post_init__(self) -> None:
        if self.judged is None:
            window = (self.tolerance_s, self.tolerance_s)
            events = [ReferenceEvent(time, "", window) for time in self.events_s]
            object.__setattr__(self, "judged", Judged("all", as_one(events), self.ignore_s))


def as_one(events: Iterable[ReferenceEvent]) -> tuple[ReferenceEvent, ...]:
    """Events in order; of those within `ONE_EVENT_S` of the first only that one."""
    kept: list[ReferenceEvent] = []
    for event in sorted(events, key=lambda each: each.time_s):
        if not kept or event.time_s - kept[-1].time_s >= ONE_EVENT_S:
            kept.append(event)
    return tuple(kept)


def read_truth(path: Path) -> dict[str, Truth]:
    """The references in a truth.json, by key. Raises ScoreError where it is malformed."""
    try:
        content = json.loads(path.read_bytes())
    except OSError as error:
        raise ScoreError(f"{path}: cannot be read ({error.strerror}); check the path.") from error
    except (ValueError, RecursionError) as error:
        raise ScoreError(f"{path}: expected JSON, but it cannot be parsed ({error}).") from error
    if not isinstance(content, dict) or not content:
        raise ScoreError(f"{path}: expected a JSON object with an entry for each recording.")
    for key in content:
        if Path(key).is_absolute() or ".." in Path(key).parts:
            raise ScoreError(f"{path}: expected keys such as set/name, but got {key!r}.")
    return {key: _truth(path, key, entry) for key, entry in content.items()}


def _truth(path: Path, key: str, entry: Any) -> Truth:
    try:
        tolerance = float(entry["tolerance_s"])
        times = tuple(sorted(float(event[0]) for event in entry["events"]))
        ignore = _intervals(entry.get("ignore", ()))
        judged = entry.get("judged")
        truth = Truth(times, ignore, tolerance)
        if judged is not None:
            truth = Truth(times, ignore, tolerance, _judged(judged, tolerance))
    except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
        raise ScoreError(
            f"{path}: {key} must have events [[time_s, label], …], ignore [[from_s, to_s], …], "
            "tolerance_s and, where it says what may be judged, judged as docs/scoring.md has it, "
            f"but they cannot be read ({type(error).__name__}: {error})."
        ) from error
    if not all(map(isfinite, _numbers(truth))) or tolerance < 0:
        raise ScoreError(f"{path}: the times of {key} must be finite, its tolerance not negative.")
    return truth


def _judged(entry: Mapping[str, Any], tolerance_s: float) -> Judged:
    what = entry["what"]
    if what not in ("contact", "all"):
        raise ValueError(f"what must be contact or all, but is {what!r}")
    events = entry["events"]
    windows = entry.get("window_s", [(tolerance_s, tolerance_s)] * len(events))
    kinds = entry.get("kinds", ["contact" if what == "contact" else None] * len(events))
    read = [
        ReferenceEvent(float(event[0]), str(event[1]), _window(window), _kind(kind))
        for event, window, kind in zip(events, windows, kinds, strict=True)
    ]
    return Judged(
        what,
        as_one(read),
        _intervals(entry.get("ignore", ())),
        _intervals(entry.get("ignore_motion", ())),
    )


def _window(pair: Any) -> tuple[float, float]:
    before, after = (float(side) for side in pair)
    if before < 0 or after < 0:
        raise ValueError(f"a window must not be negative, but is {pair!r}")
    return before, after


def _kind(value: Any) -> Kind | None:
    if value not in ("contact", "motion", None):
        raise ValueError(f"a kind must be contact or motion, but is {value!r}")
    return value


def _intervals(pairs: Any) -> tuple[Interval, ...]:
    return tuple((float(low), float(high)) for low, high in pairs)


def _numbers(truth: Truth) -> list[float]:
    judged = truth.judged
    intervals = [*truth.ignore_s, *judged.ignore_s, *judged.ignore_motion_s]
    windows = [event.window_s for event in judged.events]
    times = [*truth.events_s, *(event.time_s for event in judged.events), truth.tolerance_s]
    return times + [number for pair in [*intervals, *windows] for number in pair]
