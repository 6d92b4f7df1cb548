"""What position and force each give, kept for as long as the parameters they rest on hold."""

from collections.abc import Hashable
from dataclasses import dataclass, field

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.bins import Indices, bin_means, bin_starts
from keyphase.segmentation.motion import Motion
from keyphase.segmentation.paper.combine import CLOSEST_S
from keyphase.segmentation.paper.confidence import force_confidence, position_confidence
from keyphase.segmentation.paper.force import binned_noise, error_curve, wrench_of
from keyphase.segmentation.paper.literal_mixture import fit_literal
from keyphase.segmentation.paper.peaks import (
    REJECTIONS,
    Candidates,
    Codes,
    candidates_of,
    rejections,
)
from keyphase.segmentation.paper.position import PositionFit, fit_position
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Boundary, ErrorCurve, Gaussian, Peak

NEAR_MISS = 0.5
"""Peaks that are not used are reported from this part of the threshold and of the ratio on."""


@dataclass(frozen=True, eq=False)
class PositionStage:
    """Boundaries (B,) that position alone gives, and the Gaussians they come from."""

    time_s: Array
    interval_s: Array
    confidence: Array
    gaussians: tuple[Gaussian, ...]

    @staticmethod
    def key(parameters: Parameters) -> Hashable:
        """All of the parameters that the stage depends on."""
        seed = parameters.seed if parameters.mixture == "scikit-learn" else None
        return parameters.gaussians, parameters.mixture, parameters.estimator, seed

    @classmethod
    def of(
        cls, demonstration: Demonstration, motion: Motion, parameters: Parameters
    ) -> "PositionStage":
        """Fit the mixture that the parameters ask for and read the boundaries off it."""
        if parameters.mixture == "scikit-learn":
            fit = fit_literal(demonstration, parameters.gaussians, parameters.seed)
        else:
            fit = fit_position(motion, parameters.gaussians)
        time = fit.boundaries_s(parameters.estimator)
        low, high = fit.intervals_s().T
        interval = np.column_stack([np.minimum(low, time), np.maximum(high, time)])
        confidence = position_confidence(motion, time, interval)
        return cls(time, interval, confidence, _gaussians(fit))

    def boundary(self, point: int) -> Boundary:
        """The boundary that position alone puts at one of its points."""
        time, (low, high) = float(self.time_s[point]), self.interval_s[point].tolist()
        confidence = float(self.confidence[point])
        return Boundary(time, "position", (low, high), confidence, False, position_s=time)


def _gaussians(fit: PositionFit) -> tuple[Gaussian, ...]:
    return tuple(
        Gaussian(float(weight), float(mean), float(sigma), position, covariance)
        for weight, mean, sigma, position, covariance in zip(
            fit.weight, fit.mean_s, fit.sigma_s, fit.mean_position_m, fit.covariance_m2, strict=True
        )
    )


@dataclass(frozen=True, eq=False)
class ForceStage:
    """The normalized-error curve and its C candidate peaks; `confidence` (C,) of each."""

    curve: ErrorCurve
    candidates: Candidates
    confidence: Array
    recording_s: tuple[float, float]
    _peaks: dict[tuple[int, int], Peak] = field(default_factory=dict)

    @staticmethod
    def key(parameters: Parameters) -> Hashable:
        """All of the parameters that the stage depends on."""
        return parameters.process_noise_ratio, parameters.measurement_noise, parameters.engine

    @classmethod
    def of(cls, demonstration: Demonstration, parameters: Parameters) -> "ForceStage | None":
        """Filter the force and look at every peak; None without force."""
        curve, wrench = error_curve(demonstration, parameters), wrench_of(demonstration)
        if curve is None or wrench is None:
            return None
        binned = bin_means(wrench, bin_starts(demonstration.time_s))
        noise = binned_noise(binned, parameters)
        candidates = candidates_of(demonstration.time_s, wrench, curve, noise)
        confidence = force_confidence(candidates, curve.automatic_threshold)
        return cls(curve, candidates, confidence, (demonstration.start_s, demonstration.end_s))

    def threshold(self, parameters: Parameters) -> float:
        """The threshold in force: given, or automatic."""
        if parameters.force_threshold is None:
            return self.curve.automatic_threshold
        return parameters.force_threshold

    def codes(self, parameters: Parameters) -> Codes:
        """What becomes of each candidate; see `rejections`."""
        return rejections(
            self.candidates,
            self.threshold(parameters),
            parameters.force_ratio,
            parameters.min_distance_s,
            parameters.persistence,
            self.recording_s,
        )

    def reported(self, codes: Codes, parameters: Parameters) -> tuple[Peak, ...]:
        """The used peaks and the near misses, in time order.

        Lesser maxima on the flank of a used peak are part of it and not reported.
        """
        used = codes == 0
        near = (self.candidates.height >= NEAR_MISS * self.threshold(parameters)) & (
            self.candidates.ratio >= NEAR_MISS * parameters.force_ratio
        )
        missed = np.flatnonzero(near & ~used)
        times = self.candidates.bin_time_s
        taken = np.concatenate([[-np.inf], times[used], [np.inf]])
        after = np.searchsorted(taken, times[missed])
        apart = np.minimum(times[missed] - taken[after - 1], taken[after] - times[missed])
        chosen: Indices = np.union1d(np.flatnonzero(used), missed[apart >= CLOSEST_S])
        known = self._peaks
        keys = zip(chosen.tolist(), codes[chosen].tolist(), strict=True)
        return tuple([known.get(key) or self.peak(*key) for key in keys])

    def peak(self, candidate: int, code: int = 0) -> Peak:
        """One candidate as a value, with what became of it."""
        if (candidate, code) not in self._peaks:
            self._peaks[candidate, code] = _peak(self.candidates, candidate, code)
        return self._peaks[candidate, code]

    def interval_s(self, candidate: int) -> tuple[float, float]:
        """From the earliest to the latest the change may have been."""
        low, high = self.candidates.earliest_s[candidate], self.candidates.latest_s[candidate]
        return float(low), float(high)


def _peak(candidates: Candidates, candidate: int, code: int) -> Peak:
    x, y, z, *torque = candidates.step[candidate].tolist()
    return Peak(
        time_s=float(candidates.time_s[candidate]),
        bin_time_s=float(candidates.bin_time_s[candidate]),
        height=float(candidates.height[candidate]),
        ratio=float(candidates.ratio[candidate]),
        force_step_N=(x, y, z),
        torque_step_Nm=(torque[0], torque[1], torque[2]) if torque else None,
        persistence=float(candidates.persistence[candidate]),
        rejection=REJECTIONS[code],
    )
