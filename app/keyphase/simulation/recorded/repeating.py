"""Whether a replay repeats all of its recording, and in its order; pauses may be left out."""

import numpy as np

from keyphase.recorded_force import Even

PAUSE_M, PAUSE_RAD = 0.02, 0.2
"""A stretch in which the tool stayed so near to where it was is a pause, the beginning of a motion
that was cut 0.2 s late included."""

Span = tuple[float, float]


class Repeating:
    """What of a recording has been repeated by the skills that were begun, one after the other."""

    def __init__(self, even: Even) -> None:
        self._even = even
        self._until_s = float(even.time_s[0])
        self._left_out = False
        self._span_s: Span | None = None

    def begin(self, span_s: Span) -> None:
        """A skill repeats this stretch; what lies before it was repeated already, or is a pause."""
        if span_s == self._span_s:
            return
        self._span_s = span_s
        self._left_out |= not self._is_pause(self._until_s, span_s[0])
        self._until_s = max(self._until_s, span_s[1])

    @property
    def whole(self) -> bool:
        """Whether nothing but pauses was left out."""
        return not self._left_out and self._is_pause(self._until_s, float(self._even.time_s[-1]))

    def _is_pause(self, from_s: float, to_s: float) -> bool:
        rows = slice(*np.searchsorted(self._even.time_s, (from_s, to_s)).tolist())
        place, wxyz = self._even.position_m[rows], self._even.orientation_wxyz[rows]
        if len(place) < 2:
            return True
        far_m = np.linalg.norm(place - place[0], axis=1).max()
        turned = 2.0 * np.arccos(np.abs(wxyz @ wxyz[0]).min().clip(0.0, 1.0))
        return bool(far_m < PAUSE_M and turned < PAUSE_RAD)
