"""A stretch of a recording that a skill repeats."""

Span = tuple[float, float]
"""From when to when, in the recording's time [s]."""
