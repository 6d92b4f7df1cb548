"""Force segmentation, first half: the normalized error of a random-walk Kalman filter (II-B).

F(t+1) = F(t) + v, measured with noise e, covariances R1 = ratio * R2 and R2; it starts at the
first measurement with P(0|-1) = R2. The true force is unknown, so the error is taken on the
innovation nu = F_m - F(t|t-1), normalized by its covariance S = P(t|t-1) + R2:

    NIS = nuᵀ S⁻¹ nu

chi-square distributed, with as many degrees of freedom as channels, while nothing changes.
"""

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.bins import bins_of
from keyphase.segmentation.order_statistics import median
from keyphase.segmentation.parameters import Engine, Parameters
from keyphase.segmentation.segmentation import ErrorCurve

FORCE_FLOOR_N = 1e-3
TORQUE_FLOOR_NM = 1e-4
"""Noise is never taken to be less than this."""

FALSE_ALARMS = 0.01
"""False alarms per demonstration that the automatic threshold allows."""

MEDIAN_WINDOW_S = 2.0

_LEVER_M = 0.1
_MAX_MAGNITUDE = 1e9
_HELD_FRACTION = 0.3
_MIN_DIFFERENCES = 8


def wrench_of(demonstration: Demonstration) -> Array | None:
    """Force, and torque where recorded, side by side (N, 3 or 6); None without force."""
    force, torque = demonstration.force_N, demonstration.torque_Nm
    if force is None:
        return None
    wrench = force if torque is None else np.hstack([force, torque])
    # Squares of absurd values would overflow; the normalized error does not depend on the unit.
    largest = float(np.abs(wrench).max())
    return wrench if largest <= _MAX_MAGNITUDE else wrench / (largest / _MAX_MAGNITUDE)


def noise_variance(wrench: Array) -> Array:
    """Variance (D,) of white measurement noise in binned channels (M, D), from differences.

    (1.4826 MAD(dF) / sqrt 2)², which neither steps nor slow changes raise. Differences of zero
    are left out where there are many: a sensor that holds its value would have no noise at all.
    """
    floors = _floors(wrench.shape[1]) ** 2
    differences = np.diff(wrench, axis=0)
    return np.maximum([_robust_variance(column) / 2.0 for column in differences.T], floors)


def _floors(channels: int) -> Array:
    return np.array([FORCE_FLOOR_N] * 3 + [TORQUE_FLOOR_NM] * (channels - 3))


def _robust_variance(values: Array) -> float:
    held = values == 0.0
    if held.mean() > _HELD_FRACTION if len(values) else False:
        values = values[~held]
    if len(values) <= _MIN_DIFFERENCES:
        return 0.0
    return (1.4826 * median(np.abs(values - median(values)))) ** 2


def given_noise(measurement_noise: float, channels: int) -> Array:
    """R2 (D,) from the force channels' [N²]; torque as if that force acted on 0.1 m."""
    return np.array([measurement_noise] * 3 + [measurement_noise * _LEVER_M**2] * (channels - 3))


def normalized_error(
    measured: Array, noise: Array, ratio: float = 1.0, engine: Engine = "vectorised"
) -> Array:
    """Normalized innovation squared (M,) of `measured` (M, D).

    `noise` is R2: variances (D,) or a covariance (D, D); `ratio` is q in R1 = q R2. The engine
    "filterpy" steps filterpy's KalmanFilter as the reference; "vectorised" gives the same
    numbers over a hundred times faster.
    """
    covariance = np.diag(noise) if noise.ndim == 1 else noise
    if engine == "filterpy":
        return _filterpy_error(measured, covariance, ratio)
    return _vectorised_error(measured, covariance, ratio)


def _filterpy_error(measured: Array, covariance: Array, ratio: float) -> Array:
    from filterpy.kalman import KalmanFilter

    channels = measured.shape[1]
    kalman = KalmanFilter(dim_x=channels, dim_z=channels)
    kalman.F = kalman.H = np.eye(channels)
    kalman.R = kalman.P = covariance
    kalman.Q = ratio * covariance
    kalman.x = measured[0]
    errors = np.empty(len(measured))
    for step, sample in enumerate(measured):
        kalman.update(sample)
        errors[step] = kalman.y @ kalman.SI @ kalman.y
        kalman.predict()
    return errors


