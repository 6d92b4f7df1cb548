"""From a demonstration to its segmentation, with every stage kept for as long as it holds."""

from functools import cached_property

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.segmentation.combine import NONE, combine
from keyphase.segmentation.confidence import joint_confidence
from keyphase.segmentation.end_condition import end_condition_at, ends_in_contact
from keyphase.segmentation.labels import Evidence, proposed_label
from keyphase.segmentation.motion import Motion, motion_of
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.peaks import Codes
from keyphase.segmentation.segmentation import Boundary, Segment, Segmentation
from keyphase.segmentation.stages import ForceStage, PositionStage, Recent

_RESULTS_KEPT = 4
_SPANS_KEPT = 200_000


def segment(demonstration: Demonstration, parameters: Parameters | None = None) -> Segmentation:
    """Segment a demonstration; see `Segmenter` for doing so repeatedly."""
    return Segmenter(demonstration).segment(parameters or Parameters())


class Segmenter:
    """Segments one demonstration under changing parameters.

    The position fit depends on Gaussians, variant and seed, the normalized error on noise and
    engine; thresholds, distance, persistence and tolerance only select among what is there.
    Not for use by several threads at once.
    """

    def __init__(self, demonstration: Demonstration) -> None:
        self.demonstration = demonstration
        self._positions: Recent[PositionStage] = Recent(_RESULTS_KEPT)
        self._forces: Recent[ForceStage | None] = Recent(_RESULTS_KEPT)
        self._boundaries: Recent[dict[tuple[int, int], Boundary]] = Recent(_RESULTS_KEPT)
        self._segments: dict[tuple[float, float, bool], Segment] = {}

    def segment(self, parameters: Parameters | None = None) -> Segmentation:
        """The segmentation under these parameters, or the default ones."""
        parameters = parameters or Parameters()
        force = self._force(parameters)
        codes = None if force is None else force.codes(parameters)
        boundaries = self._combined(parameters, force, codes)
        return Segmentation(
            demonstration=self.demonstration,
            parameters=parameters,
            boundaries=boundaries,
            segments=self._between(boundaries),
            gaussians=self._position(parameters).gaussians,
            curve=None if force is None else force.curve,
            peaks=() if force is None or codes is None else force.reported(codes, parameters),
            threshold=None if force is None else force.threshold(parameters),
        )

    def segment_between(self, start_s: float, end_s: float, contact_change: bool) -> Segment:
        """The segment as the program proposes it for any span, its label and end condition."""
        span = (start_s, end_s, contact_change)
        if span not in self._segments:
            # A contact that the recording breaks off in lies too close to its end for a boundary.
            if end_s >= self.demonstration.end_s:
                contact_change = ends_in_contact(self.demonstration, start_s)
            label, idle = proposed_label(self._evidence, start_s, end_s, contact_change)
            end = end_condition_at(self.demonstration, start_s, end_s, contact_change)
            self._segments[span] = Segment(start_s, end_s, label, idle, end)
        return self._segments[span]

    @cached_property
    def _motion(self) -> Motion:
        return motion_of(self.demonstration)

    @cached_property
    def _evidence(self) -> Evidence:
        return Evidence.of(self.demonstration, self._motion)

    def _position(self, parameters: Parameters) -> PositionStage:
        return self._positions.get(
            PositionStage.key(parameters),
            lambda: PositionStage.of(self.demonstration, self._motion, parameters),
        )

    def _force(self, parameters: Parameters) -> ForceStage | None:
        return self._forces.get(
            ForceStage.key(parameters), lambda: ForceStage.of(self.demonstration, parameters)
        )

    def _combined(
        self, parameters: Parameters, force: ForceStage | None, codes: Codes | None
    ) -> tuple[Boundary, ...]:
        position = self._position(parameters)
        used = np.zeros(0, dtype=np.intp) if codes is None else np.flatnonzero(codes == 0)
        found = combine(
            position.time_s,
            np.zeros(0) if force is None else force.candidates.time_s[used],
            self.demonstration.start_s,
            self.demonstration.end_s,
            parameters.merge_tolerance_s,
        )
        candidates = np.append(used, NONE)[found.force].tolist()
        key = (PositionStage.key(parameters), ForceStage.key(parameters))
        known = self._boundaries.get(key, dict)
        pairs = list(zip(found.position.tolist(), candidates, strict=True))
        for pair in pairs:
            if pair not in known:
                known[pair] = _boundary(position, force, *pair)
        return tuple([known[pair] for pair in pairs])

    def _between(self, boundaries: tuple[Boundary, ...]) -> tuple[Segment, ...]:
        if len(self._segments) > _SPANS_KEPT:
            self._segments.clear()
        times = [self.demonstration.start_s, *[b.time_s for b in boundaries]]
        ends = [*times[1:], self.demonstration.end_s]
        changes = [*[b.contact_change for b in boundaries], False]
        known = self._segments
        spans = zip(times, ends, changes, strict=True)
        return tuple([known.get(span) or self.segment_between(*span) for span in spans])


def _boundary(
    position: PositionStage, force: ForceStage | None, point: int, candidate: int
) -> Boundary:
    """From the position's point, the force's candidate, or both."""
    if force is None or candidate == NONE:
        return position.boundary(point)
    peak = force.peak(candidate)
    confidence = float(force.confidence[candidate])
    position_s = None
    if point != NONE:
        confidence = joint_confidence(confidence, float(position.confidence[point]))
        position_s = float(position.time_s[point])
    return Boundary(
        time_s=peak.time_s,
        origin="force" if position_s is None else "both",
        interval_s=force.interval_s(candidate),
        confidence=confidence,
        contact_change=True,
        peak=peak,
        position_s=position_s,
    )
