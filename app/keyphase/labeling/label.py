"""`label`: a segmentation with a person's edits over it; docs/labeling.md has the rules."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from keyphase.demonstration import Demonstration
from keyphase.labeling.applying import applied
from keyphase.labeling.assessment import NOTHING_SAID, Assessment
from keyphase.labeling.boundary_line import Mark
from keyphase.labeling.colors import colors_of, ranked_colors
from keyphase.labeling.edits import Edit
from keyphase.labeling.edits.beside.assess import assessment_of
from keyphase.labeling.edits.beside.assess_segment import segment_assessments
from keyphase.labeling.frozen import Frozen
from keyphase.labeling.labeling import Inapplicable, LabeledSegment, Labeling
from keyphase.labeling.plan import planned
from keyphase.labeling.spans import Decision, assign
from keyphase.labeling.walk import Walk
from keyphase.segmentation.end_condition import ContactEnd, EndCondition, agrees, ends_in_contact
from keyphase.segmentation.end_condition.agreement import LEAST_S, met_beside_s
from keyphase.segmentation.end_condition.dragged import still_ends
from keyphase.segmentation.segmentation import Segment, Segmentation

Describe = Callable[[float, float, bool], Segment]
"""The segment from start to end [s] as the program would propose it, given whether it ends with a
contact change; `Segmenter.segment_between` is one."""


def label(
    segmentation: Segmentation,
    edits: Mapping[int, Edit] = MappingProxyType({}),
    describe: Describe | None = None,
) -> Labeling:
    """The segmentation with edits applied in order.

    `edits` are anchored edits (see `BaseEdit.anchored`) by their number, in the order they were
    made. Nothing is refused: an edit whose place is gone is listed as inapplicable, and applies
    again as soon as the parameters bring its place back. `describe` says what a segment with new
    ends is; where edits come often, pass `segment_between` of the segmenter at hand.
    """
    done = applied(segmentation, edits)
    known = _known(segmentation, done.frozen)
    found = _segments(segmentation, known, done.line.marks, describe)
    middles = [0.5 * (segment.start_s + segment.end_s) for segment in found]
    labels, unlabeled = assign(done.labels, middles)
    kept, unkept = _kept(done, found, middles)
    ends, unended = assign(done.ends, middles)
    found = _ended(segmentation.demonstration, found, ends)
    said, unsaid = assign(segment_assessments(edits), middles)
    colors = colors_of(known, _numbers(known, done.frozen), found)
    segments = _labeled(found, labels, kept, colors, said)
    return Labeling(
        segmentation,
        tuple(mark.as_boundary() for mark in done.line.marks),
        segments,
        planned(done.plan, segments),
        tuple(i for i, segment in enumerate(found) if segment.idle and i not in kept),
        _inapplicable(done.missed, unlabeled, unkept, unended, unsaid),
        done=done.frozen is not None,
        changed_since_done=done.frozen is not None and done.edits_applied > 1,
        made_with=done.frozen.made_with() if done.frozen else None,
        assessment=assessment_of(edits),
    )


def _known(segmentation: Segmentation, frozen: Frozen | None) -> tuple[Segment, ...]:
    """The segments as they are without a person's edits, or as they were when it was done."""
    if frozen is None:
        return segmentation.segments
    return tuple(segment.as_segment() for segment in frozen.segments)


def _numbers(known: Sequence[Segment], frozen: Frozen | None) -> tuple[int, ...]:
    if frozen is None:
        return ranked_colors(known)
    return tuple(segment.color for segment in frozen.segments)


def _segments(
    segmentation: Segmentation,
    known: Sequence[Segment],
    marks: Sequence[Mark],
    describe: Describe | None,
) -> list[Segment]:
    """The known segments where nothing changed at their ends, else described anew."""
    by_span = {(s.start_s, s.end_s): s for s in known}
    by_end = {s.end_s: s.end_condition for s in known}
    demonstration = segmentation.demonstration
    times = [demonstration.start_s, *(mark.time_s for mark in marks), demonstration.end_s]
    contacts = [False, *(mark.contact_change for mark in marks), False]
    changed = [False, *(_is_changed(mark) for mark in marks), False]
    segments: list[Segment] = []
    for i in range(len(times) - 1):
        same = None if changed[i] or changed[i + 1] else by_span.get((times[i], times[i + 1]))
        if same is None:
            describe = describe or _segmenter_of(segmentation)
            start_s, end_s = times[i], times[i + 1]
            begun_s = _begun_s(demonstration, segments[-1], end_s) if changed[i] else start_s
            last = i == len(marks) and ends_in_contact(demonstration, begun_s)
            found = describe(begun_s, end_s, contacts[i + 1] or last)
            same = replace(found, start_s=start_s)
            if i < len(marks) and contacts[i + 1]:
                kept = _kept_end(demonstration, (begun_s, end_s), marks[i], by_end)
                same = replace(same, end_condition=kept or same.end_condition)
        segments.append(same)
    return segments


