"""Boundaries and names proposed for a recording from those that are finished.

Each finished recording is warped onto the new one; of those that fit, the boundaries of one order
of phases are put where the phases between them are most like the taught ones, at the recording's
own evidence. How well it fits, how sure the evidence is and how much the finished ones agree make
the confidence.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.errors import LabelingError
from keyphase.labeling.tasks.task import TaskPhase
from keyphase.segmentation.segmentation import Segmentation
from keyphase.transfer.alignment import align
from keyphase.transfer.evidence_places import NO_PLACES, Places, places_of
from keyphase.transfer.meant_places import REACH_S
from keyphase.transfer.own_boundaries import ProposedBoundary, means_own, own_where_better
from keyphase.transfer.phase_fit import PhaseFit
from keyphase.transfer.phase_order import BRIEF_S, Difference, as_done, quoted
from keyphase.transfer.placing import Teacher, placed_ends
from keyphase.transfer.signals import Signals, signals_of
from keyphase.transfer.taught import Taught

NEARLY_AS_GOOD = 1.6
"""Finished recordings that fit worse than this many times the best one say nothing."""

MAX_COST = 0.67
OUTLIER_FACTOR = 1.8
LEAST_LIMIT = 0.55
"""A recording that fits worse than OUTLIER_FACTOR times what the finished ones do among themselves,
and than LEAST_LIMIT, or by more than MAX_COST, is of another kind."""

NAME_WORTH = 0.85
"""How sure a name is whose ends are not sure at all, were all of its time called so."""

DIFFERS_BELOW = 0.65
"""A name less sure than this is squeezed onto a stretch that is not its phase: one is missing,
doubled or in another order. Of recordings that do not differ nineteen in twenty are surer."""

_BIAS, _FIT, _SPREAD, _EVIDENCE = 2.9, -2.2, -2.0, 1.2
_MAX_ALIGNED = 3


@dataclass(frozen=True)
class ProposedPhase:
    """A phase proposed from others, and how sure its name is.

    brief  it was taught as so short that nothing is told by how well it fits
    """

    start_s: float
    end_s: float
    name: str
    kept: bool
    confidence: float
    brief: bool = False


@dataclass(frozen=True, eq=False)
class Transfer:
    """What is proposed for one recording.

    outlier         it fits none of the finished ones; nothing is proposed then
    cost            how badly the best of them fits
    teachers        the names of those it was proposed from, the best first
    done_otherwise  which phases are missing, done again or in another order
    """

    name: str
    boundaries: tuple[ProposedBoundary, ...]
    phases: tuple[ProposedPhase, ...]
    outlier: bool
    cost: float
    teachers: tuple[str, ...]
    done_otherwise: Difference | None = None

    @property
    def differs(self) -> Difference | None:
        """How its phases differ from those of the finished ones; None where they do not: done in
        another order, or one that is kept and hardly is what it is called."""
        kept = [phase for phase in self.phases if phase.kept and not phase.brief]
        least = min(kept, key=lambda one: one.confidence, default=None)
        if self.done_otherwise or least is None or least.confidence >= DIFFERS_BELOW:
            return self.done_otherwise
        told = "fits badly: a phase may be missing, doubled or in another order"
        return Difference(least.name, f"{quoted(least.name)} {told}")


def propose(
    taught: Taught | Sequence[Taught],
    demonstration: Demonstration,
    segmentation: Segmentation | None = None,
    *,
    usual_cost: float | None = None,
    phases: Sequence[TaskPhase] = (),
) -> Transfer:
    """Boundaries and names for a demonstration, from finished recordings of the same task.

    `taught` is what they teach (`taught_by`), of one or of several.
    `segmentation` is its own, whose evidence boundaries are moved to. `usual_cost` is how badly
    recordings of this task fit each other (`usual_cost_of`); a much worse fit is an outlier.
    `phases` are the task's, of which some may be missing or come again without that it differs.

    Raises LabelingError where nothing was taught.
    """
    taught = [taught] if isinstance(taught, Taught) else taught
    if not taught:
        raise LabelingError("Expected finished recordings to learn from, but there is none.")
    signals = signals_of(demonstration)
    places = NO_PLACES if segmentation is None else places_of(segmentation)
    aligned = [Teacher(one, align(one.signals, signals)) for one in _nearest(taught, signals)]
    aligned.sort(key=lambda teacher: teacher.alignment.cost)
    best, cost = aligned[0].taught, aligned[0].alignment.cost
    if cost > _limit(usual_cost):
        return Transfer(demonstration.name, (), (), True, cost, (best.name,))
    done_otherwise, stands = as_done(aligned, signals, phases)
    best, limit = aligned[0].taught, NEARLY_AS_GOOD * cost
    fitting = [one for one in aligned if one.alignment.cost <= limit]
    same = [one for one in fitting if one.taught.names == best.names]
    boundaries = _boundaries(same if stands is aligned else stands, signals, places)
    own = segmentation and own_where_better(fitting, aligned, boundaries, segmentation)
    fit = PhaseFit(stands[0], signals)
    named = _phases(fit, own or (), demonstration, joined=False, rests=stands is aligned)
    if own is None or (_same_but_for_rests(own, named, boundaries) and not means_own(aligned)):
        named = _phases(fit, boundaries, demonstration, joined=True)
    else:
        boundaries = own
    inner = {phase.end_s for phase in named[:-1]}
    boundaries = tuple(b for b in boundaries if b.time_s in inner)
    teachers = tuple(one.taught.name for one in same)
    return Transfer(demonstration.name, boundaries, named, False, cost, teachers, done_otherwise)


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
    teachers: Sequence[Teacher], signals: Signals, places: Places
) -> tuple[ProposedBoundary, ...]:
    best, alignment = teachers[0].taught, teachers[0].alignment
    ends = placed_ends(teachers, signals, places)
    if ends is None:
        return ()
    return tuple(
        ProposedBoundary(
            end.time_s,
            _confidence(alignment.residual_near(phase.end_s), end.spread_s, end.probability),
            phase.ends_in_contact,
            end.evidence_s if end.probability > 0.0 else None,
        )
        for phase, end in zip(best.phases[:-1], ends, strict=True)
    )


def _confidence(residual: float, spread_s: float, probability: float) -> float:
    z = _BIAS + _FIT * residual + _SPREAD * min(spread_s, 1.0) + _EVIDENCE * (probability - 0.5)
    return float(1.0 / (1.0 + np.exp(-z)))


def _name_confidence(share: float, sure: float) -> float:
    """A name is right far more often than its ends: half a phase under it is enough."""
    return float(np.sqrt(share)) * (NAME_WORTH + (1.0 - NAME_WORTH) * sure)


def _same_but_for_rests(
    own: Sequence[ProposedBoundary],
    phases: Sequence[ProposedPhase],
    proposed: Sequence[ProposedBoundary],
) -> bool:
    """Whether the program finds another number only by rests that belong to phases: then nothing
    is missing or doubled."""
    if not len(own) != len(proposed) == len(phases) - 1:
        return False
    pairs = zip(phases[:-1], proposed, strict=True)
    return all(abs(phase.end_s - one.time_s) <= REACH_S for phase, one in pairs)


def _limit(usual_cost: float | None) -> float:
    """The cost from which on a recording is an outlier."""
    if usual_cost is None:
        return MAX_COST
    return min(MAX_COST, max(OUTLIER_FACTOR * usual_cost, LEAST_LIMIT))


def _phases(
    fit: PhaseFit,
    boundaries: Sequence[ProposedBoundary],
    demonstration: Demonstration,
    *,
    joined: bool,
    rests: bool = True,
) -> tuple[ProposedPhase, ...]:
    """Each phase is called what most of its time is called in the best fitting recording.

    `joined`: neighbours that are parts of one phase there are one phase here, too; else only a rest
    that the finished recording has not, and what it interrupts; nor that without `rests`.
    """
    best, alignment = fit.teacher.taught, fit.teacher.alignment
    edges = [demonstration.start_s, *(b.time_s for b in boundaries), demonstration.end_s]
    sure = [1.0, *(b.confidence for b in boundaries), 1.0]
    inner = [phase.end_s for phase in best.phases[:-1]]
    at = np.searchsorted(inner, alignment.from_s, side="right")
    found: list[ProposedPhase] = []
    before, rested = -1, False
    for i in range(len(edges) - 1):
        inside = (alignment.to_s >= edges[i]) & (alignment.to_s <= edges[i + 1])
        votes = np.bincount(at[inside], minlength=len(best.phases))
        index = int(np.argmax(votes))
        phase = best.phases[index]
        share = float(votes.max() / max(votes.sum(), 1))
        confidence = _name_confidence(share, min(sure[i], sure[i + 1]))
        confidence *= fit.of(index, edges[i], edges[i + 1])
        start_s = edges[i]
        resting = rests and fit.rests(edges[i], edges[i + 1])
        if index == before and (joined or resting or rested):
            last = found.pop()
            start_s, confidence = last.start_s, min(confidence, last.confidence)
        before, rested = index, resting
        brief = alignment.tempo * (phase.end_s - phase.start_s) < BRIEF_S
        found.append(
            ProposedPhase(start_s, edges[i + 1], phase.name, phase.kept, confidence, brief)
        )
    return tuple(found)
