"""The plan: which segments are executed, in which order, how often."""

from collections import Counter
from collections.abc import Sequence

from keyphase.labeling.labeling import LabeledSegment, PlanEntry
from keyphase.labeling.spans import HeldSpan, middles_within
from keyphase.labeling.walk import HeldPlan


def planned(plan: HeldPlan | None, segments: Sequence[LabeledSegment]) -> tuple[PlanEntry, ...]:
    """The entries of the plan a person made, or all kept segments in the order of time.

    Where a person made one: parts of a segment that was split stand where it stood, segments
    that were joined stand where the longest stood, dropped ones vanish, and kept ones that the
    plan does not know follow the one before them in time.
    """
    kept = [i for i, segment in enumerate(segments) if segment.kept]
    if plan is None:
        return _entries(kept, segments)
    middles = [segment.middle_s for segment in segments]
    owners = _owners(plan.order, middles)
    order: list[int] = []
    for span in plan.order:
        within = middles_within(span.span_s, middles)
        order += [i for i in within if segments[i].kept and owners[i] is span]
    left_out = {i for span in plan.left_out for i in middles_within(span.span_s, middles)}
    for new in kept:
        if new not in left_out and new not in order:
            order.insert(_place_after(new, order), new)
    return _entries(order, segments)


def _owners(spans: Sequence[HeldSpan], middles_s: Sequence[float]) -> dict[int, HeldSpan]:
    """For each segment the span it lies in; the first where several hold it."""
    owners: dict[int, HeldSpan] = {}
    for span in spans:
        for segment in middles_within(span.span_s, middles_s):
            owners.setdefault(segment, span)
    return owners


def _place_after(segment: int, order: Sequence[int]) -> int:
    """Where a new segment goes: after the last execution of the nearest one before it in time."""
    before = max((other for other in order if other < segment), default=None)
    if before is None:
        return 0
    return len(order) - list(reversed(order)).index(before)


def _entries(order: Sequence[int], segments: Sequence[LabeledSegment]) -> tuple[PlanEntry, ...]:
    executed: Counter[int] = Counter()
    entries: list[PlanEntry] = []
    for segment in order:
        entries.append(PlanEntry(segments[segment].middle_s, segment, executed[segment]))
        executed[segment] += 1
    return tuple(entries)
