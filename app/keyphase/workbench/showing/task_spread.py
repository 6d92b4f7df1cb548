"""How far the finished demonstrations of a task lie apart along its way, as the scene draws it."""

from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from keyphase.demonstration import Array
from keyphase.errors import KeyphaseError, SkillError
from keyphase.labeling.labeling import LabeledSegment, Labeling
from keyphase.skills.many import MeanDemonstration, mean_of
from keyphase.workbench.desks.open_recording import OpenRecording
from keyphase.workbench.recordings import Recording

POINTS = 160
"""So many places along the way are drawn."""

MOST_FINISHED = 30
"""So many other recordings are looked at."""


@dataclass(frozen=True, eq=False)
class TaskSpread:
    """The mean of several demonstrations of the same phases, and their distance from it.

    position_m  (M,3) where the mean is
    spread_m    (M,) root mean square distance of the demonstrations from it
    segment     (M,) index of the segment of the shown recording that is the same phase
    count       how many demonstrations there are
    """

    position_m: Array
    spread_m: Array
    segment: Array
    count: int


def finished_beside(
    recording: Recording,
    lines: Iterable[Recording],
    look: Callable[[Recording], OpenRecording],
) -> list[Labeling]:
    """The finished recordings of its folder, as they stand on disk, itself left out."""
    found: list[Labeling] = []
    for line in lines:
        beside = line.path.parent == recording.path.parent and line.id != recording.id
        if not beside or line.state != "done" or len(found) == MOST_FINISHED:
            continue
        with suppress(KeyphaseError):
            opened = look(line)
            opened.close()
            found.append(opened.kept_labeling)
    return found


def phases_of(labeling: Labeling) -> tuple[LabeledSegment, ...]:
    """What is executed, in the order of the plan."""
    return tuple(labeling.segments[entry.segment] for entry in labeling.plan)


def task_spread(shown: Labeling, others: Sequence[Labeling]) -> TaskSpread:
    """The spread of a recording and of the `others` that have the same phases in the same order.

    Raises SkillError where there is no such other, or the plan is not in the order of time.
    """
    alike = [one for one in others if _names(one) == _names(shown) and _in_order(one)]
    if not alike:
        raise SkillError(
            "The spread needs another recording of this folder that is done (K) and has the same "
            f"phases: {', '.join(_names(shown)) or 'this one has none'}."
        )
    mean = mean_of([(one.segmentation.demonstration, phases_of(one)) for one in (shown, *alike)])
    return _drawn(mean, [entry.segment for entry in shown.plan])


def _names(labeling: Labeling) -> list[str]:
    return [phase.label for phase in phases_of(labeling)]


def _in_order(labeling: Labeling) -> bool:
    return all(later.start_s >= one.end_s for one, later in pairwise(phases_of(labeling)))


def _drawn(mean: MeanDemonstration, numbers: Sequence[int]) -> TaskSpread:
    """At even times of the phases; what lies between them is not part of the task."""
    time_s = mean.demonstration.time_s
    starts = np.array([segment.start_s for segment in mean.segments])
    ends = np.array([segment.end_s for segment in mean.segments])
    phase = np.searchsorted(starts, time_s, side="right") - 1
    inside = np.flatnonzero((phase >= 0) & (time_s <= ends[np.maximum(phase, 0)]))
    chosen = inside[np.linspace(0, len(inside) - 1, min(POINTS, len(inside))).astype(np.intp)]
    return TaskSpread(
        mean.demonstration.position_m[chosen],
        mean.spread_m[chosen],
        np.asarray(numbers)[phase[chosen]],
        mean.count,
    )
