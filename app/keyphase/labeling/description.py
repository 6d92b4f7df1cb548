"""What a segment with ends that a person set is: its proposed label, idle or not, how it ends."""

from collections.abc import Callable

from keyphase.segmentation.end_condition import end_condition_at
from keyphase.segmentation.segmentation import Segment, Segmentation

Describe = Callable[[Segmentation, float, float, bool, bool], Segment]
"""The segment from start to end [s], given whether start and end are contact changes."""


def describe_segment(
    segmentation: Segmentation,
    start_s: float,
    end_s: float,
    contact_at_start: bool,
    contact_at_end: bool,
) -> Segment:
    """The segment as the program would propose it."""
    del contact_at_start
    longest = max(
        segmentation.segments, key=lambda s: min(s.end_s, end_s) - max(s.start_s, start_s)
    )
    end = end_condition_at(segmentation.demonstration, start_s, end_s, contact_at_end)
    return Segment(start_s, end_s, longest.label, longest.idle, end)
