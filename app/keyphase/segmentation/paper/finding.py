"""The paper's method whole: a Gaussian mixture, peaks of the normalized error, and both joined."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.found import Found
from keyphase.segmentation.motion import Motion
from keyphase.segmentation.paper.combine import NONE, Combination, combine
from keyphase.segmentation.paper.confidence import joint_confidence
from keyphase.segmentation.paper.stages import ForceStage, PositionStage
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.recent import Recent
from keyphase.segmentation.segmentation import Boundary, Change

_RESULTS_KEPT = 4


class PaperMethod:
    """Finds the boundaries of one demonstration as the paper does, under changing parameters.

    The position fit depends on Gaussians, mixture and seed, the normalized error on noise and
    engine; thresholds, distance, persistence and tolerance only select among what is there.
    """

    def __init__(
        self,
        demonstration: Demonstration,
        motion: Callable[[], Motion],
        change_at: Callable[[float], Change],
    ) -> None:
        self._demonstration = demonstration
        self._motion = motion
        self._change_at = change_at
        self._positions: Recent[PositionStage] = Recent(_RESULTS_KEPT)
        self._forces: Recent[ForceStage | None] = Recent(_RESULTS_KEPT)
        self._boundaries: Recent[_Boundaries] = Recent(_RESULTS_KEPT)

    def find(self, parameters: Parameters) -> Found:
        """Boundaries, Gaussians, curve and peaks under these parameters."""
        position, force = self._position(parameters), self._force(parameters)
        codes = np.zeros(0, dtype=np.int8) if force is None else force.codes(parameters)
        used = np.flatnonzero(codes == 0)
        found = combine(
            position.time_s,
            np.zeros(0) if force is None else force.candidates.time_s[used],
            self._demonstration.start_s,
            self._demonstration.end_s,
            parameters.merge_tolerance_s,
        )
        return Found(
            boundaries=self._boundaries_of(found, used, parameters),
            gaussians=position.gaussians,
            curve=None if force is None else force.curve,
            peaks=() if force is None else force.reported(codes, parameters),
            threshold=None if force is None else force.threshold(parameters),
        )

    def _position(self, parameters: Parameters) -> PositionStage:
        return self._positions.get(
            PositionStage.key(parameters),
            lambda: PositionStage.of(self._demonstration, self._motion(), parameters),
        )

    def _force(self, parameters: Parameters) -> ForceStage | None:
        return self._forces.get(
            ForceStage.key(parameters), lambda: ForceStage.of(self._demonstration, parameters)
        )

    def _boundaries_of(
        self, found: Combination, used: Indices, parameters: Parameters
    ) -> tuple[Boundary, ...]:
        key = (PositionStage.key(parameters), ForceStage.key(parameters))
        known = self._boundaries.get(
            key,
            lambda: _Boundaries(
                self._position(parameters), self._force(parameters), self._change_at
            ),
        )
        candidates = np.append(used, NONE)[found.force]
        pairs = zip(found.position.tolist(), candidates.tolist(), strict=True)
        return tuple(map(known.__getitem__, pairs))


class _Boundaries(dict[tuple[int, int], Boundary]):
    """Boundaries by position point and force candidate, made when first asked for."""

    def __init__(
        self,
        position: PositionStage,
        force: ForceStage | None,
        change_at: Callable[[float], Change],
    ) -> None:
        super().__init__()
        self._position = position
        self._force = force
        self._change_at = change_at

    def __missing__(self, pair: tuple[int, int]) -> Boundary:
        boundary = _boundary(self._position, self._force, *pair)
        if boundary.contact_change:
            boundary = replace(boundary, change=self._change_at(boundary.time_s))
        self[pair] = boundary
        return self[pair]


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
