"""What there is to carry of a segmented recording, and what of it a format leaves behind."""

from collections.abc import Callable, Mapping, Sequence
from enum import Enum

from keyphase.writers.segmented import SegmentedRecording


class Carried(Enum):
    """One thing that a format may hold of a segmented recording; its value names it for people."""

    NAMES = "the segments' names"
    MOTIONS = "what each segment does, in keyphase's words"
    TIMES = "the segments' times to the microsecond"
    DROPPED = "which segments are dropped"
    ORDER = "the order and the repetitions of the plan"
    ENDS = "end conditions"
    DOUBTS = "origin, confidence and interval of the boundaries"
    PARAMETERS = "the parameters that found them"
    MARKS = "marks of success, quality and notes"
    SIGNALS = "the recorded signals"


EVERYTHING = frozenset(Carried)


def left_behind(
    carries: frozenset[Carried], items: Sequence[SegmentedRecording]
) -> tuple[str, ...]:
    """What is there in these recordings and not in a format that carries so much."""
    missing = [one for one in Carried if one not in carries]
    return tuple(one.value for one in missing if any(_THERE[one](item) for item in items))


def all_but(*left: Carried) -> frozenset[Carried]:
    """Everything without these."""
    return EVERYTHING.difference(left)


def _always(_item: SegmentedRecording) -> bool:
    return True


def _has_dropped(item: SegmentedRecording) -> bool:
    return any(not segment.kept for segment in item.segments)


def _is_reordered(item: SegmentedRecording) -> bool:
    return item.planned != item.kept


def _is_marked(item: SegmentedRecording) -> bool:
    file = item.file
    return any((file.assessment, *(segment.assessment for segment in file.segments)))


_THERE: Mapping[Carried, Callable[[SegmentedRecording], bool]] = {
    Carried.NAMES: _always,
    Carried.MOTIONS: _always,
    Carried.TIMES: lambda item: len(item.segments) > 1,
    Carried.DROPPED: _has_dropped,
    Carried.ORDER: _is_reordered,
    Carried.ENDS: _always,
    Carried.DOUBTS: lambda item: bool(item.file.boundaries),
    Carried.PARAMETERS: _always,
    Carried.MARKS: _is_marked,
    Carried.SIGNALS: _always,
}
