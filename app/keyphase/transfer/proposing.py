"""Boundaries and names proposed for a recording from those that are finished.

Each finished recording is warped onto the new one; of those that fit, the boundaries of one order
of phases are put where most of them say, then moved to the recording's own evidence near by. How
well it fits, how sure the evidence is and how much the finished ones agree make the confidence.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import LabelingError
from keyphase.segmentation.segmentation import Boundary, Candidate, Segmentation
from keyphase.transfer.alignment import Alignment, align
from keyphase.transfer.ordering import Option, in_order
from keyphase.transfer.signals import Signals, signals_of
from keyphase.transfer.taught import Taught

SNAP_S = 0.4
"""How far from where it was taught a boundary may be moved to evidence."""

SAME_S = 0.05
"""A boundary of the program this near to a proposed one is the same."""

MIN_PROBABILITY = 0.1
"""Evidence less likely than this moves nothing."""

STAYING_WORTH = 0.2
"""A boundary stays where it was taught unless evidence is worth more than this."""

TRUSTED = 0.7
"""Where persons kept this share of the program's boundaries, and it found this share of theirs,
its own boundaries in the other recordings are taken, and only the names transferred."""

MAX_COST = 0.9
OUTLIER_FACTOR = 1.8
"""A recording that fits worse than this many times what the finished ones do among themselves, or
by more than MAX_COST, is of another kind."""

_BIAS, _FIT, _SPREAD, _EVIDENCE = 2.9, -2.2, -2.0, 1.2
_MAX_ALIGNED = 5


@dataclass(frozen=True)
class ProposedBoundary:
    """A boundary proposed from others; `warped_s` is where it was before evidence moved it."""

    time_s: float
    confidence: float
    contact_change: bool
    warped_s: float


@dataclass(frozen=True)
class ProposedPhase:
    """A phase proposed from others, and how sure its name is."""

    start_s: float
    end_s: float
    name: str
    kept: bool
    confidence: float


@dataclass(frozen=True, eq=False)
class Transfer:
    """What is proposed for one recording.

    outlier   it fits none of the finished ones; nothing is proposed then
    cost      how badly the best of them fits
    teachers  the names of those it was proposed from, the best first
    """

    name: str
    boundaries: tuple[ProposedBoundary, ...]
    phases: tuple[ProposedPhase, ...]
    outlier: bool
    cost: float
    teachers: tuple[str, ...]


def propose(
    taught: Sequence[Taught],
    demonstration: Demonstration,
    segmentation: Segmentation | None = None,
    *,
    usual_cost: float | None = None,
) -> Transfer:
    """Boundaries and names for a demonstration, from finished recordings of the same task.

    `segmentation` is its own, whose evidence boundaries are moved to. `usual_cost` is how badly
    recordings of this task fit each other (`usual_cost_of`); a much worse fit is an outlier.

    Raises LabelingError where nothing was taught.
    """
    if not taught:
        raise LabelingError("Expected finished recordings to learn from, but there is none.")
    signals = signals_of(demonstration)
    aligned = [(one, align(one.signals, signals)) for one in _nearest(taught, signals)]
    aligned.sort(key=lambda pair: pair[1].cost)
    best, alignment = aligned[0]
    limit = MAX_COST if usual_cost is None else min(MAX_COST, OUTLIER_FACTOR * usual_cost)
    if alignment.cost > limit:
        return Transfer(demonstration.name, (), (), True, alignment.cost, (best.name,))
    same = [(one, a) for one, a in aligned if one.names == best.names]
    same = [(one, a) for one, a in same if a.cost <= 1.3 * alignment.cost]
    boundaries = _boundaries(same, demonstration, segmentation)
    if segmentation is not None and _program_agrees([one for one, _ in same]):
        boundaries = _with_own(boundaries, segmentation)
    phases = _phases(best, alignment, boundaries, demonstration)
    inner = {phase.end_s for phase in phases[:-1]}
    boundaries = tuple(b for b in boundaries if b.time_s in inner)
    teachers = tuple(one.name for one, _ in same)
    return Transfer(demonstration.name, boundaries, phases, False, alignment.cost, teachers)


def usual_cost_of(taught: Sequence[Taught]) -> float | None:
    """How badly the finished recordings fit each other, or None where there is only one."""
    chosen = taught[:_MAX_ALIGNED]
    costs = [
        align(one.signals, other.signals).cost
        for i, one in enumerate(chosen)
        for other in chosen[i + 1 :]
    ]
    return float(np.max(costs)) if costs else None


def _nearest(taught: Sequence[Taught], signals: Signals) -> Sequence[Taught]:
    """A few of many: those nearest in length, which align best."""
    length = len(signals.time_s)
    return sorted(taught, key=lambda one: abs(len(one.signals.time_s) - length))[:_MAX_ALIGNED]


def _boundaries(
    aligned: Sequence[tuple[Taught, Alignment]],
    demonstration: Demonstration,
    segmentation: Segmentation | None,
) -> tuple[ProposedBoundary, ...]:
    candidates = () if segmentation is None else segmentation.candidates
    best = aligned[0][0]
    warped, spreads, options = [], [], []
    for number, phase in enumerate(best.phases[:-1]):
        times = [a.at(one.phases[number].end_s) for one, a in aligned]
        warped.append(float(np.median(times)))
        spreads.append(float(np.ptp(times)) if len(times) > 1 else 0.15)
        options.append(_options(warped[-1], phase.ends_in_contact, candidates))
    chosen = in_order(options, demonstration.start_s, demonstration.end_s)
    return tuple(
        ProposedBoundary(
            option.time_s,
            _confidence(
                aligned[0][1].residual_near(phase.end_s), spreads[number], option.probability
            ),
            phase.ends_in_contact,
            warped[number],
        )
        for number, (phase, option) in enumerate(zip(best.phases[:-1], chosen, strict=True))
        if option is not None
    )


def _options(warped_s: float, contact: bool, candidates: Sequence[Candidate]) -> list[Option]:
    """The place itself, and evidence near by: the likelier and nearer, the better."""
    found = [Option(warped_s, 0.0, -np.log(STAYING_WORTH))]
    for one in candidates:
        away = abs(one.time_s - warped_s)
        if away <= SNAP_S and one.probability >= MIN_PROBABILITY:
            kind = 1.0 if (one.kind == "contact") == contact else 0.5
            worth = kind * one.probability * (1.0 - 0.8 * away / SNAP_S)
            found.append(Option(one.time_s, one.probability, -np.log(worth)))
    return found


def _confidence(residual: float, spread_s: float, probability: float) -> float:
    z = _BIAS + _FIT * residual + _SPREAD * min(spread_s, 1.0) + _EVIDENCE * (probability - 0.5)
    return float(1.0 / (1.0 + np.exp(-z)))


def _program_agrees(taught: Sequence[Taught]) -> bool:
    """Whether the persons who finished these kept what the program had found, and little else."""
    kept, found = np.mean([one.agreement for one in taught], axis=0)
    return bool(kept >= TRUSTED and found >= TRUSTED)


def _with_own(
    proposed: Sequence[ProposedBoundary], segmentation: Segmentation
) -> tuple[ProposedBoundary, ...]:
    """The program's own boundaries, and those proposed ones it passed over but has evidence for.

    One that the finished recordings have there, too, is at least as sure as they make it.
    """
    own = [
        ProposedBoundary(b.time_s, _confirmed(b, proposed), b.contact_change, b.time_s)
        for b in segmentation.boundaries
    ]
    times = np.array([b.time_s for b in own] or [np.inf])
    more = [
        b
        for b in proposed
        if np.abs(times - b.time_s).min() > SNAP_S
        and b.confidence >= 0.8
        and b.time_s != b.warped_s
    ]
    return tuple(sorted([*own, *more], key=lambda boundary: boundary.time_s))


def _confirmed(own: Boundary, proposed: Sequence[ProposedBoundary]) -> float:
    same = (b.confidence for b in proposed if abs(b.time_s - own.time_s) <= SAME_S)
    return max(own.confidence, *same, 0.0)


def _phases(
    best: Taught,
    alignment: Alignment,
    boundaries: Sequence[ProposedBoundary],
    demonstration: Demonstration,
) -> tuple[ProposedPhase, ...]:
    """Each phase is called what most of its time is called in the best fitting recording.

    Neighbours that are parts of one phase there are one phase here, too.
    """
    edges = [demonstration.start_s, *(b.time_s for b in boundaries), demonstration.end_s]
    sure = [1.0, *(b.confidence for b in boundaries), 1.0]
    inner = [phase.end_s for phase in best.phases[:-1]]
    at = np.searchsorted(inner, alignment.from_s, side="right")
    found: list[ProposedPhase] = []
    before = -1
    for i in range(len(edges) - 1):
        inside = (alignment.to_s >= edges[i]) & (alignment.to_s <= edges[i + 1])
        votes = np.bincount(at[inside], minlength=len(best.phases))
        index = int(np.argmax(votes))
        phase = best.phases[index]
        share = float(votes.max() / max(votes.sum(), 1))
        confidence = share * min(sure[i], sure[i + 1])
        start_s = edges[i]
        if index == before:
            last = found.pop()
            start_s, confidence = last.start_s, min(confidence, last.confidence)
        before = index
        found.append(ProposedPhase(start_s, edges[i + 1], phase.name, phase.kept, confidence))
    return tuple(found)
