"""Values that stay while a line is dragged: made once, and again only where they change."""

import threading
from collections.abc import Callable
from typing import Any, Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices

T = TypeVar("T")
Values = NDArray[Any]


class Kept(Generic[T]):
    """One value for each of `count` candidates, made when first asked for.

    `make` gets a candidate and the numbers it depends on, `width` of them and none a NaN.
    """

    def __init__(self, count: int, width: int, make: Callable[[int, list[float]], T]) -> None:
        self._make = make
        self._values: Values = np.empty(count, dtype=object)
        self._on = np.full((count, width), np.nan)
        self._lock = threading.Lock()

    def of(self, candidates: Indices, on: Array) -> Values:
        """The values of candidates (B,) under the numbers `on` (B, width)."""
        with self._lock:
            other = (self._on[candidates] != on).any(axis=1)
            new = candidates[other]
            for candidate, numbers in zip(new.tolist(), on[other].tolist(), strict=True):
                self._values[candidate] = self._make(candidate, numbers)
            self._on[new] = on[other]
            return self._values[candidates]


def places_before(before: Array, now: Array) -> Indices:
    """Where each column of `now` (K, B) is among those of `before` (K, A); -1 where it is not.

    The first row of `before` ascends.
    """
    if not before.shape[1]:
        return np.full(now.shape[1], -1, dtype=np.intp)
    at = np.minimum(np.searchsorted(before[0], now[0]), before.shape[1] - 1)
    return np.where((before[:, at] == now).all(axis=0), at, -1)
