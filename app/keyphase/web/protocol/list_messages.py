"""The list of recordings, and what is told beside the document: tasks, notices, uploads."""

from typing import Any, Literal

from msgspec import UNSET, Struct, UnsetType

from keyphase.labeling.assessment import NOTHING_SAID, Assessment
from keyphase.labeling.tasks.task import TaskPhase
from keyphase.transfer.phase_order import Difference
from keyphase.workbench.grid.rows import GridRow, Standing
from keyphase.workbench.grid.stretches import Stretch
from keyphase.workbench.proposals import Proposal
from keyphase.workbench.recording_list import Listing
from keyphase.workbench.recordings import Recording, State, folder_name, printable
from keyphase.workbench.showing.doubts import Piece
from keyphase.workbench.spread import Spread, SpreadItem


class Hello(Struct, frozen=True, tag_field="type", tag="hello"):
    """What a page is told first.

    client     its id, as in the cause of a document
    read_only  it may only look
    defaults   the parameters as they are where nobody chose any
    command    how the server is started again; null where that is not known
    """

    client: str
    read_only: bool
    defaults: dict[str, Any]
    command: str | None = None


class PageThere(Struct, frozen=True):
    """Another page at a recording."""

    id: str
    name: str
    color: int


class RecordingLine(Struct, frozen=True):
    """One line of the list.

    folder  name of the folder it lies in
    strip   its segments in small; `color` null: idle or dropped
    unsure  how many boundaries a person should look at
    pages   who else is there

    proposed_from, proposed_confidence  from which finished recordings its segmentation is proposed,
                                        and how sure the least sure of it is
    outlier                             it fits none of the finished ones
    differs                             how its phases differ from theirs
    differences                         how often another person's segments differ; null where
                                        there are none to compare with
    marked                              what is said of single segments
    changed_since_done                  segments were changed after it was done
    """

    id: str
    name: str
    folder: str
    state: State
    confidence: float | None
    unsure: int
    strip: tuple[Piece, ...]
    error: str | None
    pages: tuple[PageThere, ...]
    proposed_from: tuple[str, ...] = ()
    proposed_confidence: float | None = None
    outlier: bool = False
    differs: Difference | None = None
    assessment: Assessment = NOTHING_SAID
    differences: int | None = None
    marked: tuple[Assessment, ...] = ()
    changed_since_done: bool = False


class Recordings(Struct, frozen=True, tag_field="type", tag="recordings"):
    """The list, whenever it changes; `current` is what this page looks at."""

    folder: str
    current: str | None
    items: tuple[RecordingLine, ...]


class Following(Struct, frozen=True, tag_field="type", tag="following"):
    """The page that is followed; null: none."""

    page: str | None


class TaskMessage(Struct, frozen=True, tag_field="type", tag="task"):
    """Something that takes long; `fraction` null: nobody knows how much is left."""

    id: int
    name: str
    fraction: float | None
    done: bool


class Notice(Struct, frozen=True, tag_field="type", tag="notice"):
    """A line of text, never HTML."""

    level: Literal["info", "warning", "error"]
    text: str


class Refused(Struct, frozen=True, tag_field="type", tag="refused"):
    """A request that was not done, and why; its type, recording and event where it has them."""

    request: str
    recording: str | None
    event: int | None
    text: str


class UploadReady(Struct, frozen=True, tag_field="type", tag="upload_ready"):
    """The pieces of the file may come; `name` is what it will be called."""

    name: str


class UploadRefused(Struct, frozen=True, tag_field="type", tag="upload_refused"):
    """Why a file was not taken, before or after it came; nothing is left of it."""

    text: str


class UploadCancelled(Struct, frozen=True, tag_field="type", tag="upload_cancelled"):
    """The answer to `upload_cancel`; nothing is left of the file."""

    name: str


class Uploaded(Struct, frozen=True, tag_field="type", tag="uploaded"):
    """The file is whole, could be read, and has this name now.

    A recording is opened; a segment file (`compares`) is one of the options to compare with.
    """

    name: str
    compares: bool


