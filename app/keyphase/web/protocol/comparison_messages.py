"""Other segmentations beside the one that is shown: of the same tool, and of the other tools."""

from collections.abc import Iterable

from msgspec import Struct, field

from keyphase.files.parts import split_part
from keyphase.labeling.comparing.comparison import Outline
from keyphase.labeling.segment_file import SegmentFile
from keyphase.workbench.desks.desk_state import DeskState
from keyphase.workbench.grid.second_person import differences
from keyphase.workbench.proposals import Proposal
from keyphase.workbench.recordings import printable
from keyphase.workbench.showing.comparing import comparison
from keyphase.workbench.showing.lanes import Lane


class ComparisonMessage(Struct, frozen=True, tag_field="type", tag="comparison"):
    """With what a recording can be compared, and where `with` is not null how that agrees.

    shared                       (shown, other) times of boundaries both have
    only_first_s, only_second_s  boundaries of what is shown alone, of the other alone
    timing_s                     median distance of shared boundaries
    differs_s                    every moment at which the two differ, in boundaries or in names
    """

    recording: str
    options: tuple[str, ...]
    other: str | None = field(name="with", default=None)
    boundaries_s: tuple[float, ...] = ()
    labels: tuple[str, ...] = ()
    shared: tuple[tuple[float, float], ...] = ()
    only_first_s: tuple[float, ...] = ()
    only_second_s: tuple[float, ...] = ()
    f1: float | None = None
    same_label: float | None = None
    timing_s: float | None = None
    differs_s: tuple[float, ...] = ()


class LaneSegment(Struct, frozen=True):
    """What another tool did from one time to another; `color` null: idle or dropped."""

    start_s: float
    end_s: float
    label: str
    color: int | None


class LaneMessage(Struct, frozen=True):
    """Another tool of the same recording, which is a recording of the list by itself."""

    id: str
    name: str
    segments: tuple[LaneSegment, ...]


class LanesMessage(Struct, frozen=True, tag_field="type", tag="lanes"):
    """The other tools that were recorded at the same time, as they stand."""

    recording: str
    lanes: tuple[LaneMessage, ...]


def lanes_message(recording: str, lanes: Iterable[Lane]) -> LanesMessage:
    """What a page draws below the segments."""
    return LanesMessage(recording, tuple(map(_lane, lanes)))


def _lane(lane: Lane) -> LaneMessage:
    segments = tuple(
        LaneSegment(one.start_s, one.end_s, one.label, one.color if one.kept else None)
        for one in lane.labeling.segments
    )
    part = split_part(lane.recording.path)[1] or ""
    return LaneMessage(lane.recording.id, printable(part.rpartition("+")[2]), segments)


def comparison_message(
    state: DeskState,
    other: str | None,
    proposal: Proposal | None = None,
    second: SegmentFile | None = None,
) -> ComparisonMessage:
    """With what a recording can be compared, and how `other` agrees.

    Raises RequestError for a name that is not offered, SegmentFileError and LabelingError for a
    file that cannot be compared.
    """
    found = comparison(state, other, proposal.outline if proposal else None, second)
    if found.outline is None or found.result is None:
        return ComparisonMessage(state.recording.id, found.options)
    outline, result = found.outline, found.result
    own = Outline.of_labeling(state.kept_labeling)
    return ComparisonMessage(
        recording=state.recording.id,
        options=found.options,
        other=found.other,
        boundaries_s=tuple(map(float, outline.boundaries_s)),
        labels=tuple(outline.labels),
        shared=tuple((float(pair.first_s), float(pair.second_s)) for pair in result.shared),
        only_first_s=tuple(map(float, result.only_first_s)),
        only_second_s=tuple(map(float, result.only_second_s)),
        f1=float(result.f1),
        same_label=float(result.same_label),
        timing_s=found.timing_s,
        differs_s=tuple(float(one.start_s) for one in differences(own, outline)),
    )
