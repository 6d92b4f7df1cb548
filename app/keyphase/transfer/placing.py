"""Where the boundaries of taught phases lie in another recording: one place for each, all at once.

A segmental model: every boundary has a few places it may be at (where the alignment puts it, and
the recording's own evidence around), and each phase costs what its stretch differs from the taught
ones, as if both took the same time. The cheapest choice of all is found by dynamic programming.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.transfer.alignment import Alignment
from keyphase.transfer.evidence_places import Place, PlaceKind, Places, usual_kind
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

    warped_s     where the alignment alone puts it
    evidence_s   the evidence it belongs to; the same as warped_s without any
    probability  of the evidence it belongs to; 0 without any
    spread_s     how far the teachers are apart about it
    """

    time_s: float
    warped_s: float
    evidence_s: float
    probability: float
    spread_s: float


@dataclass(frozen=True)
class _Wanted:
    """One boundary as it was taught: the evidence it belongs to, and how far from it it lies."""

    kind: PlaceKind | None
    anchors_s: tuple[float, ...]
    offsets_s: tuple[float, ...]
    warped_s: float
    spread_s: float


@dataclass(frozen=True)
class _Option:
    time_s: float
    probability: float
    cost: float


def placed_ends(
    teachers: Sequence[Teacher], signals: Signals, places: Places
) -> tuple[PlacedEnd, ...] | None:
    """The ends of all phases but the last; None where they have no room in their order.

    The teachers have the same phases.
    """
    count = len(teachers[0].taught.phases) - 1
    wanted = [_wanted(teachers, number) for number in range(count)]
    options = [_options(one, places) for one in wanted]
    chosen = _cheapest(teachers, wanted, options, signals)
    if chosen is None:
        return None
    start_s, end_s = float(signals.time_s[0]), float(signals.time_s[-1])
    edges = [start_s, *(option.time_s for option in chosen), end_s]
    times = [
        option.time_s + _offset_s(teachers, wanted, number, edges)
        for number, option in enumerate(chosen)
    ]
    times = _in_order(times, [option.time_s for option in chosen], start_s, end_s)
    return tuple(
        PlacedEnd(time, one.warped_s, option.time_s, option.probability, one.spread_s)
        for time, one, option in zip(times, wanted, chosen, strict=True)
    )


def _wanted(teachers: Sequence[Teacher], number: int) -> _Wanted:
    ends = [one.taught.phases[number].end_s for one in teachers]
    found = [one.taught.anchors[number] for one in teachers]
    kind = usual_kind(found)
    anchors = [
        end if place is None or place.kind != kind else place.time_s
        for end, place in zip(ends, found, strict=True)
    ]
    warped = [one.alignment.at(time) for one, time in zip(teachers, anchors, strict=True)]
    return _Wanted(
        kind,
        tuple(anchors),
        tuple(end - anchor for end, anchor in zip(ends, anchors, strict=True)),
        float(np.median(warped)),
        float(np.ptp(warped)) if len(warped) > 1 else _ALONE_S,
    )


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
    teachers: Sequence[Teacher],
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
        step = _phase_costs(teachers, wanted, number, layers[number], layers[number + 1], signals)
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
    teachers: Sequence[Teacher],
    wanted: Sequence[_Wanted],
    number: int,
    before: Sequence[_Option],
    after: Sequence[_Option],
    signals: Signals,
) -> Array:
    """(B, A): what a phase from one of B places to one of A costs, the mean of all teachers."""
    first = np.array([option.time_s for option in before])
    last = np.array([option.time_s for option in after])
    lasting = last[None] - first[:, None]
    costs = np.zeros(lasting.shape)
    for index, teacher in enumerate(teachers):
        theirs, mine = in_common(teacher.taught.signals, signals, teacher.alignment.turned_rad)
        begin, finish = _taught_edges(teacher, wanted, number, index)
        shares = np.linspace(0.0, 1.0, _POINTS)
        example = theirs.between(np.array(begin + shares * (finish - begin)))
        found = mine.between(first[:, None, None] + shares * lasting[:, :, None])
        difference = np.linalg.norm(found - example, axis=-1).mean(axis=-1)
        tempo = teacher.alignment.tempo
        ratio = np.maximum(lasting, MIN_GAP_S) / max((finish - begin) * tempo, MIN_GAP_S)
        costs += _DIFFERENCE * difference + _DURATION * np.abs(np.log(ratio))
    return np.where(lasting >= MIN_GAP_S, costs / len(teachers), np.inf)


def _taught_edges(
    teacher: Teacher, wanted: Sequence[_Wanted], number: int, index: int
) -> tuple[float, float]:
    phases = teacher.taught.phases
    anchors = [one.anchors_s[index] for one in wanted]
    edges = [phases[0].start_s, *anchors, phases[-1].end_s]
    return edges[number], edges[number + 1]


def _offset_s(
    teachers: Sequence[Teacher], wanted: Sequence[_Wanted], number: int, edges: Sequence[float]
) -> float:
    """How far from its evidence the boundary lies: as taught, slower where phases are slower."""
    offsets = []
    around = edges[number + 2] - edges[number]
    for index, teacher in enumerate(teachers):
        before, _ = _taught_edges(teacher, wanted, number, index)
        _, after = _taught_edges(teacher, wanted, number + 1, index)
        tempo = np.clip(around / max(after - before, MIN_GAP_S), *_TEMPO_RANGE)
        offsets.append(wanted[number].offsets_s[index] * tempo)
    return float(np.median(offsets))


def _in_order(
    times: Sequence[float], evidence_s: Sequence[float], start_s: float, end_s: float
) -> Sequence[float]:
    """The times; where they fall out of their order, those of the evidence."""
    steps = np.diff([start_s, *times, end_s])
    return times if bool((steps >= MIN_GAP_S).all()) else evidence_s
