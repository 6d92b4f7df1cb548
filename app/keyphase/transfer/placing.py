"""Where the boundaries of taught phases lie in another recording: one place for each, all at once.

A segmental model: every boundary has a few places it may be at (where the alignment puts it, and
the recording's own evidence around), and each phase costs what its stretch differs from the taught
ones, as if both took the same time. The cheapest choice of all is found by dynamic programming.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from keyphase.demonstration import Array
from keyphase.transfer.alignment import Alignment
from keyphase.transfer.evidence_places import Place, PlaceKind, Places
from keyphase.transfer.signals import Signals, in_common
from keyphase.transfer.taught import Taught

MIN_GAP_S = 0.04

_POINTS = 15
_FAR_S = 1.0
_FARTHEST = 3.0
_AWAY, _UNLIKELY, _OTHER_KIND = 0.5, 0.5, 1.0
_WITHOUT_EVIDENCE = 2.0
_DIFFERENCE, _DURATION = 2.0, 0.3
_TEMPO_RANGE = (0.4, 2.5)
_ALONE_S = 0.15


@dataclass(frozen=True)
class Teacher:
    """A finished recording and how the new one is aligned with it (from it to the new one)."""

    taught: Taught
    alignment: Alignment


@dataclass(frozen=True)
class PlacedEnd:
    """Where a phase ends.

    evidence_s   the evidence it belongs to; where the alignment alone puts it without any
    probability  of the evidence it belongs to; 0 without any
    spread_s     how far the teachers are apart about it
    """

    time_s: float
    evidence_s: float
    probability: float
    spread_s: float


@dataclass(frozen=True)
class _Wanted:
    """One boundary as it was taught: the evidence it belongs to, and how far from it it lies."""

    kind: PlaceKind | None
    anchor_s: float
    offset_s: float
    warped_s: float


@dataclass(frozen=True)
class _Option:
    time_s: float
    probability: float
    cost: float


def placed_ends(
    teachers: Sequence[Teacher], signals: Signals, places: Places
) -> tuple[PlacedEnd, ...] | None:
    """The ends of all phases but the last; None where they have no room in the recording.

    The teachers have the same phases. Each places them by itself, and of each end the median is
    taken: one that marked it at other evidence than the others, or where there was none, decides
    nothing. Medians of ends that are in their order are so, too.
    """
    each = [_placed_by(teacher, signals, places) for teacher in teachers]
    found = [ends for ends in each if ends is not None]
    return tuple(_median(same) for same in zip(*found, strict=True)) if found else None


def _median(ends: Sequence[PlacedEnd]) -> PlacedEnd:
    times = np.array([end.time_s for end in ends])
    time_s = float(np.median(times))
    spread_s = float(np.ptp(times)) if len(ends) > 1 else _ALONE_S
    nearest = ends[int(np.abs(times - time_s).argmin())]
    return replace(nearest, time_s=time_s, spread_s=spread_s)


def _placed_by(teacher: Teacher, signals: Signals, places: Places) -> tuple[PlacedEnd, ...] | None:
    """Where the ends lie by one finished recording."""
    wanted = [_wanted(teacher, number) for number in range(len(teacher.taught.phases) - 1)]
    options = [_options(one, places) for one in wanted]
    chosen = _cheapest(teacher, wanted, options, signals)
    start_s, end_s = float(signals.time_s[0]), float(signals.time_s[-1])
    if chosen is None:
        return _as_aligned(teacher, start_s, end_s)
    edges = signals.awake_s(np.array([start_s, *(o.time_s for o in chosen), end_s])).tolist()
    times = [
        option.time_s + _offset_s(teacher, wanted, number, edges)
        for number, option in enumerate(chosen)
    ]
    times = _in_order(times, [option.time_s for option in chosen], start_s, end_s)
    return tuple(
        PlacedEnd(time, option.time_s, option.probability, 0.0)
        for time, option in zip(times, chosen, strict=True)
    )


def _as_aligned(teacher: Teacher, start_s: float, end_s: float) -> tuple[PlacedEnd, ...] | None:
    """Where the alignment alone puts them, moved apart: evidence leaves no room for their order."""
    times = np.array([teacher.alignment.at(each) for each in teacher.taught.ends_s])
    later = MIN_GAP_S * np.arange(1, len(times) + 1)
    if end_s - start_s < MIN_GAP_S * (len(times) + 1):
        return None
    times = np.maximum.accumulate(np.maximum(times - later, start_s)) + later
    before = later[::-1]
    times = np.minimum.accumulate((np.minimum(times + before, end_s))[::-1])[::-1] - before
    return tuple(PlacedEnd(time_s, time_s, 0.0, 0.0) for time_s in times.tolist())


def _wanted(teacher: Teacher, number: int) -> _Wanted:
    end_s = teacher.taught.phases[number].end_s
    place = teacher.taught.anchors[number]
    anchor_s = end_s if place is None else place.time_s
    kind = None if place is None else place.kind
    return _Wanted(kind, anchor_s, end_s - anchor_s, teacher.alignment.at(anchor_s))


def _options(wanted: _Wanted, places: Places) -> list[_Option]:
    """Where the alignment puts it, and evidence around, of the same kind rather than another."""
    if wanted.kind is None:
        return [_Option(wanted.warped_s, 0.0, 0.0)]
    found = [_Option(wanted.warped_s, 0.0, _WITHOUT_EVIDENCE)]
    for place in places.all:
        away = abs(place.time_s - wanted.warped_s) / _FAR_S
        if away <= _FARTHEST:
            found.append(_Option(place.time_s, place.probability, _cost(place, away, wanted.kind)))
    return found


def _cost(place: Place, away: float, kind: PlaceKind) -> float:
    other = 0.0 if place.kind == kind else _OTHER_KIND
    return _AWAY * away - _UNLIKELY * float(np.log(place.probability)) + other


def _cheapest(
    teacher: Teacher,
    wanted: Sequence[_Wanted],
    options: Sequence[Sequence[_Option]],
    signals: Signals,
) -> list[_Option] | None:
    """One option for each boundary, in rising order, with phases as they were taught."""
    start = _Option(float(signals.time_s[0]), 0.0, 0.0)
    end = _Option(float(signals.time_s[-1]), 0.0, 0.0)
    layers = [[start], *map(list, options), [end]]
    total = np.zeros(1)
    ways: list[np.ndarray] = []
    for number in range(len(layers) - 1):
        step = _phase_costs(teacher, wanted, number, layers[number], layers[number + 1], signals)
        reached = total[:, None] + step
        ways.append(reached.argmin(axis=0))
        total = reached.min(axis=0) + np.array([option.cost for option in layers[number + 1]])
    if not np.isfinite(total[0]):
        return None
    at, chosen = 0, []
    for number in range(len(layers) - 2, 0, -1):
        at = int(ways[number][at])
        chosen.append(layers[number][at])
    return chosen[::-1]


def _phase_costs(
    teacher: Teacher,
    wanted: Sequence[_Wanted],
    number: int,
    before: Sequence[_Option],
    after: Sequence[_Option],
    signals: Signals,
) -> Array:
    """(B, A): what a phase from one of B places to one of A costs."""
    first = np.array([option.time_s for option in before])
    last = np.array([option.time_s for option in after])
    theirs, mine = in_common(teacher.taught.signals, signals, teacher.alignment.standing)
    begin, finish = theirs.awake_s(np.array(_taught_edges(teacher, wanted, number))).tolist()
    since = mine.awake_s(first)[:, None]
    lasting = mine.awake_s(last)[None] - since
    shares = np.linspace(0.0, 1.0, _POINTS)
    example = theirs.at_awake(np.array(begin + shares * (finish - begin)))
    found = mine.at_awake(since[:, :, None] + shares * lasting[:, :, None])
    difference = np.linalg.norm(found - example, axis=-1).mean(axis=-1)
    usual = max((finish - begin) * teacher.alignment.tempo, MIN_GAP_S)
    ratio = np.maximum(lasting, MIN_GAP_S) / usual
    costs = _DIFFERENCE * difference + _DURATION * np.abs(np.log(ratio))
    return np.where(last[None] - first[:, None] >= MIN_GAP_S, costs, np.inf)


def _taught_edges(teacher: Teacher, wanted: Sequence[_Wanted], number: int) -> tuple[float, float]:
    phases = teacher.taught.phases
    edges = [phases[0].start_s, *(one.anchor_s for one in wanted), phases[-1].end_s]
    return edges[number], edges[number + 1]


def _offset_s(
    teacher: Teacher, wanted: Sequence[_Wanted], number: int, edges: Sequence[float]
) -> float:
    """How far from its evidence the boundary lies: as taught, slower where phases are slower."""
    before, _ = _taught_edges(teacher, wanted, number)
    _, after = _taught_edges(teacher, wanted, number + 1)
    around = edges[number + 2] - edges[number]
    theirs = float(np.ptp(teacher.taught.signals.awake_s(np.array([before, after]))))
    tempo = np.clip(around / max(theirs, MIN_GAP_S), *_TEMPO_RANGE)
    return float(wanted[number].offset_s * tempo)


def _in_order(
    times: Sequence[float], evidence_s: Sequence[float], start_s: float, end_s: float
) -> Sequence[float]:
    """The times; where they fall out of their order, those of the evidence."""
    steps = np.diff([start_s, *times, end_s])
    return times if bool((steps >= MIN_GAP_S).all()) else evidence_s
