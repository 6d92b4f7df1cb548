"""The `document` message of a desk's state, with the reasons in words."""

from collections.abc import Sequence
from dataclasses import asdict
from functools import lru_cache
from typing import Any

import numpy as np
from msgspec import UNSET

from keyphase.demonstration import Array, Demonstration
from keyphase.labeling.edits.beside.camera_offset import camera_offsets
from keyphase.labeling.labeling import LabeledBoundary, LabeledSegment, Labeling, PlanEntry
from keyphase.logged import Event
from keyphase.notices import Caution, severity_of
from keyphase.oddities import breaks_of
from keyphase.segmentation.end_condition import ContactEnd, EndCondition
from keyphase.segmentation.segmentation import Candidate, Peak, Reason
from keyphase.web.protocol import document_messages as say
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.recordings import printable
from keyphase.workbench.showing import thresholds
from keyphase.workbench.showing.doubts import is_unsure
from keyphase.workbench.showing.force_steps import greatest_step
from keyphase.workbench.showing.reasons import Meeting, logged_near, sentences
from keyphase.workbench.showing.short_labels import short_labels

CONNECTING_MM = 1.0
"""A plan entry that starts nearer than this to where the last one ended needs no connection."""

MOST_REASONS = 4
"""So many reasons of a boundary are told."""

MAX_BREAKS = 200
"""So many gaps and jumps are drawn."""

MAX_EVENTS = 500
"""So many events of a log are drawn."""

_AXES = ("x", "y", "z")


@lru_cache(maxsize=8)
def document_message(state: DeskState) -> say.DocumentMessage:
    """What all pages at a recording are told of it; made once for all of them."""
    segmentation = state.labeling.segmentation
    return say.DocumentMessage(
        revision=state.revision,
        cause=state.cause and say.CauseMessage(state.cause.event, state.cause.page),
        id=state.recording.id,
        folder=printable(state.recording.path.parent.name),
        force_channels=segmentation.curve.channels if segmentation.curve else 0,
        edits=len(state.document.edits),
        notices=_notices(state),
        parameters=asdict(segmentation.parameters),
        threshold=segmentation.threshold,
        automatic_threshold=thresholds.automatic_threshold(segmentation),
        motion_threshold=segmentation.motion_threshold,
        automatic_motion_threshold=thresholds.automatic_motion_threshold(segmentation),
        automatic_least_step_N=segmentation.automatic_least_step_N,
        boundaries=boundaries_of(state.labeling),
        segments=_segments(state.labeling),
        peaks=tuple(map(_peak, segmentation.peaks)),
        gaussians=len(segmentation.gaussians),
        candidates=tuple(map(_candidate, segmentation.candidates)),
        line_counts=segmentation.line_counts,
        held_back=segmentation.held_back,
        plan=plan_of(state.labeling),
        proposed_drops=tuple(state.labeling.proposed_drops),
        inapplicable=tuple(state.labeling.inapplicable),
        undo=state.document.undo_name,
        redo=state.document.redo_name,
        saved_at=state.saved_at,
        greatest_step_N=greatest_step(state.labeling),
        state=state.state,
        changed_since_done=state.kept_labeling.changed_since_done,
        locked=state.locked and printable(state.locked),
        changed=state.changed,
        elsewhere=_elsewhere(state),
        labels=state.vocabulary.labels,
        assessment=state.labeling.assessment,
        camera_offsets=camera_offsets(state.document.edits),
        **_recorded(state.demonstration),
    )


def _recorded(demonstration: Demonstration) -> dict[str, Any]:
    """What the recording itself says."""
    return {
        "name": demonstration.name,
        "start_s": demonstration.start_s,
        "end_s": demonstration.end_s,
        "rate_hz": demonstration.rate_hz,
        "channels": channels(demonstration),
        "breaks": _breaks(demonstration),
        "events": _events(demonstration),
        "wrench_estimated": demonstration.wrench_estimated,
    }


def _elsewhere(state: DeskState) -> say.ElsewhereMessage | None:
    found = state.elsewhere
    return found and say.ElsewhereMessage(printable(found.name), found.steps, found.done)


