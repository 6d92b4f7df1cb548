"""Formulae by component: the same lines serve one in plain numbers and a batch in arrays.

Control steps one at a time, and numpy takes ten times as long as Python for a single number.
"""

import math
from collections.abc import Sequence
from operator import mul
from typing import Any

import numpy as np

from keyphase.arrays import Array

Components = Sequence[Any]
"""The entries of the last axis, each a plain number or an array over the batch."""


def components(array: Array) -> Components:
    """The last axis of an array taken apart: numbers of one (N,), arrays (...) of a batch."""
    return array.tolist() if array.ndim == 1 else list(np.moveaxis(array, -1, 0))


def joined(parts: Components) -> Array:
    """The array whose last axis are these components, broadcast against each other."""
    # First and last, as a position of one may go with the rotations of a batch.
    if isinstance(parts[0], float) and isinstance(parts[-1], float):
        return np.array(parts)
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


def number(array: Array) -> Any:
    """What has no axis to take apart: the number of one, the array (...) of a batch."""
    return array.item() if array.ndim == 0 else array


def functions(part: Any) -> Any:
    """The module whose `sqrt`, `exp`, ... are for such a component: math or numpy."""
    return math if isinstance(part, float) else np


def dot(left: Components, right: Components) -> Any:
    """Sum of the products of the components."""
    return sum(map(mul, left, right))


def larger(part: Any, least: float) -> Any:
    """The component, or `least` where it is less."""
    return max(part, least) if isinstance(part, float) else np.maximum(part, least)


def chosen(condition: Any, this: Any, other: Any) -> Any:
    """One component where the condition holds, else the other."""
    if isinstance(condition, bool):
        return this if condition else other
    return np.where(condition, this, other)
