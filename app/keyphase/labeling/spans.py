"""Which segments a person's decision is about, after boundaries have moved, come and gone."""

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

from keyphase.labeling.boundary_line import BoundaryLine, Mark

Span = tuple[float, float]
"""Start and end of a segment [s]."""

Value = TypeVar("Value")


@dataclass(frozen=True, eq=False, slots=True)
class HeldSpan:
    """The span of a segment, each side held by the mark that was there, or fixed in time.

    A side that is held moves with its mark, so a decision stays with its segment when a person
    moves the boundary beside it.
    """

    start: Mark | float
    end: Mark | float

    @property
    def span_s(self) -> Span:
        """Where the span now is."""
        return _now(self.start), _now(self.end)

    @property
    def merged_by_hand(self) -> bool:
        """Whether a person took away a boundary at one of its sides."""
        return any(isinstance(side, Mark) and side.taken_away for side in (self.start, self.end))


def hold(span_s: Span, line: BoundaryLine) -> HeldSpan:
    """Hold a span by the marks that are at its sides."""
    start, end = (line.find(time) for time in span_s)
    if start is end:
        return HeldSpan(*span_s)
    return HeldSpan(start or span_s[0], end or span_s[1])


@dataclass(frozen=True, eq=False, slots=True)
class Decision(Generic[Value]):
    """What a person decided about the segments inside a span, and by which edit."""

    edit: int
    span: HeldSpan
    value: Value


def middles_within(span_s: Span, middles_s: Sequence[float]) -> range:
    """Indices of the segments whose middle lies inside a span.

    So a segment that was split passes what was decided about it to its parts, and of several
    that were joined the longest decides.
    """
    return range(bisect_right(middles_s, span_s[0]), bisect_left(middles_s, span_s[1]))


def assign(
    decisions: Sequence[Decision[Value]], middles_s: Sequence[float]
) -> tuple[dict[int, Value], list[Decision[Value]]]:
    """The latest decision about each segment, and the decisions that have no segment left.

    A decision that a later one replaced, or whose segment a person merged with another, has
    done its work and is not reported.
    """
    taken: dict[int, Value] = {}
    homeless: list[Decision[Value]] = []
    later: list[Span] = []
    for decision in reversed(decisions):
        span = decision.span.span_s
        segments = middles_within(span, middles_s)
        for segment in segments:
            taken.setdefault(segment, decision.value)
        if not segments and not decision.span.merged_by_hand and not _is_inside(span, later):
            homeless.append(decision)
        later.append(span)
    return taken, homeless[::-1]


def _is_inside(span_s: Span, others_s: Sequence[Span]) -> bool:
    return any(start <= span_s[0] and span_s[1] <= end for start, end in others_s)


def _now(side: Mark | float) -> float:
    return side.time_s if isinstance(side, Mark) else side
