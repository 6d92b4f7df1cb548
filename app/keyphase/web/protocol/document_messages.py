"""The document of a recording as messages: what the page draws, and what led to it."""

from typing import Any, Literal

from msgspec import UNSET, Struct, UnsetType

from keyphase.labeling.assessment import NOTHING_SAID, Assessment
from keyphase.labeling.labeling import Inapplicable
from keyphase.labeling.vocabulary import VocabularyLabel
from keyphase.notices import Severity
from keyphase.segmentation.segmentation import CandidateKind, HeldBack, LineCounts, Origin
from keyphase.workbench.recordings import State

Point = tuple[float, float, float]


class CauseMessage(Struct, frozen=True):
    """The page's own number of the request that led here, and which page it was."""

    event: int
    client: str


class StepMessage(Struct, frozen=True):
    """How much one channel changed at a contact change."""

    name: str
    value: float
    unit: str
    axis: str


class ReasonMessage(Struct, frozen=True):
    """One term of a boundary's probability: what it says, and what it adds to the log-odds."""

    name: str
    contribution: float


class Why(Struct, frozen=True):
    """Why a boundary is where it is, in words and figures; the few strongest reasons."""

    sentences: tuple[str, ...]
    reasons: tuple[ReasonMessage, ...]
    height: float | None
    times_threshold: float | None
    position_s: float | None
    steps: tuple[StepMessage, ...]


class BoundaryMessage(Struct, frozen=True):
    """A boundary.

    was_s       moved by hand from there
    taken_from  whose it was, where it was added by taking over
    accepted    seen by a person and found right
    unsure      a person should look at it
    change      what became of the contact; "" where it is no contact change
    at_m        where the tool was at a contact change
    """

    time_s: float
    origin: Origin
    interval_s: tuple[float, float]
    confidence: float
    contact_change: bool
    change: str
    was_s: float | None
    taken_from: str | None
    accepted: bool
    unsure: bool
    at_m: Point | None
    why: Why


class EndConditionMessage(Struct, frozen=True, omit_defaults=True):
    """When a skill is over: `contact` or `configuration`, with the figures of that kind."""

    kind: Literal["contact", "configuration"]
    direction: Point | UnsetType = UNSET
    threshold_N: float | UnsetType = UNSET
    release: bool | UnsetType = UNSET
    agrees: bool | UnsetType | None = UNSET
    offset_m: float | UnsetType | None = UNSET
    position_tolerance_m: float | UnsetType = UNSET
    rotation_tolerance_rad: float | UnsetType = UNSET
    timeout_s: float | UnsetType | None = UNSET
    gripper: dict[str, Any] | UnsetType = UNSET


class SegmentMessage(Struct, frozen=True):
    """A segment.

    proposed  its name is not accepted yet
    color     number of its colour
    short     the label, shorter, shortest
    middle_m  where the tool was in its middle
    """

    start_s: float
    end_s: float
    label: str
    proposed: bool
    kept: bool
    idle: bool
    color: int
    end_condition: EndConditionMessage
    short: tuple[str, str, str]
    middle_m: Point
    assessment: Assessment = NOTHING_SAID


class PeakMessage(Struct, frozen=True):
    """A peak of the error; `rejection` says why it is no boundary, nothing where it is."""

    time_s: float
    bin_time_s: float
    height: float
    rejection: str


class CandidateMessage(Struct, frozen=True):
    """A place where a boundary could be; `why_not` says what would let it in."""

    time_s: float
    kind: CandidateKind
    probability: float
    given: bool
    why_not: str


class PlanEntryMessage(Struct, frozen=True):
    """One entry of the plan.

    time_s      its anchor inside the segment
    repeat      how often the segment came before
    connect_mm  how far it starts from where the last one ended; null where that is near
    """

    time_s: float
    segment: int
    repeat: int
    connect_mm: float | None


class ElsewhereMessage(Struct, frozen=True):
    """What was done to the same bytes under another name; `take_journal` takes it over."""

    name: str
    steps: int
    done: bool


class BreakMessage(Struct, frozen=True):
    """A stretch in which nothing was demonstrated, a gap or a jump, and what it is in words."""

    start_s: float
    end_s: float
    text: str


class EventMessage(Struct, frozen=True):
    """Something that was logged in words, or what a button or digital output did."""

    time_s: float
    text: str