class SpreadLine(Struct, frozen=True):
    """What the parameters would do to one recording; with an `error` nothing is known.

    newly_inapplicable  edits whose place would be gone
    own                 parameters set on that recording alone, which go on holding
    done                a person has finished with it
    """

    id: str
    name: str
    error: str | None
    comes_s: tuple[float, ...] | UnsetType = UNSET
    goes_s: tuple[float, ...] | UnsetType = UNSET
    moves_s: tuple[tuple[float, float], ...] | UnsetType = UNSET
    newly_inapplicable: tuple[str, ...] | UnsetType = UNSET
    own: tuple[str, ...] | UnsetType = UNSET
    done: bool = False


class SpreadMessage(Struct, frozen=True, tag_field="type", tag="spread"):
    """What parameters would do to a folder, again and again until all `total` are known.

    Each look has a number of its own, so that what was left is told from what is asked.
    """

    look: int
    total: int
    items: tuple[SpreadLine, ...]


class GridLine(Struct, frozen=True):
    """A recording in the grid.

    standing       as it is sorted and marked
    stretches      its segments, or what is proposed for it
    unsure         how many of its boundaries a person should look at
    proposed_from  from which recordings `stretches` are proposed; empty: they are its own
    differs        how its phases differ from those of the finished ones
    """

    id: str
    name: str
    state: State
    standing: Standing
    stretches: tuple[Stretch, ...]
    unsure: int
    proposed_from: tuple[str, ...]
    error: str | None
    differs: Difference | None = None


class GridMessage(Struct, frozen=True, tag_field="type", tag="grid"):
    """All recordings of a folder and the phases of its task, again whenever any of it changes.

    ids    of all of them, in the order of the list
    rows   those that have changed since the message before; in the first one all
    task   name of the folder's task
    undo   what can be taken back in all recordings; null where nothing can
    """

    folder: str
    ids: tuple[str, ...]
    rows: tuple[GridLine, ...]
    task: str
    phases: tuple[TaskPhase, ...]
    undo: str | None


def grid_line(row: GridRow) -> GridLine:
    """A row as a page is told of it."""
    line = row.recording
    unsure = 0 if line.state == "done" else line.unsure
    return GridLine(
        line.id,
        line.name,
        line.state,
        row.standing,
        row.stretches,
        unsure,
        row.teachers,
        line.error,
        row.differs,
    )


def recordings_message(listing: Listing, current: str | None, page: str) -> Recordings:
    """The list as one page sees it."""
    there: dict[str, list[PageThere]] = {}
    for one in listing.presences:
        if one.recording is not None and one.page != page:
            there.setdefault(one.recording, []).append(PageThere(one.page, one.name, one.color))
    return Recordings(
        folder_name(listing.recordings),
        current,
        tuple(
            _line(line, tuple(there.get(line.id, ())), listing.proposals.get(line.id))
            for line in listing.recordings
        ),
    )


def spread_message(spread: Spread) -> SpreadMessage:
    """What is known of a look."""
    items = tuple(map(_spread_line, spread.items))
    return SpreadMessage(spread.look, len(spread.recordings), items)


def _line(
    recording: Recording, pages: tuple[PageThere, ...], proposal: Proposal | None
) -> RecordingLine:
    return RecordingLine(
        recording.id,
        recording.name,
        printable(recording.path.parent.name),
        recording.state,
        recording.confidence,
        recording.unsure,
        recording.strip,
        recording.error,
        pages,
        *_proposed(proposal),
        recording.assessment,
        recording.differences,
        recording.marked,
        recording.changed_since_done,
    )


def _proposed(
    proposal: Proposal | None,
) -> tuple[tuple[str, ...], float | None, bool, Difference | None]:
    if proposal is None:
        return (), None, False, None
    if proposal.is_outlier:
        return (), None, True, None
    return proposal.teachers, proposal.confidence, False, proposal.differs


def _spread_line(item: SpreadItem) -> SpreadLine:
    recording, change = item.recording, item.change
    if change is None:
        return SpreadLine(recording.id, recording.name, item.error)
    return SpreadLine(
        recording.id,
        recording.name,
        None,
        tuple(map(float, change.comes_s)),
        tuple(map(float, change.goes_s)),
        tuple((float(a), float(b)) for a, b in change.moves_s),
        change.newly_inapplicable,
        change.own,
        change.done,
    )
