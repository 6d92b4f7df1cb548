"""The `document` message: a labeling as the page draws it, with the reasons in words."""

import re
from collections.abc import Sequence
from dataclasses import asdict
from functools import lru_cache
from typing import Any

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.labeling.labeling import LabeledBoundary, LabeledSegment, Labeling, PlanEntry
from keyphase.segmentation.end_condition import ContactEnd, EndCondition
from keyphase.segmentation.segmentation import Peak
from keyphase.workbench.reasons import Meeting, sentences

CONNECTING_MM = 1.0
"""A plan entry that starts nearer than this to where the last one ended needs no connection."""

_AXES = ("x", "y", "z")
_MEASURE = re.compile(r"\s*\b\d+(\.\d+)?\s?(mm|cm|m|deg|°)(?!\w)")
_DIRECTION = re.compile(r"\s+(left|right|forward|backward|back|up|down)\b")


def _recovered(demonstration: Demonstration) -> list[str]:
    broken_off = demonstration.metadata.get("recovered") is True
    return ["Its recorder broke off; the last second at most is missing."] if broken_off else []


def document_message(labeling: Labeling) -> dict[str, Any]:
    """The parts of the `document` message that the labeling determines."""
    segmentation = labeling.segmentation
    demonstration = segmentation.demonstration
    return {
        "name": demonstration.name,
        "start_s": demonstration.start_s,
        "end_s": demonstration.end_s,
        "rate_hz": demonstration.rate_hz,
        "channels": channels(demonstration),
        "notices": [*demonstration.notices, *_recovered(demonstration)],
        "parameters": asdict(segmentation.parameters),
        "threshold": segmentation.threshold,
        "automatic_threshold": (
            segmentation.curve.automatic_threshold if segmentation.curve else None
        ),
        "force_channels": segmentation.curve.channels if segmentation.curve else 0,
        "boundaries": _boundaries(labeling),
        "segments": _segments(labeling),
        "peaks": [_peak(peak) for peak in segmentation.peaks],
        "gaussians": [
            {
                "weight": gaussian.weight,
                "mean_time_s": gaussian.mean_time_s,
                "sigma_time_s": gaussian.sigma_time_s,
            }
            for gaussian in segmentation.gaussians
        ],
        "plan": _plan(labeling),
        "proposed_drops": list(labeling.proposed_drops),
        "inapplicable": [asdict(edit) for edit in labeling.inapplicable],
    }


def channels(demonstration: Demonstration) -> list[str]:
    """Names of what was recorded."""
    recorded = {
        "position": demonstration.position_m,
        "orientation": demonstration.orientation_wxyz,
        "force": demonstration.force_N,
        "torque": demonstration.torque_Nm,
        "joints": demonstration.joints_rad,
    }
    return [name for name, values in recorded.items() if values is not None]


def strip(labeling: Labeling) -> list[dict[str, Any]]:
    """The segments in small, for the list of recordings."""
    duration = labeling.segmentation.demonstration.duration_s
    return [
        {
            "share": (segment.end_s - segment.start_s) / duration,
            "color": segment.color if segment.kept else None,
        }
        for segment in labeling.segments
    ]


def least_confidence(labeling: Labeling) -> float | None:
    """Confidence of the least certain boundary nobody has decided about; None without any."""
    open_ones = [b.confidence for b in labeling.boundaries if not b.accepted and b.origin != "user"]
    return min(open_ones, default=None)


@lru_cache(maxsize=4096)
def short_labels(label: str) -> tuple[str, str, str]:
    """The label, a shorter one without measures and directions, and its first word."""
    without_measure = unmeasured(label)
    shorter = without_measure if len(without_measure) <= 16 else _DIRECTION.sub("", without_measure)
    first, _, rest = shorter.partition(" ")
    return label, shorter or label, f"{first}…" if rest else shorter or label


def unmeasured(label: str) -> str:
    """The label without measures: "Move down until contact"."""
    return _MEASURE.sub("", label)


def _boundaries(labeling: Labeling) -> list[dict[str, Any]]:
    segmentation = labeling.segmentation
    meeting = Meeting(segmentation.gaussians)
    at_m = _at_m(segmentation.demonstration, [b.time_s for b in labeling.boundaries])
    return [
        {
            "time_s": boundary.time_s,
            "origin": boundary.origin,
            "interval_s": boundary.interval_s,
            "confidence": boundary.confidence,
            "contact_change": boundary.contact_change,
            "was_s": boundary.was_s,
            "accepted": boundary.accepted,
            "at_m": position if boundary.contact_change else None,
            "why": _why(boundary, segmentation.threshold, meeting),
        }
        for boundary, position in zip(labeling.boundaries, at_m, strict=True)
    ]


