"""Where on a tool its weight and inertia act, as its torque tells."""

import numpy as np

from keyphase.demonstration import Array
from keyphase.segmentation.order_statistics import column_medians


def lever(torque: Array, pull: Array) -> Array:
    """The vector (3,) whose cross product with a pull (n, 3) is nearest to the torque (n, 3), which
    may be off by a constant."""
    around = torque - column_medians(torque)
    square = float(np.square(pull).sum()) * np.eye(3) - pull.T @ pull
    return np.linalg.lstsq(square, np.cross(pull, around).sum(axis=0))[0]
