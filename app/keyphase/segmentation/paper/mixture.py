"""Expectation maximisation of a Gaussian mixture with full covariances, from given labels."""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices

_ITERATIONS = 100
_GAIN_PER_SAMPLE = 1e-6
_NOTHING = -45.0
"""A density e to this below the highest is lost in the last digit of their sum."""


@dataclass(frozen=True, eq=False)
class Mixture:
    """A fitted mixture of K Gaussians over n samples in d dimensions.

    weight (K,), mean (K, d), covariance (K, d, d), responsibility (n, K)
    """

    weight: Array
    mean: Array
    covariance: Array
    responsibility: Array


def fit_mixture(samples: Array, labels: Indices, count: int, floor: Array) -> Mixture:
    """Fit `count` Gaussians to `samples` (n, d), started from `labels` (n,) in 0...count-1.

    `floor` (d,) is a standard deviation added to each axis: the regularisation. All Gaussians
    are handled by matrix products over the monomials 1, y, y yᵀ of the samples. A component
    that loses its last sample ends the iteration.
    """
    centre = samples.mean(axis=0)
    monomials = _monomials(samples - centre)
    responsibility = np.zeros((len(samples), count))
    responsibility[np.arange(len(samples)), labels] = 1.0
    components = _maximise(monomials, responsibility, floor)
    last = -np.inf
    for _ in range(_ITERATIONS):
        updated, likelihood = _expect(monomials, *components)
        starved = updated.sum(axis=0).min() < 1.0
        if starved or likelihood - last < _GAIN_PER_SAMPLE * len(samples):
            break
        last, responsibility = likelihood, updated
        components = _maximise(monomials, responsibility, floor)
    weight, mean, covariance = components
    return Mixture(weight, mean + centre, covariance, responsibility)


def _expect(monomials: Array, weight: Array, mean: Array, covariance: Array) -> tuple[Array, float]:
    """Responsibilities (n, K) and the log-likelihood of all samples."""
    log_density = monomials @ _coefficients(weight, mean, covariance)
    highest = log_density.max(axis=1, keepdims=True)
    log_density -= highest
    # Most Gaussians are far from most samples, and what adds nothing to one takes time.
    near = log_density > _NOTHING
    density = np.exp(log_density, out=np.zeros_like(log_density), where=near)
    total = density.sum(axis=1, keepdims=True)
    return density / total, float((highest + np.log(total)).sum())


def _monomials(samples: Array) -> Array:
    rows, columns = np.triu_indices(samples.shape[1])
    return np.hstack([np.ones((len(samples), 1)), samples, samples[:, rows] * samples[:, columns]])


def _maximise(monomials: Array, responsibility: Array, floor: Array) -> tuple[Array, Array, Array]:
    d = len(floor)
    sums = responsibility.T @ monomials
    count = sums[:, 0]
    mean = sums[:, 1 : 1 + d] / count[:, None]
    square = np.empty((len(sums), d, d))
    rows, columns = np.triu_indices(d)
    square[:, rows, columns] = square[:, columns, rows] = sums[:, 1 + d :] / count[:, None]
    covariance = square - mean[:, :, None] * mean[:, None, :] + np.diag(floor**2)
    return count / len(monomials), mean, covariance


def _coefficients(weight: Array, mean: Array, covariance: Array) -> Array:
    """Of the monomials in each Gaussian's log density: ln w - (y - m)ᵀ S^-1 (y - m) / 2 - ..."""
    d = mean.shape[1]
    precision = np.linalg.inv(covariance)
    linear = np.einsum("kij,kj->ki", precision, mean)
    constant = np.log(weight) - 0.5 * (
        np.einsum("ki,ki->k", linear, mean)
        + np.linalg.slogdet(covariance)[1]
        + d * np.log(2 * np.pi)
    )
    rows, columns = np.triu_indices(d)
    factor = np.where(rows == columns, -0.5, -1.0)
    quadratic = factor[:, None] * precision[:, rows, columns].T
    return np.vstack([constant, linear.T, quadratic]).astype(np.float64)
