"""Boundaries with one probability each, under changing lines."""

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.evidence.selection import (
    CONTACT,
    Scores,
    Selection,
    scores_of,
    select,
)
from keyphase.segmentation.evidence.stage import Evidence, evidence_of
from keyphase.segmentation.evidence.telling.counts import Counts, held_back
from keyphase.segmentation.evidence.telling.drawn import DrawnCurve
from keyphase.segmentation.evidence.telling.gaussians import SegmentGaussians
from keyphase.segmentation.evidence.telling.told import Told
from keyphase.segmentation.evidence.telling.track import track_of
from keyphase.segmentation.evidence.weights import Weights, shipped_weights
from keyphase.segmentation.found import Found
from keyphase.segmentation.kept import Values
from keyphase.segmentation.motion import Motion
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.recent import Recent
from keyphase.segmentation.segmentation import Boundary, Change, EvidenceTrack

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
        self._counts: Recent[Counts] = Recent(_RESULTS_KEPT)
        self._curves: Recent[DrawnCurve | None] = Recent(_RESULTS_KEPT)

    def find(self, parameters: Parameters) -> Found:
        """Boundaries, Gaussians, curve and candidates under these parameters."""
        scores, told, track = self._scored(parameters)
        selection = select(self.evidence, scores, self._weights, parameters)
        times, by_contact, order = self._in_order(selection)
        fitted = self._gaussians.fitted(self._bins(selection, by_contact, order))
        boundaries = self._boundaries(told, selection, by_contact, order, fitted.intervals_s(times))
        curve = self._curve(parameters)
        return Found(
            boundaries=boundaries,
            times_s=times,
            contact_change=by_contact,
            gaussians=tuple(fitted.gaussians.tolist()),
            curve=None if curve is None else curve.curve,
            peaks=() if curve is None else curve.peaks(scores, selection),
            threshold=None if curve is None else selection.contact_line,
            motion_threshold=selection.motion_line,
            candidates=told.candidates(selection),
            track=track,
            unlike=self.evidence.unlike,
            automatic_least_step_N=None if curve is None else self.evidence.least_step_N,
            line_counts=self._counted(parameters).over_lines(selection),
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

    def _counted(self, parameters: Parameters) -> Counts:
        scores = self._scored(parameters)[0]
        key = parameters.min_distance_s, parameters.least_step_N, parameters.turns
        return self._counts.get(
            (*key, parameters.merge_tolerance_s), lambda: Counts(self.evidence, scores, parameters)
        )

    def _curve(self, parameters: Parameters) -> DrawnCurve | None:
        key = parameters.process_noise_ratio, parameters.measurement_noise, parameters.engine
        return self._curves.get(
            key, lambda: DrawnCurve.of(self._demonstration, self.evidence, parameters)
        )

    def _in_order(self, selection: Selection) -> tuple[Array, NDArray[np.bool_], Indices]:
        """Times (B,) of what is given, ascending; which are contact changes; and the place of each
        among those or among the boundaries of motion."""
        contacts = self.evidence.contact_s[selection.contacts]
        times = np.concatenate([contacts, self.evidence.motion_s[selection.motions]])
        order = np.argsort(times, kind="stable")
        order = order[self._apart(times[order])]
        by_contact = order < len(contacts)
        return times[order], by_contact, np.where(by_contact, order, order - len(contacts))

    def _bins(self, selection: Selection, by_contact: NDArray[np.bool_], place: Indices) -> Indices:
        """The first bin (B,) of the motion after each boundary."""
        touched, moved = self._candidate_bins
        found = np.empty(len(place), dtype=np.intp)
        found[by_contact] = touched[selection.contacts[place[by_contact]]]
        found[~by_contact] = moved[selection.motions[place[~by_contact]]]
        return found

    @cached_property
    def _candidate_bins(self) -> tuple[Indices, Indices]:
        times = self._motion().time_s
        evidence = self.evidence
        return np.searchsorted(times, evidence.contact_s), np.searchsorted(times, evidence.motion_s)

    def _boundaries(
        self,
        told: Told,
        selection: Selection,
        by_contact: NDArray[np.bool_],
        place: Indices,
        intervals_s: Array,
    ) -> tuple[Boundary, ...]:
        """The boundaries; of motion with the intervals (B, 2) of the Gaussians beside them."""
        found: Values = np.empty(len(place), dtype=object)
        touched, moved = place[by_contact], place[~by_contact]
        joined = self._joined(selection)[touched]
        found[by_contact] = told.contacts(selection.contacts[touched], joined)
        found[~by_contact] = told.motions(selection.motions[moved], intervals_s[~by_contact])
        return tuple(found.tolist())

    def _apart(self, times: Array) -> np.ndarray:
        """Which of ascending times are inside the recording and later than the one before."""
        start, end = self._demonstration.start_s, self._demonstration.end_s
        inside = (times > start) & (times < end)
        return inside & (np.diff(times, prepend=-np.inf) > 0.0)

    def _joined(self, selection: Selection) -> Array:
        """When the motion changes at each given contact change (C,), too; infinite where not."""
        times = self.evidence.contact_s[selection.contacts]
        moved = self.evidence.motion_s[selection.motion == CONTACT]
        joined = np.full(len(times), np.inf)
        if not len(moved):
            return joined
        after = np.searchsorted(times, moved)
        before = np.maximum(after - 1, 0)
        after = np.minimum(after, len(times) - 1)
        nearest = np.where(
            np.abs(times[before] - moved) <= np.abs(times[after] - moved), before, after
        )
        away = np.abs(times[nearest] - moved)
        # Of several at one contact the nearest comes last, and stays.
        order = np.argsort(away, kind="stable")[::-1]
        joined[nearest[order]] = moved[order]
        return joined