def _begun_s(demonstration: Demonstration, before: Segment, end_s: float) -> float:
    """Where what a segment is begins [s]: at the contact of the one before, if cut beside it.

    The way into that contact says nothing about what follows it.
    """
    met_s = met_beside_s(demonstration, before.start_s, before.end_s, before.end_condition)
    return before.end_s if met_s is None or end_s - met_s < LEAST_S else met_s


def _segmenter_of(segmentation: Segmentation) -> Describe:
    from keyphase.segmentation.segmenter import Segmenter

    return Segmenter(segmentation.demonstration).segment_between


def _kept_end(
    demonstration: Demonstration,
    span_s: tuple[float, float],
    mark: Mark,
    known: Mapping[float, EndCondition],
) -> ContactEnd | None:
    """The condition, `known` by where segments ended, of a contact whose boundary was moved."""
    found = mark.frozen or mark.automatic
    if found is None or not isinstance(end := known.get(found.time_s), ContactEnd):
        return None
    return end if still_ends(demonstration, span_s, end, found.time_s) else None


def _is_changed(mark: Mark) -> bool:
    if mark.frozen is not None:
        return not mark.as_frozen
    found = mark.automatic
    return mark.by_hand or found is None or found.contact_change != mark.contact_change


def _kept(
    done: Walk, found: Sequence[Segment], middles_s: Sequence[float]
) -> tuple[dict[int, bool], list[Decision[bool]]]:
    """What was decided about each segment; dropping the idle ones overrules what came before."""
    split = done.decided_before_idle or 0
    before, homeless_before = assign(done.keeps[:split], middles_s)
    after, homeless_after = assign(done.keeps[split:], middles_s)
    idle = range(len(found)) if done.decided_before_idle is not None else ()
    dropped = {i: False for i in idle if found[i].idle}
    return {**before, **dropped, **after}, homeless_before + homeless_after


def _ended(
    demonstration: Demonstration, found: Sequence[Segment], ends: Mapping[int, EndCondition | None]
) -> list[Segment]:
    """The segments with the end conditions a person gave, each tried on the demonstration."""
    ended = list(found)
    for index, end in ends.items():
        if end is None:
            continue
        segment = ended[index]
        if isinstance(end, ContactEnd):
            does = agrees(demonstration, segment.start_s, segment.end_s, end)
            end = replace(end, agrees=does)
        ended[index] = replace(segment, end_condition=end)
    return ended


def _labeled(
    found: Sequence[Segment],
    labels: Mapping[int, str],
    kept: Mapping[int, bool],
    colors: Sequence[int],
    said: Mapping[int, Assessment],
) -> tuple[LabeledSegment, ...]:
    return tuple(
        LabeledSegment(
            segment.start_s,
            segment.end_s,
            labels.get(i) or segment.label,
            proposed=not labels.get(i),
            kept=kept.get(i, not segment.idle),
            idle=segment.idle,
            color=colors[i],
            end_condition=segment.end_condition,
            assessment=said.get(i, NOTHING_SAID),
        )
        for i, segment in enumerate(found)
    )


def _inapplicable(
    missed: Sequence[Inapplicable],
    unlabeled: Sequence[Decision[str]],
    unkept: Sequence[Decision[bool]],
    unended: Sequence[Decision[EndCondition | None]],
    unsaid: Sequence[Decision[Assessment]],
) -> tuple[Inapplicable, ...]:
    by_edit = {each.edit: each for each in missed}
    for decision in unlabeled:
        text = f"Label “{decision.value}”{_where(decision)}: that segment is no longer found."
        by_edit.setdefault(decision.edit, Inapplicable(decision.edit, text))
    for decision in unkept:
        what = "Kept" if decision.value else "Dropped"
        text = f"{what}{_where(decision)}: that segment is no longer found."
        by_edit.setdefault(decision.edit, Inapplicable(decision.edit, text))
    for decision in unended:
        text = f"End condition{_where(decision)}: that segment is no longer found."
        by_edit.setdefault(decision.edit, Inapplicable(decision.edit, text))
    for decision in unsaid:
        text = f"Mark{_where(decision)}: that segment is no longer found."
        by_edit.setdefault(decision.edit, Inapplicable(decision.edit, text))
    return tuple(by_edit[number] for number in sorted(by_edit))


def _where(decision: Decision[Any]) -> str:
    start, end = decision.span.span_s
    return f" from {start:.2f} to {end:.2f} s"
