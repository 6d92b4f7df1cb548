"""Logistic lines with signs that make sense, fitted by weighted, regularised likelihood."""

from collections.abc import Mapping

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.evidence.probability import either, sigmoid
from keyphase.segmentation.evidence.weights import Line

REGULARISATION = 3.0
"""Strong, so that terms that say nearly the same share the weight: made recordings are only like
real ones, and no single term should carry the decision."""


def fitted_line(
    terms: Array,
    columns: Mapping[str, int],
    signs: Mapping[str, int],
    right: Array,
    share: Array,
    beside: Array | None = None,
    regularisation: float = REGULARISATION,
) -> Line:
    """The line over the terms that `signs` names, +1 or -1 each, 0 for either.

    terms (C, T), right (C,) 1 or 0, share (C,) how much each counts. With `beside` (C,), the
    log-odds of a line that is held, what is fitted is that one of the two holds.
    """
    from scipy.optimize import minimize

    names = tuple(signs)
    used = terms[:, [columns[name] for name in names]]
    mean = np.average(used, axis=0, weights=share)
    scale = np.sqrt(np.average((used - mean) ** 2, axis=0, weights=share)) + 1e-6
    table = np.column_stack([(used - mean) / scale, np.ones(len(used))])
    bounds = [_BOUNDS[signs[name]] for name in names] + [(None, None)]
    start = np.append([0.1 * signs[name] for name in names], -2.0)

    def loss(weights: Array) -> tuple[float, Array]:
        own = table @ weights
        odds = own if beside is None else either(beside, own)
        misfit = (share * (np.logaddexp(0.0, odds) - right * odds)).sum()
        slope = share * (sigmoid(odds) - right)
        if beside is not None:
            slope = slope * np.exp(np.minimum(np.logaddexp(own, beside + own) - odds, 0.0))
        penalty = np.append(regularisation * weights[:-1], 0.0)
        return misfit + 0.5 * float(penalty @ weights), table.T @ slope + penalty

    options = {"maxiter": 500}
    found = minimize(loss, start, jac=True, bounds=bounds, method="L-BFGS-B", options=options).x
    return Line(names, mean, scale, found[:-1], float(found[-1]))


CALIBRATED_AT = (-4.0, -1.5, 0.0, 1.5, 4.0)
"""Scores between which the calibration is straight."""

_LOOSE = 0.1
_BOUNDS = {1: (0.0, None), -1: (None, 0.0), 0: (None, None)}


def fitted_calibration(odds: Array, right: Array, share: Array) -> tuple[float, ...]:
    """Log-odds at `CALIBRATED_AT` that hold in the mean over scores (C,): never falling, straight
    in between. A single slope cannot say that doubt is rare between the clear cases.
    """
    at = np.array(CALIBRATED_AT)
    ends = np.append(at[1:-1], np.inf)
    begins = np.append(-np.inf, at[1:-1])
    zero = np.clip(at[0], begins, ends)
    parts = np.clip(odds[:, None], begins, ends) - zero
    signs = {str(part): 1 for part in range(len(begins))}
    columns = {name: part for part, name in enumerate(signs)}
    line = fitted_line(parts, columns, signs, right, share, regularisation=_LOOSE)
    table = np.clip(at[:, None], begins, ends) - zero
    return tuple(line.log_odds(table, columns).tolist())
