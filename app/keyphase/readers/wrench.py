"""A recorded wrench turned into keyphase's: what acts on the tool, without offset, in the base."""

import numpy as np
from scipy.spatial.transform import Rotation

from keyphase.demonstration import Array
from keyphase.readers.recipes.recipe import Load


def offset_of(load: Load, values: Array, time_s: Array) -> Array | None:
    """The constant (3,) to take out of force or torque (N, 3) [N or N m], or None.

    The mean of the first seconds is taken in the recorded frame, where the tool's weight is
    constant only as long as the tool does not turn.
    """
    if load.offset is not None:
        return load.size * np.array(load.offset)
    if load.offset_from_first_s is not None:
        return values[time_s - time_s[0] <= load.offset_from_first_s].mean(axis=0)
    return None


def in_base_frame(values: Array, orientation_wxyz: Array) -> Array:
    """Vectors (N, 3) of the tool frame in the base frame: v_base = R(q) v_tool, row by row.

    The torque stays about the tool point, since only the axes change.
    """
    return Rotation.from_quat(orientation_wxyz, scalar_first=True).apply(values)
