"""From a demonstration to its segmentation, with every stage kept for as long as it holds."""

from collections.abc import Callable
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.combine import NONE, Combination, combine
from keyphase.segmentation.confidence import joint_confidence
from keyphase.segmentation.end_condition import end_condition_at, ends_in_contact
from keyphase.segmentation.free_force import free_force
from keyphase.segmentation.labels import Evidence, proposed_label
from keyphase.segmentation.motion import Motion, motion_of
from keyphase.segmentation.parameters import Parameters
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
        self._boundaries: Recent[_Boundaries] = Recent(_RESULTS_KEPT)
        self._segments = _Segments(demonstration, lambda: self._motion)

    def segment(self, parameters: Parameters | None = None) -> Segmentation:
        """The segmentation under these parameters, or the default ones."""
        parameters = parameters or Parameters()
        position, force = self._position(parameters), self._force(parameters)
        codes = np.zeros(0, dtype=np.int8) if force is None else force.codes(parameters)
        used = np.flatnonzero(codes == 0)
        found = combine(
            position.time_s,
            np.zeros(0) if force is None else force.candidates.time_s[used],
            self.demonstration.start_s,
            self.demonstration.end_s,
            parameters.merge_tolerance_s,
        )
        return Segmentation(
            demonstration=self.demonstration,
            parameters=parameters,
            boundaries=self._boundaries_of(found, used, parameters),
            segments=self._segments_between(found),
            gaussians=position.gaussians,
            curve=None if force is None else force.curve,
            peaks=() if force is None else force.reported(codes, parameters),
            threshold=None if force is None else force.threshold(parameters),
        )

    def segment_between(self, start_s: float, end_s: float, contact_change: bool) -> Segment:
        """The segment as the program proposes it for any span, its label and end condition."""
        return self._segments[start_s, end_s, contact_change]

    @cached_property
    def _motion(self) -> Motion:
        return motion_of(self.demonstration)

    def _position(self, parameters: Parameters) -> PositionStage:
        return self._positions.get(
            PositionStage.key(parameters),
            lambda: PositionStage.of(self.demonstration, self._motion, parameters),
        )

    def _force(self, parameters: Parameters) -> ForceStage | None:
        return self._forces.get(
            ForceStage.key(parameters), lambda: ForceStage.of(self.demonstration, parameters)
        )

    def _boundaries_of(
        self, found: Combination, used: Indices, parameters: Parameters
    ) -> tuple[Boundary, ...]:
        key = (PositionStage.key(parameters), ForceStage.key(parameters))
        known = self._boundaries.get(
            key, lambda: _Boundaries(self._position(parameters), self._force(parameters))
        )
        candidates = np.append(used, NONE)[found.force]
        pairs = zip(found.position.tolist(), candidates.tolist(), strict=True)
        return tuple(map(known.__getitem__, pairs))

    def _segments_between(self, found: Combination) -> tuple[Segment, ...]:
        if len(self._segments) > _SPANS_KEPT:
            self._segments.clear()
        starts = [self.demonstration.start_s, *found.time_s.tolist()]
        ends = [*starts[1:], self.demonstration.end_s]
        last = ends_in_contact(self.demonstration, starts[-1])
        changes = [*(found.force != NONE).tolist(), last]
        return tuple(map(self._segments.__getitem__, zip(starts, ends, changes, strict=True)))


class _Boundaries(dict[tuple[int, int], Boundary]):
    """Boundaries by position point and force candidate, made when first asked for."""

    def __init__(self, position: PositionStage, force: ForceStage | None) -> None:
        super().__init__()
        self._position = position
        self._force = force

    def __missing__(self, pair: tuple[int, int]) -> Boundary:
        self[pair] = _boundary(self._position, self._force, *pair)
        return self[pair]


class _Segments(dict[tuple[float, float, bool], Segment]):
    """Segments by start, end and whether a contact change ends them, made when first asked for."""

    def __init__(self, demonstration: Demonstration, motion: Callable[[], Motion]) -> None:
        super().__init__()
        self._demonstration = demonstration
        self._motion = motion

    @cached_property
    def evidence(self) -> Evidence:
        """What labels are made from."""
        return Evidence.of(self._demonstration, self._motion())

    @cached_property
    def _free_force(self) -> Array:
        return free_force(self._demonstration)

    def __missing__(self, span: tuple[float, float, bool]) -> Segment:
        label, idle = proposed_label(self.evidence, *span)
        end = end_condition_at(self._demonstration, *span, self._free_force)
        self[span] = Segment(span[0], span[1], label, idle, end)
        return self[span]


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
