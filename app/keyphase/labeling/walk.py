"""Edits applied one after another to the boundaries of a segmentation, and what they leave."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from keyphase.labeling.boundary_line import BoundaryLine, Mark
from keyphase.labeling.edits import (
    Accept,
    AcceptLabels,
    Add,
    BringBack,
    Contact,
    DropIdle,
    Edit,
    Forget,
    Keep,
    Label,
    Merge,
    Move,
    Plan,
    Remove,
    Reset,
    Span,
    TakeOver,
)
from keyphase.labeling.labeling import Inapplicable
from keyphase.labeling.spans import Decision, HeldSpan, hold
from keyphase.segmentation.segmentation import Segmentation


@dataclass(frozen=True, eq=False)
class HeldPlan:
    """The plan a person made: spans to execute in order, and spans of what was left out."""

    order: tuple[HeldSpan, ...]
    left_out: tuple[HeldSpan, ...]


@dataclass(eq=False)
class Walk:
    """What edits leave: boundaries, decisions in the order they were made, and the plan.

    decided_before_idle  how many of `keeps` came before idle segments were last dropped
    """

    line: BoundaryLine
    labels: list[Decision[str]] = field(default_factory=list)
    keeps: list[Decision[bool]] = field(default_factory=list)
    decided_before_idle: int | None = None
    plan: HeldPlan | None = None
    _missed: dict[float, Inapplicable] = field(default_factory=dict)
    _holds: dict[Span, HeldSpan] = field(default_factory=dict)

    @property
    def missed(self) -> list[Inapplicable]:
        """Edits of boundaries that found no boundary, and that no later edit made moot."""
        return list(self._missed.values())

    def add(self, number: int, edit: Add) -> None:
        """Put a boundary where there is none."""
        obstacle = self.line.obstacle(edit.time_s)
        if obstacle is None:
            self.line.place(Mark(edit.time_s, bool(edit.contact_change)), edit.time_s)
        else:
            self._miss(
                number, edit.time_s, edit.time_s, f"Boundary at {edit.time_s:.3f} s: {obstacle}."
            )

    def move(self, number: int, edit: Move, insisted: bool) -> None:
        """Move a boundary; a person's `insisted` adds one where it is gone."""
        mark = self.line.find(edit.from_s)
        what = f"Boundary moved from {edit.from_s:.3f} to {edit.to_s:.3f} s"
        obstacle = self.line.obstacle(edit.to_s, moving=mark)
        if mark is None and not insisted:
            self._miss(number, edit.from_s, edit.to_s, f"{what}: it is no longer found.")
        elif obstacle is not None:
            self._miss(number, edit.from_s, edit.to_s, f"{what}: {obstacle}.")
        else:
            mark = mark or Mark(edit.from_s, contact_change=False)
            if not mark.by_hand and mark.automatic is not None:
                mark.was_s = mark.automatic.time_s
            self.line.place(mark, edit.to_s)

    def remove(self, edit: Remove) -> None:
        """Take a boundary away; where it is not found there is nothing to do."""
        self._missed.pop(edit.time_s, None)
        mark = self.line.find(edit.time_s)
        if mark is not None:
            self.line.take_away(mark)

    def merge(self, edit: Merge) -> None:
        """Take all boundaries between two times away."""
        for time in [time for time in self._missed if edit.from_s < time < edit.to_s]:
            del self._missed[time]
        for mark in self.line.between(edit.from_s, edit.to_s):
            self.line.take_away(mark)

    def judge(self, number: int, edit: Contact | Accept, insisted: bool) -> None:
        """Say something about a boundary."""
        mark = self.line.find(edit.time_s)
        if mark is None and insisted and self.line.obstacle(edit.time_s) is None:
            mark = Mark(edit.time_s, contact_change=False)
            self.line.place(mark, edit.time_s)
        if mark is None:
            text = f"Boundary at {edit.time_s:.3f} s: it is no longer found."
            self._miss(number, edit.time_s, edit.time_s, text)
        elif isinstance(edit, Contact):
            mark.contact_change = edit.contact_change
        else:
            mark.accepted = True

    def name(self, number: int, edit: Label, insisted: bool) -> None:
        """Give a segment its label."""
        span = self._held(edit.time_s, edit.span_s, insisted)
        self.labels.append(Decision(number, span, edit.label))

    def keep(self, number: int, edit: Keep, insisted: bool) -> None:
        """Keep or drop a segment."""
        span = self._held(edit.time_s, edit.span_s, insisted)
        self.keeps.append(Decision(number, span, edit.kept))

    def order(self, edit: Plan) -> None:
        """Replace the plan."""
        spans = edit.spans_s or tuple(self._around(time) for time in edit.order)
        held = {span: hold(span, self.line) for span in {*spans, *edit.left_out_s}}
        self.plan = HeldPlan(
            tuple(held[span] for span in spans), tuple(held[span] for span in edit.left_out_s)
        )

    def _held(self, time_s: float, span_s: Span | None, insisted: bool) -> HeldSpan:
        span = span_s or self._around(time_s)
        for side in span if insisted else ():
            if self.line.find(side) is None and self.line.obstacle(side) is None:
                self.line.place(Mark(side, contact_change=False), side)
                self.forget_holds()
        if span not in self._holds:
            self._holds[span] = hold(span, self.line)
        return self._holds[span]

    def forget_holds(self) -> None:
        """Marks have come, gone or moved: the sides of spans have to be found anew."""
        self._holds.clear()

    def _around(self, time_s: float) -> Span:
        times = [self.line.start_s, *(m.time_s for m in self.line.marks), self.line.end_s]
        after = next((i for i in range(1, len(times)) if time_s < times[i]), len(times) - 1)
        return times[after - 1], times[after]

    def _miss(self, number: int, from_s: float, to_s: float, text: str) -> None:
        # Of edits that follow one another on one boundary, the last says where it was wanted.
        self._missed.pop(from_s, None)
        self._missed[to_s] = Inapplicable(number, text)


