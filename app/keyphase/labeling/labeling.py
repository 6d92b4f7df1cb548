"""What a segmentation has become under a person's edits; plain values, made by `label`."""

from dataclasses import dataclass

from keyphase.labeling.assessment import NOTHING_SAID, Assessment
from keyphase.segmentation.end_condition import EndCondition
from keyphase.segmentation.parameters import Parameters
from keyphase.segmentation.segmentation import Boundary, Origin, Segmentation


@dataclass(frozen=True, eq=False)
class LabeledBoundary:
    """A boundary as it now stands.

    was_s       where the program had put it, if a person moved it [s]
    accepted    a person has seen it and found it right
    automatic   what the program found here; None where a person added the boundary
    taken_from  where it was taken over from, if nobody has moved it since
    """

    time_s: float
    origin: Origin
    interval_s: tuple[float, float]
    confidence: float
    contact_change: bool
    was_s: float | None = None
    accepted: bool = False
    automatic: Boundary | None = None
    taken_from: str | None = None


@dataclass(frozen=True)
class LabeledSegment:
    """A segment as it now stands.

    proposed    the label is the program's, no person has given or accepted it
    kept        it takes part in the plan; an idle one starts as not kept
    color       number of its colour; edits leave the colours of other segments alone
    assessment  what a person thinks of it
    """

    start_s: float
    end_s: float
    label: str
    proposed: bool
    kept: bool
    idle: bool
    color: int
    end_condition: EndCondition
    assessment: Assessment = NOTHING_SAID

    @property
    def middle_s(self) -> float:
        """The time at which edits of this segment are anchored."""
        return 0.5 * (self.start_s + self.end_s)


@dataclass(frozen=True)
class PlanEntry:
    """One execution of a kept segment.

    time_s    anchor inside the segment [s]
    segment   its index among the segments
    repeat    0 for its first execution in the plan, then 1, 2, …
    """

    time_s: float
    segment: int
    repeat: int


@dataclass(frozen=True)
class Inapplicable:
    """An edit whose place is gone: its number in the document, and why, for people."""

    edit: int
    text: str


@dataclass(frozen=True, eq=False)
class Labeling:
    """A segmentation with a person's edits applied.

    Boundaries ascend strictly and lie inside the recording; the segments between them tile it.
    proposed_drops  indices of idle segments about which no person has decided yet
    inapplicable    edits whose place is gone under the present parameters, see `BringBack`
    done            a person has finished with it: its values no longer follow the segmentation
    changed_since_done  edits were made since
    assessment      what a person thinks of the recording as a whole
    made_with       the parameters that had made it when it was done; None where it is not
    """

    segmentation: Segmentation
    boundaries: tuple[LabeledBoundary, ...]
    segments: tuple[LabeledSegment, ...]
    plan: tuple[PlanEntry, ...]
    proposed_drops: tuple[int, ...] = ()
    inapplicable: tuple[Inapplicable, ...] = ()
    done: bool = False
    changed_since_done: bool = False
    made_with: Parameters | None = None
    assessment: Assessment = NOTHING_SAID

    @property
    def parameters(self) -> Parameters:
        """The parameters that made it."""
        return self.made_with or self.segmentation.parameters

    def segment_at(self, time_s: float) -> int:
        """Index of the segment in which `time_s` lies; a boundary belongs to the later one."""
        for index, boundary in enumerate(self.boundaries):
            if time_s < boundary.time_s:
                return index
        return len(self.boundaries)
