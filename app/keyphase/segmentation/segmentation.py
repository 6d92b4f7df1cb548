"""What a segmentation is: boundaries and segments, and the evidence they rest on."""

from dataclasses import dataclass
from typing import Literal

from keyphase.demonstration import Array, Demonstration
from keyphase.segmentation.end_condition import EndCondition
from keyphase.segmentation.parameters import Parameters

Origin = Literal["position", "force", "both", "gripper", "user"]
CandidateKind = Literal["contact", "motion"]
Change = Literal["", "made", "lost", "changed", "released"]
GripperChange = Literal["grasp", "release"]
Rejection = Literal[
    "", "below threshold", "below ratio", "does not stay", "too close", "at an end", "small step"
]


@dataclass(frozen=True, eq=False)
class Gaussian:
    """One component of the mixture over time and pose, brought back to time and position.

    mean_time_s, sigma_time_s   when, one standard deviation
    mean_position_m     (3,)    where
    covariance_m2       (3, 3)  of position, one standard deviation is what is drawn
    """

    weight: float
    mean_time_s: float
    sigma_time_s: float
    mean_position_m: Array
    covariance_m2: Array


@dataclass(frozen=True, eq=False)
class ErrorCurve:
    """The normalized error of the force filter, one value per bin.

    time_s          (M,)    middle of each bin
    error           (M,)    normalized innovation squared
    running_median  (M,)    over 2 s
    channels                how many force and torque channels it is over
    automatic_threshold     chi-square level of one false alarm in a hundred demonstrations
    """

    time_s: Array
    error: Array
    running_median: Array
    channels: int
    automatic_threshold: float


@dataclass(frozen=True)
class Reason:
    """One term of a boundary's probability.

    name           what it says, in plain words
    value          the evidence itself
    contribution   what it adds to the log-odds: above zero for the boundary, below against it
    """

    name: str
    value: float
    contribution: float

    @property
    def sentence(self) -> str:
        """The term in one line of prose."""
        side = "for" if self.contribution >= 0.0 else "against"
        return f"{self.name}: {abs(self.contribution):.1f} {side} it"


@dataclass(frozen=True)
class Candidate:
    """A place where a boundary could be, and what became of it.

    probability    of a boundary, beside likelier candidates
    given          whether it became a boundary, or part of one
    why_not        "" where it is given, else what would let it in
    force_step_N   mean force after minus before, base frame; None for motion
    """

    time_s: float
    kind: CandidateKind
    probability: float
    given: bool
    why_not: str
    reasons: tuple[Reason, ...]
    force_step_N: tuple[float, float, float] | None = None


@dataclass(frozen=True)
class LineCounts:
    """How many boundaries are found wherever a line lies, all else as it is.

    parameter  whose line it is
    steps      probabilities (K,) at which the number changes, ascending
    counts     (K + 1,) numbers: of a line up to each step, and above the last
    """

    parameter: Literal["force_threshold", "motion_threshold"]
    steps: tuple[float, ...]
    counts: tuple[int, ...]


@dataclass(frozen=True)
class HeldBack:
    """Boundaries held back by a parameter whatever the lines, and its value that lets them go."""

    parameter: Literal["least_step_N", "turns"]
    count: int
    free: float | str


@dataclass(frozen=True, eq=False)
class EvidenceTrack:
    """How likely a boundary is over time: a bump at each candidate, as high as its probability.

    time_s (M,); contact (M,) of a contact change, None without force; motion (M,) of a boundary
    of motion
    """

    time_s: Array
    contact: Array | None
    motion: Array


@dataclass(frozen=True)
class Peak:
    """A local maximum of the normalized error and what became of it.

    time_s         refined at full rate; `bin_time_s` is where the curve peaks
    ratio          height over the running median
    force_step_N   mean force after minus before, base frame (x, y, z); torque alike or None
    persistence    norm of that step in noise levels, over sqrt(channels)
    rejection      "" when the peak is used, else why not
    probability    of a contact change; None in variant paper
    """

    time_s: float
    bin_time_s: float
    height: float
    ratio: float
    force_step_N: tuple[float, float, float]
    torque_step_Nm: tuple[float, float, float] | None
    persistence: float
    rejection: Rejection
    probability: float | None = None


@dataclass(frozen=True)
class Boundary:
    """A point in time between two segments, why it is there and how sure that is.

    interval_s      (earliest, latest) it may lie, ascending
    confidence      0 to 1
    contact_change  the force shows that contact was made, lost or changed
    peak            the force peak behind it, where origin is force or both
    position_s      where position alone puts it, where origin is position or both
    reasons         the terms of its probability, strongest first; none in variant paper
    change          what became of the contact; "" where it is no contact change
    gripper         what the gripper did there; "" where nothing
    """

    time_s: float
    origin: Origin
    interval_s: tuple[float, float]
    confidence: float
    contact_change: bool
    peak: Peak | None = None
    position_s: float | None = None
    reasons: tuple[Reason, ...] = ()
    change: Change = ""
    gripper: GripperChange | Literal[""] = ""


@dataclass(frozen=True)
class Segment:
    """The stretch between two boundaries as the program proposes it.

    label    proposed from the segment's own data, without numbers
    idle     idle segments are proposed as dropped
    measure  how far, how much or how strong: "42 mm", "90°", "20 N"; "" where idle
    """

    start_s: float
    end_s: float
    label: str
    idle: bool
    end_condition: EndCondition
    measure: str = ""


@dataclass(frozen=True, eq=False)
class Segmentation:
    """All boundaries and segments of one demonstration, with what made them.

    `curve` and `peaks` are None and empty where no force was recorded. `threshold` is the
    threshold in force (given or automatic), None without force.
    `motion_threshold` is the probability that boundaries of motion must reach, `candidates` and
    `track` what there is to choose from, `unlike` how far the recording is from all that the
    weights were fitted on, `automatic_least_step_N` how far its force wanders of itself (None
    without force), `line_counts` and `held_back` what other parameters would bring (no
    `line_counts` where a gripper moved); in variant paper they are None, empty and zero.
    Segments tile the demonstration: the first starts at its start, the last ends at its end.
    """

    demonstration: Demonstration
    parameters: Parameters
    boundaries: tuple[Boundary, ...]
    segments: tuple[Segment, ...]
    gaussians: tuple[Gaussian, ...]
    curve: ErrorCurve | None
    peaks: tuple[Peak, ...]
    threshold: float | None
    motion_threshold: float | None = None
    candidates: tuple[Candidate, ...] = ()
    track: EvidenceTrack | None = None
    unlike: float = 0.0
    automatic_least_step_N: float | None = None
    line_counts: tuple[LineCounts, ...] = ()
    held_back: tuple[HeldBack, ...] = ()
