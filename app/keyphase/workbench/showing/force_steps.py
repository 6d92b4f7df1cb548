"""By how much the force changed at each contact change."""

from math import hypot

from keyphase.labeling.labeling import LabeledBoundary, Labeling

_NEAR_S = 0.1
"""A boundary's change of force is that of evidence no further from its interval than this."""


def force_step(boundary: LabeledBoundary, labeling: Labeling) -> tuple[float, float, float] | None:
    """The change of force (3,) [N] at a contact change; None where there is none to show."""
    found = boundary.automatic
    if not boundary.contact_change or found is None:
        return None
    if found.peak is not None:
        return found.peak.force_step_N
    given = [
        one
        for one in labeling.segmentation.candidates
        if one.given and one.force_step_N is not None
    ]
    nearest = min(given, key=lambda one: abs(one.time_s - found.time_s), default=None)
    low, high = found.interval_s
    if nearest is None or not low - _NEAR_S <= nearest.time_s <= high + _NEAR_S:
        return None
    return nearest.force_step_N


def greatest_step(labeling: Labeling) -> float | None:
    """The greatest change of force [N] at any contact change; None without one."""
    steps = [force_step(boundary, labeling) for boundary in labeling.boundaries]
    return max((hypot(*step) for step in steps if step is not None), default=None)
