"""What edits leave while they are applied one after another: boundaries, decisions, the plan."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from keyphase.labeling.boundary_line import BoundaryLine, Mark
from keyphase.labeling.frozen import Frozen
from keyphase.labeling.labeling import Inapplicable
from keyphase.labeling.spans import Decision, HeldSpan, Span, hold
from keyphase.segmentation.end_condition import EndCondition


@dataclass(frozen=True, eq=False)
class HeldPlan:
    """The plan a person made: spans to execute in order, and spans of what was left out."""

    order: tuple[HeldSpan, ...]
    left_out: tuple[HeldSpan, ...]


@dataclass(eq=False)
class Walk:
    """What edits leave: boundaries, decisions in the order they were made, and the plan.

    decided_before_idle  how many of `keeps` came before idle segments were last dropped
    frozen               what was seen when the recording was done, instead of what is found now
    """

    line: BoundaryLine
    labels: list[Decision[str]] = field(default_factory=list)
    keeps: list[Decision[bool]] = field(default_factory=list)
    ends: list[Decision[EndCondition | None]] = field(default_factory=list)
    decided_before_idle: int | None = None
    plan: HeldPlan | None = None
    frozen: Frozen | None = None
    edits_applied: int = 0
    _missed: dict[float, Inapplicable] = field(default_factory=dict)
    _holds: dict[Span, HeldSpan] = field(default_factory=dict)

    @property
    def missed(self) -> list[Inapplicable]:
        """Edits of boundaries that found no boundary, and that no later edit made moot."""
        return list(self._missed.values())

    def miss(self, number: int, from_s: float, to_s: float, text: str) -> None:
        """Note an edit that found no boundary at `from_s`, wanted at `to_s`.

        Of edits that follow one another on one boundary, the last says where it was wanted.
        """
        self._missed.pop(from_s, None)
        self._missed[to_s] = Inapplicable(number, text)

    def settle(self, time_s: float) -> None:
        """What was missed at a time is moot."""
        self._missed.pop(time_s, None)

    def settle_between(self, from_s: float, to_s: float) -> None:
        """What was missed between two times is moot."""
        for time in [time for time in self._missed if from_s < time < to_s]:
            del self._missed[time]

    def decide_label(self, number: int, span: HeldSpan, label: str) -> None:
        """Edit `number` gave the segments of a span their label."""
        self.labels.append(Decision(number, span, label))

    def decide_kept(self, number: int, span: HeldSpan, kept: bool) -> None:
        """Edit `number` kept or dropped the segments of a span."""
        self.keeps.append(Decision(number, span, kept))

    def decide_end(self, number: int, span: HeldSpan, end: EndCondition | None) -> None:
        """Edit `number` said when the segments of a span are over; None: as the program says."""
        self.ends.append(Decision(number, span, end))

    def drop_idle(self) -> None:
        """From here on idle segments are dropped, whatever was decided before."""
        self.decided_before_idle = len(self.keeps)

    def set_plan(self, order: Sequence[Span], left_out: Sequence[Span]) -> None:
        """Replace the plan by these spans."""
        held = {span: hold(span, self.line) for span in {*order, *left_out}}
        self.plan = HeldPlan(
            tuple(held[span] for span in order), tuple(held[span] for span in left_out)
        )

    def held(self, time_s: float, span_s: Span | None, insisted: bool) -> HeldSpan:
        """The span an edit was made on, held by the marks at its sides.

        Insisted on, its sides are added where they are gone.
        """
        span = span_s or self.around(time_s)
        for side in span if insisted else ():
            if self.line.find(side) is None and self.line.obstacle(side) is None:
                self.line.place(Mark(side, contact_change=False), side)
                self.forget_holds()
        if span not in self._holds:
            self._holds[span] = hold(span, self.line)
        return self._holds[span]

    def freeze(self, frozen: Frozen, line: BoundaryLine) -> None:
        """Go on from what was seen when the recording was done."""
        self.frozen, self.line = frozen, line
        self.forget_holds()

    def forget_holds(self) -> None:
        """Marks have come, gone or moved: the sides of spans have to be found anew."""
        self._holds.clear()

    def around(self, time_s: float) -> Span:
        """The span of the segment around a time, as boundaries are now."""
        times = [self.line.start_s, *(m.time_s for m in self.line.marks), self.line.end_s]
        after = next((i for i in range(1, len(times)) if time_s < times[i]), len(times) - 1)
        return times[after - 1], times[after]
