"""Stretches of time before and after a contact change in which its force is taken, relative to it.

What lies between them is the change itself: fingers give, an impact rings.
"""

BEFORE_S = (-0.20, -0.06)
"""Its mean is the force before."""

AFTER_S = (0.08, 0.22)
"""Its mean is the force after."""

WIDE_BEFORE_S = (-0.40, -0.06)
WIDE_AFTER_S = (0.08, 0.50)
"""Where it is asked what the contact became, made or lost, rather than how hard it was."""

BEFORE_LAST_S = (-0.40, -0.20)
"""The window before, where the recording itself ends in the contact."""

LAST_S = (-0.04, 1.0)
"""The window after, where the recording itself ends in the contact."""
