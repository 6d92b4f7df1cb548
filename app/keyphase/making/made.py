"""A made demonstration and its exact truth."""

from dataclasses import dataclass
from typing import Any, Literal

from keyphase.demonstration import Demonstration

TOLERANCE_S = 0.15
"""How far a boundary may be from an event that happens in an instant."""

Kind = Literal["contact", "motion"]


@dataclass(frozen=True)
class Event:
    """Something that happened: contact made, lost or changed; motion began, ended or turned.

    window_s   how long before and after `time_s` a boundary may lie and still be this event's:
               the tolerance, and more on the side to which the event itself takes its time
    """

    time_s: float
    label: str
    kind: Kind
    window_s: tuple[float, float] = (TOLERANCE_S, TOLERANCE_S)


@dataclass(frozen=True)
class Made:
    """A demonstration with what is true of it.

    events            what a segmentation must find
    ignore_s          intervals in which an unmatched boundary counts neither way
    ignore_motion_s   the same for boundaries that claim no contact change: motion that begins, ends
                      or turns so near a contact change that one boundary serves both, and turns
                      beside a wrench, of which conventions differ
    gripped           grasps, releases and slips, where there is a gripper
    """

    family: str
    demonstration: Demonstration
    events: tuple[Event, ...]
    ignore_s: tuple[tuple[float, float], ...] = ()
    ignore_motion_s: tuple[tuple[float, float], ...] = ()
    gripped: tuple[Event, ...] = ()

    def truth(self) -> dict[str, Any]:
        """Its entry in a truth file, as JSON values."""
        events = [[round(each.time_s, 4), each.label] for each in self.events]
        gripped = [[round(each.time_s, 4), each.label] for each in self.gripped]
        return {
            "rate_hz": round(self.demonstration.rate_hz, 3),
            "tolerance_s": TOLERANCE_S,
            "events": events,
            "ignore": _rounded(self.ignore_s),
            "kind": f"made by formula, family {self.family}",
            **({"gripper": gripped} if gripped else {}),
            "judged": {
                "what": "all",
                "events": events,
                "kinds": [each.kind for each in self.events],
                "window_s": _rounded([each.window_s for each in self.events]),
                "ignore": _rounded(self.ignore_s),
                "ignore_motion": _rounded(self.ignore_motion_s),
            },
        }


def _rounded(pairs: Any) -> list[list[float]]:
    return [[round(low, 4), round(high, 4)] for low, high in pairs]
