"""What is odd about a recording, said before anyone labels it; nothing is changed by it."""

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.oddities.breaks import breaks_of, breaks_within
from keyphase.oddities.forces import (
    constant_force,
    frozen_force,
    helping_force,
    odd_size,
    saturated_force,
    wandering_force,
)
from keyphase.oddities.oddity import Oddity
from keyphase.oddities.poses import (
    jumps,
    odd_order,
    odd_reach,
    still_pose,
    turns_too_fast,
    zero_rows,
)
from keyphase.oddities.time_steps import gaps, odd_time, too_brief

__all__ = ["Oddity", "breaks_of", "breaks_within", "oddities_of"]

MIN_ROWS = 20

_CHECKS = (
    odd_time,
    too_brief,
    gaps,
    jumps,
    turns_too_fast,
    odd_order,
    zero_rows,
    still_pose,
    odd_reach,
    odd_size,
    constant_force,
    frozen_force,
    saturated_force,
    wandering_force,
    helping_force,
)


def oddities_of(demonstration: Demonstration) -> tuple[Oddity, ...]:
    """Everything odd about a recording: of time first, then of the pose, then of the force.

    A few rows are too few to say.
    """
    if len(demonstration) < MIN_ROWS:
        return ()
    with np.errstate(all="ignore"):
        return tuple(found for check in _CHECKS for found in check(demonstration))
