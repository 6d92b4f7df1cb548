"""Whether persons who put boundaries beside the program's mean other places, or mark without care.

Who means another place puts boundaries of one kind there every time: all ends of motion a little
late, all contacts a little early. Marks that lie now on one side, now on the other are noise.
"""

from collections.abc import Sequence

import numpy as np

from keyphase.transfer.placing import Teacher
from keyphase.transfer.taught import Taught

REACH_S = 0.4
"""Farther from the program's boundary a person's is another one, and not that one moved."""

ENOUGH = 5
"""So many boundaries more than kinds are needed to know how much a person's marks scatter."""


def meant_elsewhere_s(teachers: Sequence[Teacher]) -> float:
    """How far from the program's boundaries persons mean theirs, in the tempo of the new recording.

    The root mean square of the mean distance of each kind, less what the scatter within the kinds
    makes of it (analysis of variance); of few boundaries scatter cannot be told from intent, and
    that of all counts. Several recordings of the same phases tell it of each boundary by itself.
    Infinite where no boundary is near one of the program's.
    """
    each = len(teachers) > 1 and len({one.taught.names for one in teachers}) == 1
    kinds: dict[str | int, list[float]] = {}
    for one in teachers:
        own = range(len(one.taught.ends_s)) if each else one.taught.kinds
        for kind, offset in zip(own, offsets_s(one.taught), strict=True):
            if offset is not None:
                kinds.setdefault(kind, []).append(offset * one.alignment.tempo)
    groups = [np.array(offsets) for offsets in kinds.values()]
    count = sum(len(group) for group in groups)
    if not count:
        return np.inf
    between = sum(len(group) * group.mean() ** 2 for group in groups)
    within = sum(len(group) * group.var() for group in groups)
    if count - len(groups) < ENOUGH:
        return float(np.sqrt((between + within) / count))
    scatter = within / (count - len(groups))
    return float(np.sqrt(max(between - len(groups) * scatter, 0.0) / count))


def offsets_s(taught: Taught) -> list[float | None]:
    """How far each taught boundary lies from the program's; None where it found none there."""
    found = np.array(taught.found_s or [np.inf])
    nearest = [float(found[np.abs(found - end_s).argmin()]) for end_s in taught.ends_s]
    return [
        end_s - at if abs(end_s - at) <= REACH_S else None
        for end_s, at in zip(taught.ends_s, nearest, strict=True)
    ]
