"""Whether a replay repeats all of its recording, and in its order; pauses may be left out."""

import numpy as np

from keyphase.demonstration import Array
from keyphase.recorded_force import Even
from keyphase.simulation.recorded.span import Span

CUT_S = 0.2
"""A motion may be cut so late, or so early: what is left out is looked at without that."""

OVERLAP_S = 0.1
"""Neighbours may lie so far over each other."""

PAUSE_SHARE, PAUSE_M, PAUSE_RAD = 0.03, (0.003, 0.02), 0.14
"""A stretch in which the tool stayed within this part of all it moved through, within bounds, and
within this angle, is a pause: a hand that waits sways by up to so much."""

GRIPPED_SHARE = 0.2
"""But not one in which the gripper moved by this part of all it moved."""


class Repeating:
    """What of a recording has been repeated by the skills that were begun, one after the other."""

    def __init__(self, even: Even, gripper: Array | None = None) -> None:
        """`gripper` (N,) is its opening at the times of the recording, if it was recorded."""
        self._even = even
        self._gripper = np.zeros(len(even.time_s)) if gripper is None else gripper
        size_m = float(np.linalg.norm(np.ptp(even.position_m, axis=0)))
        self._pause_m = float(np.clip(PAUSE_SHARE * size_m, *PAUSE_M))
        self._repeated = list[Span]()
        self._reordered = False

    def begin(self, span_s: Span) -> None:
        """A skill repeats this stretch; what it passes over is left out, or a later one's."""
        if span_s in self._repeated:
            return
        until_s = max((end_s for _, end_s in self._repeated), default=-np.inf)
        late = self._left_out(span_s[0], min(span_s[1], until_s))
        self._reordered |= any(to_s - from_s > OVERLAP_S for from_s, to_s in late)
        self._repeated.append(span_s)

    @property
    def whole(self) -> bool:
        """Whether nothing but pauses was left out, and nothing made up for later."""
        start_s, end_s = self._even.time_s[[0, -1]].tolist()
        left_out = self._left_out(start_s, end_s)
        return not self._reordered and all(map(self._is_pause, left_out))

    def _left_out(self, from_s: float, to_s: float) -> list[Span]:
        """The stretches between two moments that no skill has repeated."""
        left, at_s = list[Span](), from_s
        for start_s, end_s in sorted(self._repeated):
            if at_s < min(start_s, to_s):
                left.append((at_s, min(start_s, to_s)))
            at_s = max(at_s, end_s)
        return [*left, (at_s, to_s)] if at_s < to_s else left

    def _is_pause(self, span_s: Span) -> bool:
        inside = span_s[0] + CUT_S, span_s[1] - CUT_S
        rows = slice(*np.searchsorted(self._even.time_s, inside).tolist())
        place, wxyz = self._even.position_m[rows], self._even.orientation_wxyz[rows]
        if len(place) < 2:
            return True
        if np.ptp(self._gripper[rows]) > GRIPPED_SHARE * np.ptp(self._gripper):
            return False
        far_m = np.linalg.norm(place - place[0], axis=1).max()
        turned = 2.0 * np.arccos(np.abs(wxyz @ wxyz[0]).min().clip(0.0, 1.0))
        return bool(far_m < self._pause_m and turned < PAUSE_RAD)
