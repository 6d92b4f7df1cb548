"""A boundary that a person moved a little still has its contact, and its contact its condition."""

from keyphase.demonstration import Demonstration
from keyphase.segmentation.end_condition.agreement import DRAGGED_S, agrees
from keyphase.segmentation.end_condition.values import ContactEnd

_ROUNDING_S = 1e-6


def still_ends(
    demonstration: Demonstration, span_s: tuple[float, float], end: ContactEnd, was_s: float
) -> bool:
    """Whether a segment keeps the end condition it had while its boundary was at `was_s` [s].

    Derived anew it would be that of whatever else changed near by: a hand that guides a tool in
    contact changes its force all the time. Not where the boundary was moved further than a contact
    reaches (0.2 s), or where the demonstration, begun as the segment is, does not end so.
    """
    start_s, end_s = span_s
    if not end.agrees or abs(end_s - was_s) > DRAGGED_S + _ROUNDING_S:
        return False
    return agrees(demonstration, start_s, was_s, end)
