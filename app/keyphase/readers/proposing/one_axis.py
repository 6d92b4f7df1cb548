"""Whether three numbers that turn are a rotation vector: what their course says of it."""

import numpy as np

from keyphase.demonstration import Array

ONE_AXIS = (
    "they turn over, or lie, as one axis of half a turn does: a rotation vector, as UR writes?"
)


def is_one_axis(angles: Array, unit: str) -> bool:
    """Whether (M, 3) numbers are a rotation vector, and no angles about three axes.

    At half a turn a vector becomes its opposite, of angles only one does. A tool that points down
    has a vector as long as half a turn in several parts; its angles are longer together.
    """
    turns = angles * {"rad": 1.0, "deg": np.pi / 180.0, "mrad": 1e-3}[unit]
    lengths = np.linalg.norm(turns, axis=1)
    if not len(turns) or lengths.max() > 1.0001 * np.pi:
        return False
    steps = np.diff(turns, axis=0)
    over = np.abs(steps).max(axis=1) > np.pi
    opposite = np.abs(turns[1:] + turns[:-1])[over].sum()
    around = np.abs(steps - 2.0 * np.pi * np.round(steps / (2.0 * np.pi)))[over].sum()
    lies = lengths.min() > 0.9 * np.pi and bool((np.sort(np.abs(turns))[:, 1] > 0.3).all())
    return bool(lies or opposite < 0.5 * around)
