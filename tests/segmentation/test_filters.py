"""Filters run both ways give the numbers of scipy's sosfiltfilt."""

import numpy as np
import pytest
from scipy.signal import butter, sosfiltfilt

from keyphase.segmentation.filters import fast_part, smoothed


@pytest.mark.parametrize("shape", [(25,), (500, 3), (2503, 6)])
@pytest.mark.parametrize(("run", "kind"), [(smoothed, "lowpass"), (fast_part, "highpass")])
def test_a_filter_run_both_ways_is_scipys_to_the_bit(shape, run, kind):
    values = np.random.default_rng(0).normal(size=shape).cumsum(axis=0)
    sections = butter(2, 3.0, kind, fs=50.0, output="sos")
    rows = np.ascontiguousarray(values.T)
    np.testing.assert_array_equal(run(values, 3.0, 50.0), sosfiltfilt(sections, rows).T)


def test_too_few_values_to_mirror_are_refused():
    with pytest.raises(ValueError, match="more than 9"):
        smoothed(np.zeros(9), 3.0, 50.0)