def _why(boundary: LabeledBoundary, threshold: float | None, meeting: Meeting) -> dict[str, Any]:
    found = boundary.automatic
    peak = found.peak if found else None
    return {
        "sentences": sentences(boundary, threshold, meeting),
        "height": peak.height if peak else None,
        "times_threshold": peak.height / threshold if peak and threshold else None,
        "position_s": found.position_s if found else None,
        "steps": _steps(peak),
    }


@lru_cache(maxsize=8192)
def _steps(peak: Peak | None) -> tuple[dict[str, Any], ...]:
    """The same for as long as a peak is: an hour of recording has thousands of them."""
    if peak is None:
        return ()
    measured = [("Force", "N", peak.force_step_N), ("Torque", "N m", peak.torque_step_Nm)]
    return tuple(
        {"name": f"{name} {axis}", "value": value, "unit": unit, "axis": axis}
        for name, unit, values in measured
        if values is not None
        for axis, value in zip(_AXES, values, strict=True)
    )


def _at_m(demonstration: Demonstration, times_s: Sequence[float]) -> list[list[float]]:
    """Where the tool was at the samples nearest to some times, to a tenth of a millimetre."""
    time = demonstration.time_s
    after = np.searchsorted(time, times_s).clip(1, len(time) - 1)
    rows = after - (times_s - time[after - 1] <= time[after] - times_s)
    return demonstration.position_m[rows].round(4).tolist()


def _segments(labeling: Labeling) -> list[dict[str, Any]]:
    demonstration = labeling.segmentation.demonstration
    middles_m = _at_m(demonstration, [segment.middle_s for segment in labeling.segments])
    return list(map(_segment, labeling.segments, middles_m))


def _segment(segment: LabeledSegment, middle_m: Sequence[float]) -> dict[str, Any]:
    return {
        "start_s": segment.start_s,
        "end_s": segment.end_s,
        "label": segment.label,
        "proposed": segment.proposed,
        "kept": segment.kept,
        "idle": segment.idle,
        "color": segment.color,
        "end_condition": _end_condition(segment.end_condition),
        "short": short_labels(segment.label),
        "middle_m": middle_m,
    }


def _end_condition(condition: EndCondition) -> dict[str, Any]:
    if isinstance(condition, ContactEnd):
        return {
            "kind": "contact",
            "direction": condition.direction,
            "threshold_N": condition.threshold_N,
            "release": condition.release,
            "agrees": condition.agrees,
            "offset_m": condition.offset_m,
            "timeout_s": condition.timeout_s,
        }
    return {
        "kind": "configuration",
        "position_tolerance_m": condition.position_tolerance_m,
        "rotation_tolerance_rad": condition.rotation_tolerance_rad,
        "timeout_s": condition.timeout_s,
    }


def _peak(peak: Peak) -> dict[str, Any]:
    return {
        "time_s": peak.time_s,
        "bin_time_s": peak.bin_time_s,
        "height": peak.height,
        "rejection": peak.rejection,
    }


def _plan(labeling: Labeling) -> list[dict[str, Any]]:
    demonstration = labeling.segmentation.demonstration
    gaps = _gaps_mm(labeling.plan, labeling.segments, demonstration)
    return [
        {
            "time_s": entry.time_s,
            "segment": entry.segment,
            "repeat": entry.repeat,
            "connect_mm": gap,
        }
        for entry, gap in zip(labeling.plan, gaps, strict=True)
    ]


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


def ghosts(before: Labeling, now: Labeling) -> list[dict[str, Any]]:
    """Boundaries that a change under way would bring or take."""
    old = {boundary.time_s: boundary for boundary in before.boundaries}
    new = {boundary.time_s: boundary for boundary in now.boundaries}
    comes = [_ghost(new[t], "comes") for t in sorted(new.keys() - old.keys())]
    goes = [_ghost(old[t], "goes") for t in sorted(old.keys() - new.keys())]
    return comes + goes


def _ghost(boundary: LabeledBoundary, fate: str) -> dict[str, Any]:
    return {"time_s": boundary.time_s, "origin": boundary.origin, "fate": fate}
