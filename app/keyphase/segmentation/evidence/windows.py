"""Means and scatter over windows beside each candidate, in time that does not grow with them."""

from functools import cached_property

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.bins import Indices


class Windows:
    """Windows over the rows of `values` (n,) or (n, D)."""

    def __init__(self, values: Array) -> None:
        columns = values[:, None] if values.ndim == 1 else values
        self._columns, self._n = columns, len(columns)
        self._sums = _running(columns)

    @cached_property
    def _squares(self) -> Array:
        return _running(self._columns * self._columns)

    def mean(self, first: Indices, last: Indices) -> Array:
        """Mean (C, D) over [first, last), cut at the ends; zero where nothing is left."""
        first, last, count = self._inside(first, last)
        return (self._sums[last] - self._sums[first]) / count

    def scatter(self, first: Indices, last: Indices) -> Array:
        """Root of the summed variance (C,) over [first, last)."""
        first, last, count = self._inside(first, last)
        mean = (self._sums[last] - self._sums[first]) / count
        square = (self._squares[last] - self._squares[first]) / count
        return np.sqrt(np.maximum(square - mean * mean, 0.0).sum(axis=1))

    def _inside(self, first: Indices, last: Indices) -> tuple[Indices, Indices, Indices]:
        first = np.minimum(np.maximum(first, 0), self._n)
        last = np.minimum(np.maximum(last, 0), self._n)
        return first, last, np.maximum(last - first, 1)[:, None]


def _running(columns: Array) -> Array:
    sums = np.zeros((len(columns) + 1, columns.shape[1]))
    np.cumsum(columns, axis=0, out=sums[1:])
    return sums


class Sides:
    """The windows of one length on both sides of candidates, `gap` cells away from them."""

    def __init__(self, windows: Windows, at: Indices, gap: int, length: int) -> None:
        self._windows = windows
        self._before, self._after = (at - gap - length, at - gap), (at + gap, at + gap + length)
        self.mean_before = windows.mean(*self._before)
        self.mean_after = windows.mean(*self._after)

    @cached_property
    def scatter_before(self) -> Array:
        """Root of the summed variance (C,)."""
        return self._windows.scatter(*self._before)

    @cached_property
    def scatter_after(self) -> Array:
        """Root of the summed variance (C,)."""
        return self._windows.scatter(*self._after)

    @property
    def jump(self) -> Array:
        """Mean after minus mean before (C, D)."""
        return self.mean_after - self.mean_before

    @property
    def jump_size(self) -> Array:
        """Its norm (C,)."""
        return np.linalg.norm(self.jump, axis=1)
