"""The boundaries and segments that a person means by a time, and whether there is room."""

from keyphase.errors import LabelingError
from keyphase.labeling.boundary_line import REACH_S, SAME_S
from keyphase.labeling.labeling import LabeledBoundary, LabeledSegment, Labeling
from keyphase.labeling.spans import Span


def boundary_at(time_s: float, labeling: Labeling) -> LabeledBoundary:
    """The boundary nearest to a time. Raises LabelingError where none is within reach."""

    def distance(boundary: LabeledBoundary) -> float:
        return abs(boundary.time_s - time_s)

    nearest = min(labeling.boundaries, key=distance, default=None)
    if nearest is None or distance(nearest) > REACH_S:
        raise LabelingError(
            f"Expected a boundary at {time_s:.3f} s, but there is none within {REACH_S} s; "
            "pick one that is shown."
        )
    return nearest


def segment_at(time_s: float, labeling: Labeling) -> LabeledSegment:
    """The segment around a time. Raises LabelingError where it is outside the recording."""
    demonstration = labeling.segmentation.demonstration
    if not demonstration.start_s <= time_s <= demonstration.end_s:
        raise LabelingError(
            f"Expected a time inside the recording, from {demonstration.start_s:.3f} to "
            f"{demonstration.end_s:.3f} s, but {time_s:.3f} s was given."
        )
    return labeling.segments[labeling.segment_at(time_s)]


def stretch_at(time_s: float, to_s: float | None, labeling: Labeling) -> list[LabeledSegment]:
    """The segments from the one around a time to the one around another, which may be left out.

    Raises LabelingError where either time is outside the recording.
    """
    ends = (segment_at(time, labeling) for time in (time_s, time_s if to_s is None else to_s))
    first, last = sorted(ends, key=lambda one: one.start_s)
    return [one for one in labeling.segments if first.start_s <= one.start_s <= last.start_s]


def span_of(segment: LabeledSegment) -> Span:
    """Start and end of a segment [s]."""
    return segment.start_s, segment.end_s


def check_room(time_s: float, labeling: Labeling, moving: LabeledBoundary | None = None) -> None:
    """Raise LabelingError where no boundary can be put at `time_s`."""
    demonstration = labeling.segmentation.demonstration
    gap = 1.0 / demonstration.rate_hz
    low, high = demonstration.start_s + gap, demonstration.end_s - gap
    if not low <= time_s <= high:
        raise LabelingError(
            f"A boundary must lie inside the recording, from {low:.3f} to {high:.3f} s, but "
            f"{time_s:.3f} s was given."
        )
    room = max(SAME_S, gap)
    for boundary in labeling.boundaries:
        if boundary is not moving and abs(boundary.time_s - time_s) < room:
            raise LabelingError(
                f"There is a boundary at {boundary.time_s:.3f} s already, less than {room:.2f} s "
                f"from {time_s:.3f} s; move that one, or keep clear of it."
            )


def boundary_number(time_s: float, labeling: Labeling) -> int:
    """The number, from 1, under which a boundary is shown."""
    return labeling.segment_at(time_s)


def segment_number(time_s: float, labeling: Labeling) -> int:
    """The number, from 1, under which a segment is shown."""
    return labeling.segment_at(time_s) + 1


def segments_numbered(time_s: float, to_s: float | None, labeling: Labeling) -> str:
    """What one segment, or several in a row, are called in the name of a step."""
    first = segment_number(time_s, labeling)
    return (
        f"segment {first}"
        if to_s is None
        else (f"segments {first} to {segment_number(to_s, labeling)}")
    )
