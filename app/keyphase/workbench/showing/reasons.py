"""Why a boundary is where it is, in words."""

from bisect import bisect_right
from collections.abc import Mapping, Sequence
from functools import lru_cache

from keyphase.labeling.labeling import LabeledBoundary
from keyphase.logged import Event
from keyphase.segmentation.segmentation import Gaussian, Peak

_OF_GRIPPER: Mapping[str, str] = {
    "grasp": "The gripper has closed here.",
    "release": "The gripper begins to open here.",
}


_LOGGED_NEAR_S = 0.15
"""What was logged no further away is told as a reason; a person presses a button no better."""
_MOST_LOGGED = 3


def sentences(boundary: LabeledBoundary, threshold: float | None, meeting: "Meeting") -> list[str]:
    """Why a boundary is there."""
    said: list[str] = []
    found = boundary.automatic
    if found is None:
        taken = boundary.taken_from
        return [f"Taken over: {taken}."] if taken else ["Placed by you."]
    if boundary.was_s is not None:
        said.append(f"Moved by you from {boundary.was_s:.3f} s.")
    if found.gripper:
        said.append(_OF_GRIPPER[found.gripper])
    if found.peak is not None:
        said.append(_about_peak(found.peak, threshold))
    if found.position_s is not None and (found.peak is not None or found.contact_change):
        said.append(_about_position(found.position_s - found.time_s))
    elif found.position_s is not None and not found.gripper:
        said += meeting.sentences(found.position_s)
    if not boundary.contact_change and found.peak is not None:
        said.append("It counts as no contact change.")
    return said


def logged_near(time_s: float, events: Sequence[Event]) -> list[str]:
    """What the log says, and what a button did, at a boundary."""
    near = [one for one in events if abs(one.time_s - time_s) <= _LOGGED_NEAR_S]
    return [f"The log says “{one.text}” at {one.time_s:.2f} s." for one in near[:_MOST_LOGGED]]


def _about_peak(peak: Peak, threshold: float | None) -> str:
    if not threshold:
        return f"The error peaks at {_number(peak.height)}."
    times = _number(peak.height / threshold)
    return f"The error peaks at {_number(peak.height)}, {times} × the threshold."


def _about_position(lead_s: float) -> str:
    if abs(lead_s) < 5e-4:
        return "Position alone puts the boundary at the same time."
    way = "later" if lead_s > 0 else "earlier"
    return f"Position alone puts the boundary {abs(lead_s) * 1e3:.0f} ms {way}."


class Meeting:
    """Which two Gaussians meet at a time, in words."""

    def __init__(self, gaussians: Sequence[Gaussian]) -> None:
        self._order = sorted(gaussians, key=lambda gaussian: gaussian.mean_time_s)
        self._means = [gaussian.mean_time_s for gaussian in self._order]

    def sentences(self, time_s: float) -> list[str]:
        """About a boundary that position alone found."""
        after = bisect_right(self._means, time_s)
        if not 0 < after < len(self._order):
            return ["The movement changes here; the force does not."]
        before, now = self._span(after - 1), self._span(after)
        return [f"Gaussian {before} gives way to {now}.", "The force shows no change here."]

    def _span(self, index: int) -> str:
        gaussian = self._order[index]
        return _span(index, gaussian.mean_time_s, gaussian.sigma_time_s, gaussian.weight)


@lru_cache(maxsize=8192)
def _span(index: int, mean_s: float, sigma_s: float, weight: float) -> str:
    part = f"{100 * weight:.0f} % of the samples"
    return f"{index + 1} ({mean_s - sigma_s:.2f} to {mean_s + sigma_s:.2f} s, {part})"


def _number(value: float) -> str:
    """Three figures, never in powers of ten."""
    if value >= 100:
        return f"{value:.0f}"
    return f"{value:.3g}"
