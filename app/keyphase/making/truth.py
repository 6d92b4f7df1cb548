"""What is true of a made demonstration: which events must be found, and where nobody may judge."""

from collections.abc import Iterable

from keyphase.demonstration import Demonstration
from keyphase.making.made import TOLERANCE_S, Event, Made
from keyphase.making.path import MotionEvent

SERVED_S = 0.4
"""Motion that begins, ends or turns within this of a contact change has no boundary of its own."""

END_S = 0.25
"""What happens nearer than this to either end of a recording is not judged."""


def with_truth(
    family: str,
    demonstration: Demonstration,
    contacts: Iterable[Event],
    motion: Iterable[MotionEvent],
    reversals_s: Iterable[float] = (),
    ignored_s: Iterable[tuple[float, float]] = (),
) -> Made:
    """A demonstration with its truth.

    Contact changes come first: motion beside one is served by its boundary, the rest are events.
    `reversals_s` are where a line turns back in wiping; `ignored_s` stretches nobody could judge.
    """
    contacts = list(contacts)
    has_wrench = demonstration.force_N is not None
    moved: list[Event] = []
    served: list[tuple[float, float]] = []
    for each in motion:
        event = _motion_event(each)
        beside = any(abs(each.time_s - contact.time_s) <= SERVED_S for contact in contacts)
        if beside or each.unclear or (has_wrench and each.label == "motion turned"):
            served.append((event.time_s - event.window_s[0], event.time_s + event.window_s[1]))
        else:
            moved.append(event)
    served += [(time - TOLERANCE_S, time + TOLERANCE_S) for time in reversals_s]
    start, end = demonstration.start_s, demonstration.end_s
    inside = [e for e in [*contacts, *moved] if start + END_S <= e.time_s <= end - END_S]
    inside.sort(key=lambda event: event.time_s)
    edges = [(start, start + END_S), (end - END_S, end)]
    ignored = sorted([*edges, *ignored_s])
    return Made(family, demonstration, tuple(inside), tuple(ignored), tuple(sorted(served)))


def _motion_event(event: MotionEvent) -> Event:
    half = TOLERANCE_S + 0.5 * event.standing_s
    return Event(event.time_s, event.label, "motion", (half, half))
