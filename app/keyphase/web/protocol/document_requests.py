"""What a page asks about one recording: changes, comparisons, files, curves."""

from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from keyphase.labeling import edits as labeling
from keyphase.labeling.storage.written_files import IfThere
from keyphase.labeling.tasks.task import MAX_PHASES, PhaseEnd, Task, TaskPhase
from keyphase.web.protocol.request_kinds import (
    Counter,
    Id,
    Name,
    OnDocument,
    PageRequest,
    Time,
    Value,
)

Width = Annotated[int, Meta(ge=2, le=20_000)]
"""Fewer than two pixels is no curve, and the decimation panics."""

MAX_PICKED = 10_000
Scope = Literal["this", "picked", "done", "all"]


class Set(OnDocument, tag="set", frozen=True):
    """Change a parameter; `held` while the person is still dragging."""

    parameter: Name
    value: Value | Name | None
    held: bool = False


class Reset(OnDocument, tag="reset", frozen=True):
    """Parameters back to automatic."""


class Edit(OnDocument, tag="edit", frozen=True):
    """Apply one edit."""

    edit: labeling.Edit


class Undo(OnDocument, tag="undo", frozen=True):
    """Take back the last edit or parameter change."""


class Redo(OnDocument, tag="redo", frozen=True):
    """Do again what was taken back."""


class Done(OnDocument, tag="done", frozen=True):
    """This recording is, or is not, finished."""

    done: bool


class KeepLabels(OnDocument, tag="keep_labels", frozen=True):
    """The recording has changed since it was labeled, and the labels are to be kept."""


class TakeJournal(OnDocument, tag="take_journal", frozen=True):
    """Take over what was done to the same bytes under another name."""


class ForgetLabel(OnDocument, tag="forget_label", frozen=True):
    """Take a label out of the folder's vocabulary."""

    label: Name


class Spread(OnDocument, tag="spread", frozen=True):
    """Tell what these parameters would do to all recordings of the folder; do it; or never mind.

    With `include_done` those that are done are opened again; without, they are left alone.
    """

    step: Literal["look", "apply", "leave"]
    include_done: bool = False


Text = Annotated[str, Meta(max_length=labeling.MAX_LABEL_LENGTH)]


class PhaseForAll(OnDocument, tag="phase_for_all", frozen=True):
    """Call a phase `to` in all recordings of the folder that have it; null: drop it in all.

    Those that are done stay as they are, unless `include_done`; they stay done then, too.
    """

    label: Text
    to: Text | None = None
    include_done: bool = False


class PhaseUndo(OnDocument, tag="phase_undo", frozen=True):
    """Take back what was done last to a phase in all recordings of the folder."""


class PhaseOfTask(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A phase of a task: its name, colour (`#rrggbb`), what it ends with.

    optional  not every recording has it
    repeated  a recording may have it several times
    """

    name: Text
    color: Annotated[str, Meta(max_length=7)]
    end: PhaseEnd
    optional: bool = False
    repeated: bool = False


class Phases(OnDocument, tag="phases", frozen=True):
    """Keep these as the phases of the folder's task, in this order; none: it has no task."""

    name: Text
    phases: Annotated[tuple[PhaseOfTask, ...], Meta(max_length=MAX_PHASES)]

    def task(self) -> Task:
        """The task. Raises LabelingError for what is none."""
        parts = map(msgspec.structs.asdict, self.phases)
        return Task(self.name, tuple(TaskPhase(**part) for part in parts))


class Compare(OnDocument, tag="compare", frozen=True):
    """Compare with another segmentation of this recording; null: tell with which one can."""

    other: Id | None = msgspec.field(name="with", default=None)


class Lanes(OnDocument, tag="lanes", frozen=True):
    """Tell what the other tools did that were recorded at the same time."""


class TakeOver(OnDocument, tag="take_over", frozen=True):
    """Make another segmentation of this recording its own, as one edit."""

    other: Id = msgspec.field(name="from")


class Select(OnDocument, tag="select", frozen=True):
    """Select a segment, or none; with `to` all from it to that one."""

    segment: Annotated[int, Meta(ge=0, le=1_000_000)] | None
    to: Annotated[int, Meta(ge=0, le=1_000_000)] | None = None


MAX_TRACKS = 250
"""A recording may have some two hundred further channels."""


class Signals(PageRequest, tag="signals", frozen=True):
    """Ask for the visible range of some tracks."""

    recording: Id
    request: Counter
    tracks: Annotated[list[Name], Meta(max_length=MAX_TRACKS)]
    from_s: Time
    to_s: Time
    width: Width


class Cut(OnDocument, tag="cut", frozen=True):
    """Write what was recorded from one time to another as a recording of its own, and open it."""

    from_s: Time
    to_s: Time


class Offers(OnDocument, tag="offers", frozen=True):
    """Tell in which formats this recording can be written, and what each would lose."""


class Export(OnDocument, tag="export", frozen=True):
    """Write a recording, or others of the list, too.

    kind       a format by the name it has in `offers`, or `page`: the replay that is over, as one
               that needs no server
    scope      this recording, those that are `picked`, those that are done, or all of the list
    trim_idle  leave out idle ends, where the format can
    if_there   what becomes of files that keyphase did not write as they are; without, `in_the_way`
               tells which there are
    """

    kind: Name
    scope: Scope = "this"
    picked: Annotated[tuple[Id, ...], Meta(max_length=MAX_PICKED)] = ()
    trim_idle: bool = False
    if_there: IfThere = "ask"
