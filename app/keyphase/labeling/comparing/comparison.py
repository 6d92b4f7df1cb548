"""Two segmentations of one recording: what they share, and how well they agree."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from keyphase.errors import LabelingError
from keyphase.labeling.comparing.matching import covering, match_times
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.segment_file import SegmentFile

DEFAULT_TOLERANCE_S = 0.25


@dataclass(frozen=True)
class Outline:
    """What is compared of a segmentation: its times and its labels, one more than boundaries."""

    boundaries_s: tuple[float, ...]
    labels: tuple[str, ...]
    span_s: tuple[float, float]

    @classmethod
    def of_labeling(cls, labeling: Labeling) -> "Outline":
        """The outline of what is open."""
        return cls(
            tuple(boundary.time_s for boundary in labeling.boundaries),
            tuple(segment.label for segment in labeling.segments),
            (labeling.segments[0].start_s, labeling.segments[-1].end_s),
        )

    @classmethod
    def of_file(cls, file: SegmentFile) -> "Outline":
        """The outline of a segment file, another person's for example."""
        return cls(
            tuple(boundary.time_s for boundary in file.boundaries),
            tuple(segment.label for segment in file.segments),
            (file.segments[0].start_s, file.segments[-1].end_s),
        )


@dataclass(frozen=True)
class SharedBoundary:
    """A boundary both have; the distance is positive where the second has it later."""

    first_s: float
    second_s: float

    @property
    def distance_s(self) -> float:
        """How much later the second has it."""
        return self.second_s - self.first_s


@dataclass(frozen=True)
class Comparison:
    """How two segmentations of one recording agree; swapping them changes only the names.

    shared               boundaries both have, within the tolerance, one to one
    only_first_s, only_second_s  boundaries the other does not have
    f1                   2 shared / (all of both); 1 where neither has any
    covering             mean of how each one's segments cover the other's, 0 to 1
    same_label           part of the time in which both have the same label, 0 to 1
    """

    shared: tuple[SharedBoundary, ...]
    only_first_s: tuple[float, ...]
    only_second_s: tuple[float, ...]
    f1: float
    covering: float
    same_label: float


def compare(
    first: Outline, second: Outline, tolerance_s: float = DEFAULT_TOLERANCE_S
) -> Comparison:
    """Compare two segmentations of one recording.

    Raises LabelingError where they do not span the same time.
    """
    if any(abs(a - b) > 1e-6 for a, b in zip(first.span_s, second.span_s, strict=True)):
        raise LabelingError(
            "Expected two segmentations of one recording, but one spans "
            f"{first.span_s[0]:.3f} to {first.span_s[1]:.3f} s and the other "
            f"{second.span_s[0]:.3f} to {second.span_s[1]:.3f} s; choose files of this recording."
        )
    a, b = first.boundaries_s, second.boundaries_s
    matches = match_times(a, b, tolerance_s)
    taken_a = {match.reference for match in matches}
    taken_b = {match.found for match in matches}
    total = len(a) + len(b)
    covers = covering(a, b, first.span_s), covering(b, a, first.span_s)
    return Comparison(
        shared=tuple(SharedBoundary(a[match.reference], b[match.found]) for match in matches),
        only_first_s=tuple(time for i, time in enumerate(a) if i not in taken_a),
        only_second_s=tuple(time for i, time in enumerate(b) if i not in taken_b),
        f1=2 * len(matches) / total if total else 1.0,
        covering=sum(covers) / 2,
        same_label=_same_label(first, second),
    )


def _same_label(first: Outline, second: Outline) -> float:
    start, end = first.span_s
    edges = sorted({start, end, *first.boundaries_s, *second.boundaries_s})
    same = sum(
        high - low
        for low, high in pairwise(edges)
        if label_at(first, 0.5 * (low + high)) == label_at(second, 0.5 * (low + high))
    )
    return same / (end - start)


def label_at(outline: Outline, time_s: float) -> str:
    """What is said of a moment."""
    return outline.labels[_count_before(outline.boundaries_s, time_s)]


def _count_before(times_s: Sequence[float], time_s: float) -> int:
    return sum(time <= time_s for time in times_s)
