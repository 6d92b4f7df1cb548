"""Gaussians over the boundaries that were given, as the paper draws them."""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.segmentation.motion import Motion
from keyphase.segmentation.segmentation import Gaussian

_FLOOR_M = 2e-4

_MAX_KNOWN = 5000
"""About so many Gaussians of segments that are no more are kept."""


class SegmentGaussians:
    """Fits one Gaussian to each segment of a motion, in time that grows with the segments."""

    def __init__(self, motion: Motion) -> None:
        self._motion = motion
        self._known: dict[tuple[int, int], Gaussian] = {}

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

    def fitted(self, boundaries_s: Array) -> tuple[Gaussian, ...]:
        """One Gaussian per segment between boundaries (B,), ascending; B + 1 of them.

        Those of segments that were there before are known: a line that is dragged changes few.
        """
        motion = self._motion
        inner = np.searchsorted(motion.time_s, boundaries_s)
        edges = np.concatenate([[0], inner, [len(motion.time_s)]])
        first = np.minimum(edges[:-1], len(motion.time_s) - 1)
        last = np.maximum(edges[1:], first + 1)
        spans = list(zip(first.tolist(), last.tolist(), strict=True))
        # Several threads may ask at once: what is known is replaced, never changed.
        known = self._known
        new = [i for i, span in enumerate(spans) if span not in known]
        if new:
            if len(known) > _MAX_KNOWN + len(spans):
                known = {span: known[span] for span in spans if span in known}
            found = self._between(first[new], last[new])
            known = known | dict(zip([spans[i] for i in new], found, strict=True))
            self._known = known
        return tuple([known[span] for span in spans])

    def _between(self, first: NDArray[np.intp], last: NDArray[np.intp]) -> tuple[Gaussian, ...]:
        """The Gaussians of the samples from `first` to before `last` (B,)."""
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
        return tuple(
            Gaussian(w, m, s, p, c)
            for w, m, s, p, c in zip(
                weight.tolist(),
                (mean[:, 0] + motion.time_s[0]).tolist(),
                sigma.tolist(),
                position,
                covariance,
                strict=True,
            )
        )


def intervals_s(gaussians: tuple[Gaussian, ...], times_s: Array) -> Array:
    """(B, 2): from the mean of each boundary's earlier Gaussian plus its standard deviation to
    that of the later one less its own (the paper's t_b1 and t_b2), widened to hold the boundary.
    """
    mean = np.array([gaussian.mean_time_s for gaussian in gaussians])
    sigma = np.array([gaussian.sigma_time_s for gaussian in gaussians])
    edges = np.column_stack([mean[:-1] + sigma[:-1], mean[1:] - sigma[1:], times_s])
    return np.column_stack([edges.min(axis=1), edges.max(axis=1)])
