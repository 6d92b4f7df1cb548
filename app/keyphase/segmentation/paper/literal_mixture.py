"""The position segmentation as the paper literally describes it: scikit-learn's GaussianMixture.

Random k-means starts on the samples as recorded, and the plain Bayesian information criterion
where no number of Gaussians is given. It is what keyphase's own fit is compared with.
"""

import warnings

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.rotations.courses import from_first
from keyphase.segmentation.motion import METRES_PER_RADIAN
from keyphase.segmentation.paper.position import PositionFit

MAX_GAUSSIANS = 15
"""The sweep of the criterion ends here."""

MAX_SAMPLES = 20_000
"""Of longer recordings every n-th sample is used: a sweep over all would take hours."""


def fit_literal(demonstration: Demonstration, count: int | None, seed: int) -> PositionFit:
    """Fit `count` Gaussians over [time, position, rotation], or as many as BIC finds best."""
    samples = _samples(demonstration)
    if count is not None:
        return _chronological(_fitted(samples, min(count, len(samples)), seed))
    most = min(MAX_GAUSSIANS, len(samples))
    models = [_fitted(samples, k, seed) for k in range(1, most + 1)]
    return _chronological(min(models, key=lambda model: model.bic(samples)))


def _samples(demonstration: Demonstration) -> Array:
    columns = [demonstration.time_s[:, None], demonstration.position_m]
    if demonstration.orientation_wxyz is not None:
        columns.append(METRES_PER_RADIAN * from_first(demonstration.orientation_wxyz))
    return np.hstack(columns)[:: -(-len(demonstration) // MAX_SAMPLES)]


def _fitted(samples: Array, count: int, seed: int):
    from sklearn.exceptions import ConvergenceWarning
    from sklearn.mixture import GaussianMixture
    from threadpoolctl import threadpool_limits

    model = GaussianMixture(count, covariance_type="full", random_state=seed)
    # One thread: sums in one order give the same bytes everywhere, and busy cores do not stall.
    with threadpool_limits(limits=1), warnings.catch_warnings():
        warnings.simplefilter("ignore", ConvergenceWarning)
        return model.fit(samples)


def _chronological(model) -> PositionFit:
    order = np.argsort(model.means_[:, 0], kind="stable")
    mean, covariance = model.means_[order], model.covariances_[order]
    return PositionFit(
        weight=model.weights_[order],
        mean_s=mean[:, 0],
        sigma_s=np.sqrt(covariance[:, 0, 0]),
        mean_position_m=mean[:, 1:4],
        covariance_m2=covariance[:, 1:4, 1:4],
        cut_s=None,
    )