class NoticeMessage(Struct, frozen=True):
    """What a person should know: of reading, of the journal or of the folder.

    severity  a warning where data was left out, held, filled or mended, is odd, or is not kept as
              usual
    """

    text: str
    severity: Severity


class DocumentMessage(Struct, frozen=True, tag_field="type", tag="document"):
    """What a recording is at one revision.

    selected      index of the segment this page has selected
    folder        name of the folder it lies in
    notices       what was done on reading, and what journal and folder say
    threshold     the force threshold in force; null without force
    gaussians     how many the movement is described by; none without a mixture
    candidates    where boundaries could be, and what became of each
    greatest_step_N  the change of force that the longest arrow of the scene stands for
    changed_since_done  segments were changed after it was done
    locked        why nothing can be changed; null where it can
    changed       the file, or the recipe it is read with, is no longer the one that was labeled
    elsewhere     the same bytes were labeled under another name; null where nothing is known
    labels        the folder's vocabulary, in the order of the number keys
    saved_at      HH:MM:SS of the last step on disk
    inapplicable  edits whose place is gone
    line_counts   how many boundaries are found wherever each line lies
    assessment    what a person thinks of the recording as a whole
    camera_offsets  how far a person has moved each video on the recording's clock [s]
    held_back     how many more there would be, were another parameter let go
    """

    revision: int
    cause: CauseMessage | None
    id: str
    name: str
    folder: str
    start_s: float
    end_s: float
    rate_hz: float
    channels: tuple[str, ...]
    force_channels: int
    edits: int
    notices: tuple[NoticeMessage, ...]
    parameters: dict[str, Any]
    threshold: float | None
    automatic_threshold: float | None
    motion_threshold: float | None
    automatic_motion_threshold: float | None
    automatic_least_step_N: float | None
    boundaries: tuple[BoundaryMessage, ...]
    segments: tuple[SegmentMessage, ...]
    peaks: tuple[PeakMessage, ...]
    gaussians: int
    candidates: tuple[CandidateMessage, ...]
    plan: tuple[PlanEntryMessage, ...]
    proposed_drops: tuple[int, ...]
    inapplicable: tuple[Inapplicable, ...]
    undo: str | None
    redo: str | None
    saved_at: str | None
    greatest_step_N: float | None
    state: State
    changed_since_done: bool
    locked: str | None
    changed: bool
    elsewhere: ElsewhereMessage | None
    labels: tuple[VocabularyLabel, ...]
    line_counts: tuple[LineCounts, ...] = ()
    held_back: tuple[HeldBack, ...] = ()
    breaks: tuple[BreakMessage, ...] = ()
    events: tuple[EventMessage, ...] = ()
    wrench_estimated: bool = False
    camera_offsets: dict[str, float] = {}
    assessment: Assessment = NOTHING_SAID
    selected: int | None = None


class Ghost(Struct, frozen=True):
    """A boundary that a change under way would bring or take."""

    time_s: float
    origin: Origin
    fate: Literal["comes", "goes"]


class GhostMessage(Struct, frozen=True, tag_field="type", tag="ghost"):
    """What a slider or line that is held would bring and take; empty when let go."""

    boundaries: tuple[Ghost, ...]


class OtherSelected(Struct, frozen=True):
    """Another page at the same recording, and the segment it has selected."""

    name: str
    color: int
    segment: int


class OthersMessage(Struct, frozen=True, tag_field="type", tag="others"):
    """What the other pages at the recording that is shown have selected."""

    pages: tuple[OtherSelected, ...]


class PlayheadMessage(Struct, frozen=True, tag_field="type", tag="playhead"):
    """Where this page's playhead is; `between_s` is a stretch that is played again and again."""

    time_s: float
    playing: bool
    speed: float
    loop: bool
    between_s: tuple[float, float] | None = None


class SelectionMessage(Struct, frozen=True, tag_field="type", tag="selection"):
    """The segment this page has selected."""

    segment: int | None


class ShownMessage(Struct, frozen=True, tag_field="type", tag="shown"):
    """Which parts this page's scene shows."""

    parts: dict[str, bool]


class NothingMessage(Struct, frozen=True, tag_field="type", tag="nothing"):
    """No recording is looked at any more."""
