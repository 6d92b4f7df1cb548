"""From a demonstration to its segmentation, with every stage kept for as long as it holds."""

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition import ConfigurationEnd, end_condition_at, ends_in_contact
from keyphase.segmentation.evidence.finding import EvidenceMethod
from keyphase.segmentation.found import Found
from keyphase.segmentation.free_force import free_force
from keyphase.segmentation.gripper import (
    SAME_EVENT_S,
    GripperEvent,
    gripper_end,
    gripper_events,
    stands_at,
    with_gripper,
)
from keyphase.segmentation.kept import places_before
from keyphase.segmentation.labels import Evidence, proposed_label
from keyphase.segmentation.motion import Motion, motion_of
from keyphase.segmentation.own_finding import find_by_own_method
from keyphase.segmentation.paper.finding import PaperMethod
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Change, Segment, Segmentation

_SPANS_KEPT = 200_000


def segment(demonstration: Demonstration, parameters: Parameters | None = None) -> Segmentation:
    """Segment a demonstration; see `Segmenter` for doing so repeatedly."""
    return Segmenter(demonstration).segment(parameters or Parameters())


class Segmenter:
    """Segments one demonstration under changing parameters.

    What the lines and tolerances only select among is computed once and kept. Not for use by
    several threads at once.
    """

    def __init__(self, demonstration: Demonstration) -> None:
        self.demonstration = demonstration
        self._segments = _Segments(demonstration, lambda: self._motion)

    def segment(self, parameters: Parameters | None = None) -> Segmentation:
        """The segmentation under these parameters, or the default ones."""
        parameters = parameters or Parameters()
        found = self._found(parameters)
        return Segmentation(
            demonstration=self.demonstration,
            parameters=parameters,
            boundaries=found.boundaries,
            segments=self._segments_between(found),
            gaussians=found.gaussians,
            curve=found.curve,
            peaks=found.peaks,
            threshold=found.threshold,
            motion_threshold=found.motion_threshold,
            candidates=found.candidates,
            track=found.track,
            unlike=found.unlike,
            automatic_least_step_N=found.automatic_least_step_N,
            line_counts=found.line_counts,
            held_back=found.held_back,
        )

    def _found(self, parameters: Parameters) -> Found:
        match parameters.variant:
            case "evidence":
                return self._with_gripper(self._evidence.find(parameters))
            case "paper":
                return self._paper.find(parameters)
            case _:
                return find_by_own_method(self.demonstration, parameters)

    def _with_gripper(self, found: Found) -> Found:
        events = self._segments.gripper
        if not events:
            return found
        # Which boundaries give way depends on both lines, so that numbers over one would be wrong.
        return replace(
            found,
            boundaries=with_gripper(found.boundaries, events),
            line_counts=(),
            times_s=None,
            contact_change=None,
        )

    def segment_between(self, start_s: float, end_s: float, contact_change: bool) -> Segment:
        """The segment as the program proposes it for any span, its label and end condition."""
        return self._segments[start_s, end_s, contact_change]

    @cached_property
    def _paper(self) -> PaperMethod:
        return PaperMethod(self.demonstration, lambda: self._motion, self._change_at)

    @cached_property
    def _evidence(self) -> EvidenceMethod:
        return EvidenceMethod(self.demonstration, lambda: self._motion, self._change_at)

    def _change_at(self, time_s: float) -> Change:
        contact = self._segments.evidence.contact
        return "changed" if contact is None else contact.change_at(time_s)

    @cached_property
    def _motion(self) -> Motion:
        return motion_of(self.demonstration)

    def _segments_between(self, found: Found) -> tuple[Segment, ...]:
        times, changes = found.times_s, found.contact_change
        if times is None or changes is None:
            times = np.array([boundary.time_s for boundary in found.boundaries])
            changes = np.array([boundary.contact_change for boundary in found.boundaries], bool)
        spans = np.empty((3, len(times) + 1))
        spans[0, 0], spans[0, 1:] = self.demonstration.start_s, times
        spans[1, :-1], spans[1, -1] = times, self.demonstration.end_s
        last = ends_in_contact(self.demonstration, float(spans[0, -1]))
        spans[2, :-1], spans[2, -1] = changes, last
        return self._segments.over(spans)


class _Segments(dict[tuple[float, float, bool], Segment]):
    """Segments by start, end and whether a contact change ends them, made when first asked for."""

    def __init__(self, demonstration: Demonstration, motion: Callable[[], Motion]) -> None:
        super().__init__()
        self._demonstration = demonstration
        self._motion = motion
        self._last = np.zeros((3, 0)), np.empty(0, dtype=object)

    def over(self, spans: Array) -> tuple[Segment, ...]:
        """The segments over spans (3, S) in time order: start, end, contact change.

        Those that were there the last time are not looked up one by one.
        """
        if len(self) > _SPANS_KEPT:
            self.clear()
        before, known = self._last
        place = places_before(before, spans)
        found = np.empty(len(place), dtype=object)
        found[place >= 0] = known[place[place >= 0]]
        for new in np.flatnonzero(place < 0).tolist():
            start, end, change = spans[:, new].tolist()
            found[new] = self[start, end, bool(change)]
        self._last = spans, found
        return tuple(found.tolist())

    @cached_property
    def evidence(self) -> Evidence:
        """What labels are made from."""
        return Evidence.of(self._demonstration, self._motion())

    @cached_property
    def gripper(self) -> tuple[GripperEvent, ...]:
        """Grasps and releases inside the recording."""
        start, end = self._demonstration.start_s, self._demonstration.end_s
        events = gripper_events(self._demonstration)
        inside = start + SAME_EVENT_S, end - SAME_EVENT_S
        return tuple(one for one in events if inside[0] <= one.time_s <= inside[1])

    @cached_property
    def _free_force(self) -> Array:
        return free_force(self._demonstration)

    def __missing__(self, span: tuple[float, float, bool]) -> Segment:
        label, measure, idle = proposed_label(self.evidence, *span, self.gripper)
        end = end_condition_at(self._demonstration, *span, self._free_force)
        done = gripper_end(self._demonstration, self.gripper, span[1])
        by_fingers = done is not None and stands_at(self._demonstration, span[1])
        if isinstance(end, ConfigurationEnd) or by_fingers:
            end = ConfigurationEnd(gripper=done)
        self[span] = Segment(span[0], span[1], label, idle, end, measure)
        return self[span]
