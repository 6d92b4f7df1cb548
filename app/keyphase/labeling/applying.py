"""All edits applied, in order, to the boundaries of a segmentation."""

from collections.abc import Mapping

from keyphase.labeling.boundary_line import BoundaryLine
from keyphase.labeling.edits.base import InForce
from keyphase.labeling.edits.parsing import Edit
from keyphase.labeling.walk import Walk
from keyphase.segmentation.segmentation import Segmentation


def applied(segmentation: Segmentation, edits: Mapping[int, Edit]) -> Walk:
    """What edits, by their number and in order, leave of the boundaries of a segmentation."""
    demonstration = segmentation.demonstration
    line = BoundaryLine(
        demonstration.start_s,
        demonstration.end_s,
        1.0 / demonstration.rate_hz,
        segmentation.boundaries,
    )
    in_force = InForce()
    for number, edit in edits.items():
        edit.enter(number, in_force)
    done = Walk(line)
    for number, edit in in_force.edits.items():
        edit.apply(number, done, number in in_force.insisted)
        done.edits_applied += edit.changes_segments
    return done
