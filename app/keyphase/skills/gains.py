"""How stiff the impedance must be to press as hard as a demonstration did."""

from dataclasses import dataclass
from math import sqrt

import numpy as np

from keyphase.demonstration import Demonstration
from keyphase.recorded_force import evenly, offset_while_moving
from keyphase.skills.coupling import REFERENCE_REACH

STIFFNESS_N_M = (2000.0, 8000.0)
"""Softest and stiffest translation: the softest meets a hard part gently."""

SPARE = 1.5
"""A reference at its furthest presses with so many times the demonstrated peak."""

_DAMPING_NS_M = 180.0
_PEAK = 0.995
"""Quantile of the force that is its peak: a single sample is a blow."""


@dataclass(frozen=True)
class SkillGains:
    """Stiffness and damping of the impedance that follows the reference of the skills."""

    stiffness_N_m: float = STIFFNESS_N_M[0]
    damping_Ns_m: float = _DAMPING_NS_M
    rotational_stiffness_Nm_rad: float = 40.0
    rotational_damping_Nms_rad: float = 3.0


def gains_for(demonstration: Demonstration) -> SkillGains:
    """K = 1.5 times the demonstrated peak over the reference's reach of 10 mm, 2 to 8 kN/m.

    The reference stays within 10 mm of the tool, so that K caps what can be pressed: with 2 kN/m
    at 20 N. The damping grows with the root of K.
    """
    least, most = STIFFNESS_N_M
    wanted = SPARE * demonstrated_peak(demonstration) / REFERENCE_REACH[0]
    stiffness = min(max(wanted, least), most)
    return SkillGains(stiffness, _DAMPING_NS_M * sqrt(stiffness / least))


def demonstrated_peak(demonstration: Demonstration) -> float:
    """The largest force that was demonstrated, its level in free space aside [N]."""
    if demonstration.force_N is None:
        return 0.0
    size = np.linalg.norm(
        demonstration.force_N - offset_while_moving(evenly(demonstration)), axis=1
    )
    return float(np.quantile(size, _PEAK))
