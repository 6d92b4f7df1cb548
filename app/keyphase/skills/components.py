"""Formulae by component: the same lines serve one in plain numbers and a batch in arrays.

Control steps one at a time, and numpy is slow at single numbers.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from keyphase.demonstration import Array

Components = Sequence[Any]
"""The entries of the last axis, each a plain number or an array over the batch."""


def components(array: Array) -> Components:
    """The last axis of an array taken apart: numbers of one (N,), arrays (...) of a batch."""
    return array.tolist() if array.ndim == 1 else list(np.moveaxis(array, -1, 0))


def joined(parts: Components) -> Array:
    """The array whose last axis are these components, broadcast against each other."""
    if isinstance(parts[0], float):
        return np.array(parts)
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


def functions(array: Array) -> Any:
    """The module whose `sqrt`, `sin`, ... take the components of `array`: math or numpy."""
    return math if array.ndim == 1 else np


def number(array: Array) -> Any:
    """What has no axis to take apart: the number of one, the array (...) of a batch."""
    return array.item() if array.ndim == 0 else array


def expanded(value: Any) -> Any:
    """A number as it is, an array (...) with an axis that goes along with the components."""
    return value if isinstance(value, float) else value[..., None]


def dot(left: Components, right: Components) -> Any:
    """Sum of the products of the components."""
    return sum(a * b for a, b in zip(left, right, strict=True))
