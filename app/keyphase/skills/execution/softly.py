"""Following softly where the demonstrations of a skill lay apart: there it matters less where."""

from collections.abc import Sequence
from math import sqrt

import numpy as np

from keyphase.demonstration import Array
from keyphase.skills.changed import changed
from keyphase.skills.coupling import Reference
from keyphase.skills.execution.pressing import Pressed
from keyphase.skills.execution.sensed import Sensed
from keyphase.skills.skill import Skill

ALIKE = 0.01
"""Singular value of directions below which they span nothing further."""


def softly(
    reference: Reference, sensed: Sensed, pressed: Sequence[Pressed], skill: Skill, fraction: float
) -> Reference:
    """The reference so near to the tool that a part s of the stiffness is left in translation.

    With y_a measured, y_r -> y_a + s (y_r - y_a) and v_r -> v_a + sqrt(s) (v_r - v_a), which an
    impedance K, D follows as s K, sqrt(s) D would: as well damped as before. What is pressed, and
    the way into a contact, keep all of their stiffness. `fraction` is of the demonstrated time.

    A skill of one demonstration is followed as it is.
    """
    left = 1.0 if skill.spread is None else skill.spread.stiffness_at(fraction)
    if left == 1.0:
        return reference
    across = _across(skill, pressed)
    nearer = across @ (reference.position_m - sensed.position_m)
    slower = across @ (reference.velocity[:3] - sensed.velocity[:3])
    velocity = reference.velocity.copy()
    velocity[:3] -= (1.0 - sqrt(left)) * slower
    return changed(
        reference, position_m=reference.position_m - (1.0 - left) * nearer, velocity=velocity
    )


def _across(skill: Skill, pressed: Sequence[Pressed]) -> Array:
    """Projection (3, 3) on what is at right angles to all that is to stay stiff."""
    firm = [direction for direction, _ in pressed]
    if skill.travel_direction is not None:
        firm.append(np.asarray(skill.travel_direction))
    if not firm:
        return np.eye(3)
    _, size, spanned = np.linalg.svd(np.array(firm))
    kept = spanned[: len(size)][size > ALIKE]
    return np.eye(3) - kept.T @ kept
