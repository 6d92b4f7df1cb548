"""Expectation maximisation against scikit-learn's from the same start."""

import numpy as np
from sklearn.mixture import GaussianMixture

from keyphase.segmentation.paper.mixture import fit_mixture

FLOOR = np.full(2, 1e-3)


def two_clouds(seed: int = 0):
    rng = np.random.default_rng(seed)
    clouds = [rng.normal(c, s, size=(200, 2)) for c, s in (((0, 0), 0.3), ((1.5, 1), 0.4))]
    return np.vstack(clouds), np.repeat([0, 1], 200)


def test_it_agrees_with_scikit_learn():
    samples, labels = two_clouds()
    ours = fit_mixture(samples, labels, 2, FLOOR)
    theirs = GaussianMixture(
        2,
        means_init=np.array([samples[labels == k].mean(axis=0) for k in (0, 1)]),
        weights_init=[0.5, 0.5],
        tol=1e-9,
        max_iter=500,
    ).fit(samples)
    order = np.argsort(theirs.means_[:, 0])
    np.testing.assert_allclose(ours.mean, theirs.means_[order], atol=0.01)
    np.testing.assert_allclose(ours.weight, theirs.weights_[order], atol=0.01)
    np.testing.assert_allclose(ours.covariance, theirs.covariances_[order], atol=0.01)


def test_responsibilities_of_a_sample_sum_to_one():
    samples, labels = two_clouds(1)
    mixture = fit_mixture(samples, labels, 2, FLOOR)
    np.testing.assert_allclose(mixture.responsibility.sum(axis=1), 1.0)


def test_far_from_the_origin_it_gives_the_same_shapes():
    samples, labels = two_clouds(2)
    near = fit_mixture(samples, labels, 2, FLOOR)
    far = fit_mixture(samples + 3600.0, labels, 2, FLOOR)
    np.testing.assert_allclose(far.covariance, near.covariance, rtol=1e-6)


def test_a_component_that_starves_leaves_the_others_intact():
    samples = np.zeros((50, 2))
    mixture = fit_mixture(samples, np.repeat([0, 1], [49, 1]), 2, FLOOR)
    assert np.isfinite(mixture.mean).all()
    assert np.isfinite(mixture.covariance).all()