def walk(segmentation: Segmentation, edits: Mapping[int, Edit]) -> Walk:
    """Apply edits, by their number and in order, to the boundaries of a segmentation."""
    demonstration = segmentation.demonstration
    line = BoundaryLine(
        demonstration.start_s,
        demonstration.end_s,
        1.0 / demonstration.rate_hz,
        segmentation.boundaries,
    )
    done = Walk(line)
    in_force = _in_force(edits)
    insisted = {edit.edit for edit in in_force.values() if isinstance(edit, BringBack)}
    last_plan = max((n for n, edit in in_force.items() if isinstance(edit, Plan)), default=None)
    for number, edit in in_force.items():
        if not isinstance(edit, Plan) or number == last_plan:
            _apply(done, number, edit, number in insisted)
    return done


def _in_force(edits: Mapping[int, Edit]) -> dict[int, Edit]:
    """Edits since the last reset that were not forgotten."""
    since: dict[int, Edit] = {}
    for number, edit in edits.items():
        if isinstance(edit, Reset):
            since.clear()
        elif isinstance(edit, Forget):
            since.pop(edit.edit, None)
        elif isinstance(edit, TakeOver):
            since = {number: edit}
        else:
            since[number] = edit
    return since


def _apply(done: Walk, number: int, edit: Edit, insisted: bool) -> None:
    if isinstance(edit, Add | Move | Remove | Merge | Contact | Accept):
        done.forget_holds()
    match edit:
        case Add():
            done.add(number, edit)
        case Move():
            done.move(number, edit, insisted)
        case Remove():
            done.remove(edit)
        case Merge():
            done.merge(edit)
        case Contact() | Accept():
            done.judge(number, edit, insisted)
        case Label():
            done.name(number, edit, insisted)
        case AcceptLabels(labels):
            for each in labels or ():
                done.name(number, each, insisted)
        case Keep():
            done.keep(number, edit, insisted)
        case DropIdle():
            done.decided_before_idle = len(done.keeps)
        case Plan():
            done.order(edit)
        case TakeOver(_, edits):
            for each in edits:
                _apply(done, number, each, insisted)
        case _:
            pass
