"""Median and quantile are numpy's, to the bit."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from keyphase.segmentation.order_statistics import column_medians, median, quantile

finite = st.floats(-1e9, 1e9)


@given(arrays(float, st.integers(1, 60), elements=finite), st.floats(0.0, 1.0))
def test_median_and_quantile_are_numpys_to_the_bit(values, share):
    assert median(values) == np.median(values)
    assert quantile(values, share) == np.quantile(values, share)


@given(arrays(float, st.tuples(st.integers(1, 40), st.integers(1, 6)), elements=finite))
def test_medians_of_columns_are_numpys_to_the_bit(values):
    np.testing.assert_array_equal(column_medians(values), np.median(values, axis=0))
