"""Gaussians over the boundaries that were given, as the paper draws them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices
from keyphase.segmentation.kept import Values, places_before
from keyphase.segmentation.motion import Motion
from keyphase.segmentation.segmentation import Gaussian

_FLOOR_M = 2e-4


@dataclass(frozen=True, eq=False)
class FittedGaussians:
    """One Gaussian for each of S segments.

    span (2, S)       their first bins, and those after their last ones
    mean_s, sigma_s   (S,) in time
    gaussians         (S,) the Gaussians themselves
    """

    span: Array
    mean_s: Array
    sigma_s: Array
    gaussians: Values

    @classmethod
    def none(cls) -> "FittedGaussians":
        """Of no segment."""
        return cls(np.zeros((2, 0)), np.zeros(0), np.zeros(0), np.empty(0, dtype=object))

    def intervals_s(self, times_s: Array) -> Array:
        """(S - 1, 2): from the mean of each boundary's earlier Gaussian plus its standard deviation
        to that of the later one less its own (the paper's t_b1 and t_b2), widened to hold the
        boundary, `times_s` (S - 1,).
        """
        mean, sigma = self.mean_s, self.sigma_s
        edges = np.column_stack([mean[:-1] + sigma[:-1], mean[1:] - sigma[1:], times_s])
        return np.column_stack([edges.min(axis=1), edges.max(axis=1)])


class SegmentGaussians:
    """Fits one Gaussian to each segment of a motion, in time that grows with the segments."""

    def __init__(self, motion: Motion) -> None:
        self._motion = motion
        self._last = FittedGaussians.none()

    @cached_property
    def _middle_m(self) -> Array:
        return self._motion.position_m.mean(axis=0)

    @cached_property
    def _sums(self) -> tuple[Array, Array]:
        """Running sums (n + 1, 5) and (n + 1, 10) of time and position, and of their products."""
        motion = self._motion
        samples = np.column_stack(
            [motion.time_s - motion.time_s[0], motion.position_m - self._middle_m]
        )
        rows, columns = np.triu_indices(4)
        products = samples[:, rows] * samples[:, columns]
        zeros = np.zeros((1, 4)), np.zeros((1, len(rows)))
        return (
            np.vstack([zeros[0], np.cumsum(samples, axis=0)]),
            np.vstack([zeros[1], np.cumsum(products, axis=0)]),
        )

    def fitted(self, boundaries: Indices) -> FittedGaussians:
        """One Gaussian per segment between boundaries, B + 1 of them; `boundaries` (B,) are the
        first bins of the motion after each, ascending.

        Those of segments that were there the last time stay: a line that is dragged changes few.
        """
        motion = self._motion
        edges = np.concatenate([[0], boundaries, [len(motion.time_s)]])
        first = np.minimum(edges[:-1], len(motion.time_s) - 1)
        span = np.stack([first, np.maximum(edges[1:], first + 1)])
        # Several threads may ask at once: what was there is replaced, never changed.
        last = self._last
        place = places_before(last.span, span)
        stays, new = place >= 0, np.flatnonzero(place < 0)
        mean, sigma = np.empty(len(first)), np.empty(len(first))
        gaussians: Values = np.empty(len(first), dtype=object)
        mean[stays], sigma[stays] = last.mean_s[place[stays]], last.sigma_s[place[stays]]
        gaussians[stays] = last.gaussians[place[stays]]
        if len(new):
            mean[new], sigma[new], gaussians[new] = self._between(*span[:, new])
        self._last = FittedGaussians(span, mean, sigma, gaussians)
        return self._last

    def _between(self, first: Indices, last: Indices) -> tuple[Array, Array, Values]:
        """Mean and standard deviation in time (B,) and the Gaussians (B,) of the samples from
        `first` to before `last` (B,)."""
        motion, (sums, products) = self._motion, self._sums
        count = (last - first)[:, None]
        mean = (sums[last] - sums[first]) / count
        square = np.empty((len(count), 4, 4))
        rows, columns = np.triu_indices(4)
        square[:, rows, columns] = (products[last] - products[first]) / count
        square[:, columns, rows] = square[:, rows, columns]
        covariance = square - mean[:, :, None] * mean[:, None, :]
        sigma = np.sqrt(np.maximum(covariance[:, 0, 0], (0.5 * motion.step_s) ** 2))
        covariance = covariance[:, 1:, 1:] + _FLOOR_M**2 * np.eye(3)
        position = mean[:, 1:] + self._middle_m
        weight = count[:, 0] / len(motion.time_s)
        when = mean[:, 0] + motion.time_s[0]
        found: Values = np.empty(len(count), dtype=object)
        found[:] = [
            Gaussian(*each)
            for each in zip(
                weight.tolist(), when.tolist(), sigma.tolist(), position, covariance, strict=True
            )
        ]
        return when, sigma, found
