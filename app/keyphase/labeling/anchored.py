"""Completing an edit with what it needs to find its place again, and refusing what makes no sense.

What comes in says what a person wants, at the times that person saw; what goes out holds the
exact times of the boundaries and the spans of the segments that are meant.
"""

from dataclasses import replace

from keyphase.errors import LabelingError
from keyphase.labeling.boundary_line import REACH_S, SAME_S
from keyphase.labeling.edits import (
    Accept,
    AcceptLabels,
    Add,
    BringBack,
    Contact,
    DropIdle,
    Edit,
    Forget,
    Keep,
    Label,
    Merge,
    Move,
    Plan,
    Remove,
    Reset,
    Span,
    TakeOver,
    check_label,
)
from keyphase.labeling.labeling import LabeledBoundary, LabeledSegment, Labeling


def anchored(edit: Edit, labeling: Labeling) -> Edit:
    """The edit, completed from the labeling a person saw when making it.

    Raises LabelingError, with the reason, for an edit that cannot be made there: no boundary
    within reach, no room, a time outside the recording, a plan of dropped segments, or nothing
    that would change.
    """
    match edit:
        case Add():
            return _add(edit, labeling)
        case Remove(time_s) | Accept(time_s) | Contact(time_s, _):
            return replace(edit, time_s=_boundary(time_s, labeling).time_s)
        case Move():
            return _move(edit, labeling)
        case Merge():
            return _merge(edit, labeling)
        case Label(time_s, label, _):
            segment = _segment(time_s, labeling)
            return Label(segment.middle_s, check_label(label), _span(segment))
        case Keep(time_s, kept, _):
            segment = _segment(time_s, labeling)
            return Keep(segment.middle_s, kept, _span(segment))
        case Plan():
            return _plan(edit, labeling)
        case AcceptLabels():
            return _accept_labels(labeling)
        case DropIdle():
            return _drop_idle(labeling)
        case BringBack(number) | Forget(number):
            if all(number != each.edit for each in labeling.inapplicable):
                raise LabelingError(
                    f"Edit {number} has not lost its place; there is nothing to do."
                )
            return edit
        case Reset() | TakeOver():
            return edit


def _add(edit: Add, labeling: Labeling) -> Add:
    _check_room(edit.time_s, labeling, moving=None)
    if edit.contact_change is not None:
        return edit
    return Add(edit.time_s, _force_changes(edit.time_s, labeling))


def _force_changes(time_s: float, labeling: Labeling) -> bool:
    """Whether a peak of the error lies there after which the force stays changed."""
    least = labeling.segmentation.parameters.persistence
    return any(
        abs(peak.time_s - time_s) <= REACH_S and peak.persistence >= least
        for peak in labeling.segmentation.peaks
    )


def _move(edit: Move, labeling: Labeling) -> Move:
    boundary = _boundary(edit.from_s, labeling)
    index = labeling.boundaries.index(boundary)
    before = labeling.segments[index].start_s
    after = labeling.segments[index + 1].end_s
    if not before < edit.to_s < after:
        raise LabelingError(
            f"A boundary stays between its neighbours, here from {before:.3f} to {after:.3f} s, "
            f"but was moved to {edit.to_s:.3f} s; merge the segments in between first."
        )
    _check_room(edit.to_s, labeling, moving=boundary)
    return Move(boundary.time_s, edit.to_s)


def _check_room(time_s: float, labeling: Labeling, moving: LabeledBoundary | None) -> None:
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


def _boundary(time_s: float, labeling: Labeling) -> LabeledBoundary:
    def distance(boundary: LabeledBoundary) -> float:
        return abs(boundary.time_s - time_s)

    nearest = min(labeling.boundaries, key=distance, default=None)
    if nearest is None or distance(nearest) > REACH_S:
        raise LabelingError(
            f"Expected a boundary at {time_s:.3f} s, but there is none within {REACH_S} s; "
            "pick one that is shown."
        )
    return nearest


def _segment(time_s: float, labeling: Labeling) -> LabeledSegment:
    demonstration = labeling.segmentation.demonstration
    if not demonstration.start_s <= time_s <= demonstration.end_s:
        raise LabelingError(
            f"Expected a time inside the recording, from {demonstration.start_s:.3f} to "
            f"{demonstration.end_s:.3f} s, but {time_s:.3f} s was given."
        )
    return labeling.segments[labeling.segment_at(time_s)]


def _span(segment: LabeledSegment) -> Span:
    return segment.start_s, segment.end_s


def _merge(edit: Merge, labeling: Labeling) -> Merge:
    low, high = sorted((edit.from_s, edit.to_s))
    between = [b.time_s for b in labeling.boundaries if low < b.time_s < high]
    if not between:
        raise LabelingError(
            f"Expected a boundary between {low:.3f} and {high:.3f} s to merge over, but there is "
            "none; choose a stretch over several segments."
        )
    # Anchored at the middles of the outer segments, so that their own sides may wander.
    first = labeling.segments[labeling.segment_at(between[0]) - 1]
    last = labeling.segments[labeling.segment_at(between[-1])]
    return Merge(first.middle_s, last.middle_s)


def _plan(edit: Plan, labeling: Labeling) -> Plan:
    segments = [_segment(time, labeling) for time in edit.order]
    for segment in segments:
        if not segment.kept:
            raise LabelingError(
                f"The plan holds kept segments only, but “{segment.label}” at "
                f"{segment.start_s:.3f} s is dropped; keep it first."
            )
    left_out = [s for s in labeling.segments if s.kept and s not in segments]
    return Plan(
        tuple(segment.middle_s for segment in segments),
        tuple(_span(segment) for segment in segments),
        tuple(_span(segment) for segment in left_out),
    )


def _accept_labels(labeling: Labeling) -> AcceptLabels:
    proposed = [s for s in labeling.segments if s.proposed and s.kept and s.label]
    if not proposed:
        raise LabelingError("Every kept segment has a label of yours; there is none to accept.")
    return AcceptLabels(tuple(Label(s.middle_s, s.label, _span(s)) for s in proposed))


def _drop_idle(labeling: Labeling) -> DropIdle:
    if not any(s.idle and s.kept for s in labeling.segments) and not labeling.proposed_drops:
        raise LabelingError("No idle segment is left to drop.")
    return DropIdle()