@lru_cache(maxsize=8)
def _breaks(demonstration: Demonstration) -> tuple[say.BreakMessage, ...]:
    found = breaks_of(demonstration)[:MAX_BREAKS]
    return tuple(say.BreakMessage(*one.span_s, one.text) for one in found if one.span_s)


@lru_cache(maxsize=8)
def _events(demonstration: Demonstration) -> tuple[say.EventMessage, ...]:
    found = demonstration.happenings[:MAX_EVENTS]
    return tuple(say.EventMessage(one.time_s, printable(one.text)) for one in found)


def channels(demonstration: Demonstration) -> tuple[str, ...]:
    """Names of what was recorded."""
    recorded = {
        "position": demonstration.position_m,
        "orientation": demonstration.orientation_wxyz,
        "force": demonstration.force_N,
        "torque": demonstration.torque_Nm,
        "joints": demonstration.joints_rad,
        "gripper": demonstration.gripper,
    }
    own = (name for name, values in recorded.items() if values is not None)
    return (*own, *(f"channel/{name}" for name in demonstration.channels))


def ghosts(before: Labeling, now: Labeling) -> tuple[say.Ghost, ...]:
    """Boundaries that a change under way would bring or take."""
    old = {boundary.time_s: boundary for boundary in before.boundaries}
    new = {boundary.time_s: boundary for boundary in now.boundaries}
    comes = [say.Ghost(t, new[t].origin, "comes") for t in sorted(new.keys() - old.keys())]
    goes = [say.Ghost(t, old[t].origin, "goes") for t in sorted(old.keys() - new.keys())]
    return (*comes, *goes)


def _notices(state: DeskState) -> tuple[say.NoticeMessage, ...]:
    demonstration = state.demonstration
    broken_off = demonstration.metadata.get("recovered") is True
    lost = [Caution("Its recorder broke off; the last second at most is missing.")] * broken_off
    told = (*demonstration.notices, *lost, *state.notices)
    return tuple(say.NoticeMessage(printable(one), severity_of(one)) for one in told)


def boundaries_of(labeling: Labeling) -> tuple[say.BoundaryMessage, ...]:
    """The boundaries, each with its reasons."""
    segmentation = labeling.segmentation
    meeting = Meeting(segmentation.gaussians)
    happenings = segmentation.demonstration.happenings
    at_m = _at_m(segmentation.demonstration, [b.time_s for b in labeling.boundaries])
    return tuple(
        say.BoundaryMessage(
            time_s=boundary.time_s,
            origin=boundary.origin,
            interval_s=boundary.interval_s,
            confidence=boundary.confidence,
            contact_change=boundary.contact_change,
            change=boundary.automatic.change if boundary.automatic else "",
            was_s=boundary.was_s,
            taken_from=boundary.taken_from,
            accepted=boundary.accepted,
            unsure=is_unsure(boundary),
            at_m=position if boundary.contact_change else None,
            why=_why(boundary, segmentation.threshold, meeting, happenings),
        )
        for boundary, position in zip(labeling.boundaries, at_m, strict=True)
    )


def _why(
    boundary: LabeledBoundary,
    threshold: float | None,
    meeting: Meeting,
    happenings: Sequence[Event],
) -> say.Why:
    found = boundary.automatic
    peak = found.peak if found else None
    logged = logged_near(boundary.time_s, happenings)
    return say.Why(
        sentences=(*sentences(boundary, threshold, meeting), *logged),
        reasons=_reasons(found.reasons if found else ()),
        height=peak.height if peak else None,
        times_threshold=peak.height / threshold if peak and threshold else None,
        position_s=found.position_s if found else None,
        steps=_steps(peak),
    )


@lru_cache(maxsize=8192)
def _reasons(reasons: tuple[Reason, ...]) -> tuple[say.ReasonMessage, ...]:
    """Those that weigh most, either way; the rest would not be read."""
    weighty = sorted(reasons, key=lambda one: -abs(one.contribution))[:MOST_REASONS]
    return tuple(say.ReasonMessage(one.name, float(one.contribution)) for one in weighty)