def _vectorised_error(measured: Array, covariance: Array, ratio: float) -> Array:
    """The same filter on whitened channels, where P and S are the identity times a number.

    nu(t+1) = dF(t+1) + (1 - K(t)) nu(t): a step at a time until the gain K has settled, then
    one linear filter.
    """
    differences = np.diff(measured, axis=0)
    whitening = np.linalg.inv(np.linalg.cholesky(covariance))
    variances = _predicted_variances(ratio, len(measured))
    squares = np.zeros(len(measured))
    for row in whitening:
        squares[1:] += _innovation(differences @ row, variances) ** 2
    squares[: len(variances)] /= 1.0 + variances
    squares[len(variances) :] /= 1.0 + variances[-1]
    return squares


def _innovation(white: Array, variances: Array) -> Array:
    """Innovation (M - 1,) of one channel from its whitened differences, zero before the first.

    One channel at a time: fresh memory for all at once would take longer than the filter.
    """
    from scipy.signal import lfilter

    early = min(len(variances), len(white))
    innovation = np.empty(len(white))
    last = 0.0
    for step, keep in enumerate((1.0 / (1.0 + variances[:early])).tolist()):
        innovation[step] = last = white[step] + keep * last
    keep = float(1.0 / (1.0 + variances[-1]))
    innovation[early:], _ = lfilter([1.0], [1.0, -keep], white[early:], zi=[keep * last])
    return innovation


def _predicted_variances(ratio: float, count: int) -> Array:
    """P(t|t-1) in units of R2, from 1 at the start until it no longer changes.

    P(t+1|t) = P(t|t-1) / (1 + P(t|t-1)) + ratio.
    """
    variances = [1.0]
    while len(variances) < count:
        following = variances[-1] / (1.0 + variances[-1]) + ratio
        if abs(following - variances[-1]) <= 1e-16 * following:
            break
        variances.append(following)
    return np.array(variances)


def settled_gain(ratio: float) -> float:
    """Kalman gain K after the first few steps: p / (1 + p), p = (q + sqrt(q² + 4 q)) / 2."""
    p = 0.5 * (ratio + np.sqrt(ratio * ratio + 4.0 * ratio))
    return float(p / (1.0 + p))


def paper_scales(ratio: float) -> tuple[float, float]:
    """Factors from NIS to both readings of the paper's formula, which differ only in scale.

    The residual after the update over the covariance after it, (1 - K) / K, as the paper
    literally conditions, and over the predicted covariance, (1 - K)² / K.
    For ratio 1: 0.618 and 0.236.
    """
    gain = settled_gain(ratio)
    return (1.0 - gain) / gain, (1.0 - gain) ** 2 / gain


def error_curve(demonstration: Demonstration, parameters: Parameters) -> ErrorCurve | None:
    """The normalized error of a demonstration in bins of 20 ms; None without force."""
    bins = bins_of(demonstration)
    time, binned = bins.time_s, bins.force
    if binned is None:
        return None
    if bins.torque is not None:
        binned = np.hstack([binned, bins.torque])
    noise = binned_noise(binned, parameters)
    error = normalized_error(binned, noise, parameters.process_noise_ratio, parameters.engine)
    median = running_median(time, error)
    return ErrorCurve(time, error, median, binned.shape[1], chi_square_level(*binned.shape))


def binned_noise(binned: Array, parameters: Parameters) -> Array:
    """R2 (D,) of binned channels (M, D): as given in the parameters, or estimated."""
    if parameters.measurement_noise is None:
        return noise_variance(binned)
    return given_noise(parameters.measurement_noise, binned.shape[1])


def chi_square_level(bins: int, channels: int) -> float:
    """Level that one of `bins` normalized errors exceeds once in a hundred demonstrations."""
    from scipy.special import chdtri

    return float(chdtri(channels, FALSE_ALARMS / bins))


def running_median(time_s: Array, error: Array) -> Array:
    """Median of the error over the 2 s around each bin."""
    from scipy.ndimage import median_filter

    from keyphase.segmentation.bins import count_in, typical_step_s

    size = count_in(MEDIAN_WINDOW_S, typical_step_s(time_s), 1, len(error)) | 1
    return median_filter(error, size=size, mode="reflect")
