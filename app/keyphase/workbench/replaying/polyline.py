"""How far a point is from a path, wherever on it."""

import numpy as np

from keyphase.demonstration import Array


class Polyline:
    """A path (M, 3) [m] of straight pieces; what every distance needs is worked out once."""

    def __init__(self, path_m: Array) -> None:
        self._starts, self._steps = path_m[:-1], np.diff(path_m, axis=0)
        self._along = self._steps / np.maximum((self._steps**2).sum(axis=1), 1e-18)[:, None]

    def distance_m(self, point_m: Array) -> float:
        """Distance of a point (3,) from the nearest piece."""
        away = point_m - self._starts
        shares = np.einsum("mk,mk->m", away, self._along).clip(0.0, 1.0)
        away = away - shares[:, None] * self._steps
        return float(np.sqrt(np.einsum("mk,mk->m", away, away).min()))
