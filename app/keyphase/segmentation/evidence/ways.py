"""What the ways between the valleys of the speed tell: rotation or translation, and going round."""

import numpy as np

from keyphase.demonstration import Array


def rounds(stops: Array, depth: Array) -> Array:
    """How much each valley (V,) is that of a round: two valleys on, or two before, the tool is back
    at the same place, and it never stands. stops (V + 2, 3 or 6) are the poses at the beginning,
    at the valleys and at the end."""
    found = np.zeros(len(depth))
    if len(stops) < 5:
        return found
    strokes = np.linalg.norm(np.diff(stops, axis=0), axis=1) + 1e-9
    back = np.linalg.norm(stops[2:] - stops[:-2], axis=1) / (strokes[1:] + strokes[:-1])
    # back[i] is about stops i to i + 2: valley v is stop v + 1.
    same = -np.log(np.clip(back, 0.05, 1.0))
    found[1:] = same[:-1]
    found[:-1] = np.maximum(found[:-1], same[1:])
    return found * np.clip(1.0 + np.log(np.maximum(depth, 0.02)) / 2.3, 0.0, 1.0)


def rotation_share(stroke: Array) -> Array:
    """How much of each stroke (V, 3 or 6) is rotation, 0 to 1."""
    whole = np.square(stroke).sum(axis=1) + 1e-12
    return np.square(stroke[:, 3:]).sum(axis=1) / whole
