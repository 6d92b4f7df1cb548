"""Another person's segmentation of a recording, taken over as one edit that undo takes back."""

from collections.abc import Iterator

from keyphase.errors import LabelingError
from keyphase.labeling.edits import (
    MAX_LABEL_LENGTH,
    Add,
    Contact,
    Keep,
    Label,
    Plan,
    Remove,
    TakeOver,
)
from keyphase.labeling.edits.take_over import Part
from keyphase.labeling.segment_file import FiledBoundary, FiledSegment, SegmentFile
from keyphase.segmentation.segmentation import Boundary, Segmentation

_SAME_S = 1e-3


def taking_over(file: SegmentFile, segmentation: Segmentation) -> TakeOver:
    """The edit that makes the segmentation in a file out of the automatic one.

    Boundaries the program found at the same time stay the program's, with their evidence; all
    others are removed and added. Every label, kept or dropped, and the plan are the file's.
    Parameters stay as they are: what they bring later lies beside what was taken over. Raises
    LabelingError where the two do not span the same time.
    """
    demonstration = segmentation.demonstration
    start, end = file.segments[0].start_s, file.segments[-1].end_s
    if abs(start - demonstration.start_s) > _SAME_S or abs(end - demonstration.end_s) > _SAME_S:
        raise LabelingError(
            f"Expected a segmentation from {demonstration.start_s:.3f} to "
            f"{demonstration.end_s:.3f} s, but {file.path.name} goes from {start:.3f} to "
            f"{end:.3f} s; choose a segment file of this recording."
        )
    edits = (
        *_boundary_edits(file.boundaries, segmentation.boundaries),
        *(
            Label(_middle(s), _plain(s.label), (s.start_s, s.end_s))
            for s in file.segments
            if s.label
        ),
        *(Keep(_middle(s), s.kept, (s.start_s, s.end_s)) for s in file.segments),
        *_plan_edit(file),
    )
    return TakeOver(_plain(file.path.name), edits)


def _plain(text: str) -> str:
    """A text as a label may be: what is no plain text in it becomes a question mark."""
    return "".join(c if c.isprintable() else "?" for c in text).strip()[:MAX_LABEL_LENGTH]


def _boundary_edits(
    wanted: tuple[FiledBoundary, ...], found: tuple[Boundary, ...]
) -> Iterator[Part]:
    """Removals first: a boundary added near one of the program's would take its place."""
    there = {boundary.time_s: _at(boundary.time_s, found) for boundary in wanted}
    stays = {boundary.time_s for boundary in there.values() if boundary is not None}
    yield from (Remove(b.time_s) for b in found if b.time_s not in stays)
    for boundary in wanted:
        same = there[boundary.time_s]
        if same is None:
            yield Add(boundary.time_s, boundary.contact_change)
        elif same.contact_change != boundary.contact_change:
            yield Contact(same.time_s, boundary.contact_change)


def _at(time_s: float, found: tuple[Boundary, ...]) -> Boundary | None:
    return next((b for b in found if abs(b.time_s - time_s) <= _SAME_S), None)


def _plan_edit(file: SegmentFile) -> Iterator[Plan]:
    """None where the plan is what follows from what is kept."""
    in_time = tuple(segment.id for segment in file.segments if segment.kept)
    if file.plan == in_time:
        return
    order = [file.segments[number - 1] for number in file.plan]
    left_out = [s for s in file.segments if s.kept and s.id not in file.plan]
    yield Plan(
        tuple(_middle(segment) for segment in order),
        tuple((segment.start_s, segment.end_s) for segment in order),
        tuple((segment.start_s, segment.end_s) for segment in left_out),
    )


def _middle(segment: FiledSegment) -> float:
    return 0.5 * (segment.start_s + segment.end_s)
