"""Arrays that lie on their side, one column a sample, stood upright: MATLAB's usual way."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from keyphase.readers.formats.numeric import Arraylike

_MATRIX = 4
_MAX_LYING = 16
"""A pose has at most so many numbers."""


def upright(
    arrays: Mapping[str, NDArray[Any]],
) -> tuple[dict[str, NDArray[Any]], tuple[str, ...]]:
    """Every array with one row a sample, and what was done.

    (1, N) and (N, 1) become (N,). (D, N) becomes (N, D) where another array of the recording has N
    values in one column and none has D.
    """
    flat = {
        name: values.reshape(-1) if values.ndim == 2 and 1 in values.shape else values
        for name, values in arrays.items()
    }
    return _turned(flat)


def stood_up(
    arrays: Mapping[str, NDArray[Any]],
) -> tuple[dict[str, NDArray[Any]], tuple[str, ...]]:
    """As `upright`, but a column (N, 1) keeps its shape."""
    return _turned({n: v.reshape(-1) if is_lying(v) else v for n, v in arrays.items()})


def is_lying(array: Arraylike) -> bool:
    """Whether an array is one long row of numbers."""
    row = len(array.shape) == 2 and array.shape[0] == 1 and array.shape[1] > _MAX_LYING
    return row and array.dtype.kind in "fiub"


def _turned(
    flat: dict[str, NDArray[Any]],
) -> tuple[dict[str, NDArray[Any]], tuple[str, ...]]:
    lengths = {len(values) for values in flat.values() if values.ndim == 1}
    lying = {
        name
        for name, values in flat.items()
        if (values.ndim == 2 and _lies(values.shape, lengths)) or _is_stack(values.shape, lengths)
    }
    notices = ()
    if lying:
        shown = ", ".join(sorted(lying)[:5])
        notices = (f"Turned {shown}: one column a sample became one row a sample.",)
    return {
        name: np.ascontiguousarray(np.moveaxis(v, -1, 0)) if name in lying else v
        for name, v in flat.items()
    }, notices


def _lies(shape: tuple[int, ...], lengths: set[int]) -> bool:
    wide = shape[0] <= _MAX_LYING and shape[1] > shape[0]
    return wide and shape[1] in lengths and shape[0] not in lengths


def _is_stack(shape: tuple[int, ...], lengths: set[int]) -> bool:
    """Matrices one behind the other, (4, 4, N), as MATLAB writes poses."""
    small = len(shape) == 3 and max(shape[:2]) <= _MATRIX and min(shape[:2]) >= _MATRIX - 1
    return small and shape[2] in lengths and shape[0] not in lengths
