"""Boundaries with one probability each, under changing lines."""

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.evidence.selection import (
    CONTACT,
    Scores,
    Selection,
    scores_of,
    select,
)
from keyphase.segmentation.evidence.stage import Evidence, evidence_of
from keyphase.segmentation.evidence.telling.counts import held_back, line_counts
from keyphase.segmentation.evidence.telling.drawn import DrawnCurve
from keyphase.segmentation.evidence.telling.gaussians import SegmentGaussians, intervals_s
from keyphase.segmentation.evidence.telling.told import Told
from keyphase.segmentation.evidence.telling.track import track_of
from keyphase.segmentation.evidence.weights import Weights, shipped_weights
from keyphase.segmentation.found import Found
from keyphase.segmentation.motion import Motion
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.recent import Recent
from keyphase.segmentation.segmentation import Boundary, Change, EvidenceTrack, Gaussian

ESTIMATED_STEP_N = 1.5
"""The least step of a wrench that was worked out of joint torques: friction of the joints alone
makes steps of about a newton at the tool. The parameter least_step_N goes before it."""

_RESULTS_KEPT = 4


class EvidenceMethod:
    """Finds the boundaries of one demonstration by evidence.

    Evidence does not depend on parameters; scores depend on minimal distance and least step. The
    lines, turns and the tolerance only select.
    """

    def __init__(
        self,
        demonstration: Demonstration,
        motion: Callable[[], Motion],
        change_at: Callable[[float], Change],
        weights: Weights | None = None,
    ) -> None:
        self._demonstration = demonstration
        self._motion = motion
        self._change_at = change_at
        self._weights = weights or shipped_weights()
        self._scores: Recent[tuple[Scores, Told, EvidenceTrack]] = Recent(_RESULTS_KEPT)
        self._freed: Recent[Scores] = Recent(_RESULTS_KEPT)
        self._curves: Recent[DrawnCurve | None] = Recent(_RESULTS_KEPT)

    def find(self, parameters: Parameters) -> Found:
        """Boundaries, Gaussians, curve and candidates under these parameters."""
        scores, told, track = self._scored(parameters)
        selection = select(self.evidence, scores, self._weights, parameters)
        boundaries, gaussians = self._boundaries(told, selection)
        curve = self._curve(parameters)
        return Found(
            boundaries=boundaries,
            gaussians=gaussians,
            curve=None if curve is None else curve.curve,
            peaks=() if curve is None else curve.peaks(scores, selection),
            threshold=None if curve is None else selection.contact_line,
            motion_threshold=selection.motion_line,
            candidates=told.candidates(selection),
            track=track,
            unlike=self.evidence.unlike,
            automatic_least_step_N=None if curve is None else self.evidence.least_step_N,
            line_counts=line_counts(self.evidence, scores, selection, parameters),
            held_back=held_back(
                self.evidence,
                scores,
                self._scores_alone,
                self._weights,
                parameters,
                selection,
            ),
        )

    @cached_property
    def evidence(self) -> Evidence:
        """All that is known before a line is drawn."""
        found = evidence_of(self._demonstration, self._motion(), self._weights)
        if not self._demonstration.wrench_estimated:
            return found
        return replace(found, least_step_N=max(found.least_step_N, ESTIMATED_STEP_N))

    @cached_property
    def _gaussians(self) -> SegmentGaussians:
        return SegmentGaussians(self._motion())

    def _scored(self, parameters: Parameters) -> tuple[Scores, Told, EvidenceTrack]:
        key = parameters.min_distance_s, parameters.least_step_N

        def compute() -> tuple[Scores, Told, EvidenceTrack]:
            scores = scores_of(self.evidence, self._weights, parameters)
            told = Told(self.evidence, scores, self._weights, self._change_at)
            return scores, told, track_of(self.evidence, scores)

        return self._scores.get(key, compute)

    def _scores_alone(self, parameters: Parameters) -> Scores:
        """Scores, without what is told of them."""
        key = parameters.min_distance_s, parameters.least_step_N
        return self._freed.get(key, lambda: scores_of(self.evidence, self._weights, parameters))

    def _curve(self, parameters: Parameters) -> DrawnCurve | None:
        key = parameters.process_noise_ratio, parameters.measurement_noise, parameters.engine
        return self._curves.get(
            key, lambda: DrawnCurve.of(self._demonstration, self.evidence, parameters)
        )

    def _boundaries(
        self, told: Told, selection: Selection
    ) -> tuple[tuple[Boundary, ...], tuple[Gaussian, ...]]:
        """In time order; a motion boundary's interval is that of the Gaussians beside it."""
        contacts, motions = selection.contacts, selection.motions
        times = np.concatenate([self.evidence.contact_s[contacts], self.evidence.motion_s[motions]])
        order = np.argsort(times, kind="stable")
        order = order[self._apart(times[order])]
        gaussians = self._gaussians.fitted(times[order])
        intervals = intervals_s(gaussians, times[order])
        with_motion = self._joined(selection)
        by_contact = order < len(contacts)
        boundaries = np.empty(len(order), dtype=object)
        boundaries[by_contact] = [
            told.contact(candidate, with_motion.get(candidate))
            for candidate in contacts[order[by_contact]].tolist()
        ]
        moving = motions[order[~by_contact] - len(contacts)]
        boundaries[~by_contact] = told.motions(moving, intervals[~by_contact])
        return tuple(boundaries.tolist()), gaussians

    def _apart(self, times: Array) -> np.ndarray:
        """Which of ascending times are inside the recording and later than the one before."""
        start, end = self._demonstration.start_s, self._demonstration.end_s
        inside = (times > start) & (times < end)
        return inside & (np.diff(times, prepend=-np.inf) > 0.0)

    def _joined(self, selection: Selection) -> dict[int, float]:
        """For contact changes at which the motion changes too, when it does."""
        times = self.evidence.contact_s[selection.contacts]
        moved = self.evidence.motion_s[selection.motion == CONTACT]
        after = np.searchsorted(times, moved)
        before = np.maximum(after - 1, 0)
        after = np.minimum(after, len(times) - 1)
        nearest = np.where(
            np.abs(times[before] - moved) <= np.abs(times[after] - moved), before, after
        )
        away = np.abs(times[nearest] - moved)
        # Of several at one contact the nearest comes last, and stays.
        order = np.argsort(away, kind="stable")[::-1]
        candidates = selection.contacts[nearest][order].tolist()
        return dict(zip(candidates, moved[order].tolist(), strict=True))
