"""One recording taught by others: what arrives, and what two simpler ways would have given."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from transferring.known import Known

from keyphase.labeling.comparing.matching import match_times
from keyphase.scoring.counting import Tally, tally, together
from keyphase.scoring.truth import Truth
from keyphase.segmentation import segment
from keyphase.segmentation.segmentation import Segmentation
from keyphase.transfer.proposing import Transfer, propose, usual_cost_of
from keyphase.transfer.taught import Phase, Taught, taught_from

METHODS = ("proposed", "stretched in time", "program alone")
GOALS = {1: 0.95, 3: 0.97}


@dataclass(frozen=True, eq=False)
class Tried:
    """Counts and shares of one recording by method; the shares of time with the right name.

    sure_boundaries, sure_names  confidence, and whether it was right
    """

    counts: dict[str, Tally]
    names: dict[str, float]
    outlier: bool
    differs: bool
    sure_boundaries: list[tuple[float, bool]] = field(default_factory=list)
    sure_names: list[tuple[float, bool]] = field(default_factory=list)


def taught_by_truth(known: Known) -> Taught:
    """What a person who knows the truth would teach."""
    demonstration = known.demonstration
    edges = [demonstration.start_s, *known.ends_s, demonstration.end_s]
    own = segmentation_of(known)
    contacts = np.array([b.time_s for b in own.boundaries if b.contact_change] or [np.inf])
    phases = tuple(
        Phase(edges[i], edges[i + 1], name, True, bool(np.abs(contacts - edges[i + 1]).min() < 0.2))
        for i, name in enumerate(known.names)
    )
    return taught_from(own, phases)


_SEGMENTED: dict[int, tuple[Known, Segmentation]] = {}
"""By id, which the recording kept beside keeps from being given to another."""


def segmentation_of(known: Known) -> Segmentation:
    """What the program finds by itself."""
    key = id(known)
    if key not in _SEGMENTED:
        _SEGMENTED[key] = known, segment(known.demonstration)
    return _SEGMENTED[key][1]


def tries(known: Sequence[Known], teachers: Sequence[int]) -> list[Tried]:
    """Each of the others, taught by these."""
    taught = [taught_by_truth(known[i]) for i in teachers]
    return tries_of(taught, [one for i, one in enumerate(known) if i not in teachers])


def tries_of(taught: Sequence[Taught], others: Sequence[Known]) -> list[Tried]:
    """Each of some recordings, taught by these."""
    usual = usual_cost_of(taught)
    return [_try(taught, usual, one) for one in others]


def _try(taught: Sequence[Taught], usual: float | None, known: Known) -> Tried:
    own = segmentation_of(known)
    found = propose(taught, known.demonstration, own, usual_cost=usual)
    alone = [b.time_s for b in own.boundaries]
    # On an outlier nothing is proposed: what the program found by itself stands.
    proposed = alone if found.outlier else [b.time_s for b in found.boundaries]
    stretched = _stretched(taught[0], known)
    times = {
        "proposed": proposed,
        "stretched in time": stretched,
        "program alone": alone,
    }
    truth = Truth(known.ends_s, known.ignore_s, known.tolerance_s)
    names = {"proposed": _share(known, proposed, [phase.name for phase in found.phases])}
    names["stretched in time"] = _share(known, stretched, taught[0].names)
    return Tried(
        {method: tally(truth, some) for method, some in times.items()},
        names if known.named else {},
        found.outlier,
        found.differs is not None,
        _sure_boundaries(known, found),
        _sure_names(known, found) if known.named else [],
    )


def _stretched(first: Taught, known: Known) -> list[float]:
    start_s, end_s = first.phases[0].start_s, first.phases[-1].end_s
    own = known.demonstration
    shares = [(one - start_s) / (end_s - start_s) for one in first.ends_s]
    return [own.start_s + share * own.duration_s for share in shares]


def _share(known: Known, ends_s: Sequence[float], names: Sequence[str]) -> float:
    """Part of the time that has its right name."""
    if not names:
        return 0.0
    grid = np.linspace(known.demonstration.start_s, known.demonstration.end_s, 2001)
    truth = np.array(known.names)[np.searchsorted(known.ends_s, grid)]
    given = np.array(names)[np.searchsorted(ends_s, grid)]
    return float((truth == given).mean())


def _sure_boundaries(known: Known, found: Transfer) -> list[tuple[float, bool]]:
    times = [b.time_s for b in found.boundaries]
    right = {m.found for m in match_times(known.ends_s, times, known.tolerance_s)}
    return [
        (b.confidence, i in right)
        for i, b in enumerate(found.boundaries)
        if i in right or not any(low <= b.time_s <= high for low, high in known.ignore_s)
    ]


def _sure_names(known: Known, found: Transfer) -> list[tuple[float, bool]]:
    """A name is right where most of its phase's time is called so in truth."""
    sure = []
    for phase in found.phases:
        grid = np.linspace(phase.start_s, phase.end_s, 101)
        truth = np.array(known.names)[np.searchsorted(known.ends_s, grid)]
        sure.append((phase.confidence, bool((truth == phase.name).mean() > 0.5)))
    return sure


def row(task: str, count: int, tried: Sequence[Tried], *, simulated: bool) -> tuple[str, bool]:
    """A line of the table, and whether it meets its goal."""
    f1 = {name: together([one.counts[name] for one in tried]).f1 or 0.0 for name in METHODS}
    names = {name: _mean([one.names.get(name) for one in tried]) for name in METHODS}
    cells = (f"{f1[name]:>14.3f} / {_shown(names[name])}" for name in METHODS)
    away = sum(one.outlier for one in tried)
    line = f"{task:28}{count:>7}{''.join(cells)}   {away} of {len(tried)} taken for outliers"
    mine = f1["proposed"]
    if simulated:
        return line, mine >= GOALS[count] and (names["proposed"] or 0.0) >= GOALS[count]
    return line, mine > max(f1["stretched in time"], f1["program alone"])


def _mean(values: Sequence[float | None]) -> float | None:
    given = [value for value in values if value is not None]
    return float(np.mean(given)) if given else None


def _shown(value: float | None) -> str:
    return "    –" if value is None else f"{value:.3f}"
