"""Whether a skill's own demonstration ends it: poses and forces through its monitor."""

from dataclasses import replace

import numpy as np

from keyphase.demonstration import Array, Demonstration
from keyphase.rotations import quaternions
from keyphase.segmentation.end_condition import ContactEnd
from keyphase.segmentation.end_condition.agreement import DRAGGED_S, WITHIN_S
from keyphase.segmentation.end_condition.travel import RATE_HZ, sampled
from keyphase.skills.end_monitor import Outcome, start_monitor
from keyphase.skills.primitive import PHASE_SPAN
from keyphase.skills.skill import Skill


def tried(skill: Skill, demonstration: Demonstration) -> Skill:
    """The skill, knowing whether and where its own demonstration ends it.

    It agrees if that is as planned, within 0.25 s of where the demonstration did. None for a skill
    that does not end at a contact, or was made without force: its end is the demonstration's own
    pose.
    """
    end = skill.end_condition
    if not isinstance(end, ContactEnd) or demonstration.force_N is None:
        return skill
    if end.agrees is False:
        return replace(skill, agrees=False)
    outcome, time_s = outcome_on(skill, demonstration)
    assert skill.demonstrated_s is not None
    # One that was dragged by hand was found to agree about its contact, not about its end.
    dragged_s = DRAGGED_S if end.agrees else 0.0
    near = abs(time_s - skill.demonstrated_s[1]) < WITHIN_S + dragged_s
    if outcome != "contact" or not near:
        return replace(skill, agrees=False)
    at_s, columns = time_s - skill.debounce_s, demonstration.position_m.T
    met = np.array([np.interp(at_s, demonstration.time_s, column) for column in columns])
    return replace(skill, agrees=True, met_m=met)


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