@lru_cache(maxsize=8192)
def _steps(peak: Peak | None) -> tuple[say.StepMessage, ...]:
    """The same for as long as a peak is: an hour of recording has thousands of them."""
    if peak is None:
        return ()
    measured = [("Force", "N", peak.force_step_N), ("Torque", "N m", peak.torque_step_Nm)]
    return tuple(
        say.StepMessage(f"{name} {axis}", value, unit, axis)
        for name, unit, values in measured
        if values is not None
        for axis, value in zip(_AXES, values, strict=True)
    )


def _at_m(demonstration: Demonstration, times_s: Sequence[float]) -> list[say.Point]:
    """Where the tool was at the samples nearest to some times, to a tenth of a millimetre."""
    time = demonstration.time_s
    after = np.searchsorted(time, times_s).clip(1, len(time) - 1)
    rows = after - (times_s - time[after - 1] <= time[after] - times_s)
    return [(x, y, z) for x, y, z in demonstration.position_m[rows].round(4).tolist()]


def _segments(labeling: Labeling) -> tuple[say.SegmentMessage, ...]:
    demonstration = labeling.segmentation.demonstration
    middles_m = _at_m(demonstration, [segment.middle_s for segment in labeling.segments])
    return tuple(map(_segment, labeling.segments, middles_m))


def _segment(segment: LabeledSegment, middle_m: say.Point) -> say.SegmentMessage:
    return say.SegmentMessage(
        start_s=segment.start_s,
        end_s=segment.end_s,
        label=segment.label,
        proposed=segment.proposed,
        kept=segment.kept,
        idle=segment.idle,
        color=segment.color,
        end_condition=_end_condition(segment.end_condition),
        short=short_labels(segment.label),
        middle_m=middle_m,
        assessment=segment.assessment,
    )


def _end_condition(condition: EndCondition) -> say.EndConditionMessage:
    if isinstance(condition, ContactEnd):
        return say.EndConditionMessage(
            "contact",
            direction=condition.direction,
            threshold_N=condition.threshold_N,
            release=condition.release,
            agrees=condition.agrees,
            offset_m=condition.offset_m,
            timeout_s=condition.timeout_s,
        )
    return say.EndConditionMessage(
        "configuration",
        position_tolerance_m=condition.position_tolerance_m,
        rotation_tolerance_rad=condition.rotation_tolerance_rad,
        timeout_s=condition.timeout_s,
        gripper=UNSET if condition.gripper is None else asdict(condition.gripper),
    )


def _candidate(one: Candidate) -> say.CandidateMessage:
    return say.CandidateMessage(
        one.time_s, one.kind, float(one.probability), one.given, one.why_not
    )


def _peak(peak: Peak) -> say.PeakMessage:
    return say.PeakMessage(peak.time_s, peak.bin_time_s, peak.height, peak.rejection)


def plan_of(labeling: Labeling) -> tuple[say.PlanEntryMessage, ...]:
    """The plan, with the gaps between its entries."""
    demonstration = labeling.segmentation.demonstration
    gaps = _gaps_mm(labeling.plan, labeling.segments, demonstration)
    return tuple(
        say.PlanEntryMessage(entry.time_s, entry.segment, entry.repeat, gap)
        for entry, gap in zip(labeling.plan, gaps, strict=True)
    )


def _gaps_mm(
    plan: Sequence[PlanEntry], segments: Sequence[LabeledSegment], demonstration: Demonstration
) -> list[float | None]:
    """How far each entry starts from where the one before it ended."""
    if not plan:
        return []
    starts = _positions(demonstration, [segments[entry.segment].start_s for entry in plan[1:]])
    ends = _positions(demonstration, [segments[entry.segment].end_s for entry in plan[:-1]])
    gaps = 1e3 * np.linalg.norm(starts - ends, axis=1)
    return [None, *(gap if gap >= CONNECTING_MM else None for gap in gaps.tolist())]


def _positions(demonstration: Demonstration, times_s: Sequence[float]) -> Array:
    """(M, 3) where the tool was at the first sample from each time on."""
    rows = np.searchsorted(demonstration.time_s, times_s).clip(0, len(demonstration) - 1)
    return demonstration.position_m[rows]
