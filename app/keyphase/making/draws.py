"""Random draws that all parts of a made demonstration share: sizes, directions, coloured noise."""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, sosfilt

Array = NDArray[np.float64]
Rows = NDArray[np.intp]

_MAX_SHARE_OF_RATE = 0.44
_WARM_UP_S = 2.0


def log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    """A number whose logarithm is uniform: as often between 0.1 and 1 as between 1 and 10."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def chance(rng: np.random.Generator, share: float) -> bool:
    """True in this share of cases."""
    return bool(rng.random() < share)


def direction(rng: np.random.Generator) -> Array:
    """A unit vector (3,), every direction alike."""
    vector = rng.normal(size=3)
    return vector / np.linalg.norm(vector)


def beside(rng: np.random.Generator, axis: Array) -> Array:
    """A unit vector (3,) at a right angle to `axis`."""
    vector = np.cross(axis, direction(rng))
    return vector / np.linalg.norm(vector)


def low_noise(
    rng: np.random.Generator, count: int, rate_hz: float, high_hz: float, rms: float
) -> Array:
    """Gaussian noise (count, 3) below `high_hz`, its expected root mean square `rms`."""
    return _filtered(rng, count, rate_hz, (0.0, high_hz), rms)


def band_noise(
    rng: np.random.Generator, count: int, rate_hz: float, band_hz: tuple[float, float], rms: float
) -> Array:
    """Gaussian noise (count, 3) of a band, its expected root mean square `rms`."""
    return _filtered(rng, count, rate_hz, band_hz, rms)


def _filtered(
    rng: np.random.Generator, count: int, rate_hz: float, band_hz: tuple[float, float], rms: float
) -> Array:
    """White noise through a Butterworth filter of second order, run in before it is used."""
    low, high = band_hz
    high = min(high, _MAX_SHARE_OF_RATE * rate_hz)
    low = min(low, 0.5 * high)
    run_in = int(_WARM_UP_S * rate_hz)
    white = rng.normal(size=(count + run_in, 3))
    if low > 0.0:
        sos, width = butter(2, [low, high], "band", fs=rate_hz, output="sos"), high - low
    else:
        sos, width = butter(2, high, fs=rate_hz, output="sos"), high
    # White noise spreads its power evenly up to half the rate; a Butterworth filter of second
    # order lets pi/(2 sqrt 2) of its nominal width through.
    share = width * np.pi / (2.0 * np.sqrt(2.0)) / (0.5 * rate_hz)
    return np.asarray(sosfilt(sos, white, axis=0))[run_in:] * rms / np.sqrt(min(share, 1.0))
