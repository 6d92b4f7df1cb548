"""Stretches in which nothing was demonstrated: gaps in the data, and jumps no arm makes."""

from keyphase.demonstration import Demonstration
from keyphase.oddities.oddity import Oddity
from keyphase.oddities.poses import every_jump
from keyphase.oddities.time_steps import every_gap


def breaks_of(demonstration: Demonstration) -> tuple[Oddity, ...]:
    """All gaps and jumps in the order of time, each with its `span_s`."""
    found = (*every_gap(demonstration), *every_jump(demonstration))
    return tuple(sorted(found, key=lambda one: one.span_s or (0.0, 0.0)))


def breaks_within(demonstration: Demonstration, start_s: float, end_s: float) -> tuple[Oddity, ...]:
    """Those of which something lies inside a stretch of time [s]."""
    return tuple(
        one
        for one in breaks_of(demonstration)
        if one.span_s and one.span_s[0] < end_s and one.span_s[1] > start_s
    )
