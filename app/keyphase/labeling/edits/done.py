"""Finishing with a recording, and opening it again."""

from dataclasses import replace

from keyphase.errors import LabelingError
from keyphase.labeling.boundary_line import BoundaryLine, Mark
from keyphase.labeling.edits.base import BaseEdit, InForce
from keyphase.labeling.edits.plan import Plan
from keyphase.labeling.frozen import Frozen, FrozenBoundary
from keyphase.labeling.labeling import Labeling
from keyphase.labeling.walk import Walk

_SAME_S = 1e-3


class Done(BaseEdit, frozen=True, tag="done"):
    """The recording is finished: what is seen stays, whatever the program finds later.

    frozen  what was seen; None in what a person asks for
    """

    frozen: Frozen | None = None

    def checked(self) -> "Done":
        """With values that do not contradict each other."""
        super().checked()
        return self if self.frozen is None else Done(self.frozen.checked())

    def anchored(self, labeling: Labeling) -> "Done":
        """With what is seen now; refused where that is finished already."""
        if labeling.done and not labeling.changed_since_done:
            raise LabelingError("This recording is done already.")
        return Done(Frozen.of(labeling))

    def enter(self, number: int, in_force: InForce) -> None:
        """What was seen takes the place of the edits that led to it."""
        if self.frozen is not None:
            before = _all_edits(in_force)
            in_force.begin_again()
            in_force.before_done = before
            in_force.edits[number] = self

    def apply(self, number: int, walk: Walk, insisted: bool) -> None:
        """Put the frozen values in the place of what the program found."""
        assert self.frozen is not None
        found = walk.line.marks
        start, end = walk.line.start_s, walk.line.end_s
        line = BoundaryLine(start, end, walk.line.gap_s, ())
        # A recording that was replaced by a shorter one has no room for all of them.
        there = (b for b in self.frozen.boundaries if start < b.time_s < end)
        line.marks = [_mark(boundary, found) for boundary in there]
        walk.freeze(self.frozen, line)
        spans = [segment.span_s for segment in self.frozen.segments]
        for segment, span in zip(self.frozen.segments, spans, strict=True):
            held = walk.held(segment.start_s, span, insisted=False)
            if not segment.proposed:
                walk.decide_label(number, held, segment.label)
            if not segment.undecided:
                walk.decide_kept(number, held, segment.kept)
        planned = set(self.frozen.plan)
        left_out = [s for i, s in enumerate(spans) if i not in planned]
        walk.set_plan([spans[i] for i in self.frozen.plan], left_out)

    def step_name(self, labeling: Labeling) -> str:
        """As it is offered."""
        return "Mark done"


class Reopen(BaseEdit, frozen=True, tag="reopen"):
    """The recording is not finished after all: the program's boundaries and all edits count."""

    def anchored(self, labeling: Labeling) -> "Reopen":
        """Refused where the recording is not done."""
        if not labeling.done:
            raise LabelingError("This recording is not done; there is nothing to open again.")
        return self

    def enter(self, number: int, in_force: InForce) -> None:
        """The edits from before it was done count again, and those since."""
        in_force.edits = _all_edits(in_force)
        in_force.before_done = {}
        plans = (n for n, edit in in_force.edits.items() if isinstance(edit, Plan))
        in_force.plan = max(plans, default=None)

    def step_name(self, labeling: Labeling) -> str:
        """As it is offered."""
        return "Mark as not done"


def _all_edits(in_force: InForce) -> dict[int, BaseEdit]:
    """The edits from before the recording was done and those since, without what was frozen."""
    both = {**in_force.before_done, **in_force.edits}
    return {number: edit for number, edit in both.items() if not isinstance(edit, Done)}


def _mark(boundary: FrozenBoundary, found: list[Mark]) -> Mark:
    """The boundary under edit, with what the program finds at its place as evidence."""
    near = (mark.automatic for mark in found if abs(mark.time_s - boundary.time_s) <= _SAME_S)
    labeled = boundary.as_labeled(next(near, None))
    return Mark(
        boundary.time_s,
        boundary.contact_change,
        labeled.automatic,
        by_hand=boundary.origin == "user",
        was_s=boundary.was_s,
        accepted=boundary.accepted,
        frozen=replace(labeled, accepted=boundary.accepted),
    )
