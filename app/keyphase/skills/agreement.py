"""Whether a skill's own demonstration ends it: poses and forces through its monitor."""

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.end_condition.agreement import WITHIN_S
from keyphase.segmentation.end_condition.travel import RATE_HZ, sampled
from keyphase.skills.end_monitor import Outcome, start_monitor
from keyphase.skills.primitive import PHASE_SPAN
from keyphase.skills.skill import Skill


def agrees_with(skill: Skill, demonstration: Demonstration) -> bool | None:
    """Whether the demonstration ends the skill as planned within 0.25 s of where it did.

    None for a skill that does not end at a contact, or was made without force: its end is the
    demonstration's own pose.
    """
    if not isinstance(skill.end_condition, ContactEnd) or demonstration.force_N is None:
        return None
    if skill.end_condition.agrees is False:
        return False
    outcome, time_s = outcome_on(skill, demonstration)
    assert skill.demonstrated_s is not None
    if outcome != "contact":
        return False
    # One that was dragged by hand was found to agree about its contact, not about its end.
    return bool(skill.end_condition.agrees) or abs(time_s - skill.demonstrated_s[1]) < WITHIN_S


def outcome_on(skill: Skill, demonstration: Demonstration) -> tuple[Outcome | None, float]:
    """How and when [s] the demonstration would end the skill, up to 0.25 s after it did itself.

    The demonstration must have force. The time is the demonstration's own; the outcome is None
    where it does not end.
    """
    assert skill.demonstrated_s is not None
    start_s, end_s = skill.demonstrated_s
    until = min(end_s + WITHIN_S, demonstration.end_s)
    moments, position, force = sampled(demonstration, start_s, until)
    assert force is not None
    wxyz = _orientations(demonstration, moments)
    rate = PHASE_SPAN * skill.primitive.constants.alpha_x / skill.primitive.duration_s
    phase = np.exp(-rate * (moments - start_s)).tolist()
    monitor, outcome = start_monitor(skill, force[0]), None
    for k in range(len(moments)):
        monitor, outcome = monitor.step(position[k], wxyz[k], force[k], phase[k], 1.0 / RATE_HZ)
        if outcome is not None:
            return outcome, float(moments[k])
    return None, float(moments[-1])


def _orientations(demonstration: Demonstration, moments_s: Array) -> Array:
    wxyz = demonstration.orientation_wxyz
    if wxyz is None:
        return np.tile(quaternions.IDENTITY, (len(moments_s), 1))
    rows = np.searchsorted(demonstration.time_s, moments_s).clip(0, len(demonstration) - 1)
    return wxyz[rows]
