"""Whether and when a force comes that ends a skill: one rule, for recordings and for robots.

The force counts from its level before the contact. The level follows the force with a time
constant of 0.1 s until the tool comes near where the contact was demonstrated; friction that
begins with the motion is thus no contact. A force that stays over level and threshold for 20 ms
is one.
"""

from dataclasses import dataclass

import numpy as np

from keyphase.demonstration import Array

DEBOUNCE_S = 0.02
"""How long a force must stay beyond its threshold."""

LEVEL_S = 0.1
"""Time constant with which the level before the contact follows the force."""

ARMED_WITHIN_M = 0.03
"""A contact counts from this far before the demonstrated one, or from half the way to it."""

SHORT_WAY_M = 0.01
ARMED_AFTER = 0.8
"""On a way shorter than this a contact counts from this part of the demonstrated time on."""


@dataclass(frozen=True)
class Arming:
    """From where on, and how, a force is taken for the contact.

    within_m    the tool is near where it is so far before the demonstrated contact
    after_s     and not before so much of the motion is done, in its own time
    level_s     time constant of the level before
    debounce_s  how long the force must stay over the threshold
    """

    within_m: float
    after_s: float = 0.0
    level_s: float = LEVEL_S
    debounce_s: float = DEBOUNCE_S


def arming_for(way_m: float, duration_s: float) -> Arming:
    """Arming of a skill that comes from `way_m` before its contact, along its travel."""
    if way_m < SHORT_WAY_M:
        return Arming(ARMED_WITHIN_M, ARMED_AFTER * duration_s)
    return Arming(min(ARMED_WITHIN_M, 0.5 * way_m))


def contact_time(
    arming: Arming, before_m: Array, along_N: Array, threshold_N: float, step_s: float
) -> float | None:
    """Time since the first sample at which the contact is found; None where it is not.

    before_m (M,): how far the tool is before the contact; along_N (M,): the force along the end
    condition's direction, `step_s` from sample to sample. What a monitor finds that is stepped
    through the samples, all at once.
    """
    from scipy.signal import lfilter

    waited = min(int(np.ceil(arming.after_s / step_s - 1e-6)), len(before_m))
    near = np.flatnonzero(before_m[waited:] <= arming.within_m)
    if not len(near):
        return None
    armed = waited + int(near[0])
    level = float(along_N[0])
    if armed:
        share = min(step_s / arming.level_s, 1.0)
        # The filter follows every sample until the tool is near, the first one included.
        rest = np.array([(1.0 - share) * level])
        level = float(lfilter([share], [1.0, share - 1.0], along_N[:armed], zi=rest)[0][-1])
    over = along_N[armed:] - level > threshold_N
    needed = int(np.ceil((arming.debounce_s - 1e-9) / step_s))
    runs = np.cumsum(over)
    starts = np.where(over, 0, runs)
    lasting = np.flatnonzero(runs - np.maximum.accumulate(starts) >= needed)
    return (armed + int(lasting[0])) * step_s if len(lasting) else None
