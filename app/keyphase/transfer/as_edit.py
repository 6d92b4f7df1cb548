"""A proposal as one edit: taken over whole, and taken back by one undo."""

from collections.abc import Iterator

from keyphase.labeling.edits import Add, Contact, Keep, Label, Remove, TakeOver
from keyphase.labeling.edits.take_over import Part
from keyphase.segmentation.segmentation import Segmentation
from keyphase.transfer.proposing import Transfer

_SAME_S = 1e-3


def as_edit(transfer: Transfer, segmentation: Segmentation) -> TakeOver:
    """What makes the proposal of the automatic segmentation of the same recording."""
    source = f"proposed from {', '.join(transfer.teachers)}"[:100]
    phases = transfer.phases
    labels = (
        Label(0.5 * (p.start_s + p.end_s), p.name, (p.start_s, p.end_s)) for p in phases if p.name
    )
    kept = (Keep(0.5 * (p.start_s + p.end_s), p.kept, (p.start_s, p.end_s)) for p in phases)
    edits = (*_boundary_edits(transfer, segmentation), *labels, *kept)
    return TakeOver(source, edits, tuple((b.time_s, b.confidence) for b in transfer.boundaries))


def _boundary_edits(transfer: Transfer, segmentation: Segmentation) -> Iterator[Part]:
    """Removals first: a boundary added near one of the program's would take its place."""
    wanted = {b.time_s: b for b in transfer.boundaries}
    stays = {
        own.time_s: next((t for t in wanted if abs(t - own.time_s) <= _SAME_S), None)
        for own in segmentation.boundaries
    }
    yield from (Remove(time) for time, same in stays.items() if same is None)
    taken = set(stays.values())
    for own in segmentation.boundaries:
        same = stays[own.time_s]
        if same is not None and wanted[same].contact_change != own.contact_change:
            yield Contact(own.time_s, wanted[same].contact_change)
    for time, boundary in wanted.items():
        if time not in taken:
            yield Add(time, boundary.contact_change)
