"""Boundaries found by a method of somebody else's, as a `Segmentation` has them."""

from keyphase.demonstration import Demonstration
from keyphase.segmentation.found import Found
from keyphase.segmentation.own_methods import METHODS, FoundBoundary, checked
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Boundary


def find_by_own_method(demonstration: Demonstration, parameters: Parameters) -> Found:
    """What the method named by `parameters.variant` finds.

    Raises ParameterError where there is no such method, or it finds what no boundary can be.
    """
    found = METHODS.get(parameters.variant)(demonstration, parameters)
    boundaries = checked(found, demonstration.start_s, demonstration.end_s)
    return Found(
        boundaries=tuple(map(_boundary, boundaries)),
        gaussians=(),
        curve=None,
        peaks=(),
        threshold=None,
    )


def _boundary(found: FoundBoundary) -> Boundary:
    return Boundary(
        time_s=float(found.time_s),
        origin="force" if found.contact_change else "position",
        interval_s=found.interval_s or (float(found.time_s), float(found.time_s)),
        confidence=float(found.confidence),
        contact_change=found.contact_change,
    )
